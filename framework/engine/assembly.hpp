// SPDX-License-Identifier: BSD-3-Clause
// The stages of a run: plugin objects behind their guards, created and configured from a checked
// system.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/chain.hpp"
#include "engine/checked_odometry.hpp"
#include "engine/checked_system.hpp"
#include "engine/findings.hpp"
#include "engine/services.hpp"
#include "host/instance.hpp"
#include "host/stages.hpp"

namespace tolman::engine {

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
