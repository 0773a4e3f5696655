// SPDX-License-Identifier: BSD-3-Clause
// Scores of the units of a population, each beside what chance gives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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
/// None for no errors.
std::optional<ErrorFigures> errorFigures(std::vector<double> errors);

/// One score of all units of a population, against the same score of units whose activity is
/// shifted in time.
struct UnitScore {
  double median = 0;           ///< of the units
  double chance = 0;           ///< 95th percentile of the shifted units; 5th where less is better
  double shuffled_median = 0;  ///< of the shifted units
  double share_above = 0;      ///< of the units that are better than chance
};
enum class Better { More, Less };
/// None where no unit, or no shifted unit, has the score.
std::optional<UnitScore> againstChance(std::vector<double> units, std::vector<double> shuffled,
                                       Better better = Better::More);

/// A walk, and the activity of some units of a population along it: the same moments for all.
struct RecordedUnits {
  std::vector<Sample> walk;               ///< without rates
  std::vector<std::vector<float>> rates;  ///< one row a unit, as long as the walk
};

/// Circular shifts in time pair each place with the activity of another moment: what a unit scores
/// then is chance (Boccara et al. 2010; Langston et al. 2010).
struct Shuffling {
  std::size_t count = 200;        ///< shifted units, evenly of all units
  std::size_t least_samples = 1;  ///< shortest shift, forwards and backwards
  std::uint64_t seed = 1;
};

struct RingScores {
  std::optional<UnitScore> mean_vector_length;
  std::optional<UnitScore> half_width_deg;  ///< narrower is better
  std::optional<UnitScore> information_bits;
};
RingScores scoreRing(const RecordedUnits& units, const Shuffling& shuffling);

struct SheetScores {
  std::optional<UnitScore> square;
  std::optional<UnitScore> sargolini;
  std::optional<UnitScore> langston;
  std::optional<UnitScore> information_bits;
};
/// `period`, m: of the units; 0 if not known. It sets the bins of the rate maps.
SheetScores scoreSheet(const RecordedUnits& units, double period, const Shuffling& shuffling);

}  // namespace tolman::evaluation
