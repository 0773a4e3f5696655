// SPDX-License-Identifier: BSD-3-Clause
// One record of a ROS 1 bag: a header of fields `name=value`, and data, each after its length.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "bag_file.hpp"

namespace tolman::ros_bag {

enum class Ros1Kind : std::uint8_t {
  None = 0,
  Message = 2,
  BagHeader = 3,
  Index = 4,
  Chunk = 5,
  ChunkInfo = 6,
  Connection = 7,
};

/// A view of the bytes that it was read from.
struct Ros1Record {
  Bytes header;
  Bytes data;
  std::uint64_t data_at = 0;  ///< offset of the data from the start of the record

  /// The value of the field; empty if it is missing, or if the header is damaged before it.
  std::optional<Bytes> field(std::string_view name) const;
  /// The value as a number of exactly its size.
  template <class T>
  std::optional<T> number(std::string_view name) const {
    const std::optional<Bytes> value = field(name);
    if (!value || value->size() != sizeof(T)) return std::nullopt;
    return ByteReader(*value).number<T>();
  }
  /// None: it has no kind, or a damaged one.
  Ros1Kind kind() const;
};

/// The next record; empty if it is incomplete.
std::optional<Ros1Record> takeRecord(ByteReader& bytes);

/// Time of a message, ns since 1970; empty if it is missing. ROS 1 stores the seconds without a
/// sign; from 2038 on they are taken as those before 1970, which a wrong clock gives.
std::optional<std::int64_t> timeOf(const Ros1Record& message);

/// The topic of a connection record; its type is in the notation of ROS 2.
std::optional<Topic> topicOf(const Ros1Record& connection);

/// The unpacked records of a chunk. InvalidInput or Unsupported; the message does not name the
/// place.
Result<std::vector<std::uint8_t>> unpackChunk(const Ros1Record& chunk);

}  // namespace tolman::ros_bag
