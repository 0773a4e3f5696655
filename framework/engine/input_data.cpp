// SPDX-License-Identifier: BSD-3-Clause
#include "engine/input_data.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>

namespace tolman::engine {
namespace {

namespace fs = std::filesystem;

/// All texts and paths that a stage has as parameters.
using VisitText = std::function<void(const ParameterInfo&, const std::string&)>;

void visitTexts(const config::StageConfig& stage, const config::StageValues& values,
                const StageSchemas& schemas, const VisitText& visit) {
  const auto schema = schemas.find(stage.instance);
  const auto own = values.find(stage.instance);
  if (schema == schemas.end() || own == values.end()) return;
  for (const ParameterInfo& info : *schema->second) {
    const auto value = own->second.find(info.name);
    if (value == own->second.end()) continue;
    const auto* text = std::get_if<std::string>(&value->second);
    if (text != nullptr && !text->empty()) visit(info, *text);
  }
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool isFile(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

StageSchemas schemasOf(const CheckedSystem& system) {
  StageSchemas schemas;
  for (std::size_t i = 0; i < system.plugins.size(); ++i) {
    schemas[system.config.stages[i].instance] = &system.plugins[i].schema;
  }
  return schemas;
}

}  // namespace

std::vector<std::string> inputPaths(const config::SystemConfig& config,
                                    const config::StageValues& values,
                                    const StageSchemas& schemas) {
  std::vector<std::string> paths;
  const auto add = [&](const std::string& path) {
    if (!path.empty() && exists(path) && std::ranges::find(paths, path) == paths.end()) {
      paths.push_back(path);
    }
  };
  add(config.general.continue_from);
  for (const config::StageConfig& stage : config.stages) {
    if (stage.role == Role::Observer) continue;
    visitTexts(stage, values, schemas, [&](const ParameterInfo& info, const std::string& text) {
      const bool names_file = info.type == ParameterType::Text && isFile(text);
      if (info.type == ParameterType::Path || names_file) add(text);
    });
  }
  return paths;
}

std::vector<std::string> inputPaths(const CheckedSystem& system) {
  return inputPaths(system.config, system.values, schemasOf(system));
}

std::set<std::string> missingPaths(const config::SystemConfig& config,
                                   const config::StageValues& values, const StageSchemas& schemas) {
  std::set<std::string> missing;
  const std::string& earlier = config.general.continue_from;
  if (!earlier.empty() && !exists(earlier)) missing.insert(earlier);
  for (const config::StageConfig& stage : config.stages) {
    if (stage.role != Role::Source) continue;
    visitTexts(stage, values, schemas, [&](const ParameterInfo& info, const std::string& text) {
      if (info.type == ParameterType::Path && !exists(text)) missing.insert(text);
    });
  }
  return missing;
}

}  // namespace tolman::engine
