// SPDX-License-Identifier: BSD-3-Clause
// A lack of memory that no caller can catch ends the program with a sentence.
#include "app/out_of_memory_end.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>

using tolman::app::OutOfMemoryEnd;

namespace {

struct ChildEnd {
  int status = 0;    ///< of waitpid()
  std::string said;  ///< on stderr
};

ChildEnd endOf(const std::function<void()>& work) {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    std::signal(SIGABRT, SIG_DFL);  // not that of the test's framework
    const OutOfMemoryEnd without_signal;
    [&]() noexcept { work(); }();  // as an initialiser or destructor of a library
    ::_exit(0);
  }
  ::close(ends[1]);
  ChildEnd end;
  std::array<char, 256> bytes{};
  for (ssize_t n = 0; (n = ::read(ends[0], bytes.data(), bytes.size())) > 0;) {
    end.said.append(bytes.data(), static_cast<std::size_t>(n));
  }
  ::close(ends[0]);
  REQUIRE(::waitpid(child, &end.status, 0) == child);
  return end;
}

}  // namespace

TEST_CASE("a lack of memory that cannot be caught ends with exit code 70, other exceptions abort") {
  const ChildEnd short_of_memory = endOf([] { throw std::bad_alloc(); });
  REQUIRE(WIFEXITED(short_of_memory.status));
  CHECK(WEXITSTATUS(short_of_memory.status) == 70);
  CHECK(short_of_memory.said ==
        "tolman: out of memory; give it more (`ulimit -v`), or less to do\n");
  const ChildEnd other = endOf([] { throw std::runtime_error("a defect"); });
  CHECK(WIFSIGNALED(other.status));
  const ChildEnd none = endOf([] { std::terminate(); });
  CHECK(WIFSIGNALED(none.status));
  CHECK(endOf([] {}).status == 0);
}
