// SPDX-License-Identifier: BSD-3-Clause
// Lines, fields and numbers. Times are compared with values by hand and with printed integers.
#include "text_file.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "tolman/context.hpp"

namespace tolman::image_folders {

TEST_CASE("seconds become nanoseconds exactly") {
  CHECK(parseSeconds("0.000000e+00") == 0);
  CHECK(parseSeconds("1.044989e-01") == 104498900);
  CHECK(parseSeconds("1.037875e-01") == 103787500);  // not "1.0", not 0.0037875
  CHECK(parseSeconds("4.706365e+02") == 470636500000);
  CHECK(parseSeconds("0.063") == 63000000);
  CHECK(parseSeconds("-.5") == -500000000);
  CHECK(parseSeconds("12.") == 12000000000);
  CHECK(parseSeconds("1403636579.763555584") == 1403636579763555584);  // a double loses 256 ns
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
                             "1s", "5e9", "1e999", "99999999999", "1e99999999999999999999"}) {
      CAPTURE(text);
      CHECK(parseSeconds(text) == std::nullopt);
    }
  }
}

TEST_CASE("a file cut within its last field is an error, one without a last line end is not") {
  const DataFolder data;
  const auto lines = [&](const std::string& text) {
    data.write("times.txt", text);
    Inspection inspection;
    return readLines(data.path("times.txt"), inspection).size();
  };
  CHECK(lines("0.000000e+00\n1.036224e-01\n2.072449e-01") == 3);
  CHECK(lines("0.000000e+00\n1.036224e-01\n2.072449e-0") == 0);
  CHECK(lines("0.000000e+00\n1.036224e-01\n2.072449e-0\n") == 3);
  CHECK(lines("1403636579763555584\n1403636579813555456\n140363657986355532") == 0);
  CHECK(lines("8\n9\n10") == 3);
  CHECK(lines("100 7") == 1);
}

TEST_CASE("exponents that no time has are refused, also the least of an int") {
  for (const char* text : {"0.001e-2147483648", "1e-2147483648", "1e2147483647", "0e99999999999"}) {
    CAPTURE(text);
    CHECK_FALSE(parseSeconds(text));
  }
}

TEST_CASE("any whole number of nanoseconds survives printing and reading") {
  RandomStream random(7);
  for (int i = 0; i < 2000; ++i) {
    const auto ns = static_cast<std::int64_t>(random.below(std::uint64_t{1} << (1 + i % 62)));
    const std::string fraction = std::to_string(1'000'000'000 + ns % 1'000'000'000).substr(1);
    CAPTURE(ns);
    REQUIRE(parseSeconds(std::to_string(ns / 1'000'000'000) + "." + fraction) == ns);
    REQUIRE(parseSeconds(std::to_string(ns) + "e-9") == ns);
  }
}

TEST_CASE("a byte order mark before the first line is no part of it, and elsewhere garbage") {
  const DataFolder data;
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string& text :
       {mark + "P0: 1\nb\n", mark + "# note\nP0: 1\r\nb", mark + "\n\nP0: 1\nb\n"}) {
    data.write("f.txt", text);
    Inspection inspection;
    const auto lines = readLines(data.path("f.txt"), inspection);
    CHECK_FALSE(inspection.hasErrors());
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].text == "P0: 1");
    CHECK(lines[1].text == "b");
  }
  data.write("f.txt", "a\n" + mark + "b\n");
  Inspection inspection;
  CHECK(readLines(data.path("f.txt"), inspection)[1].text == mark + "b");
  data.write("f.txt", mark);
  readLines(data.path("f.txt"), inspection);
  CHECK(data.anonymous(inspection.status().message()) == "DATA/f.txt: is empty; restore it");
}

TEST_CASE("a time that no double holds is no time, a small one is rounded") {
  CHECK(parseSeconds("1e-400") == std::nullopt);
  CHECK(parseSeconds("1e-12") == 0);
  CHECK(parseSeconds("+1.5") == 1'500'000'000);
}

TEST_CASE("numbers fill their field and are finite") {
  CHECK(parseNumber("-3.798145000000e+02") == -379.8145);
  CHECK(parseNumber("+1.5") == 1.5);
  CHECK(parseNumber("1e-400") == std::nullopt);  // not silently 0
  CHECK(parseNumber("+") == std::nullopt);
  for (const char* text : {"", "nan", "inf", "-inf", "1e999", "1.0x", "+-1", "one"}) {
    CAPTURE(text);
    CHECK(parseNumber(text) == std::nullopt);
  }
}

TEST_CASE("fields and what a message shows of them") {
  CHECK(splitFields(" a, b;c\td\r") == std::vector<std::string_view>{"a", "b", "c", "d"});
  CHECK(splitFields("  ").empty());
  CHECK(inQuotes("abc") == "'abc'");
  CHECK(inQuotes(std::string("a\0\x1b[31m", 7)) == "'a??[31m'");
  CHECK(inQuotes(std::string(100, 'x')) == "'" + std::string(24, 'x') + "...'");
}

TEST_CASE("lines keep their numbers when blanks and comments are left out") {
  const DataFolder data;
  data.write("a.txt", "one\r\n\n# comment\n  \ntwo");
  Inspection inspection;
  const std::vector<TextLine> lines = readLines(data.path("a.txt"), inspection);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].text == "one");
  CHECK(lines[1].number == 5);
  CHECK_FALSE(inspection.hasErrors());
}

TEST_CASE("a file that says nothing is an error") {
  const DataFolder data;
  const auto failure = [&](const std::string& name) {
    Inspection inspection;
    CHECK(readLines(data.path(name), inspection).empty());
    return data.anonymous(inspection.status().message());
  };
  data.write("blank.txt", "\n\n");
  CHECK(failure("blank.txt") == "DATA/blank.txt: is empty; restore it");
  CHECK(failure("none.txt") == "DATA/none.txt: is missing; restore it, or correct the path");
  CHECK(failure("image_0") == "DATA/image_0: is no regular file; put a text file in its place");
  std::filesystem::create_symlink("loop.txt", data.path("loop.txt"));
  CHECK(failure("loop.txt") ==
        "DATA/loop.txt: Too many levels of symbolic links; put a text file in its place");
}

TEST_CASE("garbage is not listed without end") {
  Inspection inspection;
  for (int line = 1; line <= 1000; ++line) inspection.error("a", line, "bad");
  inspection.error("b", "bad");
  REQUIRE(inspection.findings().size() == 22);
  CHECK(inspection.findings()[19].where == "a:20");
  CHECK(inspection.findings()[20].message == "has more problems; they are not listed");
  CHECK(inspection.findings()[21].where == "b");
  CHECK(inspection.status().message() ==
        "a:1: bad (and 21 more problems; `tolman dataset check` lists all)");
}

}  // namespace tolman::image_folders
