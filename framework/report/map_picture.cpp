// SPDX-License-Identifier: BSD-3-Clause
#include "report/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "report/axes.hpp"

namespace tolman::report {
namespace {

constexpr double kLongSide = 820;  // px; frame of a single map
constexpr double kPanelSide = 420;
constexpr double kLeft = 70;
constexpr double kMapTop = 66;
constexpr double kRight = 30;
constexpr double kBottom = 50;
constexpr double kMinWidth = 520;  // for the legend
constexpr std::size_t kPanelsInARow = 3;
constexpr double kPixelsPerCircle = 2.5;  // with less space experiences are drawn as dots

bool isAcceptedLoop(const MapGraph& graph, const Link& link) {
  return link.kind == LinkKind::Loop && !graph.isRejected(link);
}

/// The part of the plane that is drawn. Forward at the start is up, or to the right where the path
/// is more than twice as long as wide.
class PlanView {
 public:
  explicit PlanView(const std::vector<MapPicture>& pictures) {
    for (const MapPicture& picture : pictures) {
      for (const auto* line : {&picture.truth, &picture.odometry, &picture.map}) {
        for (const auto& pose : *line) box_.extend(inPlane(pose.T_world_camera.translation()));
      }
    }
    if (box_.isEmpty()) box_.extend(Eigen::Vector2d::Zero());
    const double margin = std::max(0.03 * box_.sizes().maxCoeff(), 0.5);
    box_ = {box_.min().array() - margin, box_.max().array() + margin};
    lying_ = box_.sizes().y() > 2 * box_.sizes().x();
  }

  /// Size of the frame, px, if its longer side is `side`.
  Eigen::Vector2d pixels(double side) const {
    const Eigen::Vector2d lengths(rangeX().length(), rangeY().length());
    return lengths * side / lengths.maxCoeff();
  }
  AxesPlan plan(const MapPicture& picture, const std::string& title,
                const Eigen::AlignedBox2d& place) const {
    const std::string ahead = "ahead of the start (" + picture.unit + ")";
    const std::string right = "right of the start (" + picture.unit + ")";
    const std::string left = "left of the start (" + picture.unit + ")";
    return {title, lying_ ? ahead : right, lying_ ? left : ahead, rangeX(), rangeY(), place, true};
  }
  Eigen::Vector2d at(const Axes& axes, const Eigen::Vector3d& p) const {
    return lying_ ? axes.at(p.z(), -p.x()) : axes.at(p.x(), p.z());
  }

 private:
  static Eigen::Vector2d inPlane(const Eigen::Vector3d& p) { return {p.x(), p.z()}; }
  Range rangeX() const {
    return lying_ ? Range{box_.min().y(), box_.max().y()} : Range{box_.min().x(), box_.max().x()};
  }
  Range rangeY() const {
    return lying_ ? Range{-box_.max().x(), -box_.min().x()} : Range{box_.min().y(), box_.max().y()};
  }
  Eigen::AlignedBox2d box_;  ///< right and ahead, m
  bool lying_ = false;
};

void drawPath(Svg& svg, const PlanView& view, const Axes& axes,
              const evaluation::Trajectory& trajectory, const char* colour, double thickness) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& pose : trajectory) {
    points.push_back(view.at(axes, pose.T_world_camera.translation()));
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

void drawMap(Svg& svg, const PlanView& view, const MapPicture& picture, const std::string& title,
             const Eigen::AlignedBox2d& place) {
  Axes axes(svg, view.plan(picture, title, place));
  if (!picture.truth.empty()) drawPath(svg, view, axes, picture.truth, kGrey, 4);
  drawPath(svg, view, axes, picture.odometry, kOrange, 1.5);
  drawPath(svg, view, axes, picture.map, kBlue, 1.5);
  drawGraph(svg, view, axes, picture.graph);
  axes.legend(entries(picture));
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

std::string mapFigure(const std::vector<MapPicture>& pictures) {
  const bool is_single = pictures.size() == 1;
  const PlanView view(pictures);
  const Eigen::Vector2d size = view.pixels(is_single ? kLongSide : kPanelSide);
  const Eigen::Vector2d cell(std::max(kLeft + size.x() + kRight, kMinWidth),
                             kMapTop + size.y() + kBottom);
  const std::size_t columns = std::min(pictures.size(), kPanelsInARow);
  const std::size_t rows = (pictures.size() + kPanelsInARow - 1) / kPanelsInARow;
  Svg svg(cell.x() * static_cast<double>(columns), cell.y() * static_cast<double>(rows));
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string letter =
        is_single ? "" : fmt::format("({}) ", static_cast<char>('a' + i % 26));
    const Eigen::Vector2d from(cell.x() * static_cast<double>(i % kPanelsInARow) + kLeft,
                               cell.y() * static_cast<double>(i / kPanelsInARow) + kMapTop);
    drawMap(svg, view, pictures[i], letter + pictures[i].title,
            frame(from.x(), from.y(), from.x() + size.x(), from.y() + size.y()));
  }
  return svg.take();
}

}  // namespace tolman::report
