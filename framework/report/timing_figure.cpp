// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "report/axes.hpp"
#include "report/figures.hpp"

namespace tolman::report {

std::string timingFigure(const evaluation::Metrics& metrics) {
  if (metrics.timing.empty()) return "";
  double most = 0;
  for (const auto& [stage, timing] : metrics.timing) most = std::max(most, timing.p90_ms);
  const double height = 30.0 * static_cast<double>(metrics.timing.size());
  Svg svg(900, height + 120);
  Axes axes(svg, {"Time of a frame",
                  "ms",
                  "",
                  {0, std::max(1.15 * most, 1e-3)},
                  {0, 1},
                  frame(110.0, 60.0, 880.0, 60.0 + height)});
  double y = 60;
  for (const auto& [stage, timing] : metrics.timing) {
    svg.rectangle({110, y + 5}, {axes.pixelsX(timing.p90_ms), 20}, kPaleBlue);
    svg.rectangle({110, y + 5}, {axes.pixelsX(timing.median_ms), 20}, kBlue);
    svg.text({102, y + 19}, stage, {TextAnchor::End});
    svg.text({116 + axes.pixelsX(timing.p90_ms), y + 19},
             fmt::format("{:.3g} / {:.3g}", timing.median_ms, timing.p90_ms),
             {TextAnchor::Start, 11});
    y += 30;
  }
  axes.legend({{kBlue, "median"}, {kPaleBlue, "90th percentile"}});
  return svg.take();
}

}  // namespace tolman::report
