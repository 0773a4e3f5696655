// SPDX-License-Identifier: BSD-3-Clause
// Reads settings and stages from the tree, and writes them.
#include "config/system_config.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "config/text.hpp"

namespace tolman::config {
namespace {

constexpr const char* kObservers = "observers";

const std::vector<std::string>& reservedKeys() {
  static const std::vector<std::string> kKeys = {"plugin", "name", "on_failure", "isolation"};
  return kKeys;
}

bool isReserved(const std::string& key) {
  return std::ranges::find(reservedKeys(), key) != reservedKeys().end();
}

bool isInstanceName(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return isLetter(c) || isDigit(c) || c == '_' || c == '-';
  });
}

class Parser {
 public:
  Parser(const Loaded& loaded, Problems& problems)
      : loaded_(loaded), tree_(loaded.tree), problems_(problems) {
    config_.folders = loaded.folders;
  }

  SystemConfig run() {
    general();
    nameSegmentLengths();
    visitSections(config_, [this](const char* key, auto& section) {
      const Node* given = tree_.find(key);
      section = checked<std::decay_t<decltype(section)>>(
          {key, {}, given == nullptr ? Node{} : *given},
          given == nullptr ? Node{Node::Kind::Map} : *given, {});
    });
    for (const Role role : kChain) chainStage(std::string(enumName(role)), role);
    observers();
    refuseSharedNames();
    return std::move(config_);
  }

 private:
  void report(const Origin& where, const std::string& path, const std::string& message) {
    problems_.push_back({where, path, message});
  }

  /// Checks a map against the declaration of S and stores it for the resolved configuration.
  template <class S>
  S checked(Section section, const Node& map, const std::vector<std::string>& also_known) {
    const Subject subject{section.key, "", also_known};
    section.values = check(map, schemaOf<S>(), subject, loaded_.folders, problems_);
    config_.sections.push_back(section);
    return bindParameters<S>(section.values).value();
  }

  void general() {
    std::vector<std::string> others;
    for (const Role role : kChain) others.emplace_back(enumName(role));
    others.emplace_back(kObservers);
    visitSections(config_, [&](const char* key, const auto&) { others.emplace_back(key); });
    others.emplace_back("extends");
    config_.general = checked<GeneralSettings>({"", {}, tree_}, tree_, others);
    std::string& name = config_.general.name;  // which JSON, XML and terminals show
    name = printable(name.empty() ? std::filesystem::path(loaded_.file).stem().string() : name);
    config_.sections.back().values["name"] = name;
  }

  /// A list under `segments` is read as `segment_lengths`.
  void nameSegmentLengths() {
    Node* map = tree_.find("evaluation");
    Node* segments = map == nullptr ? nullptr : map->find("segments");
    if (segments != nullptr && segments->isSequence()) segments->key = "segment_lengths";
  }

  void chainStage(const std::string& name, Role role) {
    if (const Node* given = tree_.find(name)) {
      stage(role, name, *given);
    } else if (loaded_.complete) {
      report(tree_.origin, name,
             "the stage is missing; add '" + name +
                 ": {plugin: ...}' ('tolman plugins list' shows the plugins)");
    }
  }

  void observers() {
    const Node* given = tree_.find(kObservers);
    if (given == nullptr) return;
    if (!given->isSequence()) {
      report(given->origin, kObservers,
             "expects a list such as [{plugin: progress}], not " + describe(*given));
      return;
    }
    for (const Node& item : given->children) {
      stage(Role::Observer, joinPath(kObservers, item.key), item);
    }
  }

  void stage(Role role, const std::string& path, const Node& given) {
    if (!given.isMap()) {
      report(given.origin, path, "expects a map such as {plugin: ...}, not " + describe(given));
      return;
    }
    const StageSettings settings = stageSettings(path, given);
    StageConfig stage{
        role, path, settings.plugin, settings.name, settings.on_failure, settings.isolation, given};
    if (stage.instance.empty()) {
      stage.instance = role == Role::Observer ? settings.plugin : std::string(enumName(role));
    } else if (!isInstanceName(stage.instance)) {
      report(given.find("name")->origin, joinPath(path, "name"),
             "use letters, digits, '_' and '-': it becomes the name of a folder");
    }
    if (stage.on_failure == FailurePolicy::Restart && stage.isolation == Isolation::None) {
      report(given.find("on_failure")->origin, joinPath(path, "on_failure"),
             "restart needs 'isolation: process': a stage in the host cannot be restarted");
    }
    config_.stages.push_back(std::move(stage));
  }

  /// The host's keys of a stage. Without a plugin the other keys are not checked later, so a key
  /// that resembles one of the host's is reported here.
  StageSettings stageSettings(const std::string& path, const Node& given) {
    Node own = given;
    const Node* plugin = given.find("plugin");
    std::erase_if(own.children, [&](const Node& child) {
      const bool checked_later = plugin != nullptr || !nearestName(child.key, reservedKeys());
      return !isReserved(child.key) && checked_later;
    });
    const ParameterValues values =
        check(own, schemaOf<StageSettings>(), {path, "", {}}, loaded_.folders, problems_);
    if (plugin != nullptr && plugin->isScalar() && plugin->text.empty()) {
      report(plugin->origin, joinPath(path, "plugin"), "is empty");
    }
    return bindParameters<StageSettings>(values).value();
  }

  void refuseSharedNames() {
    for (auto stage = config_.stages.begin(); stage != config_.stages.end(); ++stage) {
      const auto twin =
          std::ranges::find(config_.stages.begin(), stage, stage->instance, &StageConfig::instance);
      if (twin == stage || stage->instance.empty()) continue;
      report(
          stage->given.origin, stage->path,
          "has the same name '" + stage->instance + "' as " + twin->path + "; set another 'name'");
    }
  }

  const Loaded& loaded_;
  Node tree_;
  Problems& problems_;
  SystemConfig config_;
};

class Document {
 public:
  explicit Document(bool with_origins) : with_origins_(with_origins) {}

  std::string write(const SystemConfig& config, const StageValues& values) {
    for (const Section& section : config.sections) {
      if (!section.key.empty()) text_ += section.key + ":\n";
      addAll(section.key.empty() ? "" : "  ", section.values, section.given);
    }
    bool in_observers = false;
    for (const StageConfig& stage : config.stages) {
      const bool is_observer = stage.role == Role::Observer;
      if (!in_observers) text_ += (is_observer ? kObservers : stage.path) + ":\n";
      in_observers = is_observer;
      addStage(is_observer ? "  - " : "  ", is_observer ? "    " : "  ", stage, values);
    }
    return std::move(text_);
  }

 private:
  /// `given` is the map the value may have come from.
  void add(const std::string& before, const std::string& key, const ParameterValue& value,
           const Node& given) {
    std::string line = before + key + ": " + writeValue(value);
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

  void addAll(const std::string& indent, const ParameterValues& values, const Node& given) {
    for (const auto& [key, value] : values) add(indent, key, value, given);
  }

  void addStage(const std::string& first, const std::string& rest, const StageConfig& stage,
                const StageValues& values) {
    add(first, "plugin", stage.plugin, stage.given);
    add(rest, "name", stage.instance, stage.given);
    add(rest, "on_failure", std::string(enumName(stage.on_failure)), stage.given);
    add(rest, "isolation", std::string(enumName(stage.isolation)), stage.given);
    const auto own = values.find(stage.instance);
    if (own != values.end()) addAll(rest, own->second, stage.given);
  }

  bool with_origins_;
  std::string text_;
};

}  // namespace

Origin StageConfig::pluginOrigin() const {
  const Node* named = given.find("plugin");
  return named != nullptr ? named->origin : given.origin;
}

SystemConfig parse(const Loaded& loaded, Problems& problems) {
  return Parser(loaded, problems).run();
}

ParameterValues check(const StageConfig& stage, const Schema& schema, const BaseFolders& folders,
                      Problems& problems) {
  const Subject subject{stage.path, "plugin " + stage.plugin, reservedKeys()};
  return check(stage.given, schema, subject, folders, problems);
}

std::string resolvedYaml(const SystemConfig& config, const StageValues& values) {
  return Document(false).write(config, values);
}

std::string explain(const SystemConfig& config, const StageValues& values) {
  return Document(true).write(config, values);
}

}  // namespace tolman::config
