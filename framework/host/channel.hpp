// SPDX-License-Identifier: BSD-3-Clause
// Memory shared by two processes. It can grow but not shrink (sealed by F_SEAL_SHRINK): otherwise
// the writer could truncate it, and reading would crash the reader.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "host/child_process.hpp"

namespace tolman::host {

class SharedBuffer {
 public:
  /// Creates an empty buffer. Throws std::system_error.
  explicit SharedBuffer(const std::string& name);
  /// Takes ownership of an inherited descriptor.
  explicit SharedBuffer(int descriptor) : descriptor_(descriptor) {}
  ~SharedBuffer();
  SharedBuffer(const SharedBuffer&) = delete;
  SharedBuffer& operator=(const SharedBuffer&) = delete;

  int descriptor() const { return descriptor_; }
  /// For the writer: at least `size` bytes; keeps what was written. May move the memory.
  std::byte* reserve(std::size_t size);
  /// For the reader: the first `size` bytes; throws std::runtime_error when there are fewer.
  const std::byte* view(std::size_t size);

 private:
  void map(std::size_t size);
  int descriptor_;
  std::byte* memory_ = nullptr;
  std::size_t mapped_ = 0;
};

// The connection between the host and the process of one plugin: a sequenced-packet socket for
// short messages (a call, a reply, a log line), and one shared buffer in each direction for the
// data of a call. When one process ends, receive() of the other returns Closed at once.

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  int get() const { return value_; }
  int release();
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

// Where a program that a plugin interprets (plugin: python) was when it did not return or died: its
// interpreter writes its stack into shared memory when the host asks for it by a signal.

/// Variable with the number of the descriptor, in the environment of the plugin's process. An
/// interpreter that takes part writes any first line there, and from then on, at kStackSignal, a
/// line `  File "PATH", line N in FUNCTION` for each call, the innermost first: what `faulthandler`
/// of Python writes. It may write the same when a signal such as SIGSEGV ends the process.
inline constexpr const char* kStackVariable = "TOLMAN_STACK_DESCRIPTOR";
inline constexpr int kStackSignal = 12;  // SIGUSR2

class StackReport {
 public:
  /// Throws std::system_error.
  StackReport() : memory_("tolman-stack") {}
  /// To be passed to the process.
  int descriptor() const { return memory_.descriptor(); }
  /// Asks the process, and waits for half a second at most. "mine.py:12, in step": the innermost
  /// call in the file `program` or in its folder; empty if the interpreter does not answer.
  std::string ask(const ChildProcess& process, const std::string& program) const;
  /// The same of the stack that the interpreter wrote when the process died.
  std::string left(const std::string& program) const;

 private:
  std::string text() const;
  SharedBuffer memory_;
};

/// The same of the text of a stack. Exposed for its test.
std::string placeInStack(const std::string& stack, const std::string& program);

}  // namespace tolman::host
