// SPDX-License-Identifier: BSD-3-Clause
// Scores of the units of a population, each with the score that chance gives.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "evaluation/firing_rate.hpp"
#include "evaluation/trajectory.hpp"
#include "tolman/context.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

/// One score of all units of a population, and of units whose activity is shifted in time.
struct UnitScore {
  double median = 0;           ///< of the units
  double chance = 0;           ///< 95th percentile of the shifted units; the 5th if less is better
  double shuffled_median = 0;  ///< of the shifted units
  double share_better = 0;     ///< share of the units that are better than chance
};
enum class Better { More, Less };
/// None where no unit, or no shifted unit, has the score.
std::optional<UnitScore> againstChance(std::vector<double> units, std::vector<double> shuffled,
                                       Better better = Better::More);

/// A walk, and the activity of some units of a population at the same times.
struct RecordedUnits {
  std::vector<Sample> walk;               ///< without rates
  std::vector<std::vector<float>> rates;  ///< one row per unit, as long as the walk
  double seconds = 0;                     ///< duration of the walk
  double speed_limit = 0;                 ///< m/s; slower samples do not count
};

/// The firing rate map of a unit for figures, of at most 70 bins a side. Bins are at least 1.5
/// times as wide as the mean step of the walk: in narrower ones each visit would be a field.
RateMap firingMap(const RecordedUnits& units, std::size_t unit);
/// The smoothed rate map for grid scores, of at most 40 bins a side: a field, half a period wide,
/// spans at most four bins. `period`: of the units, m; 0: not known.
RateMap scoredMap(const RecordedUnits& units, std::size_t unit, double period);

/// Circular shifts in time pair each place with the activity of another time, which gives the score
/// by chance (Boccara et al. 2010; Langston et al. 2010).
struct Shuffling {
  std::size_t count = 200;        ///< number of shifted units, taken evenly from all units
  std::size_t least_samples = 1;  ///< shortest shift forwards and backwards, samples
  std::uint64_t seed = 1;
};

/// A score of the units of a population; `key` is that of metrics.json and neurons.json.
struct ScoreKind {
  std::string_view key;
  Better better = Better::More;
};
inline constexpr std::array<ScoreKind, 4> kRingScores = {{{"mean_vector_length"},
                                                          {"half_width_deg", Better::Less},
                                                          {"spatial_information_bits"},
                                                          {"speed_score"}}};
inline constexpr std::array<ScoreKind, 11> kSheetScores = {{{"grid_score_square"},
                                                            {"grid_score_sargolini"},
                                                            {"grid_score_langston"},
                                                            {"spatial_information_bits"},
                                                            {"spacing_m"},
                                                            {"orientation_deg"},
                                                            {"ellipticity"},
                                                            {"sparsity", Better::Less},
                                                            {"coherence"},
                                                            {"border_score"},
                                                            {"speed_score"}}};

struct MeasuredUnit {
  std::vector<std::optional<double>> scores;  ///< one for each kind
  TuningCurve tuning{};                       ///< of a ring
  std::size_t fields = 0;                     ///< of a sheet, in the firingMap()
};
struct PopulationScores {
  std::span<const ScoreKind> kinds;
  std::vector<std::optional<UnitScore>> scores;  ///< one for each kind
  std::vector<MeasuredUnit> units;
  double bin = 0;        ///< m, of the rate maps of a sheet
  double smoothing = 0;  ///< m, Gaussian; for scores of lattice and border alone

  std::size_t indexOf(std::string_view key) const;
  const std::optional<UnitScore>& of(std::string_view key) const { return scores[indexOf(key)]; }
};
PopulationScores scoreRing(const RecordedUnits& units, const Shuffling& shuffling);
/// `period`, m: of the units; 0 if not known. It sets the bins of the rate maps.
PopulationScores scoreSheet(const RecordedUnits& units, double period, const Shuffling& shuffling);

/// The regular lattice that the units of a sheet fit best, by the medians of the scores.
struct Lattice {
  std::string_view name;  ///< "square grid", "hexagonal grid"
  std::size_t score = 0;  ///< index of its score
};
Lattice bestLattice(const PopulationScores& sheet);

// Decodes the heading from the rates of a ring.

/// Number of units along a periodic axis; 0 without a step.
std::size_t unitsAlong(const ArrayAxis& axis);

/// Direction of the population vector of units along one periodic axis (Georgopoulos, Schwartz,
/// Kettner 1986), in the unit of the axis, in [0, period). None if there is no activity, or the
/// same activity everywhere.
std::optional<double> populationVector(std::span<const double> rates, const ArrayAxis& axis);

// The recorded arrays of the spatial cells, sorted by their descriptions (ArrayInfo). Their size is
// bounded for runs of any length.

/// Planar pose of the camera at one frame.
struct StampedPose {
  PlanarPose pose;
  std::int64_t stamp_ns = 0;
};
using StampedPoses = std::unordered_map<std::int64_t, StampedPose>;
/// Poses with a coordinate of 10,000 km and more are left out.
StampedPoses stampedPosesOf(const Trajectory& trajectory);

/// One array at evenly spaced frames.
struct PopulationHistory {
  ArrayInfo info;
  std::vector<int> shape;
  std::vector<std::int64_t> frames;
  std::vector<std::vector<float>> activity;  ///< one row per frame, as large as the shape
  std::size_t stride = 1;                    ///< every stride-th array was kept
  std::size_t seen = 0;

  /// Keeps at most 5000 arrays, fewer of large ones, and none of another shape.
  void add(std::int64_t frame, NamedArray&& array);
};

struct CellHistory {
  std::vector<PopulationHistory> rings;   ///< head direction: activity over one axis of angles
  std::vector<PopulationHistory> sheets;  ///< grid modules: activity over two periodic axes

  CellHistory() = default;
  explicit CellHistory(const std::vector<ArrayInfo>& infos);
  /// The arrays of the cells, frame by frame; those that are no population are left out.
  void add(std::int64_t frame, NamedArray&& array);
  /// Removes arrays that were described but not recorded.
  void dropEmpty();
};

inline constexpr int kMaxUnitsAlongAxis = 32;
/// The units that are measured, evenly spaced: at most 72 of a ring, 32 by 32 of a sheet.
std::vector<std::size_t> measuredUnits(const PopulationHistory& population);

/// Sets speeds and durations of the samples at these times, ns. A gap of more than five median
/// steps counts as one. Of an animal, which is never faster than 2 m/s, standing (slower than 2.5
/// cm/s) does not count; of a vehicle it does. `metric`: positions are in m.
void setTimes(RecordedUnits& units, const std::vector<std::int64_t>& stamps_ns, bool metric);

/// The activity of the units `chosen` at the frames that have a pose. `metric`: these are in m.
RecordedUnits unitsAt(const PopulationHistory& population, const StampedPoses& poses,
                      const std::vector<std::size_t>& chosen, bool metric);

/// The period of a sheet, m; 0 if its unit is not m.
double periodInMetres(const PopulationHistory& sheet);

/// The value that index `i` of an axis stands for; in [0, period) for a periodic axis.
double axisValue(const ArrayAxis& axis, std::size_t i);
/// The same in radians, for an axis of angles in "deg" or "rad".
double axisAngle(const ArrayAxis& axis, std::size_t i);

}  // namespace tolman::evaluation
