// SPDX-License-Identifier: BSD-3-Clause
// The declaration of a plugin: manifest, symbols, parameters. Legal parameters work, illegal ones
// are refused.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "config/values.hpp"
#include "conformance/check.hpp"

namespace tolman::conformance {
namespace {

bool isSnakeCase(const std::string& name) {
  return !name.empty() &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

void checkManifest(CheckContext& context) {
  const host::Manifest manifest = context.manifest();
  if (manifest.summary.empty()) context.error("there is no summary", "describe it in one line");
  if (manifest.version.empty() ||
      std::isdigit(static_cast<unsigned char>(manifest.version[0])) == 0) {
    context.error("'" + manifest.version + "' is not a version", "write numbers: \"0.1.0\"");
  }
  if (!isSnakeCase(manifest.id)) {
    context.warning("the id '" + manifest.id + "' is not in snake_case",
                    "use lower-case letters, digits and _, as for keys");
  }
  if (const auto refusal = host::checkGate(manifest, host::HostIdentity::ofThisBuild())) {
    throw *refusal;
  }
}

void checkLoad(CheckContext& context) { (void)context.plugin(); }

void checkSettings(CheckContext& context) {
  const std::string& problems = context.plugin().problems;
  if (!problems.empty()) context.error(problems);
}

bool isNumber(ParameterType type) {
  return type == ParameterType::Integer || type == ParameterType::Real ||
         type == ParameterType::RealList;
}

/// The limits of the type are not a declared range.
bool hasRange(const ParameterInfo& info) {
  constexpr double kInt = std::numeric_limits<int>::max();
  return info.min > -kInt || info.max < kInt;
}

void checkParameter(const ParameterInfo& info, const CheckContext& context) {
  const std::string name = "parameter '" + info.name + "'";
  if (info.doc.empty()) context.error(name + " has no doc", "describe it in one sentence: .doc()");
  if (!isSnakeCase(info.name)) context.warning(name + " is not in snake_case", "rename it");
  if (isNumber(info.type) && !hasRange(info)) {
    context.warning(name + " has no range", "declare the useful values with .range()");
  }
}

void checkSchema(CheckContext& context) {
  for (const ParameterInfo& info : context.plugin().loaded.schema) checkParameter(info, context);
}

constexpr double kChanged = 0.5;   // share of the parameters
constexpr double kExtreme = 0.15;  // share of the changed ones that get an end of their range

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

void checkRandom(CheckContext& context) {
  constexpr std::size_t kFrames = 10;
  constexpr int kWanted = 20;  // draws that configure() accepts
  constexpr int kMaxDraws = 100;
  constexpr int kMaxFailures = 3;
  const PluginUnderTest& plugin = context.completePlugin();
  const InputSequence sequence = shortened(context.sequence(), kFrames);
  const std::uint64_t seed = context.task().seed;
  int drawn = 0;
  int worked = 0;
  int refused = 0;
  int failed = 0;
  for (; worked < kWanted && failed < kMaxFailures && drawn < kMaxDraws && context.timeUsed() < 0.6;
       ++drawn) {
    const ParameterValues values = randomParameters(plugin, seed, drawn);
    const std::string draw =
        fmt::format("draw {} of seed {} ({})", drawn, seed, difference(plugin.values, values));
    context.currentInput(draw);
    const auto instance = TestInstance::make(plugin, values);
    Status status = instance->configure(sequence.rig);
    const bool is_refused = isRefusal(status);
    if (status.isOk()) status = instance->run(sequence);
    if (status.isOk()) status = instance->finish(sequence);
    ++(is_refused ? refused : status.isOk() ? worked : failed);
    if (!is_refused && !status.isOk()) context.error(draw + ": " + status.message());
  }
  context.note(fmt::format("{} draws of seed {}: {} worked, {} refused by configure()", drawn, seed,
                           worked, refused));
}

constexpr std::array kDeclarationChecks = {
    Check{"manifest", 1, kAllRoles,
          "a summary, a version, and a build that is compatible with this host",
          "pass version and summary to TOLMAN_PLUGIN", &checkManifest},
    Check{"load", 1, kAllRoles,
          "opens with all symbols resolved, its code agrees with the manifest, and its parameters "
          "have unique names and ranges that hold their defaults",
          "build from clean with tolman_add_plugin()", &checkLoad},
    Check{"settings", 1, kAllRoles, "the values of --set are legal", "correct the --set",
          &checkSettings},
    Check{"schema", 1, kAllRoles, "every parameter has a doc and, where it is a number, a range",
          "complete the declaration", &checkSchema},
    Check{"parameters-random", 1, kAllRoles,
          "works with any legal parameters, or refuses them in configure()",
          "narrow the ranges, or refuse the combination with Status::invalidParameter()",
          &checkRandom},
};

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
    std::string text = config::writeValue(value);
    if (std::holds_alternative<std::vector<double>>(value)) std::erase(text, ' ');  // one word
    words += (words.empty() ? "--set " : " --set ") + name + "=" + text;
  }
  return words;
}

std::span<const Check> declarationChecks() { return kDeclarationChecks; }

}  // namespace tolman::conformance
