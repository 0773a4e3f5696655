// SPDX-License-Identifier: BSD-3-Clause
// Texts from files, plugins and names, made safe for a terminal.
#include <catch2/catch.hpp>

#include "engine/terminal.hpp"

using tolman::run::printable;

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
