// SPDX-License-Identifier: BSD-3-Clause
// Measures the time of every stage; and place recognition: precision, recall, time and memory, over
// one drive that sees places again, or over two passes along the same path. Which images show the
// same place is known by their numbers, a list of pairs, or the true poses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/checked_system.hpp"
#include "evaluation/loops.hpp"
#include "evaluation/trajectory.hpp"
#include "experiment/tables.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::experiment {

/// Begins a pass over `frames` frames of the source (-1: unknown), and returns what is to be called
/// after each of them, from any thread, and is destroyed at the end of the pass.
using BenchProgress = std::function<std::function<void()>(std::int64_t frames)>;

struct BenchOptions {
  std::int64_t frames = -1;  ///< measure at most this many; -1 for all
  BenchProgress progress = [](std::int64_t) { return [] {}; };
};

struct BenchTable {
  Table table;
  bool interrupted = false;
};

/// The time of each stage in lossless mode, and its ratio to that of the source. Nothing is
/// recorded and there are no observers. Throws engine::Failure.
BenchTable runBench(const engine::SystemOptions& system, const BenchOptions& options,
                    engine::RunLog& log, const Cancellation& cancellation);

// Place recognition.

struct PlaceTruth {
  /// Whether image `query` shows the place of `place`.
  std::function<bool(std::int64_t query, std::int64_t place)> isSame;
  /// Whether there is an image that `query` should be recognised in.
  std::function<bool(std::int64_t query)> isFindable;
  std::int64_t last_query = -1;  ///< the highest image number that a list names; -1 without a list
};

/// Image N of the second pass shows the place of the images N +- `tolerance` of the first pass.
PlaceTruth truthByNumber(std::int64_t images_of_first_pass, std::int64_t tolerance);

/// A CSV file with two columns, query and match, and an optional header `query,match`. Images at
/// most `near` apart do not make a query findable: claims of them do not count.
Result<PlaceTruth> truthOfPairs(const std::filesystem::path& file, std::int64_t near = 0);

/// Within 5 m, headings less than 45 degrees apart, more than 20 m of path in between.
/// `height_m`: as RevisitRule::height_m. `near`: as above.
PlaceTruth truthOfPoses(const evaluation::Trajectory& truth, double height_m = 0,
                        std::int64_t near = 0);

/// Claims that a place is passed in the opposite direction, right within 5 m.
struct OppositePlaces {
  std::int64_t findable = 0;  ///< images that pass a place in the opposite direction alone
  std::int64_t found = 0;     ///< those of `findable` at most 5 m of path after a right claim
  std::vector<evaluation::PlaceClaim> claims;

  std::int64_t right() const;
  /// Median error of the right claims; 0 without any.
  double medianError() const;
};

/// Of an image; null if it has no true pose. The frames of `truth` are the numbers of images.
const evaluation::TrajectoryPose* poseOf(const evaluation::Trajectory& truth, std::int64_t image);

/// Judges the claims. `truth` has a pose for each image of a claim; `height_m`: as
/// RevisitRule::height_m.
OppositePlaces judgeOpposite(const evaluation::Trajectory& truth,
                             std::vector<evaluation::PlaceClaim> claims, double height_m = 0);

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
  BenchProgress progress = [](std::int64_t) { return [] {}; };
};

struct PlacesBench {
  std::string name;
  std::string plugin;
  std::int64_t images = 0;    ///< of all passes
  std::int64_t findable = 0;  ///< queries that have a true place
  std::int64_t templates = 0;
  std::vector<evaluation::PlaceClaim> claims;
  std::vector<evaluation::PrecisionRecall> curve;
  /// Claims of the opposite direction, not in `claims`; only for one drive with true poses.
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

/// For readers a dozen points of the curve, for programs all of them and the claims.
Table tableOf(const PlacesBench& bench);

struct PlaceCurve {
  std::string name;
  std::vector<evaluation::PrecisionRecall> points;
};

/// The curve in a file with the output of `tolman bench places --json`.
Result<PlaceCurve> placeCurveOf(const std::filesystem::path& file);

/// Curves of a measurement and of earlier ones in one figure, as SVG.
std::string placeCurvesFigure(const std::vector<PlaceCurve>& curves);

}  // namespace tolman::experiment
