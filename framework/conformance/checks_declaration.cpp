// SPDX-License-Identifier: BSD-3-Clause
// What a plugin says of itself before it lives: manifest, symbols, parameters.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "config/settings.hpp"
#include "conformance/check.hpp"
#include "conformance/lab.hpp"

namespace tolman::conformance {
namespace {

bool isSnakeCase(const std::string& name) {
  return !name.empty() &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

void checkManifest(Lab& lab) {
  const plugins::Manifest manifest = lab.manifest();
  if (manifest.summary.empty()) lab.error("there is no summary", "say in one line what it does");
  if (manifest.version.empty() ||
      std::isdigit(static_cast<unsigned char>(manifest.version[0])) == 0) {
    lab.error("'" + manifest.version + "' is no version", "write numbers: \"0.1.0\"");
  }
  if (!isSnakeCase(manifest.id)) {
    lab.warning("the id '" + manifest.id + "' is not in snake_case",
                "configurations write ids as they write keys: small letters, digits, _");
  }
  if (const auto refusal = plugins::checkGate(manifest, plugins::HostIdentity::ofThisBuild())) {
    lab.refuse(*refusal);
  }
}

void checkLoad(Lab& lab) { (void)lab.specimen(); }

void checkSettings(Lab& lab) {
  const Specimen& specimen = lab.specimen();
  const Settings settings =
      readSettings(specimen.plugin.schema, lab.options().id, lab.options().set);
  if (!settings.problems.empty()) lab.error(settings.problems, "mend the --set");
}

bool isNumber(ParameterType type) {
  return type == ParameterType::Integer || type == ParameterType::Real ||
         type == ParameterType::RealList;
}

bool hasRange(const ParameterInfo& info) {
  constexpr double kInt = std::numeric_limits<int>::max();  // that of the type, not of the author
  return info.min > -kInt || info.max < kInt;
}

bool isWithin(const ParameterInfo& info) {
  const auto fits = [&](double x) { return x >= info.min && x <= info.max; };
  if (const auto* integer = std::get_if<std::int64_t>(&info.default_value)) {
    return fits(static_cast<double>(*integer));
  }
  if (const auto* real = std::get_if<double>(&info.default_value)) return fits(*real);
  if (const auto* list = std::get_if<std::vector<double>>(&info.default_value)) {
    return std::all_of(list->begin(), list->end(), fits);
  }
  if (info.type != ParameterType::Choice) return true;
  const auto& choice = std::get<std::string>(info.default_value);
  return std::find(info.choices.begin(), info.choices.end(), choice) != info.choices.end();
}

void checkParameter(const ParameterInfo& info, const Lab& lab) {
  const std::string name = "parameter '" + info.name + "'";
  if (info.doc.empty()) lab.error(name + " has no doc", "say in one sentence what it does: .doc()");
  if (!isSnakeCase(info.name)) lab.warning(name + " is not in snake_case", "rename it");
  if (info.min > info.max) lab.error(name + " has an empty range", "swap the ends of .range()");
  if (!info.required && !isWithin(info)) {
    lab.error(name + " has a default outside of its range", "mend the default or the range");
  }
  if (isNumber(info.type) && !hasRange(info)) {
    lab.warning(name + " has no range", "declare with .range() what values make sense");
  }
}

/// Names of the host's own keys of a stage.
std::set<std::string> reservedNames() {
  std::set<std::string> names;
  for (const ParameterInfo& info : schemaOf<config::StageSettings>()) names.insert(info.name);
  return names;
}

void checkSchema(Lab& lab) {
  const std::set<std::string> reserved = reservedNames();
  std::set<std::string> seen;
  for (const ParameterInfo& info : lab.specimen().plugin.schema) {
    checkParameter(info, lab);
    if (reserved.contains(info.name)) {
      lab.error("parameter '" + info.name + "' has a name that belongs to the host", "rename it");
    }
    if (!seen.insert(info.name).second) {
      lab.error("parameter '" + info.name + "' is declared twice", "remove one declaration");
    }
  }
}

constexpr std::array kChecks = {
    Check{"manifest", 1, kAllRoles, "a summary, a version, and a build that fits this host",
          "fill in what TOLMAN_PLUGIN asks for", &checkManifest},
    Check{"load", 1, kAllRoles,
          "opens with all symbols resolved, and its code agrees with the manifest",
          "build from clean with tolman_add_plugin()", &checkLoad},
    Check{"settings", 1, kAllRoles, "the values of --set are legal", "mend the --set",
          &checkSettings},
    Check{"schema", 1, kAllRoles,
          "every parameter has a doc, a range that holds its default, and a name of its own",
          "complete the declaration", &checkSchema},
};

}  // namespace

std::span<const Check> declarationChecks() { return kChecks; }

}  // namespace tolman::conformance
