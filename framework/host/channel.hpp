// SPDX-License-Identifier: BSD-3-Clause
// The connection between the host and the process of one plugin: messages over a stream socket.
// When one process ends, receive() of the other returns Closed at once.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tolman::host {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  int get() const { return value_; }
  int release() { return std::exchange(value_, -1); }
  void close();

 private:
  int value_;
};

struct SocketMessage {
  std::uint32_t kind = 0;
  std::uint32_t detail = 0;  ///< number of the call (request, reply); level of a log line
  std::string bytes;         ///< encoded values (base/codec.hpp), or the text of a log line
};

enum class ReceiveResult : std::uint8_t { Message, Timeout, Closed };

/// One end of the socket.
class Socket {
 public:
  explicit Socket(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}
  /// Both ends of a new socket, which are closed on exec.
  static std::array<Socket, 2> pair();
  int descriptor() const { return descriptor_.get(); }
  void close() { descriptor_.close(); }

  /// May be called from any thread. False when the other end is closed.
  bool send(const SocketMessage& message) const;
  /// Waits at most `timeout` for the begin of a message; without limit if it is negative. Throws
  /// std::domain_error for a message of more than `most` bytes.
  ReceiveResult receive(SocketMessage& message, std::chrono::milliseconds timeout,
                        std::uint64_t most = UINT64_MAX) const;

 private:
  Descriptor descriptor_;
  std::unique_ptr<std::mutex> sending_ = std::make_unique<std::mutex>();
};

}  // namespace tolman::host
