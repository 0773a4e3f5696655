// SPDX-License-Identifier: BSD-3-Clause
// Short names of runs, and texts from files, plugins and names, made safe for a terminal.
#include <catch2/catch.hpp>

#include "engine/results.hpp"
#include "engine/services.hpp"

using tolman::engine::distinctNames;
using tolman::engine::printable;
using Names = std::vector<std::string>;
TEST_CASE("runs have the names of their directories") {
  CHECK(distinctNames({"runs/demo"}) == Names{"demo"});
  CHECK(distinctNames({"", "runs/demo"}) == Names{"", "demo"});  // refused where it is opened
  CHECK(distinctNames({"runs/demo/", "runs/other/."}) == Names{"demo", "other"});
}

TEST_CASE("what all paths end with tells nothing, as run/ of the points of a sweep") {
  CHECK(distinctNames({"sweeps/s/p1/run", "sweeps/s/p2/run", "sweeps/s/p3/run"}) ==
        Names{"p1", "p2", "p3"});
}

TEST_CASE("equal names get the folders above") {
  CHECK(distinctNames({"/a/x/demo", "/b/x/demo", "/c/x/other"}) ==
        Names{"a-x-demo", "b-x-demo", "c-x-other"});
  CHECK(distinctNames({"/demo", "/b/demo"}) == Names{"demo", "b-demo"});
}

TEST_CASE("a directory that is given twice gets a number") {
  CHECK(distinctNames({"runs/demo", "runs/demo"}) == Names{"demo", "demo-2"});
  CHECK(distinctNames({"runs/demo", "runs/b", "runs/demo"}) == Names{"demo", "b", "demo-2"});
}

TEST_CASE("words of every language, lines and tabs are printable") {
  for (const char* text : {"", "plain text", "Stra\u00dfe \u96ea \U0001f600", "a\n\tb\n"}) {
    CHECK(printable(text) == text);
  }
}

TEST_CASE("control characters are not printable, one byte or two") {
  CHECK(printable("a\x1b[31mb\rc\x7f\a") == "a?[31mb?c??");
  CHECK(printable("\u009b31m\u0080\u00a0") == "?31m?\u00a0");
  CHECK(printable(std::string("a\0b", 3)) == "a?b");
}

TEST_CASE("bytes that are no UTF-8 are not printable, also at the end") {
  CHECK(printable("a\x80\xff\xc1\xbfz") == "a????z");
  CHECK(printable("\xe2\x82") == "??");
  CHECK(printable("\xe2\x82\xac") == "\u20ac");
  CHECK(printable("\xe2z\xac") == "?z?");
}
