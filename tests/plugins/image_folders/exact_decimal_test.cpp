// SPDX-License-Identifier: BSD-3-Clause
// Numbers of any length as texts.
#include "exact_decimal.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace tolman::image_folders {
namespace {

ExactDecimal numberOf(const std::string& text) {
  const auto number = parseExactDecimal(text);
  INFO(text);
  REQUIRE(number);
  return *number;
}

}  // namespace

TEST_CASE("one number has one value, however it is written") {
  for (const char* text : {"12.5", "+12.5", "012.500", "1.25e1", "125E-1", "0.125e+2"}) {
    CHECK(numberOf(text) == numberOf("12.5"));
  }
  for (const char* text : {"0", "-0", "+0.00", "000", "0e7", ".0", "0."}) {
    CHECK(numberOf(text) == ExactDecimal{});
  }
}

TEST_CASE("other texts are no numbers") {
  for (const char* text : {"",       "-",       "+",   ".",   "e1",  "1e",      "1e+", "1e+-2",
                           "1e1001", "1e-1001", "--1", "+-1", "- 1", "1.2.3",   "1,5", "0x1f",
                           "1_000",  "nan",     "inf", "1 ",  " 1",  "\xd9\xa1"}) {
    INFO(text);
    CHECK_FALSE(parseExactDecimal(text));
  }
}

TEST_CASE("the order is that of the values, as double precision has it") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> thousandths(-30000, 30000);
  for (int i = 0; i < 20000; ++i) {
    const double a = thousandths(random) / 1000.0;
    const double b = thousandths(random) / 1000.0;
    char text_a[40];
    char text_b[40];
    std::snprintf(text_a, sizeof text_a, i % 2 == 0 ? "%.3f" : "%+.9g", a);
    std::snprintf(text_b, sizeof text_b, i % 3 == 0 ? "%.6e" : "%010.4f", b);
    INFO(text_a << " and " << text_b);
    REQUIRE((numberOf(text_a) < numberOf(text_b)) == (a < b));
    REQUIRE((numberOf(text_a) == numberOf(text_b)) == (a == b));
    REQUIRE((numberOf(text_a) > numberOf(text_b)) == (a > b));
  }
}

TEST_CASE("numbers beyond double precision are told apart") {
  const std::string nines(200, '9');
  CHECK(numberOf(nines + "8") < numberOf(nines + "9"));
  CHECK(numberOf("-" + nines + "9") < numberOf("-" + nines + "8"));
  CHECK(numberOf("1403636579." + nines + "1") < numberOf("1403636579." + nines + "2"));
  CHECK(numberOf("1e-1000") < numberOf("1e1000"));
  CHECK(ExactDecimal{} < numberOf("1e-1000"));
  CHECK(numberOf("-1e-1000") < ExactDecimal{});
}

}  // namespace tolman::image_folders
