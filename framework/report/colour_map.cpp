// SPDX-License-Identifier: BSD-3-Clause
#include "report/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tolman::report {

std::string rateColour(double value) {
  static constexpr std::array<std::array<double, 3>, 9> kAnchors = {{{68, 1, 84},
                                                                     {71, 44, 122},
                                                                     {59, 81, 139},
                                                                     {44, 113, 142},
                                                                     {33, 144, 141},
                                                                     {39, 173, 129},
                                                                     {92, 200, 99},
                                                                     {170, 220, 50},
                                                                     {253, 231, 37}}};
  const double place =
      std::clamp(std::isfinite(value) ? value : 0, 0.0, 1.0) * (kAnchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kAnchors.size() - 2);
  const double part = place - static_cast<double>(below);
  std::array<int, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double mixed =
        (1 - part) * kAnchors.at(below).at(i) + part * kAnchors.at(below + 1).at(i);
    colour.at(i) = static_cast<int>(std::lround(mixed));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

void colourBar(Svg& svg, const Eigen::Vector2d& middle, std::string_view low,
               std::string_view high) {
  constexpr int kSteps = 24;
  const Eigen::Vector2d cell(4, 9);
  const double left = middle.x() - kSteps * cell.x() / 2;
  for (int i = 0; i < kSteps; ++i) {
    svg.rectangle({left + i * cell.x(), middle.y() - cell.y() / 2}, cell,
                  rateColour(i / (kSteps - 1.0)));
  }
  svg.text({left - 6, middle.y() + 4}, low, {Anchor::End, 11});
  svg.text({left + kSteps * cell.x() + 6, middle.y() + 4}, high, {Anchor::Start, 11});
}

}  // namespace tolman::report
