// SPDX-License-Identifier: BSD-3-Clause
// The order of file names with whole and with decimal numbers.
#include "name_order.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace tolman::image_folders {

TEST_CASE("numbers in names count as numbers") {
  CHECK(naturalLess("image2", "image10"));
  CHECK_FALSE(naturalLess("image10", "image2"));
  CHECK(naturalLess("a9b10", "a10b1"));
  CHECK(naturalLess("07", "7"));  // equal numbers: any order, but always the same
  CHECK_FALSE(naturalLess("7", "07"));
  CHECK(naturalLess("a", "a1"));
  CHECK_FALSE(naturalLess("a", "a"));
  CHECK(naturalLess("99999999999999999999998", "99999999999999999999999"));  // no 64 bits
}

TEST_CASE("the order is total: sorting from any start gives one list") {
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

TEST_CASE("decimal numbers are told from counts separated by points") {
  CHECK(areDecimals({"0.95", "1.0", "1.05", "1.1"}));
  CHECK(areDecimals({"cam_1", "cam_1.05", "cam_1.1"}));
  CHECK_FALSE(areDecimals({"1", "2", "10"}));               // no point: natural order is right
  CHECK_FALSE(areDecimals({"1.1", "1.2", "1.9", "1.10"}));  // 1.1 and 1.10 are two images
  CHECK_FALSE(areDecimals({"a1.05", "b1.1"}));
  CHECK_FALSE(areDecimals({"1.05.2", "1.1.3"}));
  CHECK_FALSE(areDecimals({"1.", "1.5"}));
  CHECK_FALSE(areDecimals({"1.5", "x"}));
  CHECK_FALSE(areDecimals({"1.5", "01.50"}));
  CHECK_FALSE(areDecimals({}));
}

TEST_CASE("decimal numbers are compared by value, as double precision has it") {
  for (int i = 0; i < 2000; i += 7) {
    for (int j = 0; j < 2000; j += 13) {
      const double a = i / 100.0;
      const double b = j / 10.0;
      const std::string name_a = "f" + std::to_string(i / 100) + "." +
                                 std::to_string(i % 100 / 10) + std::to_string(i % 10);
      const std::string name_b = "f" + std::to_string(j / 10) + "." + std::to_string(j % 10);
      REQUIRE(decimalLess(name_a, name_b) == (a < b));
      REQUIRE(decimalLess(name_b, name_a) == (b < a));
    }
  }
  CHECK(decimalLess("1403636579.76", "1403636579.763555527"));
  CHECK(decimalLess("9", "10.5"));
}

}  // namespace tolman::image_folders
