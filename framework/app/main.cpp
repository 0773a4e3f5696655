// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <iostream>
#include <optional>
#include <string_view>
#include <vector>

#include "app/exit_guard.hpp"
#include "app/program.hpp"
#include "app/terminal_output.hpp"
#include "engine/services.hpp"
#include "host/plugin_process.hpp"
#include "host/process_mark.hpp"

namespace {

/// Repairs what a parent process may have left: closed standard streams, whose descriptors the next
/// opened files would take, and an ignored SIGCHLD, which hides the exit of child processes. A
/// closed pipe and a limit of file sizes are errors of the writes, not the end of the process.
void repairInheritedState() {
  int descriptor = 0;
  do {
    descriptor = ::open("/dev/null", O_RDONLY);  // so that writing fails and is reported
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) ::close(descriptor);
  std::signal(SIGCHLD, SIG_DFL);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Saved states and tables of whole runs get their own pages, which are returned to the system when
/// they are freed. By default glibc raises this limit to the largest buffer freed so far, and
/// long-lived blocks between such buffers then double the memory growth of a run. Images are
/// smaller: their own pages would cost 5 ms a frame. Freed memory at the end of the heap is kept
/// for the next frame, and is returned by the watchdog (run/watchdog.hpp): with glibc's fixed 128
/// KiB it would be returned, and cleared again, several times a frame.
void limitFragmentation() {
#ifdef __GLIBC__
  constexpr int kLargeBuffer = 4 << 20;  // bytes
  constexpr int kMaxKept = 256 << 20;    // bytes
  ::mallopt(M_MMAP_THRESHOLD, kLargeBuffer);
  ::mallopt(M_TRIM_THRESHOLD, kMaxKept);
#endif
}

/// Below this a run overflows its stack, which ends a process without a message.
bool hasStack() {
  constexpr rlim_t kSmallest = 256 << 10;  // bytes; 100 KiB were enough for a run
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kSmallest) return true;
  std::cerr << "tolman: the stack is limited to less than 256 KiB; give it more (`ulimit -s`)\n";
  return false;
}

void* waitFor(void* go) {
  static_cast<std::atomic<bool>*>(go)->wait(false);
  return nullptr;
}

/// Libraries that cannot start a thread end the process (TBB, GLib) instead of reporting it.
bool hasThreads(bool quiet) {
  constexpr std::size_t kFewest = 16;       // 12 were enough for a run with 8 threads
  constexpr std::size_t kStack = 64 << 10;  // bytes; the usual 8 MiB would be a test of memory
  std::atomic<bool> go = false;             // all of them exist at the same time
  std::vector<pthread_t> threads;
  pthread_attr_t small;
  ::pthread_attr_init(&small);
  ::pthread_attr_setstacksize(&small, kStack);
  pthread_t thread;
  while (threads.size() < kFewest && ::pthread_create(&thread, &small, waitFor, &go) == 0) {
    threads.push_back(thread);
  }
  ::pthread_attr_destroy(&small);
  go = true;
  go.notify_all();
  for (const pthread_t& each : threads) ::pthread_join(each, nullptr);
  if (threads.size() == kFewest) return true;
  if (quiet) return false;
  std::cerr << "tolman: fewer than " << kFewest
            << " threads can be started; raise the limit of processes (`ulimit -u`)\n";
  return false;
}

/// run::kEndSignals end a command with the documented exit code; commands that conclude
/// their work first take the signals over (run::Interrupts). Ignored signals stay ignored (nohup).
void endOnSignals() {
  for (const int signal : tolman::run::kEndSignals) {
    const auto end = [](int) { tolman::app::endAtOnce(tolman::app::ExitCode::Interrupted); };
    if (std::signal(signal, end) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

/// Whether another process of this program has started this one, and reports how it ends.
bool isInternal(int argc, char** argv) {
  constexpr std::array<std::string_view, 3> kInternal = {"run-stage", "run-check", "probe-source"};
  if (tolman::isolation::ownMark().empty()) return false;
  return std::any_of(argv, argv + argc, [&](const char* word) {
    return std::ranges::find(kInternal, word) != kInternal.end();
  });
}

}  // namespace

int main(int argc, char** argv) {
  const bool internal = isInternal(argc, argv);
  constexpr int kNoRoom = static_cast<int>(tolman::app::ExitCode::Internal);
  if (!hasStack()) return kNoRoom;
  if (!hasThreads(internal)) return internal ? tolman::isolation::kNoThreadsExit : kNoRoom;
  limitFragmentation();
  repairInheritedState();
  if (!internal) endOnSignals();
  std::optional<tolman::app::TerminalOutput> terminal;
  if (::isatty(STDOUT_FILENO) == 1) terminal.emplace(std::cout);
  return tolman::app::runProgram(argc, argv);
}
