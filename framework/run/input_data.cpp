// SPDX-License-Identifier: BSD-3-Clause
#include "run/input_data.hpp"

#include <algorithm>
#include <filesystem>

namespace tolman::run {

std::vector<std::string> inputPaths(const config::SystemConfig& config,
                                    const config::StageValues& values,
                                    const std::vector<const Schema*>& schemas) {
  namespace fs = std::filesystem;
  std::vector<std::string> paths;
  const auto add = [&](const std::string& path) {
    std::error_code ignored;
    if (path.empty() || !fs::exists(path, ignored)) return;
    if (std::ranges::find(paths, path) == paths.end()) paths.push_back(path);
  };
  add(config.general.continue_from);
  for (std::size_t i = 0; i < config.stages.size() && i < schemas.size(); ++i) {
    const config::StageConfig& stage = config.stages[i];
    const auto own = values.find(stage.instance);
    if (stage.role == Role::Observer || own == values.end()) continue;
    for (const ParameterInfo& info : *schemas[i]) {
      const auto value = own->second.find(info.name);
      if (value == own->second.end()) continue;
      const auto* text = std::get_if<std::string>(&value->second);
      if (text == nullptr) continue;
      std::error_code ignored;
      const bool names_file =
          info.type == ParameterType::Text && fs::is_regular_file(*text, ignored);
      if (info.type == ParameterType::Path || names_file) add(*text);
    }
  }
  return paths;
}

}  // namespace tolman::run
