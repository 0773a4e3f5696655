// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/unit_scores.hpp"

#include <algorithm>
#include <cmath>

#include "evaluation/grid_score.hpp"

namespace tolman::evaluation {
namespace {

constexpr int kTuningBins = 36;
/// Bins of a rate map: a grid field, half a period wide, spans four; and never more than the pairs
/// of bins of an autocorrelogram can be counted in a millisecond.
constexpr double kBinsOfPeriod = 8;
constexpr double kMostBins = 40;

/// Linear between the neighbours.
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

/// Calls measure(samples, shifted) for each unit, then for units shifted in time.
template <class Measure>
void measureAll(const RecordedUnits& units, const Shuffling& shuffling, Measure&& measure) {
  for (std::size_t unit = 0; unit < units.rates.size(); ++unit) {
    measure(samplesOf(units, unit, 0), false);
  }
  const std::size_t length = units.walk.size();
  const std::size_t least = std::max<std::size_t>(shuffling.least_samples, 1);
  if (units.rates.empty() || length < 2 * least) return;
  RandomStream random(shuffling.seed);
  for (std::size_t i = 0; i < shuffling.count; ++i) {
    const std::size_t later = least + random.below(length - 2 * least + 1);
    measure(samplesOf(units, i % units.rates.size(), later), true);
  }
}

/// Values of one score: of the units, and by chance.
struct Values {
  std::vector<double> units, shuffled;

  void add(double value, bool shifted) { (shifted ? shuffled : units).push_back(value); }
  std::optional<UnitScore> score(Better better = Better::More) {
    return againstChance(std::move(units), std::move(shuffled), better);
  }
};

/// Bins on the long side of a rate map. They are wider than the steps of the walk.
int binsFor(const std::vector<Sample>& walk, double period) {
  Eigen::AlignedBox2d box;
  double length = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    box.extend(walk[i].position);
    if (i > 0) length += (walk[i].position - walk[i - 1].position).norm();
  }
  if (walk.size() < 2 || !(length > 0)) return 1;
  const double step = length / static_cast<double>(walk.size() - 1);
  const double bin = std::max(1.5 * step, period / kBinsOfPeriod);
  return static_cast<int>(std::clamp(box.sizes().maxCoeff() / bin, 1.0, kMostBins));
}

}  // namespace

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
  const auto above = std::ranges::count_if(units, [&](double value) {
    return better == Better::More ? value > score.chance : value < score.chance;
  });
  score.share_above = static_cast<double>(above) / static_cast<double>(units.size());
  return score;
}

RingScores scoreRing(const RecordedUnits& units, const Shuffling& shuffling) {
  Values vectors;
  Values widths;
  Values bits;
  const int bins = binsFor(units.walk, 0);
  measureAll(units, shuffling, [&](const std::vector<Sample>& samples, bool shifted) {
    bits.add(spatialInformation(rateMap(samples, bins)), shifted);
    const TuningCurve curve = tuningCurve(samples, kTuningBins);
    if (!curve.half_width) return;  // too few headings
    vectors.add(curve.mean_vector_length, shifted);
    widths.add(*curve.half_width * kDegrees, shifted);
  });
  return {vectors.score(), widths.score(Better::Less), bits.score()};
}

SheetScores scoreSheet(const RecordedUnits& units, double period, const Shuffling& shuffling) {
  Values square;
  Values sargolini;
  Values langston;
  Values bits;
  const int bins = binsFor(units.walk, period);
  measureAll(units, shuffling, [&](const std::vector<Sample>& samples, bool shifted) {
    const RateMap map = rateMap(samples, bins);
    bits.add(spatialInformation(map), shifted);
    const auto scores = gridScores(map);
    if (!scores) return;
    square.add(scores->square, shifted);
    sargolini.add(scores->sargolini, shifted);
    langston.add(scores->langston, shifted);
  });
  return {square.score(), sargolini.score(), langston.score(), bits.score()};
}

}  // namespace tolman::evaluation
