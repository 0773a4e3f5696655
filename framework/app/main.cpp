// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <new>

#include "app/program.hpp"

namespace {

/// A closed pipe and a full disk are errors of the writes, not the end of the process. Closed
/// standard streams, whose numbers the next opened files would take, are opened again.
void prepareStreams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  int descriptor = 0;
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = ::open("/dev/null", O_RDONLY);
  if (descriptor >= 0) ::close(descriptor);
}

/// Saved states and tables of whole runs get their own pages, which return to the system when they
/// are freed. By default glibc raises this limit to the largest buffer freed so far, and long-lived
/// blocks between such buffers then double the memory growth of a run. Images are smaller: their
/// own pages would cost 5 ms a frame. Freed memory at the end of the heap is kept for the next
/// frame; the watchdog returns it.
void limitFragmentation() {
#ifdef __GLIBC__
  constexpr int kLargeBuffer = 4 << 20;  // bytes
  constexpr int kMaxKept = 256 << 20;    // bytes
  ::mallopt(M_MMAP_THRESHOLD, kLargeBuffer);
  ::mallopt(M_TRIM_THRESHOLD, kMaxKept);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  prepareStreams();
  limitFragmentation();
  try {
    return tolman::app::runProgram({argv, argv + argc});
  } catch (const std::bad_alloc&) {
    std::cerr << "tolman: out of memory\n";
    return static_cast<int>(tolman::app::ExitCode::Internal);
  }
}
