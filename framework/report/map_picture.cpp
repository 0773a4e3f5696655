// SPDX-License-Identifier: BSD-3-Clause
#include "report/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tolman::report {
namespace {

// Okabe and Ito's colours, which colour-blind people can tell apart.
constexpr const char* kTruthColour = "#999999";
constexpr const char* kOdometryColour = "#E69F00";
constexpr const char* kMapColour = "#0072B2";
constexpr const char* kExperienceColour = "#009E73";
constexpr const char* kLoopColour = "#D55E00";
constexpr double kLongSide = 860;  // px
constexpr double kMargin = 50;
constexpr double kLegendHeight = 70;

/// From metres in the plane to pixels. Forward at the start is up, or to the right where the path
/// is much longer than wide.
class Canvas {
 public:
  explicit Canvas(const MapPicture& picture) {
    for (const auto* line : {&picture.truth, &picture.odometry, &picture.map}) {
      for (const auto& pose : *line) box_.extend(inPlane(pose.T_world_camera.translation()));
    }
    if (box_.isEmpty()) box_.extend(Eigen::Vector2d::Zero());
    lying_ = box_.sizes().y() > 2 * box_.sizes().x();
    scale_ = kLongSide / std::max(box_.sizes().maxCoeff(), 1.0);
    Eigen::Vector2d size = scale_ * box_.sizes();
    if (lying_) std::swap(size.x(), size.y());
    width = std::max(size.x(), 420.0) + 2 * kMargin;
    height = size.y() + 2 * kMargin + kLegendHeight;
    left_ = (width - size.x()) / 2;
  }

  /// x to the right, y down, px.
  Eigen::Vector2d at(const Eigen::Vector3d& p) const {
    const Eigen::Vector2d right_forward = inPlane(p) - box_.min();
    const double from_top = box_.sizes().y() - right_forward.y();
    const Eigen::Vector2d metres = lying_ ? Eigen::Vector2d(right_forward.y(), right_forward.x())
                                          : Eigen::Vector2d(right_forward.x(), from_top);
    return scale_ * metres + Eigen::Vector2d(left_, kMargin + kLegendHeight);
  }
  double pixels(double metres) const { return metres * scale_; }
  double metres(double pixel_count) const { return pixel_count / scale_; }

  double width = 0;
  double height = 0;

 private:
  static Eigen::Vector2d inPlane(const Eigen::Vector3d& p) { return {p.x(), p.z()}; }
  Eigen::AlignedBox2d box_;
  bool lying_ = false;
  double scale_ = 1;
  double left_ = 0;
};

std::string polyline(const Canvas& canvas, const evaluation::Trajectory& line, const char* colour,
                     double width) {
  std::string points;
  for (const auto& pose : line) {
    const Eigen::Vector2d p = canvas.at(pose.T_world_camera.translation());
    points += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
  }
  return fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" points=\"{}\"/>\n",
                     colour, width, points);
}

std::string graphText(const Canvas& canvas, const MapGraph& graph) {
  std::string text;
  const auto at = [&](std::int64_t id) {
    return canvas.at(
        graph.experiences[static_cast<std::size_t>(id)].T_world_experience.translation());
  };
  for (const Link& link : graph.links) {
    if (link.kind != LinkKind::Loop) continue;
    const Eigen::Vector2d a = at(link.from);
    const Eigen::Vector2d b = at(link.to);
    text += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"2\"/>\n",
        a.x(), a.y(), b.x(), b.y(), kLoopColour);
  }
  for (const Experience& experience : graph.experiences) {
    const Eigen::Vector2d p = at(experience.id);
    text +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"none\" stroke=\"{}\"/>\n",
                    p.x(), p.y(), kExperienceColour);
  }
  return text;
}

/// A round length that takes about a fifth of the width.
std::string scaleBar(const Canvas& canvas) {
  const double wanted = canvas.metres(canvas.width / 5);
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  const double digit = wanted / power;
  const double metres = power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
  const double y = canvas.height - 20;
  return fmt::format(
      "<line x1=\"20\" y1=\"{0:.1f}\" x2=\"{1:.1f}\" y2=\"{0:.1f}\" stroke=\"black\" "
      "stroke-width=\"3\"/><text x=\"20\" y=\"{2:.1f}\">{3:g} m</text>\n",
      y, 20 + canvas.pixels(metres), y - 6, metres);
}

std::string legend(const MapPicture& picture) {
  std::string text =
      fmt::format("<text x=\"20\" y=\"26\" font-size=\"16\">{}</text>\n", picture.title);
  double x = 20;
  const auto entry = [&](const char* colour, const std::string& name) {
    text += fmt::format(
        "<rect x=\"{:.0f}\" y=\"42\" width=\"14\" height=\"8\" fill=\"{}\"/>"
        "<text x=\"{:.0f}\" y=\"50\">{}</text>\n",
        x, colour, x + 19, name);
    x += 30 + 7.2 * static_cast<double>(name.size());
  };
  if (!picture.truth.empty()) entry(kTruthColour, "truth");
  entry(kOdometryColour, "odometry");
  entry(kMapColour, "map");
  entry(kExperienceColour, fmt::format("{} experiences", picture.graph.experiences.size()));
  entry(kLoopColour, "loop links");
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return safe;
}

}  // namespace

std::string svgText(const MapPicture& picture) {
  const Canvas canvas(picture);
  MapPicture shown = picture;
  shown.title = escaped(picture.title);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      canvas.width, canvas.height);
  text += legend(shown) + scaleBar(canvas);
  if (!shown.truth.empty()) text += polyline(canvas, shown.truth, kTruthColour, 4);
  text += polyline(canvas, shown.odometry, kOdometryColour, 1.5);
  text += polyline(canvas, shown.map, kMapColour, 1.5);
  return text + graphText(canvas, shown.graph) + "</svg>\n";
}

}  // namespace tolman::report
