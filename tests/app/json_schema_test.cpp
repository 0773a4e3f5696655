// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "app/parameter_text.hpp"
#include "config/system_config.hpp"

using namespace tolman;
using Json = nlohmann::ordered_json;

namespace {

host::LoadedPlugin pluginOf(const std::string& id, Role role, Schema schema) {
  host::LoadedPlugin plugin;
  plugin.manifest.id = id;
  plugin.manifest.role = role;
  plugin.manifest.summary = "The " + id + ".";
  plugin.schema = std::move(schema);
  return plugin;
}

ParameterInfo parameterOf(const std::string& name, ParameterType type, ParameterValue value) {
  ParameterInfo info;
  info.name = name;
  info.type = type;
  info.default_value = std::move(value);
  info.doc = "About " + name + ".";
  return info;
}

host::LoadedPlugin toy() {
  ParameterInfo count = parameterOf("count", ParameterType::Integer, std::int64_t{3});
  count.min = 1;
  count.max = 9;
  count.unit = "px";
  ParameterInfo gain = parameterOf("gain", ParameterType::Real, 0.5);
  gain.min = -1.5;
  ParameterInfo colour = parameterOf("colour", ParameterType::Choice, std::string("red"));
  colour.choices = {"red", "green"};
  ParameterInfo path = parameterOf("path", ParameterType::Path, std::string());
  path.required = true;
  const ParameterInfo on = parameterOf("on", ParameterType::Bool, true);
  ParameterInfo list = parameterOf("list", ParameterType::RealList, std::vector<double>{1, 2.5});
  list.min = 0;
  return pluginOf("toy", Role::Cells, {count, gain, colour, path, on, list});
}

// The host's own keys are left out: they are declared, and tested, elsewhere.
constexpr const char* kToyProperties = R"({
  "plugin": {"const": "toy", "description": "The toy."},
  "count": {"type": ["integer", "string"], "pattern": "\\$\\{[^}]+\\}", "minimum": 1, "maximum": 9,
            "description": "About count. Unit: px. Range: 1 to 9.", "default": 3},
  "gain": {"type": ["number", "string"], "pattern": "\\$\\{[^}]+\\}", "minimum": -1.5,
           "description": "About gain. Range: >= -1.5.", "default": 0.5},
  "colour": {"anyOf": [{"enum": ["red", "green"]},
                       {"type": "string", "pattern": "\\$\\{[^}]+\\}"}],
             "description": "About colour. One of: red, green.", "default": "red"},
  "path": {"type": ["string", "number", "boolean"], "description": "About path. Required."},
  "on": {"type": ["boolean", "string"], "pattern": "\\$\\{[^}]+\\}",
         "description": "About on.", "default": true},
  "list": {"type": "array",
           "items": {"type": ["number", "string"], "pattern": "\\$\\{[^}]+\\}", "minimum": 0.0},
           "description": "About list. Range: >= 0.", "default": [1.0, 2.5]}
})";

}  // namespace

TEST_CASE("the schema of one plugin is golden") {
  const Json file = app::fileSchema({toy()});
  CHECK(file["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  Json schema = file["$defs"]["cells.toy"];
  CHECK(schema["title"] == "toy (cells)");
  CHECK(schema["additionalProperties"] == false);
  Json& properties = schema["properties"];
  for (const char* of_the_host : {"name", "on_failure", "isolation"}) {
    CHECK(properties.erase(of_the_host) == 1);
  }
  CHECK(properties.dump(1) == Json::parse(kToyProperties).dump(1));
}

TEST_CASE("the schema knows every key that the host knows") {
  config::Loaded nothing;
  nothing.tree.kind = config::Node::Kind::Map;
  config::Problems problems;
  const Json schema = app::fileSchema({});
  for (const config::Section& section : config::parse(nothing, problems).sections) {
    const Json& owner = section.key.empty() ? schema : schema["properties"][section.key];
    for (const auto& [name, value] : section.values) {
      INFO(section.key << "." << name);
      CHECK(owner["properties"].contains(name));
    }
  }
}

TEST_CASE("a whole file has the host's sections and the stages") {
  const Json schema = app::fileSchema({toy(), pluginOf("eye", Role::Observer, {})});
  for (const char* key : {"name", "seed", "threads", "extends", "pipeline", "source", "odometry",
                          "place", "cells", "map", "observers", "evaluation", "record"}) {
    CHECK(schema["properties"].contains(key));
  }
  CHECK(schema["properties"]["pipeline"]["properties"]["queue"]["maximum"] == 1024);
  CHECK(schema["$defs"]["cells"]["properties"]["plugin"]["anyOf"][0]["enum"] == Json({"toy"}));
  CHECK(schema["$defs"]["cells.toy"]["properties"]["count"]["default"] == 3);
  CHECK_FALSE(schema["$defs"]["cells.toy"].contains("required"));  // another file may have it
  CHECK(schema["$defs"]["observer.eye"]["additionalProperties"] == false);
  CHECK(schema["then"]["required"] == Json({"source", "odometry", "place", "cells", "map"}));
}
