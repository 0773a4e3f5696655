// SPDX-License-Identifier: BSD-3-Clause
#include "conditions.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <string_view>
#include <utility>

#include "street_path.hpp"

namespace tolman::town {
namespace {

constexpr double kSamePlace = 5;      ///< m between frames of two passes
constexpr double kShortMeeting = 15;  ///< m
const double kSameDirection = std::cos(35 * std::numbers::pi / 180);

/// Subject of a condition. Two words of the same subject exclude each other.
enum class Subject { Light, Weather, Ground, Leaves, Cars };

struct Word {
  std::string_view name;
  Subject subject;
  void (*change)(Condition&);
};

constexpr std::array<Word, 11> kWords = {{
    {"day", Subject::Light, [](Condition& c) { c.hour = 10.5, c.is_night = false; }},
    {"dusk", Subject::Light, [](Condition& c) { c.hour = 19.3, c.is_night = false; }},
    {"night", Subject::Light, [](Condition& c) { c.hour = 0, c.is_night = true; }},
    {"clear", Subject::Weather, [](Condition& c) { c.weather = Weather::Clear, c.rains = false; }},
    {"overcast", Subject::Weather,
     [](Condition& c) { c.weather = Weather::Overcast, c.rains = false; }},
    {"fog", Subject::Weather, [](Condition& c) { c.weather = Weather::Fog, c.rains = false; }},
    {"rain", Subject::Weather, [](Condition& c) { c.weather = Weather::Rain, c.rains = true; }},
    {"snow", Subject::Ground, [](Condition& c) { c.snow = true; }},
    {"bare", Subject::Leaves, [](Condition& c) { c.bare = true; }},
    {"leaf", Subject::Leaves, [](Condition& c) { c.bare = false; }},
    {"exchanged", Subject::Cars, [](Condition& c) { c.exchanged = true; }},
}};

const Word* findWord(std::string_view name) {
  const auto found = std::ranges::find(kWords, name, &Word::name);
  return found == kWords.end() ? nullptr : &*found;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    const std::size_t begin = part.find_first_not_of(" \t\n");
    if (begin == std::string::npos) continue;
    parts.push_back(part.substr(begin, part.find_last_not_of(" \t\n") - begin + 1));
  }
  return parts;
}

/// "2" or "2-4", numbers from `least`.
bool parseRange(std::string_view text, double least, ConditionEntry& entry) {
  const auto number = [](std::string_view digits) -> std::optional<double> {
    double value = 0;
    const auto [end, failure] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (failure != std::errc{} || end != digits.data() + digits.size() || !(value <= 1e6)) {
      return std::nullopt;
    }
    return value;
  };
  const std::size_t dash = text.find('-');
  const auto first = number(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : number(text.substr(dash + 1));
  if (!first || !last || *first < least || *last < *first) return false;
  entry.first = *first;
  entry.last = *last;
  return true;
}

Status refuse(const std::string& entry, const std::string& what) {
  return Status::invalidParameter("conditions: '" + entry + "': " + what);
}

/// "all", "pass 2", "pass 2-3" or "300-450 m".
bool parseWhere(const std::string& where, ConditionEntry& entry) {
  std::vector<std::string> parts = split(where, ' ');
  if (parts == std::vector<std::string>{"all"}) {
    entry.last = std::numeric_limits<double>::infinity();
    return true;
  }
  if (parts.size() != 2) return false;
  entry.is_pass = parts[0] == "pass";
  if (!entry.is_pass && (parts[1] != "m" || parts[0].find('-') == std::string::npos)) return false;
  const bool is_read = parseRange(parts[entry.is_pass ? 1 : 0], entry.is_pass ? 1 : 0, entry);
  return is_read && (!entry.is_pass || (std::floor(entry.first) == entry.first &&
                                        std::floor(entry.last) == entry.last));
}

Status checkWords(const std::string& entry, const std::vector<std::string>& words) {
  std::map<Subject, std::string> said;
  for (const std::string& word : words) {
    const Word* known = findWord(word);
    if (known == nullptr) {
      std::string text = "'" + word + "' is no condition; use ";
      for (const Word& one : kWords)
        text.append(&one == &kWords.front() ? "" : ", ").append(one.name);
      return refuse(entry, text);
    }
    const auto& [before, is_new] = said.emplace(known->subject, word);
    if (is_new || before->second == word) continue;
    return refuse(entry, "'" + before->second + "' and '" + word + "' exclude each other");
  }
  return Status::ok();
}

Result<ConditionEntry> parseEntry(const std::string& text) {
  const std::size_t equals = text.find('=');
  ConditionEntry entry;
  entry.text = text;
  if (equals == std::string::npos || !parseWhere(text.substr(0, equals), entry)) {
    return refuse(text,
                  "does not begin with a range; write 'pass 2 =', 'pass 2-3 =', "
                  "'300-450 m =' or 'all =', the smaller number first, passes from 1");
  }
  entry.words = split(text.substr(equals + 1), ' ');
  if (entry.words.empty()) return refuse(text, "says nothing; add words such as night or rain");
  if (Status status = checkWords(text, entry.words); !status.isOk()) return status;
  return entry;
}

/// Gives runs shorter than kShortMeeting the number of the run before them.
void dropShortRuns(std::vector<int>& passes, const std::vector<double>& driven) {
  for (std::size_t begin = 0; begin < passes.size();) {
    std::size_t end = begin + 1;
    while (end < passes.size() && passes[end] == passes[begin]) ++end;
    const bool is_short = end < passes.size() && driven[end] - driven[begin] < kShortMeeting;
    if (begin > 0 && is_short) {
      std::fill(passes.begin() + static_cast<std::ptrdiff_t>(begin),
                passes.begin() + static_cast<std::ptrdiff_t>(end), passes[begin - 1]);
    }
    begin = end;
  }
}

std::string nowhere(const ConditionEntry& entry, double driven, int passes) {
  std::string most = std::to_string(std::lround(driven)) + " m long";
  if (entry.is_pass && passes == 1) most = "never driven twice at one place";
  if (entry.is_pass && passes > 1) {
    most = "driven at most " + std::to_string(passes) + " times at one place";
  }
  return "conditions: '" + entry.text + "' holds at no frame: the route is " + most;
}

}  // namespace

Result<std::vector<ConditionEntry>> parseConditions(const std::string& text) {
  std::vector<ConditionEntry> entries;
  for (const std::string& part : split(text, ';')) {
    Result<ConditionEntry> entry = parseEntry(part);
    if (!entry.isOk()) return entry.status();
    entries.push_back(std::move(entry.value()));
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
                         std::abs(headingOf(i).dot(headingOf(other))) > kSameDirection;
      if (meets) before = std::max(before, passes[other]);
    }
    passes.push_back(before + 1);
    grid.add(placeOf(i), i);
  }
  dropShortRuns(passes, driven);
  return passes;
}

std::vector<Condition> conditionsOf(const CameraRoute& route,
                                    const std::vector<ConditionEntry>& entries,
                                    std::vector<std::string>& warnings) {
  std::vector<Condition> conditions(route.T_town_camera.size());
  if (entries.empty()) return conditions;
  const std::vector<double> driven = drivenMetres(route);
  const std::vector<int> passes = passNumbers(route);
  for (const ConditionEntry& entry : entries) {
    bool holds = false;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      const double at = entry.is_pass ? passes[i] : driven[i];
      if (at < entry.first || at > entry.last) continue;
      holds = true;
      for (const std::string& word : entry.words) findWord(word)->change(conditions[i]);
    }
    if (!holds)
      warnings.push_back(nowhere(entry, driven.back(), *std::ranges::max_element(passes)));
  }
  return conditions;
}

}  // namespace tolman::town
