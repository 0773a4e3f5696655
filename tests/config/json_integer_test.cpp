// SPDX-License-Identifier: BSD-3-Clause
// Integers in JSON are read exactly, or refused.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "config/json_text.hpp"

using nlohmann::json;
using tolman::config::integerFrom;

TEST_CASE("integers within their type") {
  CHECK(integerFrom<std::int64_t>(json::parse("-3")) == -3);
  CHECK(integerFrom<std::int64_t>(json::parse("9223372036854775807")) == INT64_MAX);
  CHECK(integerFrom<std::uint64_t>(json::parse("18446744073709551615")) == UINT64_MAX);
  CHECK(integerFrom<std::uint8_t>(json::parse("255")) == 255);
}

TEST_CASE("all else is refused, also numbers that would be cut off") {
  for (const char* text : {"1e300", "1.0", "9223372036854775808", "\"3\"", "null", "true", "[3]"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(integerFrom<std::int64_t>(json::parse(text)), json::type_error);
  }
  CHECK_THROWS_AS(integerFrom<std::uint8_t>(json::parse("256")), json::type_error);
  CHECK_THROWS_AS(integerFrom<std::uint64_t>(json::parse("-1")), json::type_error);
}
