// SPDX-License-Identifier: BSD-3-Clause
// Several runs in one picture.
#include "report/comparison.hpp"

#include <catch2/catch.hpp>

using namespace tolman::report;

namespace {

RunPage runWith(const std::string& name, const std::string& figure, const std::string& svg) {
  RunPage page;
  page.directory = name;
  page.figures.push_back({"error", "", "<svg viewBox=\"0 0 9 9\">error</svg>"});
  page.figures.push_back({figure, "", svg});
  return page;
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("maps stand in a row at one height, each at its own scale, with letter and name") {
  const std::string wide =
      "<svg xmlns=\"x\" width=\"200\" viewBox=\"0 0 200 100\">\n<g>wide</g></svg>";
  const std::string tall = "<svg viewBox=\"0 0 50 100\"><g>tall</g></svg>";
  const auto picture =
      sideBySide({runWith("rough", "map", wide), runWith("a<b", "map", tall)}, "map");
  REQUIRE(picture);
  CHECK(picture->find("viewBox=\"0 0 1224 508\"") != std::string::npos);  // 960 + 240 + two gaps
  CHECK(picture->find("<svg x=\"0.0\" y=\"28\" width=\"960.0\" height=\"480\" "
                      "viewBox=\"0 0 200 100\">\n<g>wide</g></svg>") != std::string::npos);
  CHECK(picture->find("<svg x=\"972.0\" y=\"28\" width=\"240.0\" height=\"480\" "
                      "viewBox=\"0 0 50 100\"><g>tall</g></svg>") != std::string::npos);
  CHECK(picture->find(">A</tspan> rough") != std::string::npos);
  CHECK(picture->find(">B</tspan> a&lt;b") != std::string::npos);
  CHECK(countOf(*picture, "<svg") == countOf(*picture, "</svg>"));
  CHECK(picture->find("error") == std::string::npos);
}

TEST_CASE("runs without the figure are left out; one alone is no comparison") {
  const std::string svg = "<svg viewBox=\"0 0 10 10\">map</svg>";
  const RunPage with = runWith("with", "map", svg);
  const RunPage without = runWith("without", "firing", svg);
  const RunPage damaged = runWith("damaged", "map", "<svg>no box</svg>");
  CHECK_FALSE(sideBySide({with}, "map"));
  CHECK_FALSE(sideBySide({with, without, damaged}, "map"));
  const auto picture = sideBySide({with, without, with}, "map");
  REQUIRE(picture);
  CHECK(picture->find(">B</tspan> with<") != std::string::npos);
}
