// SPDX-License-Identifier: BSD-3-Clause
#include "host/forked_child.hpp"

#include <unistd.h>

namespace tolman::host {

void endForkedChild(::pid_t caller, std::string_view call) noexcept {
  if (::getpid() == caller) return;
  // Locks that other threads held are never released in a child: no allocation, no stream.
  for (const std::string_view text :
       {std::string_view("tolman: "), call, std::string_view(": "),
        std::string_view("a child that the plugin forked has returned from the call; it is ended, "
                         "and the run goes on without it. End such a child with _exit()\n")}) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  }
  ::_exit(1);
}

}  // namespace tolman::host
