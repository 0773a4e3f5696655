// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>

#include "config/text.hpp"
#include "experiment/sweep_file.hpp"

namespace tolman::experiment {
namespace {

constexpr std::size_t kMaxPoints = 100'000;

void join(SweepPoint& point, const Choice& choice) {
  for (const Factor& factor : choice.factors) point.factors.push_back(factor);
  for (const Setting& setting : choice.settings) point.settings.push_back(setting);
  if (choice.front_end) point.front_end = choice.front_end;
}

/// Combines each point with each choice; the axis varies fastest.
std::vector<SweepPoint> times(const std::vector<SweepPoint>& points, const Axis& axis) {
  std::vector<SweepPoint> product;
  for (const SweepPoint& point : points) {
    for (const Choice& choice : axis) {
      if (product.size() > kMaxPoints) return product;
      join(product.emplace_back(point), choice);
    }
  }
  return product;
}

/// The keys of single values that a setting sets.
void addKeys(const std::string& key, const config::Node& value,
             std::map<std::string, config::Origin>& keys) {
  if (!value.isMap() || value.children.empty()) keys.emplace(key, value.origin);
  if (!value.isMap()) return;
  for (const config::Node& child : value.children) addKeys(key + "." + child.key, child, keys);
}

std::map<std::string, config::Origin> keysOf(const Axis& axis) {
  std::map<std::string, config::Origin> keys;
  for (const Choice& choice : axis) {
    for (const Setting& setting : choice.settings) addKeys(setting.key, *setting.value, keys);
  }
  return keys;
}

std::set<std::string> factorsOf(const Axis& axis) {
  std::set<std::string> names;
  for (const Choice& choice : axis) {
    for (const Factor& factor : choice.factors) names.insert(factor.name);
  }
  return names;
}

/// Refuses two axes that set the same key: the later one would override the other, whose label
/// would then be wrong.
void refuseOverlap(const Axis& a, const Axis& b, const std::string& file,
                   config::Problems& problems) {
  const std::set<std::string> names = factorsOf(a);
  for (const std::string& name : factorsOf(b)) {
    if (!names.contains(name)) continue;
    problems.push_back({config::Origin::ofFile(file), name,
                        "varies in two ways, and a run has one value of it; remove one of them"});
    return;
  }
  const auto others = keysOf(a);
  for (const auto& [key, origin] : keysOf(b)) {
    const auto same = std::ranges::find_if(others, [&](const auto& other) {
      return key == other.first || key.starts_with(other.first + ".") ||
             other.first.starts_with(key + ".");
    });
    if (same == others.end()) continue;
    problems.push_back(
        {origin, key,
         "is set at " + config::text(same->second) + " for the same runs; remove one of the two"});
    return;
  }
}

void refuseOverlaps(const SweepFile& sweep, config::Problems& problems) {
  std::vector<const Axis*> product;
  for (const Axis& axis : sweep.axes) product.push_back(&axis);
  for (const Axis& axis : sweep.repeats) product.push_back(&axis);
  for (std::size_t b = 1; b < product.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a)
      refuseOverlap(*product[a], *product[b], sweep.file, problems);
  }
  for (const Axis& axis : sweep.repeats) {
    refuseOverlap(sweep.include, axis, sweep.file, problems);
  }
}

void removeExcluded(std::vector<SweepPoint>& points, const SweepFile& sweep,
                    config::Problems& problems) {
  std::vector<std::string> names;
  for (const SweepPoint& point : points) {
    for (const Factor& factor : point.factors) {
      if (std::ranges::find(names, factor.name) == names.end()) names.push_back(factor.name);
    }
  }
  for (const Exclusion& exclusion : sweep.exclude) {
    const auto refuse = [&](const std::string& why) {
      problems.push_back({exclusion.origin, "exclude", why});
    };
    for (const auto& [factor, labels] : exclusion.conditions) {
      if (std::ranges::find(names, factor) != names.end()) continue;
      refuse("no factor '" + factor + "'" + config::didYouMean(factor, names) +
             "; factors: " + config::listed(names));
    }
    const std::size_t removed = std::erase_if(points, [&](const SweepPoint& point) {
      return std::ranges::all_of(exclusion.conditions, [&](const auto& condition) {
        return std::ranges::any_of(point.factors, [&](const Factor& factor) {
          return factor.name == condition.first &&
                 std::ranges::find(condition.second, factor.label) != condition.second.end();
        });
      });
    });
    if (removed == 0) refuse("leaves out no point; remove the entry, or correct its labels");
    if (points.empty()) return refuse("leaves out all points that were left");
  }
}

/// Names of factors, shortened to the last part if that is unique: "period" for "cells.period".
std::map<std::string, std::string> shortNames(const std::vector<SweepPoint>& points) {
  std::map<std::string, std::set<std::string>> by_end;
  for (const SweepPoint& point : points) {
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

void nameAll(std::vector<SweepPoint>& points, const SweepFile& sweep) {
  const auto names = shortNames(points);
  std::map<std::string, int> taken;
  for (SweepPoint& point : points) {
    for (const Factor& factor : point.factors) {
      point.name += (point.name.empty() ? "" : ",") + names.at(factor.name) + "=" + factor.label;
    }
    if (point.name.empty()) point.name = sweep.name;
    const int before = taken[point.name]++;
    if (before > 0) point.name += "#" + std::to_string(before + 1);
  }
}

}  // namespace

std::vector<SweepPoint> pointsOf(const SweepFile& sweep, config::Problems& problems) {
  refuseOverlaps(sweep, problems);
  std::vector<SweepPoint> points(1);
  const bool only_included = sweep.axes.empty() && !sweep.include.empty();
  if (only_included) points.clear();
  for (const Axis& axis : sweep.axes) points = times(points, axis);
  for (const SweepPoint& point : times(std::vector<SweepPoint>(1), sweep.include))
    points.push_back(point);
  for (const Axis& axis : sweep.repeats) points = times(points, axis);
  if (points.size() > kMaxPoints) {
    problems.push_back({config::Origin::ofFile(sweep.file), "", "has more than 100000 points"});
    return {};
  }
  removeExcluded(points, sweep, problems);
  nameAll(points, sweep);
  return points;
}

}  // namespace tolman::experiment
