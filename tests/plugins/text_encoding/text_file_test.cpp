// SPDX-License-Identifier: BSD-3-Clause
// Text files as lines and fields, and times without rounding.
#include "base/text_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "support/data.hpp"
#include "tolman/context.hpp"

namespace tolman::text_encoding {

TEST_CASE("seconds become nanoseconds exactly") {
  CHECK(parseSeconds("0.000000e+00") == 0);
  CHECK(parseSeconds("1.044989e-01") == 104498900);
  CHECK(parseSeconds("4.706365e+02") == 470636500000);
  CHECK(parseSeconds("0.063") == 63000000);
  CHECK(parseSeconds("-.5") == -500000000);
  CHECK(parseSeconds("12.") == 12000000000);
  CHECK(parseSeconds("+1.5") == 1'500'000'000);
  CHECK(parseSeconds("1403636579.763555584") == 1403636579763555584);  // a double loses 256 ns
  CHECK(parseSeconds("1403715273262142976", 0) == 1403715273262142976);
  CHECK(parseSeconds("12.5", 6) == 12'500'000);
  SECTION("rounded half away from zero at the tenth digit, however many follow") {
    CHECK(parseSeconds("0.0000000004999999999999999999999") == 0);
    CHECK(parseSeconds("0.0000000005") == 1);
    CHECK(parseSeconds("-0.0000000005") == -1);
    CHECK(parseSeconds("1.0000000015") == 1000000002);
    CHECK(parseSeconds("5e-10") == 1);
    CHECK(parseSeconds("5e-11") == 0);
    CHECK(parseSeconds("1e-300") == 0);
  }
  SECTION("what is no time") {
    for (const char* text : {"", "-", ".", "e5", "1e", "1e+-2", "1.2.3", "1,5", "nan", "inf", "0x1",
                             "1s", "5e9", "1e999", "99999999999", "1e-400"}) {
      CAPTURE(text);
      CHECK(parseSeconds(text) == std::nullopt);
    }
  }
  RandomStream random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto ns = static_cast<std::int64_t>(random.below(std::uint64_t{1} << 61U));
    const std::string fraction = std::to_string(1'000'000'000 + ns % 1'000'000'000).substr(1);
    REQUIRE(parseSeconds(std::to_string(ns / 1'000'000'000) + "." + fraction) == ns);
    REQUIRE(parseSeconds(std::to_string(ns) + "e-9") == ns);
  }
}

TEST_CASE("lines keep their numbers, without blank ones, comments and line ends") {
  const auto lines = contentLines("# a\r\n1 2\r\n\n , ;\n3;4");
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].number == 2);
  CHECK(lines[0].text == "1 2");
  CHECK(lines[1].number == 5);
  CHECK(splitFields(lines[1].text) == std::vector<std::string_view>{"3", "4"});
  CHECK(splitFields(" a,\tb ;") == std::vector<std::string_view>{"a", "b"});
  CHECK(contentLines("").empty());
}

TEST_CASE("what is no text is named with the remedy") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "f.txt";
  const auto problemOf = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    const auto text = readText(file);
    return text.isOk() ? "" : text.status().message().substr(file.string().size());
  };
  CHECK(problemOf("1\n").empty());
  CHECK(problemOf(std::string("1\0\n\0002\0\n\0", 8)).starts_with(": has a zero byte in line 1"));
  CHECK(readText(folder.path() / "none")
            .status()
            .message()
            .ends_with(": is missing; restore it, or correct the path"));
  CHECK(readText(folder.path()).status().message().ends_with("correct the path"));
  std::ofstream(file, std::ios::binary) << "\xef\xbb\xbf"
                                        << "a";
  CHECK(readText(file).value() == "a");
  CHECK_FALSE(readText(file, 2).isOk());
}

}  // namespace tolman::text_encoding
