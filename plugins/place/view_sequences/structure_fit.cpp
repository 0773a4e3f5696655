// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "structure_query.hpp"

namespace tolman::view_sequences {
namespace {

constexpr int kSide = 6;   // largest shift to the side, cells; chosen, not tuned
constexpr int kFront = 4;  // largest shift along the street, cells; chosen, not tuned

using Correlations = std::array<std::array<double, 2 * kFront + 1>, 2 * kSide + 1>;

/// Cosine of the deviations where the grids overlap, with the query moved by so many cells.
double correlationAt(const StructureDeviation& query, const StructureDeviation& stored, int side,
                     int front) {
  const int count = (kAlong - std::abs(front)) * kHeights;
  double products = 0;
  double squares_of_query = 0;
  double squares_of_stored = 0;
  for (int c = std::max(0, side); c < std::min(kLateral, kLateral + side); ++c) {
    const float* s = stored.data() + c * kSlice + std::max(0, front) * kHeights;
    const float* q = query.data() + (c - side) * kSlice + std::max(0, -front) * kHeights;
    for (int i = 0; i < count; ++i) {
      products += static_cast<double>(q[i]) * s[i];
      squares_of_query += static_cast<double>(q[i]) * q[i];
      squares_of_stored += static_cast<double>(s[i]) * s[i];
    }
  }
  const double norm = std::sqrt(squares_of_query * squares_of_stored);
  return norm > 0 ? products / norm : -1;
}

}  // namespace

double peakOf(double before, double at, double after) {
  const double curve = before - 2 * at + after;
  return curve < 0 ? 0.5 * (before - after) / curve : 0;
}

StructureFit fitStructure(const StructureDeviation& query, const StructureDeviation& stored) {
  Correlations all;
  std::size_t side = 0;
  std::size_t front = 0;
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b < all[a].size(); ++b) {
      all[a][b] =
          correlationAt(query, stored, static_cast<int>(a) - kSide, static_cast<int>(b) - kFront);
      if (all[a][b] > all[side][front]) {
        side = a;
        front = b;
      }
    }
  }
  StructureFit fit;
  fit.correlation = all[side][front];
  fit.within = side > 0 && side + 1 < all.size() && front > 0 && front + 1 < all[side].size();
  fit.lateral = static_cast<double>(side) - kSide;
  fit.ahead = static_cast<double>(front) - kFront;
  if (fit.within) {
    fit.lateral += peakOf(all[side - 1][front], fit.correlation, all[side + 1][front]);
    fit.ahead += peakOf(all[side][front - 1], fit.correlation, all[side][front + 1]);
  }
  fit.lateral *= kCellSize;
  fit.ahead *= kCellSize;
  return fit;
}

}  // namespace tolman::view_sequences
