// SPDX-License-Identifier: BSD-3-Clause
// From a configuration file to a system whose plugins are loaded and whose every value is checked
// against their declarations. No plugin object exists yet; Assembly makes them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "config/resolved.hpp"
#include "config/system_config.hpp"
#include "host/catalogue.hpp"
#include "host/library.hpp"
#include "isolation/remote_plugin.hpp"
#include "run/failure.hpp"

namespace tolman::run {

/// What a caller chooses; the rest stands in the configuration.
struct SystemOptions {
  std::string config;                       ///< YAML file
  std::vector<std::string> overrides{};     ///< "a.b=c", as by --set
  std::vector<std::string> plugin_paths{};  ///< folders or libraries to search first for plugins
  std::vector<std::string> observers{};     ///< ids of plugins that observe, too
  bool quiet = false;  ///< set the parameter `quiet` of the observers that declare it
  /// Open every plugin in a process of its own: a library that crashes or hangs when it is opened
  /// is then a refusal.
  bool apart = false;
  /// Program and arguments that become the process of a stage with `isolation: process`. A program
  /// without the command `run-stage` names the installed `tolman` here.
  std::vector<std::string> stage_program{"/proc/self/exe", "run-stage"};
};

/// Manifests along the search path: `plugin_paths`, TOLMAN_PLUGIN_PATH, then the build or install
/// tree of this program.
host::Catalogue openCatalogue(const std::vector<std::string>& plugin_paths);

/// Finds, gates and opens one plugin. Throws Failed.
host::LoadedPlugin loadFrom(const host::Catalogue& catalogue, const std::string& id, Role role);

/// The manifest of the plugin of a stage, or of the program that it runs. Throws Failed.
host::Manifest manifestOf(const host::Catalogue& catalogue, const config::StageConfig& stage,
                          const config::SystemConfig& config);
/// Opens it for its parameters and files; a program in a process that ends again. Throws Failed.
host::LoadedPlugin describeFrom(const host::Manifest& manifest, Role role,
                                const config::SystemConfig& config);

struct CheckedSystem {
  config::SystemConfig config;
  config::StageValues values;
  std::vector<host::LoadedPlugin> plugins;  ///< parallel to config.stages; without descriptor
                                            ///< where there is a remote
  std::vector<std::shared_ptr<isolation::RemotePlugin>> remotes;  ///< parallel; null in the host
};

/// Which stages of a configuration are checked and loaded.
enum class Scope : std::uint8_t {
  All,
  WithoutObservers,
  SourceAndOdometry,
  SourceAndPlace,
  Source
};

/// The failure lists all problems of files, values and plugins at once.
std::variant<CheckedSystem, Failure> checkSystem(const SystemOptions& options,
                                                 Scope scope = Scope::All);

/// Whether the configuration has any of odometry, place, cells and map. False for a file that
/// cannot be read: checkSystem() reports why.
bool hasChain(const SystemOptions& options);

}  // namespace tolman::run
