// SPDX-License-Identifier: BSD-3-Clause
// What could not be read of a file of a bag: texts of its problems, and the messages that are lost
// by them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "topic.hpp"

namespace tolman::ros_bag {

/// Messages of one topic that could not be read.
struct LostMessages {
  Topic topic;  ///< of the last; the name is empty if it is not known
  std::int64_t messages = 0;
};

struct FileDamage {
  std::vector<std::string> problems;         ///< each with a remedy, without the name of the file
  std::map<std::string, LostMessages> lost;  ///< by the name of the topic; empty: not known

  void lose(const Topic& topic, std::int64_t messages) {
    if (messages <= 0) return;
    LostMessages& known = lost[topic.name];
    known.topic = topic;
    known.messages += messages;
  }
};

/// "12 messages of /left and 3 messages of topics that are not known"; empty without any.
std::string lostText(const std::map<std::string, LostMessages>& lost);

/// ", and 3 more like it" for 4 things, of which the first has been told; else empty.
std::string furtherText(std::int64_t count);

/// Things of one kind in a file, which are told once: the first and the number of the others.
class Repeated {
 public:
  /// `what` is used of the first only.
  template <class What>
  void add(What&& what) {
    if (++count_ == 1) first_ = what();
  }
  std::int64_t count() const { return count_; }
  /// "FIRST, and 3 more like it"
  std::string text() const;

 private:
  std::int64_t count_ = 0;
  std::string first_;
};

}  // namespace tolman::ros_bag
