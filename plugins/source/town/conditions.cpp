// SPDX-License-Identifier: BSD-3-Clause
#include "conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <sstream>
#include <string_view>

#include "noise.hpp"
#include "street_path.hpp"

namespace tolman::town {
namespace {

constexpr double kSamePlace = 5;      ///< m between frames of two passes
constexpr double kShortMeeting = 15;  ///< m
constexpr double kChange = 10;        ///< m to either side over which light changes
const double kAlongStreet = std::cos(35 * std::numbers::pi / 180);

struct Word {
  std::string_view name;
  void (*change)(Condition&);
};

constexpr std::array<Word, 8> kWords = {{
    {"dusk", [](Condition& c) { c.hour = 19.3; }},
    {"night", [](Condition& c) { c.hour = 0, c.is_night = true; }},
    {"overcast", [](Condition& c) { c.weather = Weather::Overcast; }},
    {"haze", [](Condition& c) { c.haze = 0.004; }},
    {"rain", [](Condition& c) { c.weather = Weather::Rain; }},
    {"snow", [](Condition& c) { c.snow = true; }},
    {"bare", [](Condition& c) { c.bare = true; }},
    {"exchanged", [](Condition& c) { c.exchanged = true; }},
}};

/// Passes and what holds on them.
struct Entry {
  std::string text;
  int first = 1;
  int last = std::numeric_limits<int>::max();
  std::vector<std::function<void(Condition&)>> changes;
};

/// A word, or a time such as 18:30; empty for anything else.
std::function<void(Condition&)> changeBy(const std::string& word) {
  const auto* known = std::ranges::find(kWords, word, &Word::name);
  if (known != kWords.end()) return known->change;
  unsigned hours = 0;
  unsigned minutes = 0;
  int end = 0;
  const bool is_time = std::sscanf(word.c_str(), "%2u:%2u%n", &hours, &minutes, &end) == 2 &&
                       static_cast<std::size_t>(end) == word.size() && hours < 24 && minutes < 60;
  if (!is_time) return {};
  return [hour = hours + minutes / 60.0](Condition& c) { c.hour = hour, c.is_night = false; };
}

Status refuse(const std::string& entry, const std::string& what) {
  return Status::invalidParameter("conditions: '" + entry + "': " + what);
}

/// "pass 2" or "pass 2-3".
bool readPasses(const std::string& text, Entry& entry) {
  int end = 0;
  if (std::sscanf(text.c_str(), " pass %d-%d %n", &entry.first, &entry.last, &end) != 2) {
    if (std::sscanf(text.c_str(), " pass %d %n", &entry.first, &end) != 1) return false;
    entry.last = entry.first;
  }
  return static_cast<std::size_t>(end) == text.size() && entry.first >= 1 &&
         entry.last >= entry.first;
}

Result<std::vector<Entry>> parse(const std::string& text) {
  std::vector<Entry> entries;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    Entry entry;
    entry.text = part;
    const std::size_t equals = part.find('=');
    if (equals != std::string::npos && !readPasses(part.substr(0, equals), entry)) {
      return refuse(part, "write 'pass 2 =' or 'pass 2-3 =', or only what holds everywhere");
    }
    std::istringstream words(equals == std::string::npos ? part : part.substr(equals + 1));
    for (std::string word; words >> word;) {
      entry.changes.push_back(changeBy(word));
      if (entry.changes.back()) continue;
      std::string known = "18:30";
      for (const Word& one : kWords) known.append(", ").append(one.name);
      return refuse(part, "'" + word + "' is no condition; use " + known);
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<double> drivenMetres(const CameraRoute& route) {
  std::vector<double> driven = {0};
  for (std::size_t i = 1; i < route.T_town_camera.size(); ++i) {
    driven.push_back(
        driven.back() +
        (route.T_town_camera[i].translation() - route.T_town_camera[i - 1].translation()).norm());
  }
  return driven;
}

/// Gives runs shorter than kShortMeeting the number of the run before them.
void dropShortRuns(std::vector<int>& passes, const std::vector<double>& driven) {
  for (std::size_t begin = 0; begin < passes.size();) {
    std::size_t end = begin + 1;
    while (end < passes.size() && passes[end] == passes[begin]) ++end;
    const bool is_short = end < passes.size() && driven[end] - driven[begin] < kShortMeeting;
    for (std::size_t i = begin; begin > 0 && is_short && i < end; ++i)
      passes[i] = passes[begin - 1];
    begin = end;
  }
}

Light lightOf(const Condition& condition, std::uint32_t seed) {
  Light light = makeLight(condition.hour, condition.weather, condition.haze, hash(seed, 303));
  if (condition.is_night) makeNight(light);
  light.wet = light.rain = condition.weather == Weather::Rain ? 1 : 0;
  light.snow = condition.snow ? 1 : 0;
  return light;
}

}  // namespace

std::vector<int> passNumbers(const CameraRoute& route) {
  const std::vector<double> driven = drivenMetres(route);
  std::vector<int> passes;
  PointGrid grid;
  const auto placeOf = [&](std::size_t i) -> Eigen::Vector2d {
    return route.T_town_camera[i].translation().head<2>();
  };
  const auto headingOf = [&](std::size_t i) -> Eigen::Vector2d {
    return route.T_town_camera[i].linear().col(2).head<2>().normalized();
  };
  for (std::size_t i = 0; i < driven.size(); ++i) {
    int before = 0;
    for (const std::size_t other : grid.near(placeOf(i))) {
      const bool meets = driven[i] - driven[other] > kOtherPass &&
                         (placeOf(i) - placeOf(other)).norm() < kSamePlace &&
                         std::abs(headingOf(i).dot(headingOf(other))) > kAlongStreet;
      if (meets) before = std::max(before, passes[other]);
    }
    passes.push_back(before + 1);
    grid.add(placeOf(i), i);
  }
  dropShortRuns(passes, driven);
  return passes;
}

Result<Conditions> Conditions::make(const std::string& text, const CameraRoute& route,
                                    std::uint32_t seed) {
  const Result<std::vector<Entry>> entries = parse(text);
  if (!entries.isOk()) return entries.status();
  Conditions made;
  made.conditions_.resize(route.T_town_camera.size());
  made.driven_ = drivenMetres(route);
  const std::vector<int> passes = entries.value().empty() ? std::vector<int>{} : passNumbers(route);
  for (const Entry& entry : entries.value()) {
    bool holds = false;
    for (std::size_t i = 0; i < passes.size(); ++i) {
      if (passes[i] < entry.first || passes[i] > entry.last) continue;
      holds = true;
      for (const auto& change : entry.changes) change(made.conditions_[i]);
    }
    if (holds) continue;
    made.warnings_.push_back("conditions: '" + entry.text +
                             "' holds at no frame: a place is driven at most " +
                             std::to_string(*std::ranges::max_element(passes)) + " times");
  }
  for (const Condition& condition : made.conditions_) {
    made.lights_.push_back(lightOf(condition, seed));
  }
  return made;
}

Light Conditions::lightAt(std::size_t frame) const {
  std::size_t first = frame;
  std::size_t end = frame + 1;
  while (first > 0 && driven_[frame] - driven_[first - 1] <= kChange) --first;
  while (end < driven_.size() && driven_[end] - driven_[frame] <= kChange) ++end;
  bool is_one = true;
  for (std::size_t i = first; i < end; ++i) {
    is_one = is_one && conditions_[i] == conditions_[frame];
  }
  return is_one ? lights_[frame] : meanOf({lights_.data() + first, end - first});
}

}  // namespace tolman::town
