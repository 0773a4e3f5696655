// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/child.hpp"

#include <catch2/catch.hpp>
#include <csignal>

using namespace tolman::conformance;

namespace {

/// Runs a shell script whose $0 is the descriptor of the report.
struct Shell {
  explicit Shell(const std::string& script, double timeout_s = 60)
      : end(runChild(
            [&](int descriptor) {
              return std::vector<std::string>{"/bin/bash", "-c", script,
                                              std::to_string(descriptor)};
            },
            timeout_s, [this](const std::string& line) { lines.push_back(line); })) {}
  std::vector<std::string> lines;
  ChildEnd end;
};

}  // namespace

TEST_CASE("lines of the report arrive one by one, the rest is output") {
  const Shell shell("echo one >&$0; echo two >&$0; echo noise; echo more noise >&2; exit 7");
  CHECK(shell.lines == std::vector<std::string>{"one", "two"});
  CHECK(shell.end.output == "noise\nmore noise\n");
  CHECK(shell.end.process.exit_code == 7);
  CHECK(shell.end.process.signal == 0);
  CHECK_FALSE(shell.end.timed_out);
}

TEST_CASE("lines written before a crash arrive") {
  const Shell shell("echo before >&$0; kill -SEGV $$; echo after >&$0");
  CHECK(shell.lines == std::vector<std::string>{"before"});
  CHECK(shell.end.process.signal == SIGSEGV);
}

TEST_CASE("a child that hangs and ignores signals is killed with its own children") {
  const Shell shell("trap '' TERM INT; sleep 600 & echo $! >&$0; sleep 600", 0.3);
  CHECK(shell.end.timed_out);
  REQUIRE(shell.lines.size() == 1);
  for (int i = 0; i < 100 && ::kill(std::stoi(shell.lines[0]), 0) == 0; ++i) {
    // It is orphaned and waits for init to reap it; a zombie still has its id.
    const Shell state("grep -c '^State:.Z' /proc/" + shell.lines[0] + "/status >&$0");
    if (state.lines == std::vector<std::string>{"1"}) return;
  }
  CHECK(::kill(std::stoi(shell.lines[0]), 0) != 0);
}

TEST_CASE("a grandchild that holds the report open does not delay the end") {
  const Shell shell("sleep 600 & exit 0", 30);
  CHECK_FALSE(shell.end.timed_out);
  CHECK(shell.end.process.exit_code == 0);
}

TEST_CASE("only the last 300 bytes of output are kept") {
  const Shell shell("for i in {1..20000}; do echo line $i of a long story; done");
  CHECK(shell.end.output.size() == 300);
  CHECK(shell.end.output.ends_with("line 20000 of a long story\n"));
}

TEST_CASE("a program that does not exist is an exception") {
  const auto command = [](int) { return std::vector<std::string>{"/nowhere/program"}; };
  CHECK_THROWS(runChild(command, 1, [](const auto&) {}));
}
