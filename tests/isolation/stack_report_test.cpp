// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <string>
#include <thread>

#include "host/channel.hpp"

using tolman::host::ChildProcess;
using tolman::host::placeInStack;
using tolman::host::StackReport;

namespace {

constexpr const char* kProgram = "/home/me/cells/mine.py";

void write(const StackReport& report, const std::string& text) {
  CHECK(::write(report.descriptor(), text.data(), text.size()) ==
        static_cast<ssize_t>(text.size()));
}

}  // namespace

TEST_CASE("the place of a stack is the innermost call in the program's own files") {
  const std::string stack =
      "Current thread 0x00007f (most recent call first):\n"
      "  File \"/usr/lib/python3.11/socket.py\", line 706 in readinto\n"
      "  File \"/home/me/cells/venv/lib/site-packages/net.py\", line 3 in get\n"
      "  File \"/home/me/cells/parts/table.py\", line 12 in read\n"
      "  File \"/home/me/cells/mine.py\", line 4 in <module>\n"
      "  File \"<frozen importlib._bootstrap>\", line 241 in _call_with_frames_removed\n";
  CHECK(placeInStack(stack, kProgram) == "table.py:12, in read");
  CHECK(placeInStack(stack, "/home/other/mine.py").empty());
}

TEST_CASE("a stack that is no stack, or is cut, has no place") {
  CHECK(placeInStack("", kProgram).empty());
  CHECK(placeInStack("  File \"/home/me/cells/mine.py", kProgram).empty());
  CHECK(placeInStack("  File \"/home/me/cells/mine.py\", line 4", kProgram).empty());
  CHECK(placeInStack("  File \", line 4 in f", kProgram).empty());
  CHECK(placeInStack("\xff\0\x01 line", kProgram).empty());
}

TEST_CASE("control characters in a stack are not passed on") {
  CHECK(placeInStack("  File \"/home/me/cells/a\x1b[2J.py\", line 4 in f\n", kProgram) ==
        "a\xef\xbf\xbd[2J.py:4, in f");
}

TEST_CASE("a process that does not take part is not asked: the signal would end it") {
  const StackReport report;
  ChildProcess child({"/bin/sh", "-c", "sleep 60"}, {});
  CHECK(report.ask(child, kProgram).empty());
  CHECK_FALSE(child.hasEnded());
}

TEST_CASE("a process that takes part is asked by the signal") {
  const StackReport report;
  const std::string number = std::to_string(report.descriptor());
  const std::string line = R"(  File \"/home/me/cells/mine.py\", line 7 in step)";
  ChildProcess child({"/bin/sh", "-c",
                      "trap 'echo \"" + line + "\" >&" + number + "' USR2; echo set >&" + number +
                          "; while :; do sleep 0.01; done"},
                     {report.descriptor()});
  std::string found;
  for (int i = 0; found.empty() && i < 1000; ++i) {  // it is not asked before it has written "set"
    found = report.ask(child, kProgram);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  CHECK(found == "mine.py:7, in step");
}

TEST_CASE("the stack of a process that died") {
  const StackReport report;
  CHECK(report.left(kProgram).empty());
  write(report,
        "ready\nFatal Python error: Aborted\n\nCurrent thread (most recent call first):\n"
        "  File \"/home/me/cells/mine.py\", line 2 in <module>\n");
  CHECK(report.left(kProgram) == "mine.py:2, in <module>");
  CHECK(report.left("").empty());
}
