// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

#include "config/loader.hpp"
#include "config/text.hpp"
#include "engine/checked_system.hpp"
#include "experiment/sweep_folder.hpp"
#include "record/digest.hpp"

namespace tolman::experiment {
namespace {

using config::Node;

/// A resolved configuration without cells, map, observers, evaluation and record.
std::string frontEndPart(const std::string& yaml) {
  constexpr std::array<std::string_view, 5> kLater = {
      "cells:", "map:", "evaluation:", "record:", "observers:"};
  std::string part;
  bool taken = true;
  std::istringstream lines(yaml);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(' ')) taken = std::ranges::find(kLater, line) == kLater.end();
    if (taken) part += line + "\n";
  }
  return part;
}

std::string folderName(const std::string& name, const std::string& key) {
  constexpr std::size_t kLongest = 80;
  std::string folder = name.substr(0, kLongest);
  for (char& c : folder) {
    const bool is_plain = config::isLetter(c) || config::isDigit(c) ||
                          std::string_view("=,+_-").find(c) != std::string_view::npos ||
                          (c == '.' && &c != folder.data());
    if (!is_plain) c = '_';
  }
  return folder + "-" + key.substr(0, 10);
}

/// Sets a value of the configuration, for example "record.replay".
void setText(Node& tree, const std::string& path, const std::string& text, const Node& origin) {
  Node value{Node::Kind::Scalar, path.substr(path.rfind('.') + 1), origin.origin, origin.origin};
  value.text = text;
  (void)config::setValue(tree, path, value);
}

class Planner {
 public:
  Planner(const PlanOptions& options, Plan& plan)
      : options_(options), plan_(plan), catalogue_(engine::openCatalogue(options.plugin_paths)) {
    const auto host = record::fileDigest("/proc/self/exe");
    host_ = host.isOk() ? host.value() : "unreadable";
    for (const auto* runs : {&options.frozen.earlier, &options.frozen.planned}) {
      for (const PlannedRun& run : *runs) {
        for (const record::DataDigest& data : run.inputs.data) known_[data.path] = data;
      }
    }
  }

  void make(const SweepFile& sweep) {
    const std::vector<SweepPoint> points = pointsOf(sweep, plan_.problems);
    if (!plan_.problems.empty()) return;
    std::vector<PlannedRun> runs;
    std::map<std::string, std::string> names;  // by key
    for (const SweepPoint& point : points) {
      const PriorRun* front = point.front_end ? &priorRun(sweep, *point.front_end) : nullptr;
      const config::Loaded& base = this->base(sweep, point, front);
      std::optional<PlannedRun> run = resolve(base, point, front);
      if (!run) continue;
      const auto [same, is_new] = names.try_emplace(run->key, run->name);
      if (!is_new) {
        addProblem({config::Origin::ofFile(sweep.file), "",
                    "'" + same->second + "' and '" + run->name + "' are the same run"});
      }
      runs.push_back(std::move(*run));
    }
    for (const auto& [label, front] : prior_runs_) plan_.runs.push_back(front.run);
    if (sweep.reuse) shareFrontEnds(runs);
    std::ranges::move(runs, std::back_inserter(plan_.runs));
  }

 private:
  /// A front end or a first session, which other runs build on.
  struct PriorRun {
    PlannedRun run;
    std::string path;  ///< of its run directory
  };
  struct Plugin {
    host::LoadedPlugin loaded;
    std::map<std::string, std::string> digests;  ///< by file: library, program, its files
  };

  /// Adds a problem unless it was added before.
  void addProblem(config::Problem problem) {
    if (reported_.insert(config::format(problem)).second)
      plan_.problems.push_back(std::move(problem));
  }

  config::Loaded load(const Node& file) {
    std::filesystem::path path = std::filesystem::path(file.origin.file).parent_path() / file.text;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) path = options_.find_config(file.text);
    config::Loaded loaded =
        config::load(path.lexically_normal(), {}, options_.environment, options_.find_shipped);
    if (!loaded.complete) {
      addProblem({file.origin, file.key, "the configuration '" + file.text + "' cannot be read"});
    }
    for (const config::Problem& problem : loaded.problems) addProblem(problem);
    loaded.problems.clear();
    loaded.tree.erase("observers");
    const Node* record = loaded.tree.find("record");
    if (record == nullptr || record->find("report") == nullptr) {
      setText(loaded.tree, "record.report", "false", file);
    }
    return loaded;
  }

  /// Plugins and whole sections first: naming another plugin discards the parameters set so far.
  void apply(Node& tree, std::vector<Setting> settings) {
    // Not of std::ranges: clang 14, and so clang-tidy, cannot compile its result.
    std::stable_partition(settings.begin(), settings.end(), [](const Setting& setting) {
      return setting.key.ends_with(".plugin") || setting.value->isMap();
    });
    for (const Setting& setting : settings) {
      const Status done = config::setValue(tree, setting.key, *setting.value);
      if (!done.isOk()) addProblem({setting.value->origin, setting.key, done.message()});
    }
  }

  const PriorRun& priorRun(const SweepFile& sweep, const FrontEnd& front) {
    const std::string name = (front.is_session ? "first-session-" : "front-end-") + front.label;
    const auto found = prior_runs_.find(name);
    if (found != prior_runs_.end()) return found->second;
    PriorRun& made = prior_runs_[name];
    config::Loaded base = load(*front.base);
    if (front.is_session) apply(base.tree, sweep.settings);
    setText(base.tree, "record.replay", "true", *front.base);
    const SweepPoint point{name, {}, front.settings, nullptr};
    if (auto run = resolve(base, point, nullptr)) made.run = std::move(*run);
    made.run.is_front_end = true;
    made.path = (options_.out / made.run.folder / "run").string();
    return made;
  }

  /// The base with the settings of all points, and the replay or the map of the front end.
  const config::Loaded& base(const SweepFile& sweep, const SweepPoint& point,
                             const PriorRun* front) {
    const auto found = bases_.find(point.front_end.get());
    if (found != bases_.end()) return found->second;
    config::Loaded loaded = load(*sweep.base);
    if (front != nullptr && point.front_end->is_session) {
      setText(loaded.tree, "continue", front->path, *sweep.base);
    } else if (front != nullptr) {
      const auto environment = [&](const std::string& name) {
        return name == "REPLAY_RUN" ? front->path : options_.environment(name);
      };
      const config::Loaded replay =
          config::load(options_.find_config("experiments/replay"), {}, environment);
      for (const config::Problem& problem : replay.problems) addProblem(problem);
      config::merge(loaded.tree, replay.tree);
    }
    apply(loaded.tree, sweep.settings);
    return bases_.emplace(point.front_end.get(), std::move(loaded)).first->second;
  }

  /// The opened plugin; null if it is refused.
  const Plugin* plugin(const config::StageConfig& stage, const config::SystemConfig& system,
                       config::Problems& problems) {
    try {
      const host::Manifest manifest = engine::manifestOf(catalogue_, stage, system);
      const std::tuple key(stage.plugin, stage.role, manifest.program.string());
      if (const auto found = plugins_.find(key); found != plugins_.end()) return &found->second;
      return &plugins_.emplace(key, openPlugin(manifest, stage.role, system)).first->second;
    } catch (const engine::Failure& refused) {
      problems.push_back({stage.pluginOrigin(), stage.path + ".plugin", refused.what(),
                          config::Problem::Kind::Plugin});
      return nullptr;
    }
  }

  /// Throws engine::Failure.
  static Plugin openPlugin(const host::Manifest& manifest, Role role,
                           const config::SystemConfig& system) {
    Plugin plugin{engine::describeFrom(manifest, role, system), {}};
    std::vector<std::string> files = plugin.loaded.manifest.program_files;
    files.push_back(manifest.file.string());
    if (!manifest.program.empty()) files.push_back(manifest.program.string());
    for (const std::string& file : files) {
      const auto digest = record::fileDigest(file);
      plugin.digests[file] = digest.isOk() ? digest.value() : "unreadable";
    }
    return plugin;
  }

  const record::DataDigest* data(const std::string& path) {
    const auto found = plan_.data.find(path);
    if (found != plan_.data.end()) return &found->second;
    auto digest = record::digestData(path, known_[path]);
    if (!digest.isOk()) {
      addProblem({config::Origin::ofFile(path), "", digest.status().message()});
      return nullptr;
    }
    return &plan_.data.emplace(path, std::move(digest).value()).first->second;
  }

  /// The run of one point, with checked values; nothing if they have problems.
  std::optional<PlannedRun> resolve(const config::Loaded& base, const SweepPoint& point,
                                    const PriorRun* front) {
    config::Loaded loaded = base;
    apply(loaded.tree, point.settings);
    config::Problems problems;
    config::SystemConfig system = config::parse(loaded, problems);
    config::StageValues values;
    engine::StageSchemas schemas;
    PlannedRun run;
    for (const config::StageConfig& stage : system.stages) {
      if (stage.plugin.empty()) continue;
      const Plugin* plugin = this->plugin(stage, system, problems);
      if (plugin == nullptr) continue;
      values[stage.instance] =
          config::check(stage, plugin->loaded.schema, system.folders, problems);
      schemas[stage.instance] = &plugin->loaded.schema;
      for (const auto& [file, digest] : plugin->digests) {
        run.inputs.plugins[file] = digest;
        if (stage.role < Role::Cells)  // source, odometry or place
          run.front_end_sha256 += "plugin " + digest + "\n";
      }
    }
    for (const config::Problem& problem : problems) addProblem(problem);
    if (!problems.empty() || !loaded.complete) return std::nullopt;
    run.name = point.name;
    run.factors = point.factors;
    run.inputs.host = host_;
    engine::InputPaths inputs = engine::inputPaths(system, values, schemas);
    addData(run, inputs.present, front);
    if (front == nullptr) plan_.missing.merge(inputs.missing);
    setKey(run, system, values, front);
    return run;
  }

  void addData(PlannedRun& run, const std::vector<std::string>& paths, const PriorRun* front) {
    for (const std::string& path : paths) {
      if (front != nullptr && path == front->path) continue;  // front->run.key represents it
      if (run.inputs.plugins.contains(path)) continue;        // a program
      if (const record::DataDigest* digest = data(path)) run.inputs.data.push_back(*digest);
    }
  }

  void setKey(PlannedRun& run, config::SystemConfig& system, const config::StageValues& values,
              const PriorRun* front) const {
    const auto section = [&](const char* key) -> ParameterValues& {
      return std::ranges::find(system.sections, key, &config::Section::key)->values;
    };
    ParameterValues& general = section("");
    const ParameterValue threads = std::exchange(general["threads"], std::int64_t{0});
    const ParameterValues record = section("record");
    general["name"] = std::string("-");
    for (const char* irrelevant : {"replay", "report", "state_every"})
      section("record").erase(irrelevant);
    std::string decisive_yaml = config::resolvedYaml(system, values);
    if (front != nullptr) {
      boost::replace_all(decisive_yaml, front->path, "front end " + front->run.key);
    }
    std::string inputs = "host " + run.inputs.host + "\n";
    for (const record::DataDigest& data : run.inputs.data) {
      inputs += "data " + data.path + " " + (data.sha256.empty() ? data.stamp : data.sha256) + "\n";
    }
    run.front_end_sha256 =
        record::textDigest(frontEndPart(decisive_yaml) + inputs + run.front_end_sha256);
    for (const auto& [file, digest] : run.inputs.plugins) inputs += "plugin " + digest + "\n";
    run.key = record::textDigest(decisive_yaml + inputs);
    run.folder = folderName(run.name, run.key);
    if (front != nullptr) run.front_end_folder = front->run.folder;
    general["name"] = run.name;
    general["threads"] = threads;
    section("record") = record;
    run.config = config::resolvedYaml(system, values);
    run.config_sha256 = record::textDigest(run.config);
  }

  /// Of several runs with the same front end, the first records its answers and the others replay
  /// them. Runs that replay the run of a front end anyway (`front_end_folder`) are left out.
  static void shareFrontEnds(std::vector<PlannedRun>& runs) {
    std::map<std::string, PlannedRun*> first;  // by front end
    for (PlannedRun& run : runs) {
      if (!run.front_end_folder.empty()) continue;
      const auto [shared, is_new] = first.try_emplace(run.front_end_sha256, &run);
      if (is_new) continue;
      run.answers_folder = shared->second->folder;
      shared->second->keeps_answers = true;
    }
  }

  const PlanOptions& options_;
  Plan& plan_;
  host::Catalogue catalogue_;
  std::string host_;
  std::map<std::string, record::DataDigest> known_;  ///< of earlier plans, by path
  std::map<const FrontEnd*, config::Loaded> bases_;
  std::map<std::string, PriorRun> prior_runs_;                            ///< by name
  std::map<std::tuple<std::string, Role, std::string>, Plugin> plugins_;  ///< by id and program
  std::set<std::string> reported_;
};

}  // namespace

Plan makePlan(const std::filesystem::path& file, const PlanOptions& options) {
  Plan plan;
  const SweepFile sweep = readSweep(file, options.environment, plan.problems);
  plan.name = sweep.name;
  if (plan.problems.empty()) Planner(options, plan).make(sweep);
  return plan;
}

}  // namespace tolman::experiment
