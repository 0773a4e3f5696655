// SPDX-License-Identifier: BSD-3-Clause
#include "tolman/parameters.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace tolman;

namespace {

enum class Colour : std::uint8_t { Red, Green };
constexpr std::array<std::string_view, 2> kColourNames = {"red", "green"};
constexpr std::span<const std::string_view> enumNames(Colour) { return kColourNames; }

struct Everything {
  bool flag = true;
  int count = 3;
  std::int64_t big = 1LL << 40;
  double ratio = 0.5;
  std::string text = "hello";
  std::string file;
  Colour colour = Colour::Green;
  std::vector<double> list = {1, 2};

  static constexpr auto declaration() {
    using P = Everything;
    return parameters(parameter("flag", &P::flag).doc("A flag."),
                      parameter("count", &P::count).range(1, 9).unit("px").doc("A count."),
                      parameter("big", &P::big), parameter("ratio", &P::ratio).range(0, 1),
                      parameter("text", &P::text), parameter("file", &P::file).path().required(),
                      parameter("colour", &P::colour), parameter("list", &P::list));
  }
};

/// The same but for one bound.
struct OtherRange {
  int count = 3;
  static constexpr auto declaration() {
    return parameters(parameter("count", &OtherRange::count).range(1, 10).unit("px"));
  }
};
struct SomeRange {
  int count = 4;
  static constexpr auto declaration() {
    return parameters(parameter("count", &SomeRange::count).range(1, 9).unit("px"));
  }
};
struct SomeRangeAgain {
  int count = 7;  // another default: the same configurations are legal
  static constexpr auto declaration() {
    return parameters(parameter("count", &SomeRangeAgain::count).range(1, 9).unit("px").doc("x"));
  }
};

}  // namespace

TEST_CASE("the schema tells names, types, defaults, limits and choices") {
  const Schema schema = schemaOf<Everything>();
  REQUIRE(schema.size() == 8);
  CHECK(schema[0].type == ParameterType::Bool);
  CHECK(std::get<bool>(schema[0].default_value));
  CHECK(schema[1].type == ParameterType::Integer);
  CHECK(schema[1].min == 1);
  CHECK(schema[1].max == 9);
  CHECK(schema[1].unit == "px");
  CHECK(schema[1].doc == "A count.");
  CHECK(std::get<std::int64_t>(schema[2].default_value) == 1LL << 40);
  CHECK(schema[3].type == ParameterType::Real);
  CHECK(schema[4].type == ParameterType::Text);
  CHECK(schema[5].type == ParameterType::Path);
  CHECK(schema[5].required);
  CHECK(schema[6].type == ParameterType::Choice);
  CHECK(schema[6].choices == std::vector<std::string>{"red", "green"});
  CHECK(std::get<std::string>(schema[6].default_value) == "green");
  CHECK(std::get<std::vector<double>>(schema[7].default_value) == std::vector<double>{1, 2});
}

TEST_CASE("an int without a range has that of int, so that nothing is cut off") {
  struct Plain {
    int count = 0;
    static constexpr auto declaration() { return parameters(parameter("count", &Plain::count)); }
  };
  CHECK(schemaOf<Plain>()[0].max == std::numeric_limits<int>::max());
  CHECK(schemaOf<Plain>()[0].min == std::numeric_limits<int>::min());
}

TEST_CASE("binding fills what is given and keeps the other defaults") {
  const auto bound = bindParameters<Everything>(
      {{"count", std::int64_t{7}}, {"colour", std::string("red")}, {"ratio", 0.25}});
  REQUIRE(bound.isOk());
  CHECK(bound.value().count == 7);
  CHECK(bound.value().colour == Colour::Red);
  CHECK(bound.value().ratio == 0.25);
  CHECK(bound.value().text == "hello");
}

TEST_CASE("binding a wrong type or an unknown choice names the parameter") {
  CHECK(bindParameters<Everything>({{"ratio", std::string("much")}}).status().message() ==
        "parameter 'ratio' has a wrong type");
  CHECK_FALSE(bindParameters<Everything>({{"colour", std::string("blue")}}).isOk());
}

TEST_CASE("the schema hash changes with what is legal, and with nothing else") {
  static_assert(schemaHash<SomeRange>() == schemaHash<SomeRangeAgain>());
  static_assert(schemaHash<SomeRange>() != schemaHash<OtherRange>());
  static_assert(schemaHash<NoParameters>() != schemaHash<SomeRange>());
  CHECK(schemaOf<NoParameters>().empty());
}
