// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "experiment/averaging.hpp"

namespace tolman::experiment {
namespace {

RunRow labelled(const std::string& name, const std::string& x, const std::string& y) {
  RunRow row;
  row.name = name;
  row.factors = {{"x", x}, {"y", y}};
  return row;
}

}  // namespace

TEST_CASE("labels with commas do not bring two levels into one row") {
  const RunRow first = labelled("first", "1, 2", "3");
  const RunRow second = labelled("second", "1", "2, 3");
  CHECK(LevelNames::nameOf(first, {"x", "y"}) == "1, 2, 3");
  CHECK(LevelNames::nameOf(second, {"y"}) == "2, 3");
  LevelNames names;
  CHECK(names.add(first, {"x", "y"}).isOk());
  CHECK(names.add(first, {"x", "y"}).isOk());
  CHECK(names.add(second, {"x", "y"}).message() ==
        "'first' and 'second' differ in x, but both would be in the row '1, 2, 3'; rename a label, "
        "or compare by one factor at a time");
}

}  // namespace tolman::experiment
