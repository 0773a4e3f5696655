// SPDX-License-Identifier: BSD-3-Clause
// Between the host and the process of one stage: a socket for short notes that keep their bounds
// (a call, a reply, a line of the log), and one shared buffer each way for what a call carries.
// When one side dies the other's socket ends at once, so nobody waits for the dead.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace tolman::isolation {

/// Closes with its object.
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

/// One note. `size` bytes of the sender's buffer belong to it.
struct Note {
  std::uint32_t kind = 0;
  std::uint32_t detail = 0;  ///< number of a call and of its reply; level of a log line
  std::uint64_t size = 0;
  std::string text;  ///< at most kMostText; longer texts are cut
};
inline constexpr std::size_t kMostText = 8192;

enum class Wait : std::uint8_t { Note, Nothing, Gone };

/// One end of the socket.
class Socket {
 public:
  explicit Socket(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}
  /// Both ends, closed on exec.
  static std::array<Socket, 2> pair();
  int descriptor() const { return descriptor_.get(); }
  void close() { descriptor_.close(); }

  /// Any thread. False when nobody listens any more.
  bool send(const Note& note) const;
  /// Waits at most so long; less than zero: for ever.
  Wait receive(Note& note, std::chrono::milliseconds patience) const;

 private:
  Descriptor descriptor_;
};

/// In memory of its own, what may change during a call.
struct ControlBlock {
  std::atomic<std::uint32_t> cancelled;
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

}  // namespace tolman::isolation
