// SPDX-License-Identifier: BSD-3-Clause
// Turns a configuration file into a system with loaded plugins and checked values, and
// creates their objects (Assembly).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "engine/chain.hpp"
#include "engine/checked_odometry.hpp"
#include "engine/failure.hpp"
#include "engine/services.hpp"
#include "host/instance.hpp"
#include "host/library.hpp"
#include "host/manifest.hpp"
#include "host/remote_plugin.hpp"
#include "host/stages.hpp"

namespace tolman::engine {

/// Choices of the caller; all others are in the configuration.
struct SystemOptions {
  std::string config;                       ///< YAML file
  std::vector<std::string> overrides{};     ///< "a.b=c", as by --set
  std::vector<std::string> plugin_paths{};  ///< folders or libraries to search first for plugins
  std::vector<std::string> observers{};     ///< ids of plugins that are added as observers
  bool quiet = false;  ///< set the parameter `quiet` of the observers that declare it
  /// Open every plugin in a process of its own, so that a library that crashes or hangs when it is
  /// opened becomes a refusal.
  bool apart = false;
  /// Program and arguments for the process of a stage with `isolation: process`. A program that
  /// does not have the command `run-stage` must give the installed `tolman` here.
  std::vector<std::string> stage_program{"/proc/self/exe", "run-stage"};
  config::FindShipped find_shipped{};  ///< for `extends`; empty: files only
};

/// Manifests along the search path: `plugin_paths`, TOLMAN_PLUGIN_PATH, then the build or install
/// tree of this program.
host::Catalogue openCatalogue(const std::vector<std::string>& plugin_paths);

/// Id of the observer that serves a page of the run, for `--view` and `tolman view`: the first one
/// by id whose manifest lists the extra `page` (class PageServer of the SDK). Throws Failure.
std::string findPageObserver(const host::Catalogue& catalogue);

/// Finds one plugin, checks the gate and opens it. Throws Failure.
host::LoadedPlugin loadFrom(const host::Catalogue& catalogue, const std::string& id, Role role);

/// The manifest of the plugin of a stage, or of the program that it runs. Throws Failure.
host::Manifest manifestOf(const host::Catalogue& catalogue, const config::StageConfig& stage,
                          const config::SystemConfig& config);
/// Opens a plugin to read its parameters and files; a program is opened in a temporary process.
/// Throws Failure.
host::LoadedPlugin describeFrom(const host::Manifest& manifest, Role role,
                                const config::SystemConfig& config);

struct CheckedSystem {
  std::vector<std::string> notes;  ///< of the configuration
  config::SystemConfig config;
  config::StageValues values;
  std::vector<host::LoadedPlugin> plugins;  ///< parallel to config.stages; without descriptor
                                            ///< where there is a remote
  std::vector<std::shared_ptr<host::RemotePlugin>> remotes;  ///< parallel; null in the host
};

/// Which stages of a configuration are checked and loaded.
enum class Scope : std::uint8_t {
  All,
  WithoutObservers,
  SourceAndOdometry,
  SourceAndPlace,
  SourceAndObservers,
  Source
};

/// Throws Failure, which lists all problems of files, values and plugins at once.
CheckedSystem checkSystem(const SystemOptions& options, Scope scope = Scope::All);

/// What the plugins of the stages declare, by the name of the stage; not of stages without a
/// plugin.
using StageSchemas = std::map<std::string, const Schema*, std::less<>>;

/// The files and folders that a configuration reads.
struct InputPaths {
  /// Those that parameters of the stages name, and the run that is continued; each once, in order.
  /// A text parameter that is the path of a file counts as well.
  std::vector<std::string> present;
  /// Those of the source, and the run to continue, that do not exist (yet). A run will fail.
  std::set<std::string> missing;
};
InputPaths inputPaths(const config::SystemConfig& config, const config::StageValues& values,
                      const StageSchemas& schemas);
InputPaths inputPaths(const CheckedSystem& system);

// The stages of a run: plugin objects behind their guards, created and configured from a checked
// system.

/// Constructs the object of stage `i`, here or in its process. Throws Failure.
std::unique_ptr<host::Instance> instantiate(const CheckedSystem& system, std::size_t i);

/// Holds the stages that are in the scope of the checked system.
class Assembly {
 public:
  struct RunningObserver {
    host::ObserverStage stage;
    config::FailurePolicy policy;
  };

  /// Throws Failure.
  Assembly(CheckedSystem checked, RunLog& log, const Clock& clock,
           const Cancellation& cancellation);

  /// From now on plugins can write artefacts into the run directory.
  void openArtefacts(const std::filesystem::path& run_directory);
  /// Destroys all stages in the reverse order of the flow; returns the exceptions of their
  /// destructors.
  std::vector<Status> teardown();

  const CheckedSystem& system() const { return checked_; }
  const SourceInfo& sourceInfo() const { return info_; }
  /// What the stages found; what configure() found is in the log already.
  Findings& findings() { return *findings_; }
  /// Appends descriptions of the source's sensors and of the arrays of the cells.
  Status describeArrays(std::vector<ArrayInfo>& arrays);
  /// The failure policies of odometry, place, cells and map.
  Policies policies() const;
  /// All stages from source to map, which must be in the scope.
  Stages stages() { return {*source_, *checked_odometry_, *place_, *cells_, *map_}; }
  CheckedOdometry& checkedOdometry() { return *checked_odometry_; }
  RectifiedSource& source() { return *source_; }
  const RectifiedSource& source() const { return *source_; }
  host::OdometryStage& odometry() { return *odometry_; }
  host::PlaceStage& place() { return *place_; }
  host::CellsStage& cells() { return *cells_; }
  host::MapStage& map() { return *map_; }
  std::vector<RunningObserver>& observers() { return observers_; }
  /// The instances of all stages, in the order of CheckedSystem::config.stages.
  const std::vector<host::Instance*>& instances() const { return instances_; }

 private:
  /// The services that the Context of one stage refers to.
  struct Services {
    std::string instance;
    StageLogger log;
    StageFindings findings;
    host::StageArtefacts artefacts;
  };

  void add(std::unique_ptr<host::Instance> instance, const config::StageConfig& stage);
  TruePath truePath(const config::StageConfig& source);

  CheckedSystem checked_;
  SourceInfo info_;
  std::unique_ptr<Findings> findings_;  ///< at a fixed address
  std::vector<std::unique_ptr<Services>> services_;
  std::vector<host::Instance*> instances_;
  std::unique_ptr<RectifiedSource> source_;
  std::unique_ptr<host::OdometryStage> odometry_;
  std::unique_ptr<CheckedOdometry> checked_odometry_;
  std::unique_ptr<host::PlaceStage> place_;
  std::unique_ptr<host::CellsStage> cells_;
  std::unique_ptr<host::MapStage> map_;
  std::vector<RunningObserver> observers_;
};

}  // namespace tolman::engine
