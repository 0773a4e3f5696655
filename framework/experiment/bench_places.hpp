// SPDX-License-Identifier: BSD-3-Clause
// Measures place recognition: precision, recall, time and memory, over one drive that sees places
// again, or over two passes along the same path.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/loops.hpp"
#include "experiment/bench.hpp"
#include "experiment/place_truth.hpp"
#include "tolman/records.hpp"

namespace tolman::experiment {

/// Whether the observation says that the template was seen in the opposite direction.
bool isTurned(const PlaceObservation& seen);
/// The camera pose relative to the template by the observation: the measured one, or without one
/// the position of the template, turned by relative_yaw.
Eigen::Isometry3d claimedPose(const PlaceObservation& seen);

struct PlacesOptions {
  std::string second;                        ///< folder of the second pass; empty: one drive
  std::vector<std::string> query_overrides;  ///< of the second pass only
  std::string pairs;                         ///< file of true pairs, for one drive
  std::int64_t tolerance = 5;                ///< images, for two passes
  std::int64_t near = 20;                    ///< claims over at most this many images are ignored
  double metres_per_image = 1;               ///< for images without true poses
  std::int64_t frames = -1;                  ///< of each pass, at most; -1: all
  BenchProgress progress{[](std::int64_t) {}, [] {}, [] {}};
};

struct PlacesBench {
  std::string name;
  std::string plugin;
  std::int64_t images = 0;    ///< of all passes
  std::int64_t findable = 0;  ///< queries that have a true place
  std::int64_t templates = 0;
  std::vector<evaluation::PlaceClaim> claims;
  std::vector<evaluation::PrecisionRecall> curve;
  /// Claims of the opposite direction, which `claims` does not contain then; only for one drive
  /// with true poses.
  std::optional<OppositePlaces> opposite;
  double median_ms = 0;  ///< time of one call
  double p99_ms = 0;
  std::int64_t state_bytes = 0;  ///< of the saved state; 0: the plugin saves none
  bool interrupted = false;
};

/// The configuration needs a source and a place recogniser. Two passes need a recogniser that saves
/// its state: the second pass starts with the state of the first. Throws engine::Failure.
PlacesBench runPlacesBench(const engine::SystemOptions& system, const PlacesOptions& options,
                           engine::RunLog& log, const Cancellation& cancellation);

std::string placesBenchText(const PlacesBench& bench);
nlohmann::ordered_json placesBenchJson(const PlacesBench& bench);

}  // namespace tolman::experiment
