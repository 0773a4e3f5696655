// SPDX-License-Identifier: BSD-3-Clause
#include "app/assembly.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "config/loader.hpp"
#include "config/problem.hpp"
#include "isolation/remote_roles.hpp"

namespace tolman::app {
namespace {

/// Each instance has its own stream, whatever other plugins there are.
std::uint64_t seedOf(std::int64_t run_seed, const std::string& instance) {
  const auto start = static_cast<std::uint64_t>(run_seed) ^ 0xcbf29ce484222325ULL;
  return RandomStream(detail::fnv1a(start, instance)).bits();
}

/// A stage that cannot be configured: whose fault is it?
ExitCode configureFailure(Role role, const Status& status) {
  if (role == Role::Source && status.code() != StatusCode::InvalidParameter) {
    return ExitCode::Dataset;
  }
  const bool choice =
      status.code() == StatusCode::InvalidParameter || status.code() == StatusCode::Unsupported;
  return choice ? ExitCode::Configuration : ExitCode::Plugin;
}

constexpr std::array<std::string_view, 4> kChain = {"odometry", "place", "cells", "map"};

/// Leaves out what is beyond the scope, as if it had never been written.
void confine(config::Loaded& loaded, Scope scope, config::Problems& problems) {
  if (scope == Scope::All) return;
  loaded.tree.erase("observers");
  if (scope == Scope::WithoutObservers) return;
  std::vector<std::string_view> needed = {"source"};
  if (scope == Scope::SourceAndOdometry) needed.emplace_back("odometry");
  for (const std::string_view stage : kChain) {
    if (stage != needed.back()) loaded.tree.erase(stage);
  }
  for (const std::string_view stage : needed) {
    if (!loaded.complete || loaded.tree.find(stage) != nullptr) continue;
    problems.push_back({loaded.tree.origin, std::string(stage),
                        "the stage is missing; add '" + std::string(stage) +
                            ": {plugin: ...}' ('tolman plugins list' shows what there is)"});
  }
  loaded.complete = false;  // of the other stages nothing is to be said
}

/// Appends observers, each by its plugin's id, that the configuration does not name itself.
void addObservers(config::Loaded& loaded, const std::vector<std::string>& plugins) {
  for (const std::string& plugin : plugins) {
    config::Node* list = loaded.tree.find("observers");
    const config::Origin origin{config::Origin::Kind::CommandLine, "--view", 0, 0, {}};
    const auto child = [&](config::Node& parent, config::Node::Kind kind, const std::string& key) {
      config::Node node;
      node.kind = kind;
      node.key = key;
      node.key_origin = node.origin = origin;
      parent.children.push_back(node);
      return &parent.children.back();
    };
    if (list == nullptr) list = child(loaded.tree, config::Node::Kind::Sequence, "observers");
    if (list->kind == config::Node::Kind::Null) list->kind = config::Node::Kind::Sequence;
    if (!list->isSequence()) continue;  // a problem that parsing tells
    const bool named = std::ranges::any_of(list->children, [&](const config::Node& stage) {
      const config::Node* id = stage.find("plugin");
      return id != nullptr && id->text == plugin;
    });
    if (named) continue;
    config::Node* stage =
        child(*list, config::Node::Kind::Map, std::to_string(list->children.size()));
    child(*stage, config::Node::Kind::Scalar, "plugin")->text = plugin;
  }
}

struct Opened {
  plugins::LoadedPlugin plugin;
  std::shared_ptr<isolation::Remote> remote;
};

plugins::OrRefusal<Opened> openInProcess(const plugins::Catalogue& catalogue,
                                         const config::StageConfig& stage,
                                         const config::SystemConfig& config) {
  auto manifest = catalogue.find(stage.plugin, stage.role);
  if (auto* refusal = std::get_if<plugins::Refusal>(&manifest)) return *refusal;
  const isolation::Launch launch{{"/proc/self/exe", "run-stage"},
                                 config.isolation.deadline,
                                 static_cast<std::uint64_t>(config.isolation.memory_limit),
                                 config.general.threads};
  auto started = isolation::Remote::start(std::get<plugins::Manifest>(manifest), launch);
  if (auto* refusal = std::get_if<plugins::Refusal>(&started)) return *refusal;
  auto& remote = std::get<std::shared_ptr<isolation::Remote>>(started);
  return Opened{{remote->manifest(), nullptr, remote->schema()}, remote};
}

plugins::OrRefusal<Opened> open(const plugins::Catalogue& catalogue,
                                const config::StageConfig& stage,
                                const config::SystemConfig& config) {
  if (stage.isolation == config::Isolation::Process) return openInProcess(catalogue, stage, config);
  auto loaded = loadFrom(catalogue, stage.plugin, stage.role);
  if (auto* refusal = std::get_if<plugins::Refusal>(&loaded)) return *refusal;
  return Opened{std::move(std::get<plugins::LoadedPlugin>(loaded)), nullptr};
}

/// Only the plugin's object knows whether it saves its state.
void prepareRestart(const config::StageConfig& stage, isolation::Remote& remote,
                    config::Problems& problems) {
  const config::Origin origin = stage.given.find("on_failure")->origin;
  if (const auto refusal = remote.create()) {
    problems.push_back({origin, stage.path + ".plugin", refusal->text()});
  } else if (!remote.enableRestart()) {
    problems.push_back(
        {origin, stage.path + ".on_failure",
         "plugin '" + stage.plugin +
             "' cannot go on in a new process where an old one ended (a source never can; places, "
             "cells and maps must save their state); use 'skip' or 'stop'"});
  }
}

using MaybeInstance = std::variant<std::unique_ptr<plugins::Instance>, Failure>;

MaybeInstance instantiate(const CheckedSystem& system, std::size_t i) {
  const config::StageConfig& stage = system.config.stages[i];
  const auto& remote = system.remotes[i];
  auto created = remote ? isolation::instantiate(remote, stage.instance)
                        : plugins::Instance::create(system.plugins[i], stage.instance);
  if (auto* refusal = std::get_if<plugins::Refusal>(&created)) {
    return Failure{ExitCode::Plugin, refusal->text()};
  }
  return std::move(std::get<std::unique_ptr<plugins::Instance>>(created));
}

}  // namespace

plugins::Catalogue openCatalogue(const std::vector<std::string>& plugin_paths) {
  std::error_code ignored;
  const auto executable = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return plugins::Catalogue(
      plugins::searchPath(plugin_paths, std::getenv("TOLMAN_PLUGIN_PATH"), executable));
}

plugins::OrRefusal<plugins::LoadedPlugin> loadFrom(const plugins::Catalogue& catalogue,
                                                   const std::string& id, Role role) {
  auto manifest = catalogue.find(id, role);
  if (auto* refusal = std::get_if<plugins::Refusal>(&manifest)) return *refusal;
  return plugins::loadPlugin(std::get<plugins::Manifest>(manifest),
                             plugins::HostIdentity::ofThisBuild());
}

bool hasChain(const SystemOptions& options) {
  const config::Loaded loaded =
      config::load(options.config, options.overrides, config::processEnvironment());
  return std::any_of(kChain.begin(), kChain.end(),
                     [&](std::string_view stage) { return loaded.tree.find(stage) != nullptr; });
}

std::variant<CheckedSystem, Failure> checkSystem(const SystemOptions& options, Scope scope) {
  config::Loaded loaded =
      config::load(options.config, options.overrides, config::processEnvironment());
  config::Problems problems = loaded.problems;
  addObservers(loaded, options.observers);
  confine(loaded, scope, problems);
  CheckedSystem checked;
  checked.config = config::parse(loaded, problems);
  const plugins::Catalogue catalogue = openCatalogue(options.plugin_paths);
  bool refused = false;
  for (const config::StageConfig& stage : checked.config.stages) {
    if (stage.plugin.empty()) continue;  // already a problem
    auto found = open(catalogue, stage, checked.config);
    if (auto* refusal = std::get_if<plugins::Refusal>(&found)) {
      problems.push_back({stage.pluginOrigin(), stage.path + ".plugin", refusal->text()});
      refused = true;
      continue;
    }
    auto& opened = std::get<Opened>(found);
    checked.values[stage.instance] =
        config::check(stage, opened.plugin.schema, checked.config.places, problems);
    if (opened.remote && stage.on_failure == config::FailurePolicy::Restart) {
      prepareRestart(stage, *opened.remote, problems);
    }
    checked.plugins.push_back(std::move(opened.plugin));
    checked.remotes.push_back(std::move(opened.remote));
  }
  if (problems.empty()) return checked;
  const bool only_plugins = refused && std::all_of(problems.begin(), problems.end(), [](auto& p) {
                              return p.message.starts_with("[plugin/");
                            });
  return Failure{only_plugins ? ExitCode::Plugin : ExitCode::Configuration,
                 config::format(problems)};
}

std::variant<std::unique_ptr<Assembly>, Failure> Assembly::open(const SystemOptions& options,
                                                                Scope scope, RunLog& log,
                                                                const Clock& clock,
                                                                const Cancellation& cancellation) {
  auto checked = checkSystem(options, scope);
  if (auto* failure = std::get_if<Failure>(&checked)) return *failure;
  return create(std::move(std::get<CheckedSystem>(checked)), log, clock, cancellation,
                {false, true});
}

std::variant<std::unique_ptr<Assembly>, Failure> Assembly::create(CheckedSystem checked,
                                                                  RunLog& log, const Clock& clock,
                                                                  const Cancellation& cancellation,
                                                                  const Audience& audience) {
  std::unique_ptr<Assembly> assembly(new Assembly(std::move(checked)));
  const CheckedSystem& system = assembly->checked_;
  SourceInfo source;  // stages are in the order of the flow: the source is the first
  for (std::size_t i = 0; i < system.config.stages.size(); ++i) {
    const config::StageConfig& stage = system.config.stages[i];
    auto created = instantiate(system, i);
    if (auto* failure = std::get_if<Failure>(&created)) return *failure;
    auto instance = std::move(std::get<std::unique_ptr<plugins::Instance>>(created));
    auto services = std::make_unique<Services>(log, stage.instance);
    const Context context{system.values.find(stage.instance)->second,
                          services->log,
                          services->artefacts,
                          cancellation,
                          clock,
                          source.rig,
                          seedOf(system.config.general.seed, stage.instance),
                          stage.instance,
                          audience.interactive,
                          audience.quiet};
    assembly->services_.push_back(std::move(services));
    const Status status = instance->configure(context);
    if (!status.isOk()) return Failure{configureFailure(stage.role, status), status.message()};
    assembly->place(std::move(instance), stage);
    if (stage.role != Role::Source) continue;
    const Status informed = assembly->source().info(source);
    if (!informed.isOk()) return Failure{ExitCode::Dataset, informed.message()};
  }
  return assembly;
}

void Assembly::place(std::unique_ptr<plugins::Instance> instance,
                     const config::StageConfig& stage) {
  switch (stage.role) {
    case Role::Source:
      source_ = std::make_unique<plugins::SourceStage>(std::move(instance));
      break;
    case Role::Odometry:
      odometry_ = std::make_unique<plugins::OdometryStage>(std::move(instance));
      break;
    case Role::Place:
      place_ = std::make_unique<plugins::PlaceStage>(std::move(instance));
      break;
    case Role::Cells:
      cells_ = std::make_unique<plugins::CellsStage>(std::move(instance));
      break;
    case Role::Map:
      map_ = std::make_unique<plugins::MapStage>(std::move(instance));
      break;
    case Role::Observer:
      observers_.push_back({plugins::ObserverStage(std::move(instance)), stage.on_failure});
      break;
  }
}

void Assembly::openArtefacts(const std::filesystem::path& run_directory) {
  for (const auto& services : services_) services->artefacts.open(run_directory);
  for (const auto& remote : checked_.remotes) {
    // A process that died in between says so at its next call.
    if (remote) (void)isolation::openArtefacts(*remote, run_directory.string());
  }
}

std::vector<plugins::Instance*> Assembly::instances() {
  std::vector<plugins::Instance*> all;
  const auto add = [&](auto& stage) {
    if (stage) all.push_back(&stage->instance());
  };
  add(source_);
  add(odometry_);
  add(place_);
  add(cells_);
  add(map_);
  for (Observer& observer : observers_) all.push_back(&observer.stage.instance());
  return all;
}

std::vector<Status> Assembly::teardown() {
  std::vector<Status> failures;
  auto all = instances();
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    Status status = (*it)->destroy();
    if (!status.isOk()) failures.push_back(std::move(status));
  }
  return failures;
}

config::FailurePolicy Assembly::policy(Role role) const {
  const auto& stages = checked_.config.stages;
  const auto found = std::find_if(stages.begin(), stages.end(),
                                  [&](const config::StageConfig& s) { return s.role == role; });
  return found == stages.end() ? config::FailurePolicy::Stop : found->on_failure;
}

}  // namespace tolman::app
