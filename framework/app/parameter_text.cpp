// SPDX-License-Identifier: BSD-3-Clause
#include "app/parameter_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "config/json_text.hpp"
#include "engine/provenance.hpp"

namespace tolman::app {
namespace {

constexpr std::array<std::string_view, 7> kTypeNames = {"bool", "integer", "real",        "text",
                                                        "path", "choice",  "list of real"};

std::string_view typeName(const ParameterInfo& info) {
  return kTypeNames.at(static_cast<std::size_t>(info.type));
}

std::string defaultText(const ParameterInfo& info) {
  return info.required ? "required" : config::jsonText(engine::valueJson(info.default_value));
}

/// The stage of a configuration that uses the plugin, with the parameters that have no default.
std::string stageText(const host::LoadedPlugin& plugin) {
  std::string stage = "{plugin: " + plugin.manifest.id;
  if (!plugin.manifest.program.empty()) {
    stage += ", file: " + plugin.manifest.program.filename().string();
  }
  for (const ParameterInfo& p : plugin.schema) {
    if (p.required) stage += fmt::format(", {}: ...", p.name);
  }
  stage += "}";
  return plugin.manifest.role == Role::Observer
             ? "observers: [" + stage + "]"
             : fmt::format("{}: {}", enumName(plugin.manifest.role), stage);
}

/// The file's name for a program.
std::string nameOf(const host::Manifest& manifest) {
  return manifest.program.empty() ? manifest.id : manifest.program.filename().string();
}

std::string headline(const host::LoadedPlugin& plugin) {
  const auto& m = plugin.manifest;
  return fmt::format("{} {} ({}): {}", nameOf(m), m.version, enumName(m.role), m.summary);
}

}  // namespace

std::string limitsText(const ParameterInfo& info) {
  std::string text;
  for (const std::string& choice : info.choices) text += (text.empty() ? "" : ", ") + choice;
  constexpr double kInt =
      std::numeric_limits<int>::max();  // the limit of the type, not one that the author chose
  const bool low = info.min > -kInt;
  const bool high = info.max < kInt;
  if (low && high) return fmt::format("{} to {}", info.min, info.max);
  if (low) return fmt::format(">= {}", info.min);
  if (high) return fmt::format("<= {}", info.max);
  return text;
}

std::string parametersText(const host::LoadedPlugin& plugin) {
  std::string text = headline(plugin) + "\n";
  for (const ParameterInfo& p : plugin.schema) {
    text += fmt::format("  {:<26} {:<13} {}{}", p.name, typeName(p), p.required ? "" : "default ",
                        defaultText(p));
    if (!p.unit.empty()) text += " " + p.unit;
    const std::string limits = limitsText(p);
    if (!limits.empty()) text += "  [" + limits + "]";
    text += "\n      " + p.doc + "\n";
  }
  text += "In a configuration:\n  " + stageText(plugin) +
          "\n  Parameters are keys beside `plugin`, and so are the keys of every stage: name,\n"
          "  on_failure (stop, skip, restart) and isolation (none, process).\n";
  return text;
}

std::string parametersMarkdown(const host::LoadedPlugin& plugin) {
  const auto& m = plugin.manifest;
  std::string text = fmt::format("## `{}` ({})\n\n{}\n\n", nameOf(m), enumName(m.role), m.summary);
  if (plugin.schema.empty()) return text + "No parameters.\n";
  text += "| parameter | type | default | unit | range | meaning |\n|---|---|---|---|---|---|\n";
  for (const ParameterInfo& p : plugin.schema) {
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", p.name, typeName(p), defaultText(p),
                        p.unit, limitsText(p), p.doc);
  }
  return text;
}

nlohmann::ordered_json parametersJson(const host::LoadedPlugin& plugin) {
  const auto& m = plugin.manifest;
  nlohmann::ordered_json json = {{"id", m.id},
                                 {"role", enumName(m.role)},
                                 {"version", m.version},
                                 {"summary", m.summary},
                                 {"file", m.file.string()}};
  if (!m.program.empty()) json["program"] = m.program.string();
  json["parameters"] = nlohmann::ordered_json::array();
  for (const ParameterInfo& p : plugin.schema) {
    nlohmann::ordered_json one = {{"name", p.name},
                                  {"type", typeName(p)},
                                  {"default", engine::valueJson(p.default_value)},
                                  {"required", p.required},
                                  {"unit", p.unit},
                                  {"doc", p.doc}};
    if (std::isfinite(p.min)) one["min"] = p.min;
    if (std::isfinite(p.max)) one["max"] = p.max;
    if (!p.choices.empty()) one["choices"] = p.choices;
    json["parameters"].push_back(std::move(one));
  }
  return json;
}

}  // namespace tolman::app
