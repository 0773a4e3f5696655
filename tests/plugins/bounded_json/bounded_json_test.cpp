// SPDX-License-Identifier: BSD-3-Clause
// JSON as any parser reads it, but for texts that are nested too deeply.
#include "base/bounded_json.hpp"

#include <catch2/catch.hpp>
#include <sstream>

using tolman::bounded_json::kDeepest;
using tolman::bounded_json::parse;
using Json = nlohmann::ordered_json;

namespace {

std::string nested(int levels, const std::string& inside = "1") {
  std::string text = inside;
  for (int i = 0; i < levels; ++i) text = i % 2 == 0 ? "[" + text + "]" : "{\"a\":" + text + "}";
  return text;
}

}  // namespace

TEST_CASE("values are those of the library, with the order of the keys") {
  const std::string text = R"({"b":[1,-2.5,"x",null,true],"a":{"c":{},"d":[[]]}})";
  CHECK(parse<Json>(text).dump() == text);
  std::istringstream stream(text);
  CHECK(parse<nlohmann::json>(stream) == nlohmann::json::parse(text));
}

TEST_CASE("what is no JSON is discarded") {
  for (const char* text : {"", "{", "[1,]", "x", "{\"a\":1}}", "\xff"}) {
    CHECK(parse<Json>(std::string(text)).is_discarded());
  }
}

TEST_CASE("texts beyond the largest depth are discarded, whole") {
  CHECK(parse<Json>(nested(kDeepest)).dump() == nested(kDeepest));
  CHECK(parse<Json>(nested(kDeepest + 1)).is_discarded());
  for (const int levels : {1000, 300'000}) {
    const std::string deep(static_cast<std::size_t>(levels), '[');
    const std::string closed = deep + std::string(static_cast<std::size_t>(levels), ']');
    for (const std::string& text :
         {deep, closed, R"({"status":"finished","zz":)" + closed + "}", "[1," + closed + ",2]"}) {
      CHECK(parse<Json>(text).is_discarded());
    }
  }
}
