// SPDX-License-Identifier: BSD-3-Clause
// The connection between the host and the process of one plugin: a sequenced-packet socket for
// short messages (a call, a reply, a log line), and one shared buffer in each direction for the
// data of a call. When one process ends, receive() of the other returns Closed at once.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "base/codec.hpp"

namespace tolman::host {

/// Memory shared by two processes. It can grow but not shrink (sealed by F_SEAL_SHRINK): otherwise
/// the writer could truncate it, and reading would crash the reader.
class SharedBuffer : public ByteBuffer {
 public:
  /// Creates an empty buffer. Throws std::system_error.
  explicit SharedBuffer(const std::string& name);
  /// Takes ownership of an inherited descriptor.
  explicit SharedBuffer(int descriptor) : descriptor_(descriptor) {}
  ~SharedBuffer() override;
  SharedBuffer(const SharedBuffer&) = delete;
  SharedBuffer& operator=(const SharedBuffer&) = delete;

  int descriptor() const { return descriptor_; }
  /// For the writer.
  std::byte* reserve(std::size_t size) override;
  /// For the reader: the first `size` bytes; throws std::runtime_error when there are fewer.
  const std::byte* view(std::size_t size);

 private:
  void map(std::size_t size);
  int descriptor_;
  std::byte* memory_ = nullptr;
  std::size_t mapped_ = 0;
};

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

/// The data of a message are the first `size` bytes of the sender's shared buffer.
struct MessageHead {
  std::uint32_t kind = 0;
  std::uint32_t detail = 0;  ///< number of the call (request, reply); level of a log line
  std::uint64_t size = 0;
};

struct SocketMessage : MessageHead {
  std::string text;  ///< cut off after kMaxText bytes
};
inline constexpr std::size_t kMaxText = 8192;  // bytes

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
  /// Waits at most `timeout`; without limit if it is negative.
  ReceiveResult receive(SocketMessage& message, std::chrono::milliseconds timeout) const;

 private:
  Descriptor descriptor_;
};

/// Shared memory for values that change during a call.
struct ControlBlock {
  std::atomic<std::uint32_t> cancelled;
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

}  // namespace tolman::host
