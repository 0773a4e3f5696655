// SPDX-License-Identifier: BSD-3-Clause
#include "app/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tolman::app {
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

/// From metres in the plane (x right, z forward) to pixels.
class Canvas {
 public:
  explicit Canvas(const MapPicture& picture) {
    for (const auto* line : {&picture.truth, &picture.odometry, &picture.map}) {
      for (const auto& pose : *line) include(pose.T_world_camera.translation());
    }
    if (low_x_ > high_x_) low_x_ = high_x_ = low_z_ = high_z_ = 0;
    const double span = std::max({high_x_ - low_x_, high_z_ - low_z_, 1.0});
    scale_ = kLongSide / span;
    width = std::max((high_x_ - low_x_) * scale_, 420.0) + 2 * kMargin;
    height = (high_z_ - low_z_) * scale_ + 2 * kMargin + kLegendHeight;
    left_ = (width - (high_x_ - low_x_) * scale_) / 2;
  }

  double x(const Eigen::Vector3d& p) const { return left_ + (p.x() - low_x_) * scale_; }
  double y(const Eigen::Vector3d& p) const {
    return kMargin + kLegendHeight + (high_z_ - p.z()) * scale_;
  }
  double pixels(double metres) const { return metres * scale_; }
  double metres(double pixel_count) const { return pixel_count / scale_; }

  double width = 0;
  double height = 0;

 private:
  void include(const Eigen::Vector3d& p) {
    low_x_ = std::min(low_x_, p.x());
    high_x_ = std::max(high_x_, p.x());
    low_z_ = std::min(low_z_, p.z());
    high_z_ = std::max(high_z_, p.z());
  }
  double low_x_ = 1e300, high_x_ = -1e300, low_z_ = 1e300, high_z_ = -1e300;
  double scale_ = 1;
  double left_ = 0;
};

std::string polyline(const Canvas& canvas, const evaluation::Trajectory& line, const char* colour,
                     double width) {
  std::string points;
  for (const auto& pose : line) {
    const Eigen::Vector3d p = pose.T_world_camera.translation();
    points += fmt::format("{:.1f},{:.1f} ", canvas.x(p), canvas.y(p));
  }
  return fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" points=\"{}\"/>\n",
                     colour, width, points);
}

std::string graphText(const Canvas& canvas, const MapGraph& graph) {
  std::string text;
  const auto at = [&](std::int64_t id) -> Eigen::Vector3d {
    return graph.experiences[static_cast<std::size_t>(id)].T_world_experience.translation();
  };
  for (const Link& link : graph.links) {
    if (link.kind != LinkKind::Loop) continue;
    const Eigen::Vector3d a = at(link.from);
    const Eigen::Vector3d b = at(link.to);
    text += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"2\"/>\n",
        canvas.x(a), canvas.y(a), canvas.x(b), canvas.y(b), kLoopColour);
  }
  for (const Experience& experience : graph.experiences) {
    const Eigen::Vector3d p = experience.T_world_experience.translation();
    text +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"none\" stroke=\"{}\"/>\n",
                    canvas.x(p), canvas.y(p), kExperienceColour);
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

}  // namespace tolman::app
