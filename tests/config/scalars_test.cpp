// SPDX-License-Identifier: BSD-3-Clause
// Which spellings are numbers and truth values, and which are refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "config/values.hpp"
#include "tolman/context.hpp"

namespace tolman {
namespace {

template <class T>
std::string message(const Result<T>& result) {
  return result.status().message();
}

}  // namespace

TEST_CASE("Integers are decimal digits with a sign") {
  CHECK(config::readInteger("0").value() == 0);
  CHECK(config::readInteger("+42").value() == 42);
  CHECK(config::readInteger("-7").value() == -7);
  CHECK(config::readInteger("9223372036854775807").value() ==
        std::numeric_limits<std::int64_t>::max());
  const std::string bad =
      GENERATE(as<std::string>(), "", " ", "-", "+", "+-1", "--1", "1 ", " 1", "0x10", "0b1",
               "1_000", "1,000", "1.5", "ten", "00", "010", "-010", "1e400", "nan");
  CAPTURE(bad);
  CHECK_FALSE(config::readInteger(bad).isOk());
}

TEST_CASE("Refused integers name the right spelling") {
  CHECK(message(config::readInteger("1e3")) == "expects an integer, not '1e3'; write 1000");
  CHECK(message(config::readInteger("2.0")) == "expects an integer, not '2.0'; write 2");
  CHECK(message(config::readInteger("010")) ==
        "expects an integer, not '010'; write it without leading zeros");
  CHECK(message(config::readInteger("9223372036854775808")) ==
        "expects an integer of at most 64 bits, not '9223372036854775808'");
}

TEST_CASE("Reals are finite decimal numbers") {
  CHECK(config::readReal("1").value() == 1.0);
  CHECK(config::readReal("+.5").value() == 0.5);
  CHECK(config::readReal("-2.5e-3").value() == -0.0025);
  CHECK(config::readReal("1E3").value() == 1000.0);
  CHECK(config::readReal("0.1").value() == 0.1);
  const std::string bad = GENERATE(as<std::string>(), "", ".", "e3", "1e", "0x1p3", "1.5m", "1,5",
                                   "01.5", "one", "1 2");
  CAPTURE(bad);
  CHECK(message(config::readReal(bad)).starts_with("expects a number, not '" + bad + "'"));
}

TEST_CASE("NaN and infinity in every spelling are refused as such") {
  const std::string bad =
      GENERATE(as<std::string>(), "nan", "NaN", "-nan", ".nan", ".NaN", ".NAN", "inf", "-inf",
               "infinity", ".inf", "-.inf", "+.inf", ".Inf", "-.INF", "1e999", "-1e999");
  CHECK(message(config::readReal(bad)) == "expects a finite number, not '" + bad + "'");
}

TEST_CASE("A number too small for a double is told as such, not as infinite") {
  for (const char* text : {"1e-400", "-1E-400", "+2.5e-999"}) {
    CHECK(message(config::readReal(text)) ==
          "expects 0 or a number of at least 1e-307, not '" + std::string(text) + "'; write 0");
  }
}

TEST_CASE("Only true and false are booleans") {
  CHECK(config::readBool("true").value());
  CHECK_FALSE(config::readBool("false").value());
  CHECK(message(config::readBool("Yes")) == "expects true or false, not 'Yes'; write true");
  CHECK(message(config::readBool("TRUE")) == "expects true or false, not 'TRUE'; write true");
  CHECK(message(config::readBool("off")) == "expects true or false, not 'off'; write false");
  CHECK(message(config::readBool("0")) == "expects true or false, not '0'; write false");
  CHECK(message(config::readBool("maybe")) == "expects true or false, not 'maybe'");
}

TEST_CASE("Written reals read back to the same bits") {
  CHECK(config::writeReal(2000) == "2000");
  CHECK(config::writeReal(1e6) == "1000000");
  CHECK(config::writeReal(0.085) == "0.085");
  CHECK(std::signbit(config::readReal(config::writeReal(-0.0)).value()));
  RandomStream random(3);
  for (int i = 0; i < 1000; ++i) {
    const double value =
        std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(600)) - 300);
    CHECK(config::readReal(config::writeReal(value)).value() == value);
  }
}

}  // namespace tolman
