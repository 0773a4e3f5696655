// SPDX-License-Identifier: BSD-3-Clause
// From a configuration file to living, configured stages.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/exit_code.hpp"
#include "app/services.hpp"
#include "config/resolved.hpp"
#include "config/system_config.hpp"
#include "isolation/remote.hpp"
#include "plugins/catalogue.hpp"
#include "plugins/library.hpp"
#include "plugins/stages.hpp"

namespace tolman::app {

/// What the command line says of a system.
struct SystemOptions {
  std::string config;
  std::vector<std::string> overrides;     ///< "a.b=c"
  std::vector<std::string> plugin_paths;  ///< --plugin-path
  std::vector<std::string> observers{};   ///< plugins that watch beside the configured ones
};

plugins::Catalogue openCatalogue(const std::vector<std::string>& plugin_paths);

/// Finds, gates and opens one plugin.
plugins::OrRefusal<plugins::LoadedPlugin> loadFrom(const plugins::Catalogue& catalogue,
                                                   const std::string& id, Role role);

/// A configuration whose plugins are loaded and whose every value is checked.
struct CheckedSystem {
  config::SystemConfig config;
  config::StageValues values;
  std::vector<plugins::LoadedPlugin> plugins;  ///< parallel to config.stages; without descriptor
                                               ///< where there is a remote
  std::vector<std::shared_ptr<isolation::Remote>> remotes;  ///< parallel; null in the host
};

/// Which stages of a configuration a command is about; the others are neither checked nor loaded.
enum class Scope : std::uint8_t { All, WithoutObservers, SourceAndOdometry, Source };

/// All problems at once: those of files, values and plugins.
std::variant<CheckedSystem, Failure> checkSystem(const SystemOptions& options,
                                                 Scope scope = Scope::All);

/// Whether the configuration has any of odometry, place, cells and map. False for what cannot be
/// read: checkSystem() says why.
bool hasChain(const SystemOptions& options);

/// Who listens at the terminal.
struct Audience {
  bool interactive = false;
  bool quiet = false;
};

/// The stages of a run, alive and configured; those that are in the scope.
class Assembly {
 public:
  struct Observer {
    plugins::ObserverStage stage;
    config::FailurePolicy policy;
  };

  static std::variant<std::unique_ptr<Assembly>, Failure> create(CheckedSystem checked, RunLog& log,
                                                                 const Clock& clock,
                                                                 const Cancellation& cancellation,
                                                                 const Audience& audience);

  /// Checks and creates for a command that shows progress itself: the stages are silent.
  static std::variant<std::unique_ptr<Assembly>, Failure> open(const SystemOptions& options,
                                                               Scope scope, RunLog& log,
                                                               const Clock& clock,
                                                               const Cancellation& cancellation);

  /// From now on artefacts can be written.
  void openArtefacts(const std::filesystem::path& run_directory);
  /// Destroys all stages against the order of the flow; returns what their destructors threw.
  std::vector<Status> teardown();

  const CheckedSystem& system() const { return checked_; }
  config::FailurePolicy policy(Role role) const;
  plugins::SourceStage& source() { return *source_; }
  plugins::OdometryStage& odometry() { return *odometry_; }
  plugins::PlaceStage& place() { return *place_; }
  plugins::CellsStage& cells() { return *cells_; }
  plugins::MapStage& map() { return *map_; }
  std::vector<Observer>& observers() { return observers_; }

 private:
  /// What one stage's Context refers to.
  struct Services {
    Services(RunLog& run_log, const std::string& instance)
        : log(run_log, instance), artefacts(instance) {}
    StageLogger log;
    StageArtefacts artefacts;
  };

  explicit Assembly(CheckedSystem checked) : checked_(std::move(checked)) {}
  void place(std::unique_ptr<plugins::Instance> instance, const config::StageConfig& stage);
  std::vector<plugins::Instance*> instances();

  CheckedSystem checked_;
  std::vector<std::unique_ptr<Services>> services_;
  std::unique_ptr<plugins::SourceStage> source_;
  std::unique_ptr<plugins::OdometryStage> odometry_;
  std::unique_ptr<plugins::PlaceStage> place_;
  std::unique_ptr<plugins::CellsStage> cells_;
  std::unique_ptr<plugins::MapStage> map_;
  std::vector<Observer> observers_;
};

}  // namespace tolman::app
