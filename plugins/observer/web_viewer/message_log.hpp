// SPDX-License-Identifier: BSD-3-Clause
// The newest messages of /api/events, numbered, so that each client gets every one once.
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace tolman::web_viewer {

class MessageLog {
 public:
  static constexpr std::size_t kMax = 1000;

  void append(const std::vector<std::string>& messages) {
    for (const std::string& text : messages) {
      messages_.push_back(std::make_shared<const std::string>(text));
    }
    end_ += messages.size();
    while (messages_.size() > kMax) messages_.pop_front();
  }
  std::size_t end() const { return end_; }

  /// Returns the message with the number `next` and increments `next`; null at the end. If that
  /// message was dropped: a message with the number of dropped ones, and `next` is that of the
  /// oldest.
  std::shared_ptr<const std::string> next(std::size_t& next) const {
    const std::size_t oldest = end_ - messages_.size();
    if (next < oldest) {
      const std::size_t missed = oldest - next;
      next = oldest;
      return std::make_shared<const std::string>(R"({"type":"missed","messages":)" +
                                                 std::to_string(missed) + "}");
    }
    return next < end_ ? messages_[next++ - oldest] : nullptr;
  }

 private:
  std::deque<std::shared_ptr<const std::string>> messages_;
  std::size_t end_ = 0;
};

}  // namespace tolman::web_viewer
