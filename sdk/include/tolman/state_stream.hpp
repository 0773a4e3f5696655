// SPDX-License-Identifier: BSD-3-Clause
// For StateKeeper: a saved state as a header (magic number, version, size, checksum) and a payload
// of plain numbers in the machine's byte order. The checksum is verified before any number is read.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "tolman/status.hpp"

namespace tolman {

namespace detail {

struct StateHeader {
  char magic[8];
  std::uint64_t version;
  std::uint64_t size;      ///< bytes of payload
  std::uint64_t checksum;  ///< FNV-1a of the payload
};

inline std::uint64_t stateChecksum(std::string_view payload) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : payload) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

}  // namespace detail

/// Collects numbers, then writes them with a header.
class StateWriter {
 public:
  template <class T>
  void put(const T& value) requires std::is_arithmetic_v<T> {
    payload_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void putAll(std::span<const T> values) requires std::is_arithmetic_v<T> {
    payload_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }

  /// `magic` has eight characters.
  Status write(std::ostream& stream, std::string_view magic, std::uint64_t version) const {
    detail::StateHeader header{{}, version, payload_.size(), detail::stateChecksum(payload_)};
    std::memcpy(header.magic, magic.data(), sizeof header.magic);
    stream.write(reinterpret_cast<const char*>(&header), sizeof header);
    stream.write(payload_.data(), static_cast<std::streamsize>(payload_.size()));
    return stream ? Status::ok() : Status::failed("the state could not be written");
  }

 private:
  std::string payload_;
};

/// Reads one header and its payload. Reading beyond the end gives zero and makes complete() false.
/// A bool is one byte; any nonzero value is true.
class StateReader {
 public:
  static Result<StateReader> open(std::istream& stream, std::string_view magic,
                                  std::uint64_t version) {
    detail::StateHeader header{};
    stream.read(reinterpret_cast<char*>(&header), sizeof header);
    if (!stream || std::memcmp(header.magic, magic.data(), sizeof header.magic) != 0) {
      return Status::invalidInput("this is not a saved state of '" + std::string(magic) + "'");
    }
    if (header.version != version) {
      return Status::invalidInput("the saved state has version " + std::to_string(header.version) +
                                  ", this plugin reads version " + std::to_string(version));
    }
    StateReader reader;
    reader.readPayload(stream, header.size);
    if (reader.payload_.size() != header.size ||
        detail::stateChecksum(reader.payload_) != header.checksum) {
      return Status::invalidInput("the saved state is damaged: its checksum does not agree");
    }
    return reader;
  }

  template <class T>
  T get() requires std::is_arithmetic_v<T> {
    // A bool that holds another value than 0 or 1 is undefined behaviour, so read it as an integer.
    std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T> value{};
    take(&value, sizeof value);
    return static_cast<T>(value);
  }
  template <class T>
  void getAll(std::span<T> values) requires std::is_arithmetic_v<T> {
    take(values.data(), values.size_bytes());
  }
  /// Number of unread bytes; 0 after a read beyond the end, so that loops over it stop.
  std::size_t remaining() const { return overrun_ ? 0 : payload_.size() - position_; }
  /// Whether all bytes were read, and no read went beyond the end.
  bool complete() const { return !overrun_ && remaining() == 0; }

 private:
  void take(void* destination, std::size_t bytes) {
    overrun_ = overrun_ || bytes > remaining();
    if (overrun_ || bytes == 0) return;
    std::memcpy(destination, payload_.data() + position_, bytes);
    position_ += bytes;
  }
  /// Reads in pieces, so that a damaged size does not allocate too much memory.
  void readPayload(std::istream& stream, std::uint64_t size) {
    constexpr std::uint64_t kPiece = 1U << 16U;
    while (stream && payload_.size() < size) {
      const std::size_t start = payload_.size();
      payload_.resize(start + std::min(kPiece, size - start));
      stream.read(payload_.data() + start, static_cast<std::streamsize>(payload_.size() - start));
      payload_.resize(start + static_cast<std::size_t>(stream.gcount()));
    }
  }

  std::string payload_;
  std::size_t position_ = 0;
  bool overrun_ = false;
};

}  // namespace tolman
