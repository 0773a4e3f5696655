// SPDX-License-Identifier: BSD-3-Clause
// Reads settings and stages from the tree.
#include "config/system_config.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "config/text.hpp"

namespace tolman::config {
namespace {

constexpr std::array kChain = {Role::Source, Role::Odometry, Role::Place, Role::Cells, Role::Map};
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
    config_.pipeline = section<PipelineSettings>("pipeline");
    evaluation();
    config_.record = section<RecordSettings>("record");
    config_.isolation = section<IsolationSettings>("isolation");
    config_.checks = section<CheckSettings>("checks");
    config_.rectification = section<RectificationSettings>("rectification");
    config_.images = section<ImageSettings>("images");
    for (const Role role : kChain) chainStage(role);
    observers();
    refuseSharedNames();
    return std::move(config_);
  }

 private:
  /// Checks a map against the declaration of S and stores it for the resolved configuration.
  template <class S>
  S checked(Section section, const Node& map, const std::vector<std::string>& also_known) {
    const Subject subject{section.key, "", also_known};
    section.values = check(map, schemaOf<S>(), subject, loaded_.folders, problems_);
    config_.sections.push_back(section);
    return bindParameters<S>(section.values).value();
  }

  template <class S>
  S section(const std::string& key) {
    const Node* given = tree_.find(key);
    if (given == nullptr) return checked<S>({key, {}, {}}, {Node::Kind::Map}, {});
    return checked<S>({key, {}, *given}, *given, {});
  }

  void general() {
    std::vector<std::string> others(kChain.size());
    std::ranges::transform(kChain, others.begin(), [](Role role) { return enumName(role); });
    others.insert(others.end(), {kObservers, "pipeline", "evaluation", "record", "isolation",
                                 "checks", "rectification", "images", "extends"});
    config_.general = checked<GeneralSettings>({"", {}, tree_}, tree_, others);
    std::string& name = config_.general.name;  // which JSON, XML and terminals show
    name = printable(name.empty() ? std::filesystem::path(loaded_.file).stem().string() : name);
    config_.sections.back().values["name"] = name;
  }

  /// A list under `segments` is read as `segment_lengths`.
  void evaluation() {
    Node* segments = nullptr;
    if (Node* map = tree_.find("evaluation")) segments = map->find("segments");
    if (segments != nullptr && segments->isSequence()) segments->key = "segment_lengths";
    config_.evaluation = section<EvaluationSettings>("evaluation");
  }

  void chainStage(Role role) {
    const std::string name(enumName(role));
    if (const Node* given = tree_.find(name)) {
      stage(role, name, *given);
    } else if (loaded_.complete) {
      problems_.push_back({tree_.origin, name,
                           "the stage is missing; add '" + name +
                               ": {plugin: ...}' ('tolman plugins list' shows the plugins)"});
    }
  }

  void observers() {
    const Node* given = tree_.find(kObservers);
    if (given == nullptr) return;
    if (!given->isSequence()) {
      problems_.push_back({given->origin, kObservers,
                           "expects a list such as [{plugin: progress}], not " + describe(*given)});
      return;
    }
    for (const Node& item : given->children) {
      stage(Role::Observer, joinPath(kObservers, item.key), item);
    }
  }

  void stage(Role role, const std::string& path, const Node& given) {
    if (!given.isMap()) {
      problems_.push_back(
          {given.origin, path, "expects a map such as {plugin: ...}, not " + describe(given)});
      return;
    }
    const StageSettings settings = stageSettings(path, given);
    StageConfig stage{
        role, path, settings.plugin, settings.name, settings.on_failure, settings.isolation, given};
    if (stage.instance.empty()) {
      stage.instance = role == Role::Observer ? settings.plugin : std::string(enumName(role));
    } else if (!isInstanceName(stage.instance)) {
      problems_.push_back({given.find("name")->origin, joinPath(path, "name"),
                           "use letters, digits, '_' and '-': it becomes the name of a folder"});
    }
    if (stage.on_failure == FailurePolicy::Restart && stage.isolation == Isolation::None) {
      problems_.push_back({given.find("on_failure")->origin, joinPath(path, "on_failure"),
                           "restart needs 'isolation: process': a stage in the host cannot be "
                           "restarted"});
    }
    config_.stages.push_back(std::move(stage));
  }

  /// The host's keys of a stage. Without a plugin the other keys are not checked later, so a key
  /// that resembles one of the host's is reported here.
  StageSettings stageSettings(const std::string& path, const Node& given) {
    Node own = given;
    const bool has_plugin = given.find("plugin") != nullptr;
    std::erase_if(own.children, [&](const Node& child) {
      return !isReserved(child.key) && (has_plugin || !nearestName(child.key, reservedKeys()));
    });
    const ParameterValues values =
        check(own, schemaOf<StageSettings>(), {path, "", {}}, loaded_.folders, problems_);
    const Node* plugin = given.find("plugin");
    if (plugin != nullptr && plugin->isScalar() && plugin->text.empty()) {
      problems_.push_back({plugin->origin, joinPath(path, "plugin"), "is empty"});
    }
    return bindParameters<StageSettings>(values).value();
  }

  void refuseSharedNames() {
    for (auto stage = config_.stages.begin(); stage != config_.stages.end(); ++stage) {
      const auto twin = std::find_if(config_.stages.begin(), stage, [&](const StageConfig& other) {
        return other.instance == stage->instance && !other.instance.empty();
      });
      if (twin == stage) continue;
      problems_.push_back({stage->given.origin, stage->path,
                           "has the same name '" + stage->instance + "' as " + twin->path +
                               "; set another 'name'"});
    }
  }

  const Loaded& loaded_;
  Node tree_;
  Problems& problems_;
  SystemConfig config_;
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
  for (const ParameterInfo& info : schema) {
    if (!isReserved(info.name)) continue;
    problems.push_back({stage.pluginOrigin(), stage.path,
                        "plugin " + stage.plugin + " declares the parameter '" + info.name +
                            "', which is a key of the host; rename it in the plugin"});
  }
  const Subject subject{stage.path, "plugin " + stage.plugin, reservedKeys()};
  return check(stage.given, schema, subject, folders, problems);
}

}  // namespace tolman::config
