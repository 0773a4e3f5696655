// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/points.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "config/nearest_name.hpp"

namespace tolman::experiment {
namespace {

constexpr std::size_t kMostPoints = 100'000;

void join(Point& point, const Choice& choice) {
  for (const Factor& factor : choice.factors) point.factors.push_back(factor);
  for (const Setting& setting : choice.settings) point.settings.push_back(setting);
  if (choice.front_end) point.front_end = choice.front_end;
}

/// Each point with each choice; the axis varies fastest.
std::vector<Point> times(const std::vector<Point>& points, const Axis& axis) {
  std::vector<Point> product;
  for (const Point& point : points) {
    for (const Choice& choice : axis) {
      if (product.size() > kMostPoints) return product;
      join(product.emplace_back(point), choice);
    }
  }
  return product;
}

bool meets(const Point& point, const Exclusion::Condition& condition) {
  return std::ranges::any_of(point.factors, [&](const Factor& factor) {
    return factor.name == condition.factor &&
           std::ranges::find(condition.labels, factor.label) != condition.labels.end();
  });
}

void removeExcluded(std::vector<Point>& points, const SweepFile& sweep,
                    config::Problems& problems) {
  std::vector<std::string> names;
  for (const Point& point : points) {
    for (const Factor& factor : point.factors) {
      if (std::ranges::find(names, factor.name) == names.end()) names.push_back(factor.name);
    }
  }
  for (const Exclusion& exclusion : sweep.exclude) {
    for (const auto& condition : exclusion.conditions) {
      if (std::ranges::find(names, condition.factor) != names.end()) continue;
      problems.push_back({exclusion.origin, "exclude",
                          "no factor '" + condition.factor + "'" +
                              config::didYouMean(condition.factor, names) +
                              "; factors: " + config::listed(names)});
    }
    const std::size_t removed = std::erase_if(points, [&](const Point& point) {
      return std::ranges::all_of(exclusion.conditions,
                                 [&](const auto& condition) { return meets(point, condition); });
    });
    if (removed == 0) problems.push_back({exclusion.origin, "exclude", "leaves out no point"});
  }
}

/// Factors by their last part where that is unique: "period" for "cells.period".
std::map<std::string, std::string> shortNames(const std::vector<Point>& points) {
  std::map<std::string, std::set<std::string>> by_end;
  for (const Point& point : points) {
    for (const Factor& factor : point.factors) {
      by_end[factor.name.substr(factor.name.rfind('.') + 1)].insert(factor.name);
    }
  }
  std::map<std::string, std::string> names;
  for (const auto& [end, full] : by_end) {
    for (const std::string& name : full) names[name] = full.size() == 1 ? end : name;
  }
  return names;
}

void nameAll(std::vector<Point>& points, const SweepFile& sweep) {
  const auto names = shortNames(points);
  std::map<std::string, int> taken;
  for (Point& point : points) {
    for (const Factor& factor : point.factors) {
      point.name += (point.name.empty() ? "" : ",") + names.at(factor.name) + "=" + factor.label;
    }
    if (point.name.empty()) point.name = sweep.name;
    const int before = taken[point.name]++;
    if (before > 0) point.name += "#" + std::to_string(before + 1);
  }
}

}  // namespace

std::vector<Point> pointsOf(const SweepFile& sweep, config::Problems& problems) {
  std::vector<Point> points(1);
  const bool only_included = sweep.axes.empty() && !sweep.include.empty();
  if (only_included) points.clear();
  for (const Axis& axis : sweep.axes) points = times(points, axis);
  for (const Point& point : times(std::vector<Point>(1), sweep.include)) points.push_back(point);
  for (const Axis& axis : sweep.repeats) points = times(points, axis);
  if (points.size() > kMostPoints) {
    problems.push_back({config::Origin::ofFile(sweep.file), "", "has more than 100000 points"});
    return {};
  }
  removeExcluded(points, sweep, problems);
  nameAll(points, sweep);
  return points;
}

}  // namespace tolman::experiment
