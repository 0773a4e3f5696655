// SPDX-License-Identifier: BSD-3-Clause
// Pictures of paths: the map from above, errors, templates and times.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "report/axes.hpp"
#include "report/figures.hpp"

namespace tolman::report {
namespace {

constexpr double kLongSide = 820;  // px
constexpr double kLeft = 70;
constexpr double kMapTop = 66;
constexpr double kRight = 30;
constexpr double kBottom = 50;
constexpr double kMinWidth = 520;         // for the legend
constexpr double kPixelsPerCircle = 2.5;  // with less space experiences are drawn as dots

bool isAcceptedLoop(const MapGraph& graph, const Link& link) {
  return link.kind == LinkKind::Loop && !graph.isRejected(link);
}

/// What is drawn of the plane. Forward is up, or right for a path more than twice as long as wide.
class PlanView {
 public:
  explicit PlanView(const MapPicture& picture) {
    for (const auto* line : {&picture.truth, &picture.odometry, &picture.map}) {
      for (const auto& pose : *line) {
        const Eigen::Vector3d at = pose.T_world_camera.translation();
        box_.extend(Eigen::Vector2d(at.x(), at.z()));
      }
    }
    if (box_.isEmpty()) box_.extend(Eigen::Vector2d::Zero());
    const double margin = std::max(0.03 * box_.sizes().maxCoeff(), 0.5);
    box_ = {box_.min().array() - margin, box_.max().array() + margin};
    lying_ = box_.sizes().y() > 2 * box_.sizes().x();
    if (!lying_) return;
    box_ = {Eigen::Vector2d(box_.min().y(), -box_.max().x()),
            Eigen::Vector2d(box_.max().y(), -box_.min().x())};
  }

  /// Size of the frame, px, if its longer side is `side`.
  Eigen::Vector2d pixels(double side) const {
    return box_.sizes() * side / box_.sizes().maxCoeff();
  }
  AxesPlan plan(const MapPicture& picture, const Eigen::AlignedBox2d& place) const {
    const auto label = [&](const char* side) {
      return fmt::format("{} of the start ({})", side, picture.unit);
    };
    return {picture.title,
            label(lying_ ? "ahead" : "right"),
            label(lying_ ? "left" : "ahead"),
            {box_.min().x(), box_.max().x()},
            {box_.min().y(), box_.max().y()},
            place,
            true};
  }
  Eigen::Vector2d at(const Axes& axes, const Eigen::Vector3d& p) const {
    return lying_ ? axes.at(p.z(), -p.x()) : axes.at(p.x(), p.z());
  }

 private:
  Eigen::AlignedBox2d box_;  ///< of the axes, m
  bool lying_ = false;
};

/// The line ends where many frames have no pose: the place was unknown.
void drawPath(Svg& svg, const PlanView& view, const Axes& axes,
              const evaluation::Trajectory& trajectory, const char* colour, double thickness) {
  constexpr std::int64_t kHidden = 20;  // frames; chosen, not tuned
  std::vector<Eigen::Vector2d> points;
  std::int64_t last = -1;
  for (const auto& pose : trajectory) {
    if (!points.empty() && pose.frame - last > kHidden) {
      svg.polyline(std::exchange(points, {}), colour, thickness);
    }
    points.push_back(view.at(axes, pose.T_world_camera.translation()));
    last = pose.frame;
  }
  svg.polyline(points, colour, thickness);
}

void drawGraph(Svg& svg, const PlanView& view, const Axes& axes, const MapGraph& graph) {
  const auto at = [&](std::int64_t id) {
    const Experience& experience = graph.experiences[static_cast<std::size_t>(id)];
    return view.at(axes, experience.T_world_experience.translation());
  };
  const double room = axes.box().sizes().maxCoeff() / kPixelsPerCircle;
  const bool many = static_cast<double>(graph.experiences.size()) > room;
  for (const Experience& experience : graph.experiences) {
    svg.circle(at(experience.id), many ? 1.2 : 3, many ? kGreen : "none", many ? "none" : kGreen);
  }
  for (const Link& link : graph.links) {
    if (isAcceptedLoop(graph, link)) svg.line(at(link.from), at(link.to), kVermilion, 2);
  }
}

std::vector<Axes::LegendEntry> entries(const MapPicture& picture) {
  std::vector<Axes::LegendEntry> list;
  if (!picture.truth.empty()) list.push_back({kGrey, "truth"});
  list.push_back({kOrange, "odometry"});
  list.push_back({kBlue, "map"});
  list.push_back({kGreen, fmt::format("{} experiences", picture.graph.experiences.size())});
  const auto loops = std::ranges::count_if(
      picture.graph.links, [&](const Link& link) { return isAcceptedLoop(picture.graph, link); });
  list.push_back({kVermilion, fmt::format("{} loop link{}", loops, loops == 1 ? "" : "s")});
  return list;
}

std::string entry(const char* name, const evaluation::TrajectoryMetrics& metrics) {
  if (!metrics.scores) return name;
  return fmt::format("{}, rmse {:.3f} m", name, metrics.scores->ate_m.rmse);
}

}  // namespace

MapPicture pictureOf(const RunData& run, std::string title) {
  MapPicture picture{std::move(title), run.has_metres ? "m" : "units",
                     run.truth,        run.odometry,
                     run.map,          run.graph};
  for (auto* trajectory : {&picture.truth, &picture.odometry, &picture.map}) {
    for (auto& pose : *trajectory) pose.T_world_camera.translation() *= run.metres;
  }
  for (Experience& experience : picture.graph.experiences) {
    experience.T_world_experience.translation() *= run.metres;
  }
  return picture;
}

std::string mapFigure(const MapPicture& picture) {
  const PlanView view(picture);
  const Eigen::Vector2d size = view.pixels(kLongSide);
  Svg svg(std::max(kLeft + size.x() + kRight, kMinWidth), kMapTop + size.y() + kBottom);
  Axes axes(svg, view.plan(picture, frame(kLeft, kMapTop, kLeft + size.x(), kMapTop + size.y())));
  if (!picture.truth.empty()) drawPath(svg, view, axes, picture.truth, kGrey, 4);
  drawPath(svg, view, axes, picture.odometry, kOrange, 1.5);
  drawPath(svg, view, axes, picture.map, kBlue, 1.5);
  drawGraph(svg, view, axes, picture.graph);
  axes.legend(entries(picture));
  return svg.take();
}

std::string errorFigure(const RunData& run) {
  if (run.odometry_error.metres.empty() && run.map_error.metres.empty()) return "";
  return curveFigure(
      {"Position error after alignment", "data time (s)", "error (m)", {0, 1}, {0, 1e-3}, {}},
      {{entry("odometry", run.metrics.odometry), kOrange, run.odometry_error.seconds,
        run.odometry_error.metres},
       {entry("map", run.metrics.map), kBlue, run.map_error.seconds, run.map_error.metres}},
      {900, 330});
}

std::string stepFigure(const RunData& run) {
  std::vector<Curve> lengths;
  std::vector<Curve> turns;
  Range frames = Range::none();
  for (const auto& [name, colour, series] :
       {std::tuple("odometry", kOrange, &run.odometry_error.steps),
        std::tuple("map", kBlue, &run.map_error.steps)}) {
    const std::vector<double> at(series->frames.begin(), series->frames.end());
    for (const double frame : at) frames.include(frame);
    lengths.push_back({name, colour, at, series->log_ratio});
    turns.push_back({"", colour, at, {}});
    for (const double turn : series->turn) turns.back().y.push_back(turn * evaluation::kDegrees);
  }
  if (!(frames.length() > 0)) return "";
  Svg svg(900, 520);
  plot(svg,
       {"Motion against the true motion",
        "frame",
        "ln (length / true length)",
        frames,
        {-0.1, 0.1},
        frame(70.0, 60.0, 880.0, 250.0)},
       lengths);
  plot(svg, {"", "frame", "turn apart (deg)", frames, {0, 0.1}, frame(70.0, 310.0, 880.0, 470.0)},
       turns);
  return svg.take();
}

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
    Eigen::Vector2d last(-1, -1);
    for (const PlaceObservation& place : places) {
      if (place.recognition != kind) continue;
      const double seconds = static_cast<double>(place.stamp_ns - places.front().stamp_ns) * 1e-9;
      const Eigen::Vector2d at = axes.at(seconds, static_cast<double>(place.template_id));
      if ((at - last).norm() < 0.2) continue;  // as if it were drawn
      svg.circle(at, 1.6, kind == Recognition::Novel ? kBlue : kVermilion);
      last = at;
    }
  }
  axes.legend({{kBlue, "novel"}, {kVermilion, "familiar"}});
  return svg.take();
}

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
