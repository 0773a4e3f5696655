// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/unit_scores.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace tolman::evaluation {
namespace {

using Value = std::optional<double>;

constexpr int kTuningBins = 36;
/// Bins of a rate map per period: a grid field, half a period wide, spans four bins. kMaxBins
/// bounds the time of an autocorrelogram, which grows with the square of the number of visited
/// bins.
constexpr double kBinsOfPeriod = 8;
constexpr double kMaxBins = 40;
constexpr double kMaxDrawnBins = 70;

/// Interpolates linearly between neighbours.
double percentile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return std::lerp(sorted[low], sorted[high], place - static_cast<double>(low));
}

std::vector<Sample> samplesOf(const RecordedUnits& units, std::size_t unit, std::size_t later) {
  std::vector<Sample> samples = units.walk;
  const std::vector<float>& rates = units.rates[unit];
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].rate = static_cast<double>(rates[(i + later) % rates.size()]);
  }
  return samples;
}

template <class Unit>
struct Measured {
  std::vector<Unit> units;
  std::vector<Unit> shuffled;  ///< units shifted in time
};

/// Calls measure(samples) for all units, and for some units shifted in time.
template <class Measure>
auto measureAll(const RecordedUnits& units, const Shuffling& shuffling, Measure&& measure) {
  Measured<std::invoke_result_t<Measure, const std::vector<Sample>&>> measured;
  const std::size_t count = units.rates.size();
  for (std::size_t unit = 0; unit < count; ++unit) {
    measured.units.push_back(measure(samplesOf(units, unit, 0)));
  }
  const std::size_t length = units.walk.size();
  const std::size_t least = std::max<std::size_t>(shuffling.least_samples, 1);
  if (count == 0 || length < 2 * least) return measured;
  RandomStream random(shuffling.seed);
  for (std::size_t i = 0; i < shuffling.count; ++i) {
    const std::size_t later = least + random.below(length - 2 * least + 1);
    measured.shuffled.push_back(measure(samplesOf(units, i * count / shuffling.count, later)));
  }
  return measured;
}

/// value(unit) returns the score of a unit, or none.
template <class Unit, class ValueOf>
std::optional<UnitScore> scoreOf(const Measured<Unit>& measured, ValueOf&& value,
                                 Better better = Better::More) {
  const auto known = [&](const std::vector<Unit>& units) {
    std::vector<double> values;
    for (const Unit& unit : units) {
      if (const Value score = value(unit)) values.push_back(*score);
    }
    return values;
  };
  return againstChance(known(measured.units), known(measured.shuffled), better);
}

/// Number of bins on the long side of a rate map. Bins are wider than the steps of the walk.
int binsFor(const std::vector<Sample>& walk, double least_bin, double most_bins) {
  Eigen::AlignedBox2d box;
  double length = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    box.extend(walk[i].position);
    if (i > 0) length += (walk[i].position - walk[i - 1].position).norm();
  }
  if (walk.size() < 2 || !(length > 0)) return 1;
  const double step = length / static_cast<double>(walk.size() - 1);
  const double bin = std::max(1.5 * step, least_bin);
  return static_cast<int>(std::clamp(box.sizes().maxCoeff() / bin, 1.0, most_bins));
}

int scoredBins(const std::vector<Sample>& walk, double period) {
  return binsFor(walk, period / kBinsOfPeriod, kMaxBins);
}

}  // namespace

RateMap firingMap(const RecordedUnits& units, std::size_t unit) {
  return rateMap(samplesOf(units, unit, 0), binsFor(units.walk, 0, kMaxDrawnBins));
}

RateMap scoredMap(const RecordedUnits& units, std::size_t unit, double period) {
  return rateMap(samplesOf(units, unit, 0), scoredBins(units.walk, period));
}

std::optional<ErrorFigures> errorFigures(std::vector<double> errors) {
  if (errors.empty()) return std::nullopt;
  std::ranges::sort(errors);
  return ErrorFigures{errors.size(), percentile(errors, 0.5), percentile(errors, 0.9)};
}

std::optional<UnitScore> againstChance(std::vector<double> units, std::vector<double> shuffled,
                                       Better better) {
  if (units.empty() || shuffled.empty()) return std::nullopt;
  std::ranges::sort(units);
  std::ranges::sort(shuffled);
  UnitScore score{percentile(units, 0.5), 0, percentile(shuffled, 0.5), 0};
  score.chance = percentile(shuffled, better == Better::More ? 0.95 : 0.05);
  const auto better_units = std::ranges::count_if(units, [&](double value) {
    return better == Better::More ? value > score.chance : value < score.chance;
  });
  score.share_better = static_cast<double>(better_units) / static_cast<double>(units.size());
  return score;
}

RingScores scoreRing(const RecordedUnits& units, const Shuffling& shuffling) {
  const int bins = binsFor(units.walk, 0, kMaxDrawnBins);
  auto measured = measureAll(units, shuffling, [&](const std::vector<Sample>& samples) {
    return RingUnit{tuningCurve(samples, kTuningBins), spatialInformation(rateMap(samples, bins))};
  });
  const auto length = [](const RingUnit& unit) {  // none if there are too few headings
    return unit.tuning.half_width ? Value(unit.tuning.mean_vector_length) : Value();
  };
  const auto width = [](const RingUnit& unit) {
    return unit.tuning.half_width ? Value(*unit.tuning.half_width * kDegrees) : Value();
  };
  const auto bits = [](const RingUnit& unit) { return Value(unit.information_bits); };
  return {scoreOf(measured, length), scoreOf(measured, width, Better::Less),
          scoreOf(measured, bits), std::move(measured.units)};
}

LatticeScore bestLattice(const SheetScores& scores) {
  const bool hexagonal =
      scores.sargolini && (!scores.square || scores.sargolini->median > scores.square->median);
  if (hexagonal) return {"hexagonal grid", scores.sargolini, &GridScores::sargolini};
  return {"square grid", scores.square, &GridScores::square};
}

SheetScores scoreSheet(const RecordedUnits& units, double period, const Shuffling& shuffling) {
  const int bins = scoredBins(units.walk, period);
  auto measured = measureAll(units, shuffling, [&](const std::vector<Sample>& samples) {
    const RateMap map = rateMap(samples, bins);
    return SheetUnit{gridScores(map), spatialInformation(map), 0};
  });
  for (std::size_t i = 0; i < units.rates.size(); ++i) {
    measured.units[i].fields = fields(firingMap(units, i)).size();
  }
  const auto score = [&](double GridScores::*member) {
    return scoreOf(measured, [=](const SheetUnit& unit) {
      return unit.scores ? Value((*unit.scores).*member) : Value();
    });
  };
  const auto bits = [](const SheetUnit& unit) { return Value(unit.information_bits); };
  return {score(&GridScores::square), score(&GridScores::sargolini), score(&GridScores::langston),
          scoreOf(measured, bits), std::move(measured.units)};
}

}  // namespace tolman::evaluation
