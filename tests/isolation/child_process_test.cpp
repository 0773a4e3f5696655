// SPDX-License-Identifier: BSD-3-Clause
#include "host/child_process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

using namespace tolman::host;
using std::chrono::milliseconds;

namespace {

struct Pipe {
  Pipe() { REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0); }
  ~Pipe() {
    for (const int end : ends) ::close(end);
  }
  std::array<int, 2> ends{};
};

ProcessEnd endOf(const std::string& script) {
  ChildProcess child({"/bin/sh", "-c", script}, {});
  return child.end(milliseconds(10'000));
}

/// Gone, or a zombie that waits for init.
bool isDead(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("State:")) return line.find('Z') != std::string::npos;
  }
  return true;
}

}  // namespace

TEST_CASE("the end of a process is described by signal or exit code") {
  CHECK(endOf("exit 3").text() == "exited with code 3");
  CHECK(endOf("kill -SEGV $$").text() == "died of SIGSEGV (Segmentation fault)");
  CHECK(signalName(SIGKILL) == "SIGKILL (Killed)");
  CHECK(signalName(999) == "signal 999");
}

TEST_CASE("descriptors are passed with their numbers; others are closed") {
  const Pipe passed;
  const Pipe kept;
  const std::string to = std::to_string(passed.ends[1]);
  ChildProcess child({"/bin/sh", "-c",
                      "if [ -e /proc/self/fd/" + std::to_string(kept.ends[1]) +
                          " ]; then echo leak >&" + to + "; else echo fine >&" + to + "; fi"},
                     {passed.ends[1]});
  std::array<char, 5> text{};
  REQUIRE(::read(passed.ends[0], text.data(), 4) == 4);
  CHECK(std::string(text.data()) == "fine");
  CHECK(child.end(milliseconds(10'000)).exit_code == 0);
}

TEST_CASE("after the timeout the process and all of its group are killed") {
  const Pipe pipe;
  const std::string to = std::to_string(pipe.ends[1]);
  ChildProcess child(
      {"/bin/sh", "-c",
       "trap '' TERM; sh -c 'echo $$ >&" + to + "; exec sleep 600' & sleep 600; exit 0"},
      {pipe.ends[1]});
  std::array<char, 16> text{};
  REQUIRE(::read(pipe.ends[0], text.data(), text.size() - 1) > 0);
  const auto grandchild = static_cast<pid_t>(std::stoi(text.data()));
  CHECK_FALSE(isDead(grandchild));
  CHECK(child.end(milliseconds(10)).signal == SIGKILL);
  for (int i = 0; i < 1000 && !isDead(grandchild); ++i) {
    std::this_thread::sleep_for(milliseconds(10));
  }
  CHECK(isDead(grandchild));
}

TEST_CASE("a program that does not exist is an error") {
  CHECK_THROWS_AS(ChildProcess({"/no/such/program"}, {}), std::system_error);
}
