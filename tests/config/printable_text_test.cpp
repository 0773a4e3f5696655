// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "config/text.hpp"

using namespace tolman::config;

TEST_CASE("text of any script is printable") {
  for (const char* text : {"", "a b~", "\xc3\xa4", "\xe4\xb8\xad", "\xf0\x9f\x90\xad"}) {
    CHECK(isPrintable(text));
    CHECK(printable(text) == text);
  }
}

TEST_CASE("control characters and damaged UTF-8 are not") {
  for (const std::string& text : {
           std::string("\0", 1), std::string("\x1b"), std::string("\x7f"),
           std::string("\xc2\x9b"),          // U+009B, a control character of terminals
           std::string("\xff"),              // no byte of UTF-8
           std::string("\x80"),              // continues nothing
           std::string("\xc3"),              // cut
           std::string("\xc3("),             // cut by another character
           std::string("\xc0\x80"),          // U+0000, too long
           std::string("\xe0\x82\xa9"),      // U+00A9, too long
           std::string("\xf0\x82\x82\xac"),  // U+20AC, too long
           std::string("\xed\xa0\x80"),      // a surrogate
           std::string("\xef\xbf\xbf"),      // U+FFFF
           std::string("\xf4\x90\x80\x80"),  // U+110000
       }) {
    INFO(Catch::rangeToString(text));
    CHECK_FALSE(isPrintable("a" + text + "b"));
    CHECK(isPrintable(printable("a" + text + "b")));
  }
}

TEST_CASE("control characters, and bytes that are no UTF-8, are replaced one by one; lines stay") {
  CHECK(printable("\xc2\x9bm\xe2\x82", "?") == "?m??");
  CHECK(printable("a\n\tb") == "a\n\tb");
  CHECK_FALSE(isPrintable("a\nb"));
  CHECK(printable("\x1b[31m\xff\xc3\xa4") == "\xef\xbf\xbd[31m\xef\xbf\xbd\xc3\xa4");
}
