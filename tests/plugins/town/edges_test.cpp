// SPDX-License-Identifier: BSD-3-Clause
// Edges of drawn images, and of random ones compared with the definition, pixel by pixel.
#include "edges.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "ray_packet.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

struct Drawing {
  int width;
  int height;
  std::vector<float> radiance;
  std::vector<float> depth;
  std::vector<std::uint32_t> seen;

  Drawing(int columns, int rows)
      : width(columns),
        height(rows),
        radiance(static_cast<std::size_t>(columns * rows), 0.5F),
        depth(radiance.size(), 10),
        seen(radiance.size(), 4) {}
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(std::clamp(row, 0, height - 1) * width +
                                    std::clamp(column, 0, width - 1));
  }
  std::vector<std::uint32_t> edges() const {
    std::vector<std::uint32_t> found(radiance.size());
    for (int row = 0; row < height; ++row) {
      findEdges({radiance, depth, seen, width, height}, row, found.data() + at(0, row));
    }
    return found;
  }
  /// The definition, in double precision.
  bool isEdge(std::size_t before, std::size_t here, std::size_t after) const {
    const auto value = [&](std::size_t i) { return static_cast<double>(radiance[i]); };
    const auto inverse = [&](std::size_t i) {
      return depth[i] > 0 ? 1 / static_cast<double>(depth[i]) : 0.0;
    };
    const double contrast =
        std::max(std::abs(value(before) - value(here)), std::abs(value(after) - value(here)));
    if (contrast < 0.012 || contrast < 0.04 * value(here)) return false;
    if (seen[before] != seen[here] || seen[after] != seen[here]) return true;
    if ((seen[here] & kFoliage) != 0) return false;
    return std::abs(inverse(before) - 2 * inverse(here) + inverse(after)) > 0.02 * inverse(here);
  }
};

Drawing randomDrawing(int width, int height) {
  Drawing drawing(width, height);
  RandomStream random(8);
  for (std::size_t i = 0; i < drawing.seen.size(); ++i) {
    drawing.radiance[i] = static_cast<float>(0.5 + 0.02 * random.uniform(-1, 1));
    const bool is_sky = random.uniform(0, 1) < 0.03;
    drawing.depth[i] = is_sky ? 0.0F : static_cast<float>(10 + 0.1 * random.uniform(-1, 1));
    drawing.seen[i] = 4U + static_cast<std::uint32_t>(random.uniform(0, 4));
    if (random.uniform(0, 1) < 0.9) drawing.seen[i] = 4;
  }
  return drawing;
}

}  // namespace

TEST_CASE("edges are on both sides of a change of objects that is visible") {
  Drawing drawing(8, 4);
  for (int row = 0; row < 4; ++row) {
    for (int column = 5; column < 8; ++column) drawing.seen[drawing.at(column, row)] = 12;
  }
  CHECK(drawing.edges() == std::vector<std::uint32_t>(32, 0));
  for (int row = 0; row < 4; ++row) drawing.radiance[drawing.at(5, row)] = 0.6F;
  const auto edges = drawing.edges();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 8; ++column) {
      CAPTURE(row, column);
      CHECK(edges[drawing.at(column, row)] == (column == 4 || column == 5 ? 1U : 0U));
    }
  }
}

TEST_CASE("edges of random images are those of the definition") {
  for (const auto& [width, height] : {std::pair{61, 9}, std::pair{1, 5}, std::pair{2, 1}}) {
    const Drawing drawing = randomDrawing(width, height);
    const auto edges = drawing.edges();
    std::uint32_t count = 0;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const std::size_t here = drawing.at(column, row);
        const bool beside =
            drawing.isEdge(drawing.at(column - 1, row), here, drawing.at(column + 1, row));
        const bool above =
            drawing.isEdge(drawing.at(column, row - 1), here, drawing.at(column, row + 1));
        CAPTURE(width, row, column);
        REQUIRE(edges[here] == (beside || above ? 1U : 0U));
        count += edges[here];
      }
    }
    if (width == 61) CHECK((count > 100 && count < 450));  // both kinds are many
  }
}
