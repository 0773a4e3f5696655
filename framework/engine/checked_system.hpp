// SPDX-License-Identifier: BSD-3-Clause
// Turns a configuration file into a system with loaded plugins and checked values. No plugin object
// exists yet; Assembly creates them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "engine/failure.hpp"
#include "host/catalogue.hpp"
#include "host/library.hpp"
#include "host/remote_plugin.hpp"

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

/// Id of the observer that serves a page of the run, for `--view` and `tolman view`: `wanted`, or
/// when that is empty the first one by id whose manifest lists the extra `page` (class PageServer
/// of the SDK). Throws Failure.
std::string findPageObserver(const host::Catalogue& catalogue, const std::string& wanted = {});

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
  Source
};

/// Throws Failure, which lists all problems of files, values and plugins at once.
CheckedSystem checkSystem(const SystemOptions& options, Scope scope = Scope::All);

/// Whether the configuration has any of odometry, place, cells and map. False for a file that
/// cannot be read: checkSystem() reports why.
bool hasChain(const SystemOptions& options);

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

}  // namespace tolman::engine
