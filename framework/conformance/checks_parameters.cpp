// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/checks_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/values.hpp"
#include "conformance/check.hpp"

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

// Legal parameters work, illegal ones are refused.

namespace {

constexpr int kWanted = 20;  // draws that configure() accepts
constexpr int kMaxDraws = 100;

bool isRefusal(const Status& status) {
  return status.code() == StatusCode::InvalidParameter ||
         status.code() == StatusCode::Unsupported || status.code() == StatusCode::InvalidInput;
}

enum class DrawResult { Worked, Refused, Failed };

DrawResult tryDraw(CheckContext& context, const InputSequence& sequence,
                   const ParameterValues& values, const std::string& draw) {
  TestInstance instance(context.completePlugin(), values);
  Status status = instance.configure(sequence.rig);
  if (isRefusal(status) && !status.message().empty()) return DrawResult::Refused;
  if (status.isOk()) status = instance.run(sequence);
  if (status.isOk()) status = instance.finish(sequence);
  if (status.isOk()) return DrawResult::Worked;
  context.error(draw + ": " + status.message());
  return DrawResult::Failed;
}

void checkRandom(CheckContext& context) {
  constexpr std::size_t kFrames = 10;
  constexpr int kMaxFailures = 3;
  const PluginUnderTest& plugin = context.completePlugin();
  const InputSequence sequence = shortened(context.sequence(), kFrames);
  int drawn = 0;
  std::array<int, 3> outcomes{};
  const auto count = [&](DrawResult outcome) -> int& {
    return outcomes.at(static_cast<std::size_t>(outcome));
  };
  while (count(DrawResult::Worked) < kWanted && drawn < kMaxDraws && context.timeUsed() < 0.6 &&
         count(DrawResult::Failed) < kMaxFailures) {
    const ParameterValues values = randomParameters(plugin, context.task().seed, drawn);
    const std::string draw = "draw " + std::to_string(drawn) + " of seed " +
                             std::to_string(context.task().seed) + " (" +
                             difference(plugin.values, values) + ")";
    context.currentInput(draw);
    ++count(tryDraw(context, sequence, values, draw));
    ++drawn;
  }
  context.note(std::to_string(drawn) + " draws of seed " + std::to_string(context.task().seed) +
               ": " + std::to_string(count(DrawResult::Worked)) + " worked, " +
               std::to_string(count(DrawResult::Refused)) + " refused by configure()");
}

/// A value of another type than the declared one.
ParameterValue ofWrongType(const ParameterInfo& info) {
  if (info.type == ParameterType::Bool) return std::string("maybe");
  return true;
}

void checkWrongTypes(CheckContext& context) {
  const PluginUnderTest& plugin = context.completePlugin();
  const InputSequence nothing = shortened(context.sequence(), 0);
  for (const ParameterInfo& info : plugin.loaded.schema) {
    ParameterValues values = plugin.values;
    values[info.name] = ofWrongType(info);
    context.currentInput("parameter '" + info.name + "' of a wrong type");
    TestInstance instance(plugin, values);
    const Status status = instance.configure(nothing.rig);
    if (status.isOk()) {
      context.error("configure() accepts parameter '" + info.name + "' of a wrong type");
    } else if (status.code() != StatusCode::InvalidParameter) {
      context.warning("parameter '" + info.name + "' of a wrong type: " + status.message());
    }
  }
}

/// A number outside of the range as text; empty if there is none.
std::string outsideOf(const ParameterInfo& info, bool above) {
  const double end = above ? info.max : info.min;
  const bool number = info.type == ParameterType::Integer || info.type == ParameterType::Real;
  if (!number || std::abs(end) > 1e15) return {};
  const double outside = end + (above ? 1 : -1) * std::max(1.0, std::abs(end));
  return std::to_string(static_cast<std::int64_t>(outside));
}

/// The host refuses values outside of the declared ranges.
void checkOutOfRange(CheckContext& context) {
  const PluginUnderTest& plugin = context.plugin();
  for (const ParameterInfo& info : plugin.loaded.schema) {
    for (const std::string& value : {outsideOf(info, false), outsideOf(info, true)}) {
      if (value.empty()) continue;
      const std::string assignment = info.name + "=" + value;
      const auto settings = readSettings(plugin.loaded.schema, context.task().id, {assignment});
      if (settings.problems.empty()) context.error("--set " + assignment + " is not refused");
    }
  }
}

void checkMissingData(CheckContext& context) {
  const PluginUnderTest& plugin = context.plugin();
  ParameterValues values = plugin.values;
  bool has_path = false;
  for (const ParameterInfo& info : plugin.loaded.schema) {
    if (info.type != ParameterType::Path || !info.required) continue;
    values[info.name] = (plugin.scratch / "nothing/here").string();
    has_path = true;
  }
  if (!has_path) context.skip("it has no required path");
  TestInstance instance(plugin, values);
  const Status status = instance.configure({});
  if (status.isOk()) {
    context.error("configure() accepts a path that does not exist",
                  "check the data in configure(), so that errors come before frame 0");
  } else if (status.message().find("nothing") == std::string::npos) {
    context.warning("the failure does not name the path: " + status.message(),
                    "name the missing file and a remedy");
  }
}

constexpr std::array kParameterChecks = {
    Check{"parameters-random", 1, kAllRoles,
          "works with any legal parameters, or refuses them in configure()",
          "narrow the ranges, or refuse the combination with Status::invalidParameter()",
          &checkRandom},
    Check{"parameters-illegal", 1, kAllRoles, "values out of range are refused",
          "declare the range", &checkOutOfRange},
    Check{"missing-data", 1, kSource, "missing data are refused with their path",
          "check the data in configure()", &checkMissingData},
    Check{"parameters-types", 3, kAllRoles, "configure() refuses values of a wrong type",
          "let bindParameters() read the values", &checkWrongTypes},
};

}  // namespace

std::span<const Check> parameterChecks() { return kParameterChecks; }

}  // namespace tolman::conformance
