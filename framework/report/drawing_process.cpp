// SPDX-License-Identifier: BSD-3-Clause
#include "report/drawing_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <new>

namespace tolman::report {
namespace {

constexpr char kDrawn = 'd';
constexpr char kFailed = 'f';

bool isLimited() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

void writeAll(int pipe, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ::ssize_t written = ::write(pipe, bytes.data() + at, bytes.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(1);
    at += static_cast<std::size_t>(written);
  }
}

std::string readAll(int pipe) {
  std::string bytes;
  std::array<char, 65536> block{};
  while (true) {
    const ::ssize_t read = ::read(pipe, block.data(), block.size());
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return bytes;
    bytes.append(block.data(), static_cast<std::size_t>(read));
  }
}

/// The child: its answer is a letter, and bytes or a message. It leaves no core and no messages.
[[noreturn]] void answer(int pipe, const Draw& draw) {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  const int null = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (null >= 0) ::dup2(null, STDERR_FILENO);
  try {
    const Result<std::string> drawn = draw();
    writeAll(pipe, drawn.isOk() ? kDrawn + drawn.value() : kFailed + drawn.status().message());
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

bool endedWell(::pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return false;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

Result<std::string> drawnSafely(const Draw& draw) {
  if (!isLimited()) return draw();
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::bad_alloc();
  const ::pid_t child = ::fork();
  if (child == 0) answer(pipe[1], draw);
  ::close(pipe[1]);
  std::string answered;
  if (child > 0) answered = readAll(pipe[0]);
  ::close(pipe[0]);
  if (child < 0 || !endedWell(child) || answered.empty()) throw std::bad_alloc();
  const std::string rest = answered.substr(1);
  if (answered.front() == kFailed) return Status::failed(rest);
  return rest;
}

}  // namespace tolman::report
