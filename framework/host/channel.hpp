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
#include <tuple>
#include <type_traits>
#include <utility>

#include "host/manifest.hpp"
#include "tolman/context.hpp"

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

// The calls from the host to the process of a plugin, and its replies.

/// Messages from the host. Each call gets one reply.
enum class Call : std::uint32_t {
  Load = 1,
  Create,
  Configure,
  OpenArtefacts,
  Reset,
  Destroy,
  Arrays,
  Save,
  Restore,
  Info,
  Next,
  Track,
  FinishOdometry,
  Input,
  Observe,
  FinishPlace,
  Step,
  FinishCells,
  Update,
  PoseOf,
  Graph,
  FinishMap,
  Begin,
  Watch,
  FinishObserver,
  Describe,
  Url,
  RawRig,
  Cancel,  ///< at any time, without a reply
};

/// Messages from the process.
enum class ReplyKind : std::uint32_t {
  Reply = 1,  ///< to a call: status and results
  Log,        ///< one log line; at any time
  Finding,    ///< one finding; at any time
};

// The values of a context that are sent to the process of a plugin, whose services (log, findings,
// artefacts, cancellation) are created in that process.

struct ContextMessage {
  ParameterValues parameters;
  CameraRig rig;
  std::uint64_t seed = 0;
  std::string instance;
  bool localise = false;

  static ContextMessage of(const Context& context) {
    return {context.parameters, context.rig, context.seed, context.instance, context.localise};
  }
};

/// Which plugin a process opens, and its limits.
struct LoadMessage {
  std::string file;
  std::string id;
  std::string program;           ///< program of an interpreter; empty for other plugins
  std::uint64_t memory_mib = 0;  ///< 0 for no limit
  std::int64_t threads = 0;      ///< 0 for one per processor
};

template <class T>
requires std::same_as<std::remove_const_t<T>, Refusal>
auto parts(T& refusal) { return std::tie(refusal.id, refusal.message, refusal.remedy); }
template <class T>
requires std::same_as<std::remove_const_t<T>, ContextMessage>
auto parts(T& m) { return std::tie(m.parameters, m.rig, m.seed, m.instance, m.localise); }
template <class T>
requires std::same_as<std::remove_const_t<T>, LoadMessage>
auto parts(T& m) { return std::tie(m.file, m.id, m.program, m.memory_mib, m.threads); }

}  // namespace tolman::host
