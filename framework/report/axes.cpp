// SPDX-License-Identifier: BSD-3-Clause
#include "report/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tolman::report {
namespace {

double stepOf(const Range& range, int wanted) {
  const double rough = range.length() / std::max(wanted, 1);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  const double digit = rough / power;
  return power * (digit > 5 ? 10 : digit > 2 ? 5 : digit > 1 ? 2 : 1);
}

/// Of the entries from the first one, px: lines of at most this width.
std::vector<Eigen::Vector2d> legendPlaces(const std::vector<Axes::LegendEntry>& entries,
                                          double width) {
  constexpr double kLetter = 6.1;
  std::vector<Eigen::Vector2d> places;
  Eigen::Vector2d at(0, 0);
  for (const Axes::LegendEntry& entry : entries) {
    const double own = 34 + kLetter * static_cast<double>(entry.name.size());
    if (at.x() > 0 && at.x() + own > width) at = {0, at.y() + 14};
    places.push_back(at);
    at.x() += own;
  }
  return places;
}

}  // namespace

void Range::include(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

std::vector<double> ticks(const Range& range, int wanted) {
  if (!(range.length() > 0) || !std::isfinite(range.length())) return {range.low};
  const double step = stepOf(range, wanted);
  const double slack = 1e-9 * range.length();
  const double first = std::ceil((range.low - slack) / step);
  if (std::abs(first) > 1e12) return {range.low};  // the step is below double precision
  std::vector<double> values;
  for (double i = first; i * step <= range.high + slack; ++i) values.push_back(i * step);
  return values;
}

std::string tickText(double value, double step) {
  constexpr double kMaxDecimals = 9;
  const bool is_step = step > 0 && std::isfinite(step);
  const double decimals =
      is_step ? std::clamp(-std::floor(std::log10(step) + 1e-9), 0.0, kMaxDecimals) : 0;
  const double clean = std::abs(value) < 1e-9 * std::max(step, 1e-300) ? 0 : value;
  return fmt::format("{:.{}f}", clean, static_cast<int>(decimals));
}

Axes::Axes(Svg& svg, AxesPlan plan) : svg_(svg), plan_(std::move(plan)) {
  for (Range* range : {&plan_.x, &plan_.y}) {
    if (range->length() < 0) *range = Range();
    if (!(range->length() > 0)) range->high = range->low + 1;
  }
  fit();
  svg_.rectangle(plan_.place.min(), plan_.place.sizes(), kPaper, "none");
  draw(false);
  if (!plan_.y_label.empty()) draw(true);
  svg_.rectangle(plan_.place.min(), plan_.place.sizes(), "none", kFrameLine);
  const double middle = plan_.place.center().x();
  svg_.text({middle, plan_.place.min().y() - 26}, plan_.title, {TextAnchor::Middle, 13, 0, true});
}

void Axes::fit() {
  Eigen::Vector2d sizes = plan_.place.sizes();
  scale_ = {sizes.x() / plan_.x.length(), sizes.y() / plan_.y.length()};
  if (!plan_.equal) return;
  scale_.setConstant(scale_.minCoeff());
  const Eigen::Vector2d wanted(scale_.x() * plan_.x.length(), scale_.y() * plan_.y.length());
  const Eigen::Vector2d corner(plan_.place.center().x() - wanted.x() / 2, plan_.place.min().y());
  plan_.place = Eigen::AlignedBox2d(corner, corner + wanted);
}

/// The lower or the left side of the box; distances in px.
void Axes::draw(bool vertical) {
  constexpr double kTick = 4;
  const Range& range = vertical ? plan_.y : plan_.x;
  const Eigen::Vector2d sizes = plan_.place.sizes();
  const int row = vertical ? 1 : 0;
  const Eigen::Vector2d outward(vertical ? -1 : 0, vertical ? 0 : 1);
  const Eigen::Vector2d text(vertical ? -7 : 0, vertical ? 4 : 17);  // from the foot of a tick
  const int wanted = std::max(2, static_cast<int>(sizes[row] / (vertical ? 40 : 75)));
  const auto values = ticks(range, wanted);
  const double step = values.size() > 1 ? values[1] - values[0] : range.length();
  for (const double value : values) {
    const Eigen::Vector2d foot = vertical ? at(plan_.x.low, value) : at(value, plan_.y.low);
    svg_.line(foot, foot - sizes[1 - row] * outward, kGridLine);
    svg_.line(foot, foot + kTick * outward, kFrameLine);
    svg_.text(foot + text, tickText(value, step),
              {vertical ? TextAnchor::End : TextAnchor::Middle, 11});
  }
  Eigen::Vector2d middle = plan_.place.center();
  middle[1 - row] = vertical ? plan_.place.min().x() : plan_.place.max().y();
  svg_.text(middle + (vertical ? 46 : 34) * outward, vertical ? plan_.y_label : plan_.x_label,
            {TextAnchor::Middle, 12, vertical ? -90.0 : 0.0});
}

Eigen::Vector2d Axes::at(double x, double y) const {
  return {plan_.place.min().x() + (x - plan_.x.low) * scale_.x(),
          plan_.place.max().y() - (y - plan_.y.low) * scale_.y()};
}

void Axes::polyline(const std::vector<double>& x, const std::vector<double>& y, const char* colour,
                    double thickness) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    points.push_back(at(std::clamp(x[i], plan_.x.low, plan_.x.high),
                        std::clamp(y[i], plan_.y.low, plan_.y.high)));
  }
  svg_.polyline(points, colour, thickness);
}

void Axes::legend(const std::vector<LegendEntry>& entries) {
  const auto places = legendPlaces(entries, plan_.place.sizes().x());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double up = places.back().y() - places[i].y() + 8;
    const Eigen::Vector2d at = plan_.place.min() + Eigen::Vector2d(places[i].x(), -up);
    svg_.line(at - Eigen::Vector2d(0, 4), at + Eigen::Vector2d(16, -4), entries[i].colour, 3);
    svg_.text(at + Eigen::Vector2d(20, 0), entries[i].name, {TextAnchor::Start, 11});
  }
}

namespace {

std::vector<Axes::LegendEntry> legendOf(const std::vector<Curve>& curves) {
  std::vector<Axes::LegendEntry> entries;
  for (const Curve& curve : curves) {
    if (!curve.name.empty()) entries.push_back({curve.colour, curve.name});
  }
  return entries;
}

}  // namespace

Axes plot(Svg& svg, AxesPlan plan, const std::vector<Curve>& curves) {
  const bool is_free = plan.y.length() < 0;
  for (const Curve& curve : curves) {
    for (const double x : curve.x) plan.x.include(x);
    for (const auto* values : {&curve.y, &curve.low, &curve.high}) {
      for (const double y : *values) plan.y.include(y);
    }
  }
  if (is_free && plan.y.length() >= 0) {
    const double margin = 0.05 * plan.y.length() + 1e-9;
    const bool is_near_zero = plan.y.low >= 0 && plan.y.low < 0.5 * plan.y.high;
    plan.y = {is_near_zero ? 0 : plan.y.low - margin, plan.y.high + margin};
  }
  Axes axes(svg, std::move(plan));
  for (const Curve& curve : curves) {
    std::vector<Eigen::Vector2d> border;
    for (std::size_t i = 0; i < curve.low.size(); ++i) {
      border.push_back(axes.at(curve.x[i], curve.low[i]));
    }
    for (std::size_t i = curve.high.size(); i > 0; --i) {
      border.push_back(axes.at(curve.x[i - 1], curve.high[i - 1]));
    }
    if (!border.empty()) svg.area(border, curve.colour, 0.2);
  }
  for (const Curve& curve : curves) {
    axes.polyline(curve.x, curve.y, curve.colour, curve.thickness);
    for (std::size_t i = 0; curve.dots && i < curve.x.size(); ++i) {
      svg.circle(axes.at(curve.x[i], curve.y[i]), 3, curve.colour);
    }
  }
  axes.legend(legendOf(curves));
  return axes;
}

std::string curveFigure(AxesPlan plan, const std::vector<Curve>& curves,
                        const Eigen::Vector2d& size) {
  constexpr double kLeft = 64, kRight = 12, kFoot = 44;
  std::vector<Curve> named = curves;
  if (named.size() == 1 && plan.title.empty()) named[0].name.clear();
  const auto places = legendPlaces(legendOf(named), size.x() - kRight - kLeft);
  const double top = (plan.title.empty() ? 0 : 30) + (places.empty() ? 8 : 22 + places.back().y());
  plan.place = frame(kLeft, top, size.x() - kRight, size.y() - kFoot);
  Svg svg(size.x(), size.y());
  plot(svg, std::move(plan), named);
  return svg.take();
}

}  // namespace tolman::report
