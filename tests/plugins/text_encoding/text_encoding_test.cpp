// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "base/text_file.hpp"

namespace tolman::text_encoding {
namespace {

const std::string kText = "# timestamp filename\n1305031102.175304 rgb/1305031102.175304.png\n";

}  // namespace

TEST_CASE("UTF-16 is recognised by its mark") {
  CHECK(encodingProblem("\xFF\xFE") == "is UTF-16; save it as UTF-8");
  CHECK(encodingProblem("\xFE\xFF" + kText) == "is UTF-16; save it as UTF-8");
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

TEST_CASE("a zero byte is reported with its line") {
  std::string text = kText + kText;
  text[kText.size() + 30] = '\0';
  CHECK(encodingProblem(text) ==
        "has a zero byte in line 4: it is UTF-16, damaged or no text; save it as UTF-8");
  CHECK(encodingProblem(std::string(1, '\0')).starts_with("has a zero byte in line 1"));
}

}  // namespace tolman::text_encoding
