// SPDX-License-Identifier: BSD-3-Clause
#include "message_order.hpp"

#include <algorithm>
#include <limits>

#include "messages.hpp"

namespace tolman::ros_bag {
namespace {

bool isSame(const BagMessage& a, const BagMessage& b, const ReadMessage& read) {
  const auto first = read(a);
  const auto second = read(b);
  return first.isOk() && second.isOk() && first.value() == second.value();
}

}  // namespace

std::string movedText(const BagTopic& topic) {
  std::vector<BagMessage> recorded = topic.index;  // files may hold messages in any order
  std::ranges::stable_sort(recorded, {}, &BagMessage::log_ns);
  std::int64_t moved = 0;
  std::int64_t first = 0;
  std::int64_t latest_ns = std::numeric_limits<std::int64_t>::min();
  for (const BagMessage& message : recorded) {
    if (message.stamp_ns < latest_ns && ++moved == 1) first = message.number;
    latest_ns = std::max(latest_ns, message.stamp_ns);
  }
  if (moved == 0) return "";
  return topic.topic.name + ": by the times in their headers, " + std::to_string(moved) +
         (moved == 1 ? " message lies" : " messages lie") +
         " before one that was recorded earlier, the first of them message " +
         std::to_string(first) +
         " (counted from 0); they are taken in the order of these times. Is one of them damaged?";
}

void leaveOutSameTimes(BagTopic& topic, const ReadMessage& read) {
  const bool images = topic.topic.type == kImage || topic.topic.type == kCompressedImage;
  if (!images && topic.topic.type != kOdometry) return;
  std::vector<BagMessage> kept;
  kept.reserve(topic.index.size());
  for (const BagMessage& message : topic.index) {
    if (kept.empty() || kept.back().stamp_ns != message.stamp_ns) {
      kept.push_back(message);
    } else if (isSame(kept.back(), message, read)) {
      ++topic.recorded_twice;
    } else if (++topic.same_time == 1) {
      topic.first_same_time = "messages " + std::to_string(kept.back().number) + " and " +
                              std::to_string(message.number) + " (counted from 0) have the time " +
                              std::to_string(message.stamp_ns) + " ns in their headers and " +
                              (images ? "different images" : "different contents");
    }
  }
  topic.index = std::move(kept);
}

}  // namespace tolman::ros_bag
