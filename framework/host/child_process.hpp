// SPDX-License-Identifier: BSD-3-Clause
// Processes of plugins: starts a child in its own process group and reports how it ended, and talks
// to it by messages over a socket.
#pragma once

#include <stdlib.h>
#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/file_descriptor.hpp"
#include "host/manifest.hpp"
#include "tolman/context.hpp"

namespace tolman::host {

/// How a process ended.
struct ProcessEnd {
  int signal = 0;     ///< 0 for none
  int exit_code = 0;  ///< if there was no signal
  /// "died of SIGSEGV (Segmentation fault)", "exited with code 3"
  std::string text() const;
};

/// "SIGSEGV (Segmentation fault)".
std::string signalName(int signal);

/// Forbids core files in this process and limits its data segment (0 for no limit).
void limitResources(std::uint64_t memory_mib);

class ChildProcess {
 public:
  /// Starts `command`. It inherits the descriptors of `passed` with the same numbers; its stdout
  /// and stderr go to `output`. Throws std::system_error.
  ChildProcess(const std::vector<std::string>& command, const std::vector<int>& passed,
               int output = 2);
  /// Kills the process and its group.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool hasEnded() const;
  /// Sends a signal to the process alone; nothing if it has ended.
  void signal(int number) const;
  /// Waits at most `timeout`, then kills the process and its group: what it started, unless that
  /// has left the group.
  ProcessEnd end(std::chrono::milliseconds timeout);

 private:
  void reap();
  pid_t pid_ = -1;
  bool reaped_ = false;
  ProcessEnd end_;
};

// A temporary folder for files of plugins, removed by the destructor.

inline constexpr const char* kNoScratchFolder =
    "no temporary folder can be made; set TMPDIR to a folder that exists and can be written";

class ScratchFolder {
 public:
  /// `name` is the prefix of the folder's name.
  explicit ScratchFolder(const std::string& name) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    std::string pattern = (folder / (name + "-XXXXXX")).string();
    if (!error && ::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// Empty when it could not be created, see kNoScratchFolder.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// The connection between the host and the process of one plugin: messages over a stream socket.
// When one process ends, receive() of the other returns Closed at once.

struct SocketMessage {
  std::uint32_t kind = 0;
  std::uint32_t detail = 0;  ///< number of the call (request, reply); level of a log line
  std::string bytes;         ///< encoded values (base/codec.hpp), or the text of a log line
};

enum class ReceiveResult : std::uint8_t { Message, Timeout, Closed };

/// One end of the socket.
class Socket {
 public:
  explicit Socket(FileDescriptor descriptor) : descriptor_(std::move(descriptor)) {}
  /// Both ends of a new socket, which are closed on exec.
  static std::array<Socket, 2> pair();
  int descriptor() const { return descriptor_.number(); }
  void close() { descriptor_ = FileDescriptor(); }

  /// May be called from any thread. False when the other end is closed.
  bool send(const SocketMessage& message) const;
  /// Waits at most `timeout` for the begin of a message; without limit if it is negative. Throws
  /// std::domain_error for a message of more than `most` bytes.
  ReceiveResult receive(SocketMessage& message, std::chrono::milliseconds timeout,
                        std::uint64_t most = UINT64_MAX) const;

 private:
  FileDescriptor descriptor_;
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
