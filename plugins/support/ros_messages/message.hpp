// SPDX-License-Identifier: BSD-3-Clause
// The bytes of one message, and the encoding of its fields.
#pragma once

#include <cstdint>
#include <vector>

#include "bytes.hpp"

namespace tolman::ros_messages {

enum class Encoding : std::uint8_t { Cdr, Ros1 };

/// A view; the bytes must outlive it.
struct Message {
  Message(Bytes of, Encoding written = Encoding::Cdr) : bytes(of), encoding(written) {}
  Message(const std::vector<std::uint8_t>& of, Encoding written = Encoding::Cdr)
      : bytes(of), encoding(written) {}

  Bytes bytes;
  Encoding encoding;
};

}  // namespace tolman::ros_messages
