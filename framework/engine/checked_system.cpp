// SPDX-License-Identifier: BSD-3-Clause
#include "engine/checked_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>

#include "config/loader.hpp"
#include "config/tree.hpp"
#include "host/remote_plugin.hpp"
#include "record/atomic_file.hpp"

namespace tolman::engine {

namespace {

using Kind = config::Problem::Kind;

constexpr std::array<std::string_view, 4> kChain = {"odometry", "place", "cells", "map"};

/// Removes the stages that are outside the scope from the configuration.
void confine(config::Loaded& loaded, Scope scope, config::Problems& problems) {
  if (scope == Scope::All) return;
  if (scope != Scope::SourceAndObservers) loaded.tree.erase("observers");
  if (scope == Scope::WithoutObservers) return;
  std::vector<std::string_view> needed = {"source"};
  if (scope == Scope::SourceAndOdometry) needed.emplace_back("odometry");
  if (scope == Scope::SourceAndPlace) needed.emplace_back("place");
  for (const std::string_view stage : kChain) {
    if (stage != needed.back()) loaded.tree.erase(stage);
  }
  for (const std::string_view stage : needed) {
    if (!loaded.complete || loaded.tree.find(stage) != nullptr) continue;
    problems.push_back({loaded.tree.origin, std::string(stage),
                        "the stage is missing; add '" + std::string(stage) +
                            ": {plugin: ...}' ('tolman plugins list' shows the plugins)"});
  }
  loaded.complete = false;  // the other stages may be missing
}

/// Appends observers by the ids of their plugins, unless the configuration names them already.
void addObservers(config::Loaded& loaded, const std::vector<std::string>& plugins,
                  config::Problems& problems) {
  for (const std::string& plugin : plugins) {
    const config::Node none;
    const config::Node* list = loaded.tree.find("observers");
    const auto& stages = list == nullptr ? none.children : list->children;
    const bool named = std::ranges::any_of(stages, [&](const config::Node& stage) {
      const config::Node* id = stage.find("plugin");
      return id != nullptr && id->text == plugin;
    });
    if (named) continue;
    config::applyOverrides(loaded.tree,
                           {fmt::format("observers.{}.plugin={}", stages.size(), plugin)},
                           config::processEnvironment(), problems);
  }
}

struct Opened {
  host::LoadedPlugin plugin;
  std::shared_ptr<host::RemotePlugin> remote;
};

/// The program that the key `file` names, as a plugin. Throws Failure or host::Refusal.
host::Manifest programOf(const host::Catalogue& catalogue, const config::StageConfig& stage,
                         const config::SystemConfig& config) {
  const Schema schema = config::programSchema();
  config::Node own = stage.given;
  std::erase_if(own.children, [&](const auto& child) { return child.key != schema[0].name; });
  config::Problems problems;
  const auto values = config::check(own, schema, {stage.path, "plugin " + stage.plugin, {}},
                                    config.folders, problems);
  if (!problems.empty())
    throw Failure(FailureKind::Configuration,
                  "'" + schema[0].name + "' " + problems.front().message);
  return catalogue.program(std::get<std::string>(values.at(schema[0].name)));
}

/// Opens a plugin in a process of its own. Throws host::Refusal.
Opened openApart(const host::Manifest& manifest, Role role, const config::SystemConfig& config,
                 const SystemOptions& options) {
  const host::LaunchOptions launch{options.stage_program, config.isolation.deadline,
                                   static_cast<std::uint64_t>(config.isolation.memory_limit),
                                   config.general.threads};
  auto remote = host::RemotePlugin::start(manifest, launch);
  if (remote->manifest().role != role) {  // known of a program only when it is open
    throw host::Refusal{"plugin/wrong-role",
                        fmt::format("{} has the role {}, not {}", manifest.program.string(),
                                    enumName(remote->manifest().role), enumName(role)),
                        "derive its class from the class of the stage's role"};
  }
  Schema schema = manifest.program.empty() ? Schema() : config::programSchema();
  schema.insert(schema.end(), remote->schema().begin(), remote->schema().end());
  return {{remote->manifest(), nullptr, std::move(schema)}, remote};
}

/// "(extra `localise`): view_templates, ..."
std::string localisersOf(const host::Catalogue& catalogue, Role role) {
  std::set<std::string> ids;
  for (const host::Manifest& manifest : catalogue.manifests()) {
    if (manifest.role == role && manifest.hasExtra("localise")) ids.insert(manifest.id);
  }
  return fmt::format("(extra `localise`): {}", fmt::join(ids, ", "));
}

/// Opens the plugin of a stage. Throws Failure or host::Refusal.
Opened open(const host::Catalogue& catalogue, const config::StageConfig& stage,
            const config::SystemConfig& config, const SystemOptions& options) {
  const auto manifest = manifestOf(catalogue, stage, config);
  const bool learns = stage.role == Role::Place || stage.role == Role::Cells;
  if (learns && !config.general.localise.empty() && !manifest.hasExtra("localise")) {
    throw host::Refusal{"plugin/cannot-localise",
                        "plugin '" + stage.plugin + "' cannot use a map without changing it",
                        "continue the map with --continue, or make it with plugins that can " +
                            localisersOf(catalogue, stage.role)};
  }
  if (options.apart || !manifest.program.empty() || stage.isolation != config::Isolation::None) {
    return openApart(manifest, stage.role, config, options);
  }
  return {host::loadPlugin(manifest, host::HostIdentity::ofThisBuild()), nullptr};
}

/// Enables restarts of a remote plugin. Creates its object, because only the object shows whether
/// the plugin saves its state.
void prepareRestart(const config::StageConfig& stage, host::RemotePlugin& remote,
                    config::Problems& problems) {
  const config::Origin origin = stage.given.find("on_failure")->origin;
  try {
    remote.create();
  } catch (const host::Refusal& refusal) {
    problems.push_back({origin, stage.path + ".plugin", refusal.text(), Kind::Plugin});
    return;
  }
  if (remote.enableRestart()) return;
  problems.push_back(
      {origin, stage.path + ".on_failure",
       "plugin '" + stage.plugin +
           "' cannot be restarted in a new process (a source never can; place, cells and map "
           "plugins must save their state); use 'skip' or 'stop'"});
}

}  // namespace

host::Catalogue openCatalogue(const std::vector<std::string>& plugin_paths) {
  std::error_code ignored;
  const auto executable = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return host::Catalogue(
      host::searchPath(plugin_paths, std::getenv("TOLMAN_PLUGIN_PATH"), executable));
}

std::string findPageObserver(const host::Catalogue& catalogue) {
  std::set<std::string> ids;
  for (const host::Manifest& manifest : catalogue.manifests()) {
    if (manifest.role == Role::Observer && manifest.hasExtra("page")) ids.insert(manifest.id);
  }
  if (!ids.empty()) return *ids.begin();
  const host::Refusal none{"plugin/no-page", "no observer on the search path serves a page",
                           "name the folder of such an observer with --plugin-path"};
  throw Failure(FailureKind::Plugin, none.text());
}

host::LoadedPlugin loadFrom(const host::Catalogue& catalogue, const std::string& id, Role role) {
  return opening([&] {
    return host::loadPlugin(catalogue.find(id, role), host::HostIdentity::ofThisBuild());
  });
}

host::Manifest manifestOf(const host::Catalogue& catalogue, const config::StageConfig& stage,
                          const config::SystemConfig& config) {
  if (catalogue.interpreter(stage.plugin) != nullptr) {
    return opening([&] { return programOf(catalogue, stage, config); });
  }
  return opening([&] { return catalogue.find(stage.plugin, stage.role); });
}

host::LoadedPlugin describeFrom(const host::Manifest& manifest, Role role,
                                const config::SystemConfig& config) {
  return opening([&] {
    if (!manifest.program.empty()) return openApart(manifest, role, config, {}).plugin;
    return host::loadPlugin(manifest, host::HostIdentity::ofThisBuild());
  });
}

CheckedSystem checkSystem(const SystemOptions& options, Scope scope) {
  config::Loaded loaded = config::load(options.config, options.overrides,
                                       config::processEnvironment(), options.find_shipped);
  config::Problems problems = loaded.problems;
  addObservers(loaded, options.observers, problems);
  confine(loaded, scope, problems);
  CheckedSystem checked;
  checked.notes = loaded.notes;
  checked.config = config::parse(loaded, problems);
  const host::Catalogue catalogue = openCatalogue(options.plugin_paths);
  for (const config::StageConfig& stage : checked.config.stages) {
    if (stage.plugin.empty()) continue;  // already a problem
    Opened opened;
    try {
      opened = opening([&] { return open(catalogue, stage, checked.config, options); });
    } catch (const Failure& refused) {
      if (refused.kind == FailureKind::Machine) throw;
      problems.push_back(
          {stage.pluginOrigin(), stage.path + ".plugin", refused.what(), Kind::Plugin});
      continue;
    }
    ParameterValues& values = checked.values[stage.instance];
    values = config::check(stage, opened.plugin.schema, checked.config.folders, problems);
    const auto quiet = values.find("quiet");
    if (options.quiet && stage.role == Role::Observer && quiet != values.end() &&
        std::holds_alternative<bool>(quiet->second)) {
      quiet->second = true;
    }
    if (opened.remote && stage.on_failure == config::FailurePolicy::Restart) {
      prepareRestart(stage, *opened.remote, problems);
    }
    checked.plugins.push_back(std::move(opened.plugin));
    checked.remotes.push_back(std::move(opened.remote));
  }
  if (problems.empty()) return checked;
  const bool only_plugins = std::ranges::all_of(
      problems, [](const config::Problem& p) { return p.kind == Kind::Plugin; });
  throw Failure{only_plugins ? FailureKind::Plugin : FailureKind::Configuration,
                config::format(problems)};
}

InputPaths inputPaths(const config::SystemConfig& config, const config::StageValues& values,
                      const StageSchemas& schemas) {
  namespace fs = std::filesystem;
  InputPaths paths;
  std::error_code ignored;
  const auto add = [&](const std::string& path, bool is_needed) {
    if (!fs::exists(path, ignored)) {
      if (is_needed) paths.missing.insert(path);
    } else if (std::ranges::find(paths.present, path) == paths.present.end()) {
      paths.present.push_back(path);
    }
  };
  if (!config.general.earlier().empty()) add(config.general.earlier(), true);
  if (!config.evaluation.truth.empty()) add(config.evaluation.truth, true);
  for (const config::StageConfig& stage : config.stages) {
    const auto schema = schemas.find(stage.instance);
    const auto own = values.find(stage.instance);
    if (stage.role == Role::Observer || schema == schemas.end() || own == values.end()) continue;
    for (const ParameterInfo& info : *schema->second) {
      const auto value = own->second.find(info.name);
      if (value == own->second.end()) continue;
      const auto* text = std::get_if<std::string>(&value->second);
      if (text == nullptr || text->empty()) continue;
      const bool names_file =
          info.type == ParameterType::Text && fs::is_regular_file(*text, ignored);
      if (info.type == ParameterType::Path || names_file) add(*text, stage.role == Role::Source);
    }
  }
  return paths;
}

InputPaths inputPaths(const CheckedSystem& system) {
  StageSchemas schemas;
  for (std::size_t i = 0; i < system.plugins.size(); ++i) {
    schemas[system.config.stages[i].instance] = &system.plugins[i].schema;
  }
  return inputPaths(system.config, system.values, schemas);
}

namespace {

/// The seed of an instance depends on its name, so adding a plugin does not change the others'.
std::uint64_t seedOf(std::int64_t run_seed, const std::string& instance) {
  const auto start = static_cast<std::uint64_t>(run_seed) ^ 0xcbf29ce484222325ULL;
  return RandomStream(detail::fnv1a(start, instance)).bits();
}

/// The kind of a failure of configure(): Configuration for a bad value, Dataset for other failures
/// of a source.
FailureKind configureFailure(Role role, const Status& status) {
  const StatusCode code = status.code();
  if (code == StatusCode::InvalidParameter) return FailureKind::Configuration;
  if (role == Role::Source) return FailureKind::Dataset;
  return code == StatusCode::Unsupported ? FailureKind::Configuration : FailureKind::Plugin;
}

}  // namespace

std::unique_ptr<host::Instance> instantiate(const CheckedSystem& system, std::size_t i) {
  const std::string& name = system.config.stages[i].instance;
  const auto& remote = system.remotes[i];
  return opening(
      [&] {
        return remote ? host::instantiate(remote, name)
                      : host::Instance::create(system.plugins[i], name);
      },
      name);
}

Assembly::Assembly(CheckedSystem checked, RunLog& log, const Clock& clock,
                   const Cancellation& cancellation)
    : checked_(std::move(checked)),
      findings_(std::make_unique<Findings>(checked_.config.general.on_findings)) {
  for (std::size_t i = 0; i < checked_.config.stages.size(); ++i) {
    const config::StageConfig& stage = checked_.config.stages[i];
    auto instance = instantiate(checked_, i);
    const auto& services = services_.emplace_back(std::unique_ptr<Services>(
        new Services{stage.instance, {log, stage.instance}, {*findings_, stage.instance}, {}}));
    const Status status = findings_->judge(
        instance->configure({checked_.values.find(stage.instance)->second, services->log,
                             services->findings, services->artefacts, cancellation, clock,
                             info_.rig, seedOf(checked_.config.general.seed, stage.instance),
                             stage.instance, !checked_.config.general.localise.empty()}),
        -1);
    for (const Findings::Kind& kind : findings_->takeNewKinds()) {
      log.write(kind.level(), kind.first.stage, kind.text());
    }
    // What configure() answers then says nothing of the plugin or its data.
    if (cancellation.requested()) {
      throw Failure(FailureKind::Interrupted,
                    "interrupted while it was configured; nothing was run", stage.instance);
    }
    require(status, configureFailure(stage.role, status), stage.instance);
    instances_.push_back(instance.get());
    add(std::move(instance), stage);
    if (stage.role != Role::Source) continue;  // it is the first stage
    require(source().info(info_), FailureKind::Dataset, stage.instance);
  }
}

void Assembly::add(std::unique_ptr<host::Instance> instance, const config::StageConfig& stage) {
  switch (stage.role) {
    case Role::Source:
      source_ = std::make_unique<RectifiedSource>(
          std::move(instance), checked_.config.rectification, checked_.config.images);
      source_->judgeBy(*findings_);
      source_->setTruth(truePath(stage));
      break;
    case Role::Odometry:
      odometry_ = std::make_unique<host::OdometryStage>(std::move(instance));
      checked_odometry_ = std::make_unique<CheckedOdometry>(*odometry_, checked_.config.checks);
      break;
    case Role::Place:
      place_ = std::make_unique<host::PlaceStage>(std::move(instance));
      break;
    case Role::Cells:
      cells_ = std::make_unique<host::CellsStage>(std::move(instance));
      break;
    case Role::Map:
      map_ = std::make_unique<host::MapStage>(std::move(instance));
      break;
    case Role::Observer:
      observers_.push_back({host::ObserverStage(std::move(instance)), stage.on_failure});
      break;
  }
}

TruePath Assembly::truePath(const config::StageConfig& source) {
  config::EvaluationSettings settings = checked_.config.evaluation;
  // A replayed run has the truth of its camera already.
  if (source.plugin == "record" && settings.truth.empty()) settings = {};
  const auto& values = checked_.values.find(source.instance)->second;
  const auto found = values.find("path");
  const auto* folder = found == values.end() ? nullptr : std::get_if<std::string>(&found->second);
  Result<TruePath> path = TruePath::open(settings, folder == nullptr ? "" : *folder);
  const bool is_given = path.status().code() == StatusCode::InvalidParameter;  // the body
  if (path.isOk() || is_given || !settings.truth.empty()) {
    require(path.status(), is_given ? FailureKind::Configuration : FailureKind::Dataset);
    return std::move(path).value();
  }
  findings_->add("evaluation",
                 {Finding::Severity::Error, "truth", path.status().message(),
                  "correct the true poses, or remove the file", Finding::Kind::Damaged});
  return {};
}

void Assembly::openArtefacts(const std::filesystem::path& run_directory) {
  for (const auto& services : services_) {
    services->artefacts.folder =
        std::make_unique<record::ArtefactFolder>(run_directory, services->instance);
  }
  for (const auto& remote : checked_.remotes) {
    // If the process has ended, the next call reports the failure.
    if (remote) (void)host::openArtefacts(*remote, run_directory.string());
  }
}

std::vector<Status> Assembly::teardown() {
  std::vector<Status> failures;
  // clang 14 cannot compile views::reverse of this library.
  for (auto instance = instances_.rbegin(); instance != instances_.rend(); ++instance) {
    Status status = (*instance)->destroy();
    if (!status.isOk()) failures.push_back(std::move(status));
  }
  return failures;
}

Status Assembly::describeArrays(std::vector<ArrayInfo>& arrays) {
  const Status status = source_->instance().describe(arrays);
  return status.isOk() && cells_ ? cells_->instance().describe(arrays) : status;
}

Policies Assembly::policies() const {
  Policies policies{};
  for (const config::StageConfig& stage : checked_.config.stages) {
    policies.at(static_cast<std::size_t>(stage.role)) = stage.on_failure;
  }
  return policies;
}

}  // namespace tolman::engine
