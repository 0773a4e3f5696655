// SPDX-License-Identifier: BSD-3-Clause
#include "report/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tolman::report {

namespace {

std::uint32_t colourOf(double value) {
  static constexpr std::array<int, 9> kAnchors = {0x440154, 0x472c7a, 0x3b518b, 0x2c718e, 0x21908d,
                                                  0x27ad81, 0x5cc863, 0xaadc32, 0xfde725};
  const double place =
      std::clamp(std::isfinite(value) ? value : 0, 0.0, 1.0) * (kAnchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kAnchors.size() - 2);
  const double part = place - static_cast<double>(below);
  long colour = 0;
  for (const int shift : {16, 8, 0}) {
    const auto channel = [&](std::size_t i) { return kAnchors.at(i) >> shift & 0xff; };
    colour = colour << 8 | std::lround((1 - part) * channel(below) + part * channel(below + 1));
  }
  return static_cast<std::uint32_t>(colour);
}

}  // namespace

std::string rateColour(double value) { return fmt::format("#{:06x}", colourOf(value)); }

Pixels ratePixels(const Eigen::MatrixXd& rates, double most) {
  constexpr double kLevels = 32;  // few colours make the file small
  const auto pixel = [&](double rate) {
    if (std::isnan(rate)) return 0U;
    return 0xff000000 | colourOf(std::round(kLevels * rate / std::max(most, 1e-12)) / kLevels);
  };
  return rates.transpose().colwise().reverse().unaryExpr(pixel);
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
  svg.text({left - 6, middle.y() + 4}, low, {TextAnchor::End, 11});
  svg.text({left + kSteps * cell.x() + 6, middle.y() + 4}, high, {TextAnchor::Start, 11});
}

}  // namespace tolman::report
