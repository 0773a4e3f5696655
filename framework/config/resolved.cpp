// SPDX-License-Identifier: BSD-3-Clause
// Writing configurations.
#include <algorithm>

#include "config/system_config.hpp"

namespace tolman::config {
namespace {

struct Writer {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return writeReal(value); }
  std::string operator()(const std::string& value) const { return writeText(value); }
  std::string operator()(const std::vector<double>& values) const {
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ", ") + writeReal(value);
    return '[' + list + ']';
  }
};

class Document {
 public:
  explicit Document(bool with_origins) : with_origins_(with_origins) {}

  void heading(const std::string& line) { text_ += line + '\n'; }

  /// `given` is the map the value may have come from.
  void value(const std::string& before, const std::string& key, const ParameterValue& value,
             const Node& given) {
    std::string line = before + key + ": " + std::visit(Writer{}, value);
    if (with_origins_) {
      const Node* node = given.find(key);
      line.resize(std::max<std::size_t>(line.size() + 2, 44), ' ');
      line += "# " + text(node != nullptr ? node->origin : Origin{});
      if (node != nullptr && !node->origin.variables.empty()) {
        line += " with " + node->origin.variables + " of the environment";
      }
    }
    text_ += line + '\n';
  }

  void values(const std::string& indent, const ParameterValues& values, const Node& given) {
    for (const auto& [key, one] : values) value(indent, key, one, given);
  }

  void stage(const std::string& first, const std::string& rest, const StageConfig& stage,
             const StageValues& values) {
    value(first, "plugin", stage.plugin, stage.given);
    value(rest, "name", stage.instance, stage.given);
    value(rest, "on_failure", std::string(enumName(stage.on_failure)), stage.given);
    value(rest, "isolation", std::string(enumName(stage.isolation)), stage.given);
    const auto own = values.find(stage.instance);
    if (own != values.end()) this->values(rest, own->second, stage.given);
  }

  std::string take() { return std::move(text_); }

 private:
  bool with_origins_;
  std::string text_;
};

std::string write(const SystemConfig& config, const StageValues& values, bool with_origins) {
  Document document(with_origins);
  for (const Section& section : config.sections) {
    if (!section.key.empty()) document.heading(section.key + ":");
    document.values(section.key.empty() ? "" : "  ", section.values, section.given);
  }
  bool in_observers = false;
  for (const StageConfig& stage : config.stages) {
    if (stage.role != Role::Observer) {
      document.heading(stage.path + ":");
      document.stage("  ", "  ", stage, values);
      continue;
    }
    if (!in_observers) document.heading("observers:");
    in_observers = true;
    document.stage("  - ", "    ", stage, values);
  }
  return document.take();
}

}  // namespace

std::string resolvedYaml(const SystemConfig& config, const StageValues& values) {
  return write(config, values, false);
}

std::string explain(const SystemConfig& config, const StageValues& values) {
  return write(config, values, true);
}

}  // namespace tolman::config
