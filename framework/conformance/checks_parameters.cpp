// SPDX-License-Identifier: BSD-3-Clause
// Legal parameters work, illegal ones are refused.
#include <array>
#include <cmath>
#include <limits>

#include "conformance/check.hpp"
#include "conformance/draw.hpp"
#include "conformance/lab.hpp"

namespace tolman::conformance {
namespace {

constexpr int kWanted = 20;  // draws that configure() takes
constexpr int kMostDraws = 100;

bool isRefusal(const Status& status) {
  return status.code() == StatusCode::InvalidParameter ||
         status.code() == StatusCode::Unsupported || status.code() == StatusCode::InvalidInput;
}

enum class Drawn { Worked, Refused, Failed };

Drawn tryDraw(Lab& lab, const Stimulus& stimulus, const ParameterValues& values,
              const std::string& who) {
  Actor actor(lab.complete(), values);
  Status status = actor.configure(stimulus.rig);
  if (isRefusal(status) && !status.message().empty()) return Drawn::Refused;
  if (status.isOk()) status = actor.run(stimulus);
  if (status.isOk()) status = actor.finish(stimulus);
  if (status.isOk()) return Drawn::Worked;
  lab.error(who + ": " + status.message());
  return Drawn::Failed;
}

void checkRandom(Lab& lab) {
  constexpr std::size_t kFrames = 10;
  constexpr int kMostFailures = 3;
  const Specimen& specimen = lab.complete();
  const Stimulus stimulus = shortened(lab.stimulus(), kFrames);
  int drawn = 0;
  std::array<int, 3> outcomes{};
  const auto count = [&](Drawn outcome) -> int& {
    return outcomes.at(static_cast<std::size_t>(outcome));
  };
  while (count(Drawn::Worked) < kWanted && drawn < kMostDraws && lab.spent() < 0.6 &&
         count(Drawn::Failed) < kMostFailures) {
    const ParameterValues values = drawParameters(specimen, lab.options().seed, drawn);
    const std::string who = "draw " + std::to_string(drawn) + " of seed " +
                            std::to_string(lab.options().seed) + " (" +
                            difference(specimen.values, values) + ")";
    lab.topic(who);
    ++count(tryDraw(lab, stimulus, values, who));
    ++drawn;
  }
  lab.note(std::to_string(drawn) + " draws of seed " + std::to_string(lab.options().seed) + ": " +
           std::to_string(count(Drawn::Worked)) + " worked, " +
           std::to_string(count(Drawn::Refused)) + " refused by configure()");
}

/// A value of another type than the declared one.
ParameterValue ofWrongType(const ParameterInfo& info) {
  if (info.type == ParameterType::Bool) return std::string("maybe");
  return true;
}

void checkWrongTypes(Lab& lab) {
  const Specimen& specimen = lab.complete();
  const Stimulus nothing = shortened(lab.stimulus(), 0);
  for (const ParameterInfo& info : specimen.plugin.schema) {
    ParameterValues values = specimen.values;
    values[info.name] = ofWrongType(info);
    lab.topic("parameter '" + info.name + "' of a wrong type");
    Actor actor(specimen, values);
    const Status status = actor.configure(nothing.rig);
    if (status.isOk()) {
      lab.error("configure() takes parameter '" + info.name + "' of a wrong type");
    } else if (status.code() != StatusCode::InvalidParameter) {
      lab.warning("parameter '" + info.name + "' of a wrong type: " + status.message());
    }
  }
}

/// The text that a user would type for a number just beyond the range; empty where there is none.
std::string beyond(const ParameterInfo& info, bool above) {
  const double end = above ? info.max : info.min;
  const bool number = info.type == ParameterType::Integer || info.type == ParameterType::Real;
  if (!number || std::abs(end) > 1e15) return {};
  const double outside = end + (above ? 1 : -1) * std::max(1.0, std::abs(end));
  return std::to_string(static_cast<std::int64_t>(outside));
}

/// What the host refuses by the plugin's declaration, tried through the plugin's own schema.
void checkOutOfRange(Lab& lab) {
  const Specimen& specimen = lab.specimen();
  for (const ParameterInfo& info : specimen.plugin.schema) {
    for (const std::string& value : {beyond(info, false), beyond(info, true)}) {
      if (value.empty()) continue;
      const std::string assignment = info.name + "=" + value;
      const auto settings = readSettings(specimen.plugin.schema, lab.options().id, {assignment});
      if (settings.problems.empty()) lab.error("--set " + assignment + " is not refused");
    }
  }
}

void checkMissingData(Lab& lab) {
  const Specimen& specimen = lab.specimen();
  ParameterValues values = specimen.values;
  bool any = false;
  for (const ParameterInfo& info : specimen.plugin.schema) {
    if (info.type != ParameterType::Path || !info.required) continue;
    values[info.name] = (specimen.scratch / "nothing/here").string();
    any = true;
  }
  if (!any) lab.skip("it requires no path");
  Actor actor(specimen, values);
  const Status status = actor.configure({});
  if (status.isOk()) {
    lab.error("configure() takes a path where there is nothing",
              "check the data in configure(), so that errors come before frame 0");
  } else if (status.message().find("nothing") == std::string::npos) {
    lab.warning("the failure does not name the path: " + status.message(),
                "name the file that is missing, and what to do");
  }
}

constexpr std::array kChecks = {
    Check{"parameters-random", 1, kAllRoles,
          "works with any legal parameters, or refuses them in configure()",
          "narrow the ranges, or refuse the combination with Status::invalidParameter()",
          &checkRandom},
    Check{"parameters-illegal", 1, kAllRoles, "values out of range are refused",
          "declare the range", &checkOutOfRange},
    Check{"missing-data", 1, kSource, "data that are not there are refused with their path",
          "check the data in configure()", &checkMissingData},
    Check{"parameters-types", 3, kAllRoles, "configure() refuses values of a wrong type",
          "let bindParameters() read the values", &checkWrongTypes},
};

}  // namespace

std::span<const Check> parameterChecks() { return kChecks; }

}  // namespace tolman::conformance
