// SPDX-License-Identifier: BSD-3-Clause
// Names as text and numbers, and the natural order.
#include "image_name.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "unicode_digits.hpp"

namespace tolman::image_folders {
namespace {

bool before(const char* a, const char* b, bool numeric = false) {
  return parseImageName(a, numeric).key < parseImageName(b, numeric).key;
}

bool alike(const char* a, const char* b, bool numeric = false) {
  return parseImageName(a, numeric).key == parseImageName(b, numeric).key;
}

}  // namespace

TEST_CASE("numbers in names count as numbers") {
  CHECK(naturalLess("image2", "image10"));
  CHECK_FALSE(naturalLess("image10", "image2"));
  CHECK(naturalLess("a9b10", "a10b1"));
  CHECK(naturalLess("07", "7"));  // equal numbers: any order, but always the same
  CHECK_FALSE(naturalLess("7", "07"));
  CHECK(naturalLess("a", "a1"));
  CHECK_FALSE(naturalLess("a", "a"));
  CHECK(naturalLess("99999999999999999999998", "99999999999999999999999"));  // no 64 bits
  CHECK(naturalLess("z", "\xc3\xa4"));  // bytes, also where char is signed
}

TEST_CASE("the natural order is total: sorting from any start gives one list") {
  std::vector<std::string> names = {"0",   "00", "1",   "01", "2",  "10",  "a",   "a0",
                                    "a00", "a1", "a1b", "b",  "b2", "b10", "b10a"};
  const std::vector<std::string> sorted = names;
  std::sort(names.begin(), names.end());
  do {
    std::vector<std::string> shuffled = names;
    std::sort(shuffled.begin(), shuffled.end(), naturalLess);
    REQUIRE(shuffled == std::vector<std::string>{"0", "00", "01", "1", "2", "10", "a", "a0", "a00",
                                                 "a1", "a1b", "b", "b2", "b10", "b10a"});
    std::rotate(names.begin(), names.begin() + 4, names.end());
  } while (!std::is_sorted(names.begin(), names.end()));
}

TEST_CASE("fractions have a point or a comma, between whole text or at the end") {
  CHECK(before("1.05", "1.1"));
  CHECK(before("frame_1.05", "frame_1.1"));
  CHECK(before("cam0_1,05_left", "cam0_1,1_left"));
  CHECK(before("9", "10.5"));
  CHECK(alike("1.1", "1.10"));
  CHECK(alike("01.50", "1.5"));
  CHECK(before("a.9", "a.10"));            // the point follows no digit
  CHECK(before("1.9.5", "1.10.5"));        // versions
  CHECK(before("12.9.30", "12.10.05"));    // times
  CHECK(before("12.5,3.05", "12.5,3.1"));  // two numbers
  CHECK(before("12,3.05", "12,3.1"));
  CHECK(before("1,2,3", "1,10,2"));
  CHECK(parseImageName("x1.2.3", false).has_version);
  CHECK_FALSE(parseImageName("x1.2_3.4", false).has_version);
}

TEST_CASE("a sign follows nothing but a separator") {
  CHECK(before("-2", "-1"));
  CHECK(before("-1.5", "-0.5"));
  CHECK(before("t_-2", "t_-1"));
  CHECK(before("-1", "+0"));
  CHECK(alike("-0", "0"));
  CHECK(before("cam-1", "cam-2"));
  CHECK(before("2024-01-02", "2024-01-03"));
  CHECK(before("a--1", "a--2"));
  CHECK(before("-", "-a"));
}

TEST_CASE("keys compare as the numbers, whatever follows") {
  const std::vector<std::string> numbers = {"-12000", "-1200", "-120",   "-13e-1", "-1.2",
                                            "-12e-1", "-0.12", "-0.012", "0",      "0.0",
                                            "0.011",  "0.11",  "0.1101", "1",      "1.001",
                                            "1.01",   "9",     "10",     "10.01",  "1e300"};
  for (const std::string& a : numbers) {
    for (const std::string& b : numbers) {
      const double difference = std::stod(a) - std::stod(b);
      INFO(a << " and " << b);
      CHECK(before(a.c_str(), b.c_str(), true) == (difference < 0));
      CHECK(alike(a.c_str(), b.c_str(), true) == (difference == 0));
      if ((a + b).find('e') != std::string::npos) continue;
      CHECK(before((a + " z").c_str(), (b + " a").c_str()) == (difference < 0));
      CHECK(before(("x_" + a).c_str(), ("x_" + b + "\xff").c_str()) == (difference <= 0));
    }
  }
  CHECK(before("1", "1a"));
  CHECK(before("-1", "-1a"));
  CHECK(before("-1!", "-1a"));
}

TEST_CASE("exponents belong to numbers that are the whole name, where names are numbers") {
  CHECK(before("2e1", "1e2", true));
  CHECK(before("1e2", "2e1", false));
  CHECK(before("a1e2", "a2e1", true));
  CHECK(before("a_1e-05s", "a_0.0001s"));  // with a sign it is one in every name
  CHECK(before("1e+1001", "1e+1002"));     // text: beyond the range
}

TEST_CASE("commas that may separate thousands are removed") {
  CHECK(withoutThousands("1,024") == "1024");
  CHECK(withoutThousands("a1,000,000.png") == "a1000000.png");
  for (const char* other : {"1,5", "1,0000", "1,00", ",100", "a,100", "1,", ""}) {
    CHECK(withoutThousands(other) == other);
  }
}

TEST_CASE("upper case, digits of other scripts and blanks at the ends make no difference") {
  CHECK(alike("IMG_1", "img_1"));
  CHECK(alike(" 1", "1 "));
  CHECK_FALSE(alike("a 1", "a1"));
  CHECK(alike("\xd9\xa1\xd9\xa2", "12"));            // Arabic
  CHECK(alike("\xef\xbc\x91\xef\xbc\x90", "10"));    // full width
  CHECK(alike("\xe0\xa5\xa7.\xe0\xa5\xab", "1.5"));  // Devanagari
  CHECK(withLatinDigits("\xef\xbc\x99") == "9");
  for (const char* other :
       {"\xef\xbc\x9a", "\xd9", "\xef\xbc", "\xff", "\xc3\xa4", "\xd9\x41", "\xf0\x9d\x9f\x8e"}) {
    CHECK(withLatinDigits(other) == other);  // no digits, or no UTF-8, or of mathematics
  }
  CHECK(withLatinDigits("").empty());
}

}  // namespace tolman::image_folders
