// SPDX-License-Identifier: BSD-3-Clause
#include "street_sections.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::town {
namespace {

constexpr double kJoins = 5;           ///< m between centrelines at which a known street begins
constexpr double kLeaves = 7;          ///< m at which it ends: larger, so that it is not split
constexpr std::size_t kShortest = 6;   ///< points; shorter streets and interruptions are ignored
constexpr double kSmallestStep = 0.2;  ///< m; smaller advances are on the inside of a tight bend

/// Collects the parts of the path that were not driven before.
class SectionFinder {
 public:
  explicit SectionFinder(const std::vector<PathPoint>& path) : path_(path), kept_(path.size()) {}

  std::vector<std::vector<std::size_t>> find() {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (path_[i].raised) {
        closeSection();
        known_run_.clear();
      } else if (isKnown(i)) {
        known_run_.push_back(i);
        if (known_run_.size() == kShortest) closeSection();
      } else {
        // A short interruption belongs to the street after it.
        if (known_run_.size() < kShortest && !section_.empty()) keepAll(known_run_);
        known_run_.clear();
        keepAll({i});
      }
    }
    closeSection();
    return std::move(found_);
  }

 private:
  bool isKnown(std::size_t index) const {
    const double reach = known_run_.empty() ? kJoins : kLeaves;
    const std::vector<std::size_t> candidates = grid_.near(path_[index].centre);
    return std::any_of(candidates.begin(), candidates.end(), [&](std::size_t other) {
      return kept_[other] && isSameStreet(path_[index], path_[other], reach);
    });
  }

  void keepAll(const std::vector<std::size_t>& indices) {
    for (const std::size_t index : indices) {
      section_.push_back(index);
      kept_[index] = true;
      grid_.add(path_[index].centre, index);
    }
  }

  void closeSection() {
    if (section_.size() >= kShortest) {
      found_.push_back(section_);
    } else {
      for (const std::size_t index : section_) kept_[index] = false;
    }
    section_.clear();
  }

  const std::vector<PathPoint>& path_;
  std::vector<bool> kept_;
  PointGrid grid_;
  std::vector<std::size_t> section_;
  std::vector<std::size_t> known_run_;
  std::vector<std::vector<std::size_t>> found_;
};

/// The centreline through the points, with s, without points that go backwards.
std::vector<StreetPoint> centreline(const std::vector<PathPoint>& path,
                                    const std::vector<std::size_t>& indices) {
  std::vector<StreetPoint> line;
  for (const std::size_t index : indices) {
    const PathPoint& point = path[index];
    double s = 0;
    if (!line.empty()) {
      const Eigen::Vector2d step = point.centre - line.back().position;
      if (step.dot(point.direction) < kSmallestStep) continue;
      s = line.back().s + step.norm();
    }
    line.push_back({point.centre, point.direction, s});
  }
  return line;
}

StreetSection everyMetre(const std::vector<StreetPoint>& line) {
  StreetSection section;
  std::size_t i = 0;
  for (double s = 0; s <= line.back().s; s += 1) {
    while (i + 2 < line.size() && line[i + 1].s <= s) ++i;
    const StreetPoint& a = line[i];
    const StreetPoint& b = line[i + 1];
    const double t = (s - a.s) / (b.s - a.s);
    section.points.push_back({a.position + t * (b.position - a.position),
                              (a.direction + t * (b.direction - a.direction)).normalized(), s});
  }
  return section;
}

}  // namespace

std::vector<StreetSection> findSections(const std::vector<PathPoint>& path) {
  std::vector<StreetSection> sections;
  for (const std::vector<std::size_t>& indices : SectionFinder(path).find()) {
    const std::vector<StreetPoint> line = centreline(path, indices);
    if (line.size() >= 2 && line.back().s >= static_cast<double>(kShortest - 1)) {
      sections.push_back(everyMetre(line));
    }
  }
  return sections;
}

}  // namespace tolman::town
