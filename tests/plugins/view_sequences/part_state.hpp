// SPDX-License-Identifier: BSD-3-Clause
// Bytes of one part of the plugin's state, and a reader over any bytes.
#pragma once

#include <catch2/catch.hpp>
#include <span>
#include <sstream>
#include <string>

#include "tolman/state_stream.hpp"

namespace tolman::view_sequences::test {

inline constexpr const char* kPartMagic = "TESTPART";

/// What `save(StateWriter&)` puts.
std::string savedBytes(auto&& save) {
  StateWriter writer;
  save(writer);
  std::ostringstream stream;
  REQUIRE(writer.write(stream, kPartMagic, 1).isOk());
  return stream.str().substr(sizeof(detail::StateHeader));
}

/// A reader over the bytes, in an envelope whose checksum is right.
inline StateReader readerOf(const std::string& bytes) {
  StateWriter writer;
  writer.putAll(std::span<const char>(bytes.data(), bytes.size()));
  std::ostringstream out;
  REQUIRE(writer.write(out, kPartMagic, 1).isOk());
  std::istringstream in(out.str());
  auto reader = StateReader::open(in, kPartMagic, 1);
  REQUIRE(reader.isOk());
  return std::move(reader).value();
}

/// The bytes with `value` written over them at `at`.
template <class T>
std::string overwritten(std::string bytes, std::size_t at, T value) {
  REQUIRE(at + sizeof value <= bytes.size());
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

}  // namespace tolman::view_sequences::test
