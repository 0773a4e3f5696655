// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/random_parameters.hpp"

#include <algorithm>
#include <cmath>

#include "config/values.hpp"

namespace tolman::conformance {
namespace {

constexpr double kChanged = 0.5;  // share of the parameters
constexpr double kExtreme =
    0.15;  // share of the changed ones that are set to an end of their range

/// The declared limit; without one, ten times the default away from it.
double limit(double declared, double standard, double sign) {
  if (std::abs(declared) < 2e9) return declared;
  return standard + sign * 10 * (std::abs(standard) + 1);
}

double drawNumber(const ParameterInfo& info, double standard, RandomStream& random) {
  const double low = limit(info.min, standard, -1);
  const double high = limit(info.max, standard, 1);
  const double where = random.uniform();
  if (where < kExtreme / 2) return low;
  if (where < kExtreme) return high;
  const bool decades = low > 0 && high > 100 * low;
  const double share = random.uniform();
  return decades ? low * std::pow(high / low, share) : low + share * (high - low);
}

ParameterValue drawValue(const ParameterInfo& info, const ParameterValue& base,
                         RandomStream& random) {
  switch (info.type) {
    case ParameterType::Bool:
      return random.below(2) == 1;
    case ParameterType::Choice:
      return info.choices[random.below(info.choices.size())];
    case ParameterType::Integer: {
      const auto standard = static_cast<double>(std::get<std::int64_t>(base));
      const double number = std::round(drawNumber(info, standard, random));
      return static_cast<std::int64_t>(std::clamp(number, info.min, info.max));
    }
    case ParameterType::Real:
      return std::clamp(drawNumber(info, std::get<double>(base), random), info.min, info.max);
    case ParameterType::RealList: {
      auto list = std::get<std::vector<double>>(base);
      for (double& x : list) x = std::clamp(drawNumber(info, x, random), info.min, info.max);
      return list;
    }
    default:
      return base;  // which texts and paths are legal is not declared
  }
}

std::string text(const ParameterValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* real = std::get_if<double>(&value)) return config::writeReal(*real);
  if (const auto* string = std::get_if<std::string>(&value)) return *string;
  std::string list;
  for (const double x : std::get<std::vector<double>>(value)) {
    list += (list.empty() ? "[" : ",") + config::writeReal(x);
  }
  return list.empty() ? "[]" : list + "]";
}

}  // namespace

ParameterValues randomParameters(const PluginUnderTest& plugin, std::uint64_t seed, int index) {
  RandomStream random(seed * 1'000'003 + static_cast<std::uint64_t>(index));
  ParameterValues values = plugin.values;
  for (const ParameterInfo& info : plugin.loaded.schema) {
    RandomStream own = random.fork();  // so that a new parameter does not change the others
    const auto& set = plugin.set;
    if (std::find(set.begin(), set.end(), info.name) != set.end()) continue;
    if (own.uniform() < kChanged) {
      values[info.name] = drawValue(info, values.find(info.name)->second, own);
    }
  }
  return values;
}

std::string difference(const ParameterValues& base, const ParameterValues& drawn) {
  std::string words;
  for (const auto& [name, value] : drawn) {
    if (value == base.find(name)->second) continue;
    words += (words.empty() ? "--set " : " --set ") + name + "=" + text(value);
  }
  return words;
}

}  // namespace tolman::conformance
