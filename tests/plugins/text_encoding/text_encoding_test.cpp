// SPDX-License-Identifier: BSD-3-Clause
#include "base/text_encoding.hpp"

#include <catch2/catch.hpp>

namespace tolman::text_encoding {
namespace {

const std::string kText = "# timestamp filename\n1305031102.175304 rgb/1305031102.175304.png\n";

/// ASCII in characters of `bytes` bytes.
std::string widened(const std::string& text, std::size_t bytes, bool big_endian) {
  std::string wide;
  for (const char c : text) {
    std::string character(bytes, '\0');
    character[big_endian ? bytes - 1 : 0] = c;
    wide += character;
  }
  return wide;
}

}  // namespace

TEST_CASE("UTF-16 and UTF-32 are recognised, with a byte order mark and without") {
  using namespace std::string_literals;
  for (const bool big : {false, true}) {
    CAPTURE(big);
    const std::string two = widened(kText, 2, big);
    const std::string four = widened(kText, 4, big);
    const std::string mark2 = big ? "\xFE\xFF"s : "\xFF\xFE"s;
    const std::string mark4 = big ? "\0\0\xFE\xFF"s : "\xFF\xFE\0\0"s;
    CHECK(encodingProblem(two) == "is UTF-16; save it as UTF-8");
    CHECK(encodingProblem(mark2 + two) == "is UTF-16; save it as UTF-8");
    CHECK(encodingProblem(four) == "is UTF-32; save it as UTF-8");
    CHECK(encodingProblem(mark4 + four) == "is UTF-32; save it as UTF-8");
    CHECK(encodingProblem(mark2) == "is UTF-16; save it as UTF-8");
  }
}

TEST_CASE("sound text has no problem, also other characters and a mark of UTF-8") {
  CHECK(encodingProblem("").empty());
  CHECK(encodingProblem("1").empty());
  CHECK(encodingProblem(kText).empty());
  CHECK(encodingProblem("\xEF\xBB\xBF" + kText).empty());
  CHECK(encodingProblem("# gr\xC3\xBC\xC3\x9F" + kText).empty());
  CHECK(withoutMark("\xEF\xBB\xBF"
                    "a") == "a");
  CHECK(withoutMark("a") == "a");
}

TEST_CASE("zero bytes are told by their line; a hole of them is no encoding") {
  std::string text = kText + kText;
  text[kText.size() + 30] = '\0';
  CHECK(encodingProblem(text) ==
        "has a zero byte in line 4, so it is damaged or no text; restore it");
  CHECK(encodingProblem(std::string(4096, '\0')).starts_with("has a zero byte in line 1"));
  CHECK(encodingProblem(kText + std::string(4096, '\0')).starts_with("has a zero byte in line 3"));
  CHECK(encodingProblem(std::string(1, '\0')).starts_with("has a zero byte in line 1"));
}

}  // namespace tolman::text_encoding
