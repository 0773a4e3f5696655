// SPDX-License-Identifier: BSD-3-Clause
#include "report/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <utility>

#include "config/text.hpp"

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

std::string listOf(const std::vector<Eigen::Vector2d>& points) {
  std::string list;
  for (const auto& p : points) list += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
  return list;
}

/// Without the points that look like the one before: a long run has hundreds of them in a
/// pixel.
std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& points) {
  constexpr double kVisible = 0.2;  // px
  std::vector<Eigen::Vector2d> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_end = i + 1 == points.size();
    if (kept.empty() || is_end || (points[i] - kept.back()).norm() > kVisible) {
      kept.push_back(points[i]);
    }
  }
  return kept;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe = config::printable(text);
  for (const auto& [character, entity] : {std::pair("&", "&amp;"), std::pair("<", "&lt;"),
                                          std::pair(">", "&gt;"), std::pair("\"", "&quot;")}) {
    boost::replace_all(safe, character, entity);
  }
  return safe;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view colour,
               double thickness) {
  body_ += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
      "stroke-width=\"{:g}\"/>\n",
      from.x(), from.y(), to.x(), to.y(), colour, thickness);
}

void Svg::polyline(const std::vector<Eigen::Vector2d>& points, std::string_view colour,
                   double thickness) {
  body_ += fmt::format(
      "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" stroke-linejoin=\"round\" "
      "points=\"{}\"/>\n",
      colour, thickness, listOf(thinned(points)));
}

void Svg::area(const std::vector<Eigen::Vector2d>& border, std::string_view fill, double opacity) {
  body_ += fmt::format("<polygon fill=\"{}\" fill-opacity=\"{:g}\" points=\"{}\"/>\n", fill,
                       opacity, listOf(border));
}

void Svg::circle(const Eigen::Vector2d& centre, double radius, std::string_view fill,
                 std::string_view stroke) {
  body_ +=
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\" stroke=\"{}\"/>\n",
                  centre.x(), centre.y(), radius, fill, stroke);
}

void Svg::rectangle(const Eigen::Vector2d& corner, const Eigen::Vector2d& size,
                    std::string_view fill, std::string_view stroke) {
  body_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" "
      "stroke=\"{}\"/>\n",
      corner.x(), corner.y(), size.x(), size.y(), fill, stroke);
}

void Svg::image(const Eigen::Vector2d& corner, const Eigen::Vector2d& size, std::string_view url) {
  body_ += fmt::format(
      "<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
      "preserveAspectRatio=\"none\" "
      "image-rendering=\"optimizeSpeed\" href=\"{}\"/>\n",
      corner.x(), corner.y(), size.x(), size.y(), url);
}

void Svg::text(const Eigen::Vector2d& at, std::string_view text, const TextStyle& style) {
  const char* anchor = style.anchor == TextAnchor::Start    ? "start"
                       : style.anchor == TextAnchor::Middle ? "middle"
                                                            : "end";
  const std::string turn = style.turned_deg == 0
                               ? ""
                               : fmt::format(" transform=\"rotate({:g} {:.1f} {:.1f})\"",
                                             style.turned_deg, at.x(), at.y());
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{:g}\"{}{}>{}</text>\n",
      at.x(), at.y(), anchor, style.size, style.bold ? " font-weight=\"bold\"" : "", turn,
      escaped(text));
}

std::string Svg::take() const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
             "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"{2}\"/>\n",
             width_, height_, kPaper) +
         body_ + "</svg>\n";
}

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
