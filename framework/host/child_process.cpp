// SPDX-License-Identifier: BSD-3-Clause
#include "host/child_process.hpp"

#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "tolman/version.hpp"

namespace tolman::host {

namespace {

void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// Starts a process by posix_spawn(), because the host has threads: stdin is empty, stdout and
/// stderr go to `output`.
pid_t spawn(std::vector<std::string> command, const std::vector<int>& passed, int output) {
  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
  check(::posix_spawn_file_actions_init(&actions), "no process");
  check(::posix_spawnattr_init(&attributes), "no process");
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  // dup2() of a descriptor to itself removes its close-on-exec flag.
  for (const int fd : passed) ::posix_spawn_file_actions_adddup2(&actions, fd, fd);
  sigset_t none;
  ::sigemptyset(&none);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  // Its own process group, so that Ctrl-C in the terminal reaches only the host.
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  pid_t pid = -1;
  const int error = ::posix_spawn(&pid, words[0], &actions, &attributes, words.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  check(error, "no further process can be started");
  return pid;
}

}  // namespace

std::string signalName(int signal) {
  const char* name = ::sigabbrev_np(signal);
  const char* meaning = ::sigdescr_np(signal);
  if (name == nullptr || meaning == nullptr) return "signal " + std::to_string(signal);
  return std::string("SIG") + name + " (" + meaning + ")";
}

void limitResources(std::uint64_t memory_mib) {
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const bool sanitized = std::strcmp(TOLMAN_SANITIZER, "none") != 0;  // they reserve terabytes
  if (memory_mib == 0 || sanitized) return;
  const rlimit data{memory_mib << 20U, memory_mib << 20U};
  ::setrlimit(RLIMIT_DATA, &data);
}

std::string ProcessEnd::text() const {
  if (signal != 0) return "died of " + signalName(signal);
  return "exited with code " + std::to_string(exit_code);
}

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::vector<int>& passed,
                           int output)
    : pid_(spawn(command, passed, output)) {}

ChildProcess::~ChildProcess() { (void)end(std::chrono::milliseconds(0)); }

bool ChildProcess::hasEnded() const {
  if (reaped_) return true;
  siginfo_t state{};
  const int answer = ::waitid(P_PID, static_cast<id_t>(pid_), &state, WEXITED | WNOHANG | WNOWAIT);
  return answer == 0 && state.si_pid == pid_;
}

void ChildProcess::signal(int number) const {
  if (!reaped_) ::kill(pid_, number);
}

void ChildProcess::reap() {
  int state = 0;
  pid_t answer = 0;
  do {
    answer = ::waitpid(pid_, &state, 0);
  } while (answer < 0 && errno == EINTR);
  reaped_ = true;
  if (answer != pid_) return;
  end_.signal = WIFSIGNALED(state) ? WTERMSIG(state) : 0;
  end_.exit_code = WIFEXITED(state) ? WEXITSTATUS(state) : 0;
}

ProcessEnd ChildProcess::end(std::chrono::milliseconds timeout) {
  if (reaped_) return end_;
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (!hasEnded() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // The group before the child is reaped: until then the id cannot belong to another process.
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  reap();
  return end_;
}

namespace {

struct Head {
  std::uint32_t kind;
  std::uint32_t detail;
  std::uint64_t size;
};

/// Whether all bytes came before the other end was closed.
bool readAll(int socket, void* bytes, std::size_t size) {
  auto* next = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t count = ::recv(socket, next, size, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    next += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

std::array<Socket, 2> Socket::pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "no socket");
  }
  return {Socket(FileDescriptor(ends[0])), Socket(FileDescriptor(ends[1]))};
}

bool Socket::send(const SocketMessage& message) const {
  const std::lock_guard lock(*sending_);
  Head head{message.kind, message.detail, message.bytes.size()};
  // Both pieces in one call, so that small messages of processes that share the socket stay whole.
  std::array<iovec, 2> pieces{
      {{&head, sizeof head}, {const_cast<char*>(message.bytes.data()), message.bytes.size()}}};
  msghdr header{};
  header.msg_iov = pieces.data();
  header.msg_iovlen = pieces.size();
  while (pieces[0].iov_len + pieces[1].iov_len > 0) {
    const ssize_t sent = ::sendmsg(descriptor_.number(), &header, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    auto left = static_cast<std::size_t>(sent);
    for (iovec& piece : pieces) {
      const std::size_t done = std::min(left, piece.iov_len);
      piece.iov_base = static_cast<char*>(piece.iov_base) + done;
      piece.iov_len -= done;
      left -= done;
    }
  }
  return true;
}

ReceiveResult Socket::receive(SocketMessage& message, std::chrono::milliseconds timeout,
                              std::uint64_t most) const {
  pollfd watched{descriptor_.number(), POLLIN, 0};
  const int ready = ::poll(&watched, 1, static_cast<int>(timeout.count()));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return ReceiveResult::Timeout;
  Head head{};
  if (!readAll(descriptor_.number(), &head, sizeof head)) return ReceiveResult::Closed;
  if (head.size > most) throw std::domain_error("it is larger than isolation.memory_limit");
  message.kind = head.kind;
  message.detail = head.detail;
  message.bytes.resize(head.size);
  const bool is_whole = readAll(descriptor_.number(), message.bytes.data(), head.size);
  return is_whole ? ReceiveResult::Message : ReceiveResult::Closed;
}

}  // namespace tolman::host
