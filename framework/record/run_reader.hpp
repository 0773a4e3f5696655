// SPDX-License-Identifier: BSD-3-Clause
// Reads run.sqlite of a finished, a running or a killed run; never changes it.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/pose_files.hpp"
#include "record/session.hpp"
#include "record/store.hpp"

namespace tolman::record {

/// What a run has come to.
struct Counters {
  std::int64_t frames = 0;
  std::int64_t lost = 0;       ///< frames with tracking lost
  std::int64_t templates = 0;  ///< novel views
  std::int64_t experiences = 0;
  std::int64_t links = 0;
  std::int64_t loops = 0;
  std::int64_t first_stamp_ns = 0;
  std::int64_t last_stamp_ns = 0;
};

/// Sees the state at the time of opening, even while the run goes on; so trajectories and graph are
/// composed once and kept. Not for two threads at once. A damaged database gives a failure, never
/// wrong rows of the wrong shape.
class RunReader {
 public:
  static Result<std::unique_ptr<RunReader>> open(const std::filesystem::path& directory);

  /// All records of a kind, by frame or id, nested lists included.
  template <Record R>
  Result<std::vector<R>> records() const {
    return answered(name_, [&] {
      std::vector<R> rows;
      forEachRow<R>(database_, "", [&](const R& row) { rows.push_back(row); });
      return rows;
    });
  }
  /// The named arrays of a frame: source "sensors" or "cells".
  Result<std::vector<NamedArray>> arrays(std::int64_t frame, std::string_view source) const;

  /// The runs whose frames are here, in order; at least one where there are frames.
  Result<std::vector<Session>> sessions() const;
  /// One more than the last frame.
  Result<std::int64_t> nextFrame() const;
  /// The motions with their last revisions, composed; each session starts with the identity.
  const Result<std::vector<StampedPose>>& odometry() const;
  /// Each frame where the finished map has it; of a run that was killed before, on its experience,
  /// by the experiences as last known.
  const Result<std::vector<StampedPose>>& map() const;
  /// The true poses of the frames that have one.
  Result<std::vector<StampedPose>> truth() const;
  const Result<MapGraph>& graph() const;
  Result<Counters> counters() const;
  /// Whether the last motion was in metres; true where there is none.
  Result<bool> scaleKnown() const;
  Result<std::map<std::string, std::string>> meta() const;
  /// Durations by stage, ns.
  Result<std::map<std::string, std::vector<std::int64_t>>> timing() const;

  const std::filesystem::path& directory() const { return directory_; }
  const Database& database() const { return database_; }

 private:
  RunReader(std::filesystem::path directory, const std::filesystem::path& file);
  void checkVersion() const;
  template <class T, class Work>
  const Result<T>& once(std::optional<Result<T>>& kept, Work&& work) const {
    if (!kept) kept = answered(name_, work);
    return *kept;
  }

  std::filesystem::path directory_;
  std::string name_;  // of the file, for messages
  Database database_;
  mutable std::optional<Result<std::vector<StampedPose>>> odometry_;
  mutable std::optional<Result<std::vector<StampedPose>>> map_;
  mutable std::optional<Result<MapGraph>> graph_;
};

}  // namespace tolman::record
