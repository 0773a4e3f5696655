// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "app/parameter_text.hpp"
#include "config/system_config.hpp"
#include "engine/provenance.hpp"

namespace tolman::app {
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
