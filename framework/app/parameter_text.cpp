// SPDX-License-Identifier: BSD-3-Clause
#include "app/parameter_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "config/json_text.hpp"
#include "config/system_config.hpp"
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

/// "1 to 512", ">= 0", "forward, backward", or nothing.
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

}  // namespace

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

// The JSON Schema of a configuration file.

namespace {

using config::kChain;
using Json = nlohmann::ordered_json;

constexpr const char* kDialect = "https://json-schema.org/draft/2020-12/schema";

// A text with an environment variable is allowed for any value.
constexpr const char* kVariable = R"(\$\{[^}]+\})";

Json plainOrVariable(const char* type) {
  return {{"type", {type, "string"}}, {"pattern", kVariable}};  // `pattern` is for strings only
}

Json oneOfOrVariable(const Json& names) {
  return {{"anyOf", {{{"enum", names}}, {{"type", "string"}, {"pattern", kVariable}}}}};
}

Json limit(ParameterType type, double value) {
  const bool whole = type == ParameterType::Integer && std::abs(value) < 0x1.0p53;
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json number(const ParameterInfo& info) {
  Json schema = plainOrVariable(info.type == ParameterType::Integer ? "integer" : "number");
  if (std::isfinite(info.min)) schema["minimum"] = limit(info.type, info.min);
  if (std::isfinite(info.max)) schema["maximum"] = limit(info.type, info.max);
  return schema;
}

Json valueSchema(const ParameterInfo& info) {
  switch (info.type) {
    case ParameterType::Bool:
      return plainOrVariable("boolean");
    case ParameterType::Choice:
      return oneOfOrVariable(info.choices);
    case ParameterType::RealList:
      return {{"type", "array"}, {"items", number(info)}};
    case ParameterType::Text:
    case ParameterType::Path:  // in YAML a folder `06` is a number; the host reads it as text
      return {{"type", {"string", "number", "boolean"}}};
    default:
      return number(info);
  }
}

std::string description(const ParameterInfo& info) {
  std::string text = info.doc;
  if (!info.unit.empty()) text += " Unit: " + info.unit + ".";
  const std::string limits = limitsText(info);
  if (!limits.empty()) text += (info.choices.empty() ? " Range: " : " One of: ") + limits + ".";
  if (info.required) text += " Required.";
  return text;
}

Json propertySchema(const ParameterInfo& info) {
  Json schema = valueSchema(info);
  schema["description"] = description(info);
  if (!info.required) schema["default"] = engine::valueJson(info.default_value);
  return schema;
}

Json propertiesOf(const Schema& declared) {
  Json properties = Json::object();
  for (const ParameterInfo& info : declared) properties[info.name] = propertySchema(info);
  return properties;
}

Json objectOf(Json properties) {
  return {
      {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

/// Schema of a stage with this plugin, without required keys.
Json alternative(const host::LoadedPlugin& plugin) {
  Json properties = {{"plugin", {{"const", plugin.manifest.id}}}};
  properties["plugin"]["description"] = plugin.manifest.summary;
  if (!plugin.manifest.program.empty()) properties.update(propertiesOf(config::programSchema()));
  properties.update(propertiesOf(plugin.schema));
  Json host = propertiesOf(schemaOf<config::StageSettings>());
  host.erase("plugin");
  properties.update(host);
  Json schema = objectOf(std::move(properties));
  schema["title"] = plugin.manifest.id + " (" + std::string(enumName(plugin.manifest.role)) + ")";
  return schema;
}

std::string reference(const std::string& name) { return "#/$defs/" + name; }

/// Adds the plugins of one role, and under the role's name the choice among them. It uses
/// conditions instead of a plain anyOf, so that a validator reports the value that is wrong. A
/// stage without `plugin` (another file names it) is valid if some plugin has its keys.
void addRole(Json& definitions, const std::vector<host::LoadedPlugin>& plugins, Role role) {
  const std::string name(enumName(role));
  Json ids = Json::array();
  Json conditions = Json::array();
  Json any = Json::array();
  for (const auto& plugin : plugins) {
    if (plugin.manifest.role != role) continue;
    const std::string own = name + "." + plugin.manifest.id;
    definitions[own] = alternative(plugin);
    ids.push_back(plugin.manifest.id);
    any.push_back({{"$ref", reference(own)}});
    const Json is_it = {{"properties", {{"plugin", {{"const", plugin.manifest.id}}}}},
                        {"required", {"plugin"}}};
    conditions.push_back({{"if", is_it}, {"then", any.back()}});
  }
  Json& choice = definitions[name] = {{"type", "object"}};
  choice["properties"]["plugin"] = oneOfOrVariable(ids);
  if (any.empty()) return;
  conditions.push_back(
      {{"if", {{"required", {"plugin"}}}}, {"then", true}, {"else", {{"anyOf", std::move(any)}}}});
  choice["allOf"] = std::move(conditions);
}

Json sections() {
  Json properties = propertiesOf(schemaOf<config::GeneralSettings>());
  const Json file = {{"type", "string"}};
  properties["extends"] = {{"anyOf", {file, {{"type", "array"}, {"items", file}}}},
                           {"description",
                            "Files below this one, relative to it; the later wins, this one over "
                            "all. A stage may then leave out what they say."}};
  const config::SystemConfig declared;
  config::visitSections(declared, [&](const char* key, const auto& section) {
    properties[key] = objectOf(propertiesOf(schemaOf<std::decay_t<decltype(section)>>()));
  });
  Json& evaluation = properties["evaluation"]["properties"];  // `segments` may be a list, too
  evaluation["segments"]["anyOf"].push_back(
      {{"type", "array"}, {"items", evaluation["segment_lengths"]["items"]}});
  return properties;
}

}  // namespace

Json fileSchema(const std::vector<host::LoadedPlugin>& plugins) {
  Json properties = sections();
  for (const Role role : kChain) {
    const std::string name(enumName(role));
    properties[name] = {{"$ref", reference(name)}};
  }
  properties["observers"] = {{"type", "array"}, {"items", {{"$ref", reference("observer")}}}};
  Json schema = {{"$schema", kDialect}, {"title", "Tolman configuration"}};
  schema.update(objectOf(std::move(properties)));
  schema["if"] = {{"not", {{"required", {"extends"}}}}};
  for (const Role role : kChain) schema["then"]["required"].push_back(enumName(role));
  Json& definitions = schema["$defs"];
  for (const Role role : kChain) addRole(definitions, plugins, role);
  addRole(definitions, plugins, Role::Observer);
  return schema;
}

}  // namespace tolman::app
