// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <utility>

#include "isolation/child_process.hpp"

namespace tolman::conformance {
namespace {

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    ::close(ends[0]);
    closeWriter();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int reader() const { return ends[0]; }
  int writer() const { return ends[1]; }
  void closeWriter() {
    if (ends[1] >= 0) ::close(std::exchange(ends[1], -1));
  }
  std::array<int, 2> ends{};
};

/// In the child: a group of its own, dies with its parent, writes into the pipes.
[[noreturn]] void become(std::vector<std::string> command, const ChildLimits& limits, int report,
                         int output) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(::open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::fcntl(report, F_SETFD, 0);  // this one is passed on
  isolation::limitResources(limits.memory_mib);
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  ::execv(words[0], words.data());
  ::_exit(127);
}

/// Reads what is there; false at the end.
bool drain(int descriptor, std::string& text) {
  std::array<char, 4096> piece{};
  for (;;) {
    const ssize_t bytes = ::read(descriptor, piece.data(), piece.size());
    if (bytes == 0) return false;
    if (bytes < 0) return true;
    text.append(piece.data(), static_cast<std::size_t>(bytes));
  }
}

/// Listens to a child until it is gone.
class Watch {
 public:
  Watch(pid_t pid, const Pipe& report, const Pipe& output, double seconds,
        const std::function<void(const std::string&)>& on_line)
      : pid_(pid),
        report_(report),
        output_(output),
        deadline_(std::chrono::steady_clock::now() +
                  std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                      std::chrono::duration<double>(seconds))),
        on_line_(on_line) {}

  ChildEnd wait() {
    int state = 0;
    while (::waitpid(pid_, &state, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > deadline_) {
        end_.timed_out = true;
        ::kill(-pid_, SIGKILL);
        ::waitpid(pid_, &state, 0);
        break;
      }
      std::array<pollfd, 2> watched{{{report_.reader(), POLLIN, 0}, {output_.reader(), POLLIN, 0}}};
      ::poll(watched.data(), watched.size(), open_ ? 50 : 0);
      if (!open_) ::usleep(2000);
      listen();
    }
    listen();
    ::kill(-pid_, SIGKILL);  // what it started, if anything
    end_.signal = WIFSIGNALED(state) ? WTERMSIG(state) : 0;
    end_.exit_code = WIFEXITED(state) ? WEXITSTATUS(state) : 0;
    return end_;
  }

 private:
  void listen() {
    constexpr std::size_t kKept = 300;  // bytes
    open_ = drain(report_.reader(), pending_);
    drain(output_.reader(), end_.output);
    if (end_.output.size() > kKept) end_.output.erase(0, end_.output.size() - kKept);
    std::size_t newline = 0;
    while ((newline = pending_.find('\n')) != std::string::npos) {
      on_line_(pending_.substr(0, newline));
      pending_.erase(0, newline + 1);
    }
  }

  pid_t pid_;
  const Pipe& report_;
  const Pipe& output_;
  std::chrono::steady_clock::time_point deadline_;
  const std::function<void(const std::string&)>& on_line_;
  ChildEnd end_;
  std::string pending_;
  bool open_ = true;
};

}  // namespace

ChildEnd runChild(const std::function<std::vector<std::string>(int descriptor)>& command,
                  const ChildLimits& limits,
                  const std::function<void(const std::string& line)>& on_line) {
  Pipe report;
  Pipe output;
  const std::vector<std::string> words = command(report.writer());
  const pid_t pid = ::fork();
  if (pid < 0) throw std::runtime_error("no further process can be started");
  if (pid == 0) become(words, limits, report.writer(), output.writer());
  ::setpgid(pid, pid);  // whoever comes first
  report.closeWriter();
  output.closeWriter();
  return Watch(pid, report, output, limits.seconds, on_line).wait();
}

}  // namespace tolman::conformance
