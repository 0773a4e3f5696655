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

/// Panels with the same axes; if there are several, their titles begin with a letter.
class Panels {
 public:
  Panels(const std::vector<MapPicture>& pictures, double long_side)
      : pictures_(pictures), view_(pictures), size_(view_.pixels(long_side)) {}

  /// Size of a panel with its labels, px.
  Eigen::Vector2d cell() const {
    return {std::max(kLeft + size_.x() + kRight, kMinWidth), kMapTop + size_.y() + kBottom};
  }
  /// Draws panel i; `corner` is the upper left corner of its cell.
  void draw(Svg& svg, std::size_t i, const Eigen::Vector2d& corner) const {
    const std::string letter =
        pictures_.size() > 1 ? fmt::format("({}) ", static_cast<char>('a' + i % 26)) : "";
    const Eigen::Vector2d from = corner + Eigen::Vector2d(kLeft, kMapTop);
    const Eigen::Vector2d to = from + size_;
    drawMap(svg, view_, pictures_[i], letter + pictures_[i].title,
            frame(from.x(), from.y(), to.x(), to.y()));
  }

 private:
  const std::vector<MapPicture>& pictures_;
  PlanView view_;
  Eigen::Vector2d size_;
};

std::string panelRows(const std::vector<MapPicture>& pictures, double long_side) {
  const Panels panels(pictures, long_side);
  const Eigen::Vector2d cell = panels.cell();
  const std::size_t columns = std::min(pictures.size(), kPanelsInARow);
  const std::size_t rows = (pictures.size() + kPanelsInARow - 1) / kPanelsInARow;
  Svg svg(cell.x() * static_cast<double>(columns), cell.y() * static_cast<double>(rows));
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::size_t column = i % kPanelsInARow;
    const std::size_t row = i / kPanelsInARow;
    panels.draw(svg, i,
                {cell.x() * static_cast<double>(column), cell.y() * static_cast<double>(row)});
  }
  return svg.take();
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

std::string svgText(const MapPicture& picture) { return panelRows({picture}, kLongSide); }

std::string comparisonText(const std::vector<MapPicture>& pictures) {
  return panelRows(pictures, kPanelSide);
}

std::vector<std::string> mapTexts(const std::vector<MapPicture>& pictures) {
  const Panels panels(pictures, kPanelSide);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    Svg svg(panels.cell().x(), panels.cell().y());
    panels.draw(svg, i, Eigen::Vector2d::Zero());
    texts.push_back(svg.take());
  }
  return texts;
}

}  // namespace tolman::report
