// SPDX-License-Identifier: BSD-3-Clause
// Codes of views: bits counted one by one, and their distance against the angle between views.
#include "place_codes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "random_views.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

int differingBits(const PlaceCode& a, const PlaceCode& b) {
  int differing = 0;
  for (int bit = 0; bit < kCodeBits; ++bit) {
    const auto word = static_cast<std::size_t>(bit / 64);
    differing += ((a[word] >> (bit % 64)) & 1U) != ((b[word] >> (bit % 64)) & 1U) ? 1 : 0;
  }
  return differing;
}

EdgeValues gaussian(RandomStream& random) {
  EdgeValues values;
  for (float& value : values) value = static_cast<float>(random.normal());
  return values;
}

double dot(const EdgeValues& a, const EdgeValues& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kValues; ++i) sum += double{a[i]} * b[i];
  return sum;
}

/// A vector at exactly this angle to `a`.
EdgeValues atAngle(const EdgeValues& a, double angle, RandomStream& random) {
  EdgeValues b = gaussian(random);
  const double along = dot(a, b) / dot(a, a);
  for (std::size_t i = 0; i < kValues; ++i) b[i] -= static_cast<float>(along) * a[i];
  const double scale = std::sqrt(dot(a, a) / dot(b, b));
  for (std::size_t i = 0; i < kValues; ++i) {
    b[i] = static_cast<float>(std::cos(angle) * a[i] + std::sin(angle) * scale * b[i]);
  }
  return b;
}

EdgeValues deviationOf(const ViewBank& bank, const Chunk& chunk, std::int64_t view) {
  EdgeValues deviation = levelsOf(bank.view(view));
  for (std::size_t k = 0; k < kValues; ++k) {
    deviation[k] -= static_cast<float>(chunk.mean[k]) / kMeanScale;
  }
  return deviation;
}

}  // namespace

TEST_CASE("the share of differing bits is the angle over pi (Charikar 2002)") {
  const CodeMaker maker;
  RandomStream random(1);
  double before = -1;
  for (const double angle : {0.0, 0.1, 0.3, 0.6, 1.0, 1.3, 1.5708, 2.0, 2.6, 3.1416}) {
    double share = 0;
    constexpr int kPairs = 200;
    for (int i = 0; i < kPairs; ++i) {
      const EdgeValues a = gaussian(random);
      share += differingBits(maker.codeOf(a), maker.codeOf(atAngle(a, angle, random)));
    }
    share /= kPairs * kCodeBits;
    CAPTURE(angle);
    CHECK(share == Approx(angle / std::numbers::pi).margin(0.012));
    CHECK(share > before);
    before = share;
  }
}

TEST_CASE("codes are the same in every instance, whatever the length of the deviation") {
  RandomStream random(2);
  const CodeMaker one;
  const CodeMaker other;
  for (int i = 0; i < 20; ++i) {
    const EdgeValues view = gaussian(random);
    EdgeValues longer = view;
    for (float& value : longer) value *= 4;
    CHECK(one.codeOf(view) == other.codeOf(view));
    CHECK(one.codeOf(view) == one.codeOf(longer));
    CHECK(one.codeOf(view) != one.codeOf(gaussian(random)));
  }
}

TEST_CASE("the code of a shifted view is that of its columns further right") {
  RandomStream random(3);
  const CodeMaker maker;
  const EdgeValues view = gaussian(random);
  for (const int shift : {-3, -2, -1, 0, 1, 2, 3}) {
    EdgeValues moved{};
    for (int c = 0; c < kColumns; ++c) {
      if (c - shift < 0 || c - shift >= kColumns) continue;
      for (int i = 0; i < kColumnValues; ++i) {
        moved[static_cast<std::size_t>(c * kColumnValues + i)] =
            view[static_cast<std::size_t>((c - shift) * kColumnValues + i)];
      }
    }
    CHECK(maker.codeOfShifted(view, shift) == maker.codeOf(moved));
  }
}

TEST_CASE("distances are the fewest differing bits over the tried shifts, counted one by one") {
  RandomStream random(4);
  const std::vector<EdgeValues> path = randomPath(230, random);
  ViewBank bank;
  PlaceCodes codes;
  for (std::size_t i = 0; i < path.size(); ++i) {
    bank.add(packedLevels(path[i]), static_cast<double>(i));
    codes.update(bank);
    REQUIRE(codes.size() <= bank.size());
  }
  CHECK(codes.size() >= 230 - 2 * 64);  // two chunks may still change
  bank.beginPass();
  codes.update(bank);
  REQUIRE(codes.size() == 230);
  const CodeMaker maker;
  EdgeValues mean{};
  for (const EdgeValues& view : path) {
    for (std::size_t k = 0; k < kValues; ++k) mean[k] += view[k] / 230;
  }
  for (const std::size_t place : {3U, 70U, 200U}) {
    for (const int cells : {0, 2, -2}) {
      const ViewQuery query(movedLeft(path[place], cells, random), mean);
      std::vector<std::uint16_t> bits;
      codes.distances(query, bits);
      REQUIRE(bits.size() == 230);
      for (const Chunk& chunk : bank.chunks()) {
        for (std::int64_t i = chunk.first; i < chunk.first + chunk.count; ++i) {
          const PlaceCode stored = maker.codeOf(deviationOf(bank, chunk, i));
          int fewest = kCodeBits;
          for (const int shift : {-2, 0, 2}) {
            fewest = std::min(fewest,
                              differingBits(stored, maker.codeOfShifted(query.deviation(), shift)));
          }
          REQUIRE(bits[static_cast<std::size_t>(i)] == fewest);
        }
      }
      CAPTURE(place, cells);
      CHECK(std::ranges::min_element(bits) - bits.begin() == static_cast<std::ptrdiff_t>(place));
    }
  }
}

TEST_CASE("views of finished passes all have codes") {
  RandomStream random(5);
  ViewBank bank;
  PlaceCodes codes;
  for (const int views : {100, 64, 1, 130}) {
    for (int i = 0; i < views; ++i) bank.add(packedLevels(randomLevels(random)), 0);
    bank.beginPass();
    codes.update(bank);
    CHECK(codes.size() == bank.size());
  }
}
