// SPDX-License-Identifier: BSD-3-Clause
// Scores of the units of a population, each with the score that chance gives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "evaluation/firing_rate.hpp"
#include "tolman/context.hpp"

namespace tolman::evaluation {

/// Median and 90th percentile of errors.
struct ErrorFigures {
  std::size_t count = 0;
  double median = 0;
  double p90 = 0;
};
/// None if there are no errors.
std::optional<ErrorFigures> errorFigures(std::vector<double> errors);

/// One score of all units of a population, against the same score of units whose activity is
/// shifted in time.
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
};

/// The firing rate map of a unit for figures, of at most 70 bins a side. Bins are at least 1.5
/// times as wide as the mean step of the walk; in narrower ones each visit would be a field of its
/// own.
RateMap firingMap(const RecordedUnits& units, std::size_t unit);
/// The rate map for grid scores, of at most 40 bins a side: a field, half a period wide, spans at
/// most four bins. `period`: of the units, m; 0: not known.
RateMap scoredMap(const RecordedUnits& units, std::size_t unit, double period);

/// Circular shifts in time pair each place with the activity of another time, which gives the score
/// by chance (Boccara et al. 2010; Langston et al. 2010).
struct Shuffling {
  std::size_t count = 200;        ///< number of shifted units, taken evenly from all units
  std::size_t least_samples = 1;  ///< shortest shift forwards and backwards, samples
  std::uint64_t seed = 1;
};

struct RingUnit {
  TuningCurve tuning;
  double information_bits = 0;
};
struct RingScores {
  std::optional<UnitScore> mean_vector_length, half_width_deg, information_bits;
  std::vector<RingUnit> units;
};
RingScores scoreRing(const RecordedUnits& units, const Shuffling& shuffling);

struct SheetUnit {
  std::optional<GridScores> scores;
  double information_bits = 0;
  std::size_t fields = 0;  ///< of the firingMap()
};
struct SheetScores {
  std::optional<UnitScore> square, sargolini, langston, information_bits;
  std::vector<SheetUnit> units;
};
/// The regular lattice that the units fit best, by the medians of the scores.
struct LatticeScore {
  std::string_view name;  ///< "square grid", "hexagonal grid"
  std::optional<UnitScore> score;
  double GridScores::*of_unit = &GridScores::square;  ///< the same score of one unit
};
LatticeScore bestLattice(const SheetScores& scores);

/// `period`, m: of the units; 0 if not known. It sets the bins of the rate maps.
SheetScores scoreSheet(const RecordedUnits& units, double period, const Shuffling& shuffling);

}  // namespace tolman::evaluation
