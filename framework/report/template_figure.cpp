// SPDX-License-Identifier: BSD-3-Clause
#include "report/axes.hpp"
#include "report/figures.hpp"

namespace tolman::report {

std::string templateFigure(const std::vector<PlaceObservation>& places) {
  Range time;
  Range templates;
  for (const PlaceObservation& place : places) {
    if (place.recognition == Recognition::None) continue;
    time.include(static_cast<double>(place.stamp_ns - places.front().stamp_ns) * 1e-9);
    templates.include(static_cast<double>(place.template_id));
  }
  if (places.empty()) return "";
  Svg svg(900, 380);
  Axes axes(svg, {"Local view template over time", "data time (s)", "template", time, templates,
                  frame(70.0, 60.0, 880.0, 330.0)});
  // Draws novel ones last, because the familiar ones after each would cover it.
  for (const Recognition kind : {Recognition::Familiar, Recognition::Novel}) {
    for (const PlaceObservation& place : places) {
      if (place.recognition != kind) continue;
      const double seconds = static_cast<double>(place.stamp_ns - places.front().stamp_ns) * 1e-9;
      svg.circle(axes.at(seconds, static_cast<double>(place.template_id)), 1.6,
                 kind == Recognition::Novel ? kBlue : kVermilion);
    }
  }
  axes.legend({{kBlue, "novel"}, {kVermilion, "familiar"}});
  return svg.take();
}

}  // namespace tolman::report
