// SPDX-License-Identifier: BSD-3-Clause
// The declaration of a plugin: manifest, symbols, parameters.
#include <array>
#include <limits>

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

constexpr std::array kDeclarationChecks = {
    Check{"manifest", 1, kAllRoles,
          "a summary, a version, and a build that is compatible with this host",
          "pass version and summary to TOLMAN_PLUGIN", &checkManifest},
    Check{"load", 1, kAllRoles,
          "opens with all symbols resolved, its code agrees with the manifest, and its parameters "
          "have "
          "unique names and ranges that hold their defaults",
          "build from clean with tolman_add_plugin()", &checkLoad},
    Check{"settings", 1, kAllRoles, "the values of --set are legal", "correct the --set",
          &checkSettings},
    Check{"schema", 1, kAllRoles, "every parameter has a doc and, where it is a number, a range",
          "complete the declaration", &checkSchema},
};

}  // namespace

std::span<const Check> declarationChecks() { return kDeclarationChecks; }

}  // namespace tolman::conformance
