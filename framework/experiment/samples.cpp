// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/samples.hpp"

#include <array>
#include <bit>

#include "tolman/context.hpp"

namespace tolman::experiment {
namespace {

constexpr unsigned kBits = 32;

/// A primitive polynomial and the first direction numbers of one dimension (Joe and Kuo 2008).
struct Direction {
  unsigned degree;
  unsigned polynomial;
  std::array<unsigned, 5> first;
};
constexpr std::array<Direction, kSobolDimensions - 1> kDirections = {{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
}};

std::array<std::uint32_t, kBits> directionNumbers(std::size_t dimension) {
  std::array<std::uint32_t, kBits> v{};
  if (dimension == 0) {
    for (unsigned i = 0; i < kBits; ++i) v.at(i) = 1U << (kBits - 1 - i);
    return v;
  }
  const Direction& d = kDirections.at(dimension - 1);
  for (unsigned i = 0; i < kBits; ++i) {
    if (i < d.degree) {
      v.at(i) = d.first.at(i) << (kBits - 1 - i);
      continue;
    }
    v.at(i) = v.at(i - d.degree) ^ (v.at(i - d.degree) >> d.degree);
    for (unsigned k = 1; k < d.degree; ++k) {
      if (((d.polynomial >> (d.degree - 1 - k)) & 1U) != 0) v.at(i) ^= v.at(i - k);
    }
  }
  return v;
}

}  // namespace

std::vector<std::vector<double>> sobolPoints(std::size_t count, std::size_t dimensions) {
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    const auto v = directionNumbers(d);
    std::uint32_t x = 0;
    for (std::size_t i = 0; i < count; ++i) {
      points[i][d] = static_cast<double>(x) * 0x1.0p-32;
      x ^= v.at(static_cast<std::size_t>(std::countr_one(i)));
    }
  }
  return points;
}

std::vector<std::vector<double>> randomPoints(std::size_t count, std::size_t dimensions,
                                              std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (auto& point : points) {
    for (double& coordinate : point) coordinate = random.uniform();
  }
  return points;
}

}  // namespace tolman::experiment
