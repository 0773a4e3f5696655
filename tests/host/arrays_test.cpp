// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <cmath>

#include "host/values.hpp"

using namespace tolman;
using namespace tolman::host;

namespace {

std::string message(const std::vector<NamedArray>& arrays) { return checkArrays(arrays).message(); }

std::string nameMessage(const std::string& name) { return message({{name, {1}, {1}}}); }

}  // namespace

TEST_CASE("arrays have finite values in the number of their shape") {
  CHECK(message({{"a", {2}, {1, 2}}, {"b", {}, {1}}, {"c", {0, 7}, {}}}).empty());
  CHECK(message({{"a", {1}, {std::nanf("")}}}) ==
        "array 'a' has NaN, infinity or a number beyond 3.4e38, the largest of 32 bits");
  const std::string unfit = "array 'a' has a size that differs from its shape";
  CHECK(message({{"a", {2}, {1}}}) == unfit);
  CHECK(message({{"a", {-3}, {}}}) == unfit);
  CHECK(message({{"a", {1 << 16, 1 << 16, 1 << 16, 1 << 16}, {}}}) == unfit);  // 2^64
}

TEST_CASE("names of arrays are printable, short and not repeated") {
  CHECK(nameMessage("hd.activity").empty());
  CHECK(nameMessage("Zellen \xc3\xa4, \xe4\xb8\xad").empty());
  CHECK(nameMessage("") ==
        "the array name '' is not of 1 to 100 bytes of UTF-8 without control characters");
  CHECK(nameMessage("a\033[31m").starts_with("the array name 'a\xef\xbf\xbd[31m' is not"));
  CHECK_FALSE(nameMessage("\xff\xfe").empty());
  CHECK_FALSE(nameMessage(std::string(101, 'a')).empty());
  CHECK(message({{"a", {1}, {1}}, {"b", {1}, {1}}, {"a", {1}, {2}}}) == "array 'a' is given twice");
}

TEST_CASE("a frame has a limited number of arrays") {
  std::vector<NamedArray> arrays;
  for (int i = 0; i < 256; ++i) arrays.push_back({std::to_string(i), {1}, {0}});
  CHECK(message(arrays).empty());
  arrays.push_back({"one more", {1}, {0}});
  CHECK(message(arrays) == "257 arrays; at most 256 are allowed");
}

TEST_CASE("names and shapes stay the same over a run") {
  ArrayShapes shapes;
  const NamedArray a{"a", {2}, {1, 2}};
  const NamedArray b{"b", {1}, {1}};
  CHECK_FALSE(shapes.check({{"x", {1}, {NAN}}}).isOk());  // does not count as the first
  CHECK(shapes.check({a, b}).isOk());
  CHECK(shapes.check({b, a}).isOk());
  CHECK(shapes.check({{"a", {1}, {1}}, b}).message() == "array 'a' changed its shape");
  CHECK(shapes.check({a, {"c", {1}, {1}}}).message() ==
        "array 'c' was not there before; the names stay the same over a run");
  CHECK(shapes.check({a}).message() == "array 'b' is missing; the names stay the same over a run");
  CHECK(shapes.check({}).message() == "array 'a' is missing; the names stay the same over a run");
}

TEST_CASE("descriptions have finite numbers and are given once") {
  ArrayInfo info;
  info.name = "a";
  info.unit = "\xc2\xb0/s";
  info.axes.resize(1);
  const auto described = [&] { return checkDescriptions(std::vector{info}).message(); };
  CHECK(described().empty());
  info.axes[0].step = NAN;
  CHECK(described() == "the answer has NaN, infinity or an illegal value in 'axes.step'");
  info.axes.clear();
  CHECK(checkDescriptions(std::vector{info, info}).message() == "array 'a' is given twice");
}

TEST_CASE("sensors may be missing, and lists have any length") {
  ArrayShapes shapes;
  CHECK(shapes.checkShapes({{"loops", {1, 2}, {3, 4}}}).isOk());
  CHECK(shapes.checkShapes({}).isOk());
  CHECK(shapes.checkShapes({{"loops", {0, 2}, {}}, {"depth", {2}, {1, 2}}}).isOk());
  CHECK(shapes.checkShapes({{"loops", {1, 3}, {3, 4, 5}}}).message() ==
        "array 'loops' changed its shape");
  CHECK(shapes.checkShapes({{"depth", {1, 2}, {1, 2}}}).message() ==
        "array 'depth' changed its shape");
}
