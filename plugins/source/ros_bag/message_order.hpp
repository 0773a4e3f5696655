// SPDX-License-Identifier: BSD-3-Clause
// Times of a topic's messages that contradict each other: messages that lie before one that was
// recorded earlier, and images or poses with the time of another.
#pragma once

#include <functional>
#include <string>

#include "bag.hpp"

namespace tolman::ros_bag {

using ReadMessage = std::function<Result<std::vector<std::uint8_t>>(const BagMessage&)>;

/// Messages whose time is before that of a message that was recorded earlier; empty if there are
/// none. One damaged time is enough to move a frame.
std::string movedText(const BagTopic& topic);

/// Leaves only the first of images or odometry messages with the same time. `topic.index` must be
/// sorted. Those that are the same byte by byte, as if two recorders wrote the same topic, are
/// counted in `topic.recorded_twice`, others in `topic.same_time`.
void leaveOutSameTimes(BagTopic& topic, const ReadMessage& read);

}  // namespace tolman::ros_bag
