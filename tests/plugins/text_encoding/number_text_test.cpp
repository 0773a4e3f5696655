// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <limits>

#include "base/text_file.hpp"

namespace tolman::text_encoding {

TEST_CASE("numbers of all readers: with and without signs, zero only if it is written so") {
  CHECK(parseNumber("1.5") == 1.5);
  CHECK(parseNumber("+1.5e3") == 1500);
  CHECK(parseNumber("-0.25") == -0.25);
  CHECK(parseNumber("0e-999") == 0);
  CHECK(parseNumber("5e-324") == std::numeric_limits<double>::denorm_min());
  for (const char* word : {"1e-400", "+1e-400", "-1e-400", "0.5e-330", "1e400", "-1e999", "", "+",
                           "+-1", "--1", "nan", "-inf", "1.0x", " 1", "0x10", "1,5"}) {
    INFO(word);
    CHECK_FALSE(parseNumber(word));
  }
}

TEST_CASE("the reason says which end of the range a number is beyond") {
  CHECK(numberProblem("1e-400") == "is too small for a double (write 0)");
  CHECK(numberProblem("+1e-400") == "is too small for a double (write 0)");
  CHECK(numberProblem("-1e400") == "is too large for a double");
  CHECK(numberProblem("nan") == "is no finite number");
  CHECK(numberProblem("1.0x") == "is no finite number");
}

}  // namespace tolman::text_encoding
