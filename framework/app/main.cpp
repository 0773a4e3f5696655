// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "app/program.hpp"

namespace {

/// What a careless parent left: closed standard streams, whose numbers the next files would take,
/// and ignored children, of whose ends nobody would hear.
void tidyInheritance() {
  int descriptor = 0;
  do {
    descriptor = ::open("/dev/null", O_RDWR);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) ::close(descriptor);
  std::signal(SIGCHLD, SIG_DFL);
}

}  // namespace

int main(int argc, char** argv) {
  tidyInheritance();
  return tolman::app::runProgram(argc, argv);
}
