// SPDX-License-Identifier: BSD-3-Clause
// The declaration of a plugin: manifest, symbols, parameters.
#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "config/settings.hpp"
#include "conformance/check.hpp"
#include "conformance/check_context.hpp"

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
    context.refuse(*refusal);
  }
}

void checkLoad(CheckContext& context) { (void)context.plugin(); }

void checkSettings(CheckContext& context) {
  const PluginUnderTest& plugin = context.plugin();
  const Settings settings =
      readSettings(plugin.loaded.schema, context.task().id, context.task().set);
  if (!settings.problems.empty()) context.error(settings.problems, "correct the --set");
}

bool isNumber(ParameterType type) {
  return type == ParameterType::Integer || type == ParameterType::Real ||
         type == ParameterType::RealList;
}

bool hasRange(const ParameterInfo& info) {
  constexpr double kInt =
      std::numeric_limits<int>::max();  // the limits of the type are not a declared range
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

void checkParameter(const ParameterInfo& info, const CheckContext& context) {
  const std::string name = "parameter '" + info.name + "'";
  if (info.doc.empty()) context.error(name + " has no doc", "describe it in one sentence: .doc()");
  if (!isSnakeCase(info.name)) context.warning(name + " is not in snake_case", "rename it");
  if (info.min > info.max) context.error(name + " has an empty range", "swap the ends of .range()");
  if (!info.required && !isWithin(info)) {
    context.error(name + " has a default outside of its range", "correct the default or the range");
  }
  if (isNumber(info.type) && !hasRange(info)) {
    context.warning(name + " has no range", "declare the useful values with .range()");
  }
}

void checkSchema(CheckContext& context) {
  const Schema reserved = schemaOf<config::StageSettings>();  // keys that the host reads
  std::set<std::string> seen;
  for (const ParameterInfo& info : context.plugin().loaded.schema) {
    checkParameter(info, context);
    if (std::ranges::find(reserved, info.name, &ParameterInfo::name) != reserved.end()) {
      context.error("parameter '" + info.name + "' has a name that is reserved for the host",
                    "rename it");
    }
    if (!seen.insert(info.name).second) {
      context.error("parameter '" + info.name + "' is declared twice", "remove one declaration");
    }
  }
}

constexpr std::array kDeclarationChecks = {
    Check{"manifest", 1, kAllRoles,
          "a summary, a version, and a build that is compatible with this host",
          "pass version and summary to TOLMAN_PLUGIN", &checkManifest},
    Check{"load", 1, kAllRoles,
          "opens with all symbols resolved, and its code agrees with the manifest",
          "build from clean with tolman_add_plugin()", &checkLoad},
    Check{"settings", 1, kAllRoles, "the values of --set are legal", "correct the --set",
          &checkSettings},
    Check{"schema", 1, kAllRoles,
          "every parameter has a doc, a range that holds its default, and a unique name",
          "complete the declaration", &checkSchema},
};

}  // namespace

std::span<const Check> declarationChecks() { return kDeclarationChecks; }

}  // namespace tolman::conformance
