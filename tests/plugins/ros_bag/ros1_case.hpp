// SPDX-License-Identifier: BSD-3-Clause
// Reading of a file of a ROS 1 bag, and small hand-written bags.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "bag_case.hpp"

namespace tolman::ros_bag {

template <class T>
std::string rawNumber(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

inline std::string ros1Text(const std::string& text) {
  return rawNumber(static_cast<std::uint32_t>(text.size())) + text;
}

/// A record with these fields, "name=value".
inline std::string ros1Record(const std::vector<std::string>& fields, const std::string& data) {
  std::string header;
  for (const std::string& field : fields) header += ros1Text(field);
  return ros1Text(header) + ros1Text(data);
}

inline std::string ros1Op(char kind) { return std::string("op=") + kind; }

/// The start of a bag whose index stands at `index_at`; 0: the recording was killed.
inline std::string ros1Start(std::uint64_t index_at, const std::string& encryptor = "") {
  return "#ROSBAG V2.0\n" +
         ros1Record({ros1Op('\3'), "index_pos=" + rawNumber(index_at), "encryptor=" + encryptor},
                    std::string(20, ' '));
}

inline std::string ros1Connection(std::uint32_t number, const std::string& topic,
                                  const std::string& type) {
  return ros1Record({ros1Op('\7'), "conn=" + rawNumber(number), "topic=" + topic},
                    ros1Text("type=" + type) + ros1Text("md5sum=*"));
}

inline std::string ros1Message(std::uint32_t connection, std::uint32_t seconds,
                               const std::string& data) {
  return ros1Record({ros1Op('\2'), "conn=" + rawNumber(connection),
                     "time=" + rawNumber(seconds) + rawNumber(std::uint32_t{7})},
                    data);
}

inline std::string ros1Chunk(const std::string& records, const std::string& compression = "none",
                             std::uint32_t claimed = 0) {
  const auto size = claimed == 0 ? static_cast<std::uint32_t>(records.size()) : claimed;
  return ros1Record({ros1Op('\5'), "compression=" + compression, "size=" + rawNumber(size)},
                    records);
}

/// The index of a chunk that has `messages` of a connection.
inline std::string ros1ChunkIndex(std::uint32_t connection, std::uint32_t messages) {
  return ros1Record({ros1Op('\4'), "conn=" + rawNumber(connection), "count=" + rawNumber(messages)},
                    std::string(12 * messages, '\0'));
}

/// An entry of the index at the end, of a chunk that has `messages` of each of two connections.
inline std::string ros1ChunkInfo(std::uint32_t messages) {
  return ros1Record({ros1Op('\6'), "count=" + rawNumber(2U)},
                    rawNumber(0U) + rawNumber(messages) + rawNumber(1U) + rawNumber(messages));
}

}  // namespace tolman::ros_bag
