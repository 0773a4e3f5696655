// SPDX-License-Identifier: BSD-3-Clause
// Output on a terminal: without control sequences, in the same order, and errors stay errors.
#include "app/terminal_output.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

using tolman::app::TerminalOutput;

TEST_CASE("control sequences of names do not reach the terminal, also between two writes") {
  std::ostringstream terminal;
  {
    const TerminalOutput output(terminal);
    terminal << "runs/\x1b[31m"
             << "red\n"
             << "\xe2"
             << "\x82\xac" << 5;
    CHECK(terminal.str().empty() == false);
    terminal.flush();
    terminal << " end";
  }
  CHECK(terminal.str() == "runs/?[31mred\n\u20ac5 end");
  terminal << "\x1b";
  CHECK(terminal.str().back() == '\x1b');  // the stream is as before
}

TEST_CASE("a terminal that cannot be written is an error of the stream") {
  std::ofstream full("/dev/full");
  const TerminalOutput output(full);
  full << "text\n" << std::flush;
  CHECK(full.fail());
}
