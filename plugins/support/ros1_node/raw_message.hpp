// SPDX-License-Identifier: BSD-3-Clause
// The bytes of a message of any type, for roscpp's subscribers.
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <cstdint>
#include <vector>

namespace tolman::ros1_node {

struct RawMessage {
  std::vector<std::uint8_t> bytes;
};

}  // namespace tolman::ros1_node

namespace ros {
namespace message_traits {

/// "*" matches any type.
template <>
struct MD5Sum<tolman::ros1_node::RawMessage> {
  static const char* value() { return "*"; }
  static const char* value(const tolman::ros1_node::RawMessage&) { return "*"; }
};
template <>
struct DataType<tolman::ros1_node::RawMessage> {
  static const char* value() { return "*"; }
  static const char* value(const tolman::ros1_node::RawMessage&) { return "*"; }
};
template <>
struct Definition<tolman::ros1_node::RawMessage> {
  static const char* value() { return ""; }
  static const char* value(const tolman::ros1_node::RawMessage&) { return ""; }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<tolman::ros1_node::RawMessage> {
  template <class Stream>
  static void read(Stream& stream, tolman::ros1_node::RawMessage& message) {
    message.bytes.assign(stream.getData(), stream.getData() + stream.getLength());
  }
};

}  // namespace serialization
}  // namespace ros
