// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/recorded_cells.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "evaluation/errors.hpp"
#include "evaluation/firing_rate.hpp"
#include "tolman/geometry.hpp"

namespace tolman::evaluation {

namespace {

using Value = std::optional<double>;

constexpr int kTuningBins = 36;
/// Bins of a rate map per period: a grid field, half a period wide, spans four bins. The time of an
/// autocorrelogram grows with the square of the number of visited bins.
constexpr double kBinsOfPeriod = 8;
constexpr double kMaxBins = 40;
constexpr double kMaxDrawnBins = 70;
constexpr double kSmoothing = 1;  // bins, of the maps that lattices and borders are measured on

std::vector<Sample> samplesOf(const RecordedUnits& units, std::size_t unit, std::size_t later) {
  std::vector<Sample> samples = units.walk;
  const std::vector<float>& rates = units.rates[unit];
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].rate = static_cast<double>(rates[(i + later) % rates.size()]);
  }
  return samples;
}

/// Measures all units, and some of them shifted in time. measure(samples) gives a MeasuredUnit.
template <class Measure>
PopulationScores scored(const RecordedUnits& units, const Shuffling& shuffling,
                        std::span<const ScoreKind> kinds, Measure&& measure) {
  PopulationScores result{kinds, {}, {}};
  std::vector<MeasuredUnit> shuffled;
  const std::size_t count = units.rates.size();
  for (std::size_t unit = 0; unit < count; ++unit) {
    result.units.push_back(measure(samplesOf(units, unit, 0)));
  }
  const std::size_t length = units.walk.size();
  const std::size_t least = std::max<std::size_t>(shuffling.least_samples, 1);
  RandomStream random(shuffling.seed);
  for (std::size_t i = 0; count > 0 && length >= 2 * least && i < shuffling.count; ++i) {
    const std::size_t later = least + random.below(length - 2 * least + 1);
    shuffled.push_back(measure(samplesOf(units, i * count / shuffling.count, later)));
  }
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const auto known = [&](const std::vector<MeasuredUnit>& of) {
      std::vector<double> values;
      for (const MeasuredUnit& unit : of) {
        if (unit.scores[kind]) values.push_back(*unit.scores[kind]);
      }
      return values;
    };
    result.scores.push_back(
        againstChance(known(result.units), known(shuffled), kinds[kind].better));
  }
  return result;
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
  return smoothed(rateMap(samplesOf(units, unit, 0), scoredBins(units.walk, period)), kSmoothing);
}

std::optional<UnitScore> againstChance(std::vector<double> units, std::vector<double> shuffled,
                                       Better better) {
  if (units.empty() || shuffled.empty()) return std::nullopt;
  std::ranges::sort(units);
  std::ranges::sort(shuffled);
  UnitScore score{quantile(units, 0.5), 0, quantile(shuffled, 0.5), 0};
  score.chance = quantile(shuffled, better == Better::More ? 0.95 : 0.05);
  const auto better_units = std::ranges::count_if(units, [&](double value) {
    return better == Better::More ? value > score.chance : value < score.chance;
  });
  score.share_better = static_cast<double>(better_units) / static_cast<double>(units.size());
  return score;
}

std::size_t PopulationScores::indexOf(std::string_view key) const {
  return static_cast<std::size_t>(std::ranges::find(kinds, key, &ScoreKind::key) - kinds.begin());
}

PopulationScores scoreRing(const RecordedUnits& units, const Shuffling& shuffling) {
  const int bins = binsFor(units.walk, 0, kMaxDrawnBins);
  return scored(units, shuffling, kRingScores, [&](const std::vector<Sample>& samples) {
    MeasuredUnit unit{{}, tuningCurve(samples, kTuningBins)};
    const auto& width = unit.tuning.half_width;  // none if there are too few headings
    unit.scores = {width ? Value(unit.tuning.mean_vector_length) : Value(),
                   width ? Value(*width * kDegrees) : Value(),
                   spatialInformation(rateMap(samples, bins)), speedScore(samples)};
    return unit;
  });
}

PopulationScores scoreSheet(const RecordedUnits& units, double period, const Shuffling& shuffling) {
  const int bins = scoredBins(units.walk, period);
  PopulationScores sheet =
      scored(units, shuffling, kSheetScores, [&](const std::vector<Sample>& samples) {
        const RateMap map = rateMap(samples, bins);
        const RateMap smooth = smoothed(map, kSmoothing);
        const auto grid = gridScores(smooth);
        const auto of = [&](double GridScores::*score, double factor = 1) {
          return grid && !std::isnan((*grid).*score) ? Value(factor * (*grid).*score) : Value();
        };
        return MeasuredUnit{{of(&GridScores::square), of(&GridScores::sargolini),
                             of(&GridScores::langston), spatialInformation(map),
                             of(&GridScores::spacing), of(&GridScores::orientation, kDegrees),
                             of(&GridScores::ellipticity), sparsity(map), coherence(map),
                             borderScore(smooth), speedScore(samples)}};
      });
  for (std::size_t i = 0; i < units.rates.size(); ++i) {
    sheet.units[i].fields = fields(firingMap(units, i)).size();
  }
  sheet.bin = rateMap(units.walk, bins).bin;
  sheet.smoothing = kSmoothing * sheet.bin;
  return sheet;
}

Lattice bestLattice(const PopulationScores& sheet) {
  const std::size_t square = sheet.indexOf("grid_score_square");
  const std::size_t hexagonal = sheet.indexOf("grid_score_sargolini");
  const auto median = [&](std::size_t i) {
    return sheet.scores[i] ? sheet.scores[i]->median : -HUGE_VAL;
  };
  if (median(hexagonal) > median(square)) return {"hexagonal grid", hexagonal};
  return {"square grid", square};
}

namespace {

/// A population vector shorter than this share of all activity is a rounding error.
constexpr double kMinLength = 1e-6;

}  // namespace

std::size_t unitsAlong(const ArrayAxis& axis) {
  return axis.step > 0 ? static_cast<std::size_t>(std::lround(axis.period / axis.step)) : 0;
}

std::optional<double> populationVector(std::span<const double> rates, const ArrayAxis& axis) {
  std::complex<double> sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const double value = axis.first + axis.step * static_cast<double>(i);
    sum += std::polar(1.0, kRadiansOfTurn * value / axis.period) * rates[i];
    total += std::abs(rates[i]);
  }
  if (!(std::abs(sum) > kMinLength * total)) return std::nullopt;
  return wrapPeriod(std::arg(sum) / kRadiansOfTurn * axis.period, axis.period);
}

namespace {

constexpr double kFarthest = 1e7;             // m
constexpr std::size_t kMinFrames = 240;       // of a population, however large
constexpr std::size_t kMaxFrames = 5000;      // of a population; beyond it every second is dropped
constexpr std::size_t kMaxValues = 10000000;  // of a population, all frames together
constexpr std::size_t kMaxRingUnits = 72;

/// At most `most` indices below `count`, evenly spaced.
std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t size = std::min(count, most);
  for (std::size_t i = 0; i < size; ++i) chosen.push_back((2 * i + 1) * count / (2 * size));
  return chosen;
}

template <class T>
void dropEverySecond(std::vector<T>& list) {
  for (std::size_t i = 2; i < list.size(); i += 2) list[i / 2] = std::move(list[i]);
  list.resize((list.size() + 1) / 2);
}

bool isPopulation(const ArrayInfo& info) {
  const auto periodic = [](const ArrayAxis& axis) {
    return axis.period > 0 && unitsAlong(axis) > 2;
  };
  return info.kind == ArrayKind::Activity && std::ranges::all_of(info.axes, periodic);
}

bool isAngle(const ArrayAxis& axis) {
  const double turn = axis.unit == "deg" ? 360 : 2 * std::numbers::pi;
  return (axis.unit == "deg" || axis.unit == "rad") && std::abs(axis.period - turn) < 1e-6 * turn;
}

}  // namespace

StampedPoses stampedPosesOf(const Trajectory& trajectory) {
  StampedPoses poses;
  for (const auto& pose : trajectory) {
    if (!(pose.T_world_camera.translation().cwiseAbs().maxCoeff() < kFarthest)) continue;
    poses[pose.frame] = {toPlanar(pose.T_world_camera), pose.stamp_ns};
  }
  return poses;
}

void PopulationHistory::add(std::int64_t frame, NamedArray&& array) {
  if (array.values.empty() || array.shape != shape || seen++ % stride != 0) return;
  const std::size_t most = std::clamp(kMaxValues / array.values.size(), kMinFrames, kMaxFrames);
  frames.push_back(frame);
  activity.push_back(std::move(array.values));
  if (frames.size() <= most) return;
  dropEverySecond(frames);
  dropEverySecond(activity);
  stride *= 2;
}

CellHistory::CellHistory(const std::vector<ArrayInfo>& infos) {
  for (const ArrayInfo& info : infos) {
    const bool ring = isPopulation(info) && info.axes.size() == 1 && isAngle(info.axes[0]);
    const bool sheet = isPopulation(info) && info.axes.size() == 2;
    if (!ring && !sheet) continue;
    PopulationHistory& history = (ring ? rings : sheets).emplace_back();
    history.info = info;
    for (const ArrayAxis& axis : info.axes) {
      history.shape.push_back(static_cast<int>(unitsAlong(axis)));
    }
  }
}

void CellHistory::add(std::int64_t frame, NamedArray&& array) {
  for (auto* list : {&rings, &sheets}) {
    const auto known = std::ranges::find(
        *list, array.name, [](const PopulationHistory& history) { return history.info.name; });
    if (known != list->end()) return known->add(frame, std::move(array));
  }
}

void CellHistory::dropEmpty() {
  for (auto* list : {&rings, &sheets}) {
    std::erase_if(*list, [](const PopulationHistory& history) { return history.frames.empty(); });
  }
}

std::vector<std::size_t> measuredUnits(const PopulationHistory& population) {
  const auto size = [&](std::size_t axis) {
    return static_cast<std::size_t>(population.shape[axis]);
  };
  if (population.shape.size() == 1) return evenly(size(0), kMaxRingUnits);
  std::vector<std::size_t> chosen;
  for (const std::size_t row : evenly(size(0), kMaxUnitsAlongAxis)) {
    for (const std::size_t column : evenly(size(1), kMaxUnitsAlongAxis)) {
      chosen.push_back(row * size(1) + column);
    }
  }
  return chosen;
}

void setTimes(RecordedUnits& units, const std::vector<std::int64_t>& stamps_ns, bool metric) {
  constexpr double kLongest = 5;       // median steps
  constexpr double kStanding = 0.025;  // m/s
  constexpr double kAnimal = 2;        // m/s
  std::vector<Sample>& walk = units.walk;
  const auto between = [&](std::size_t from, std::size_t to) {
    return 1e-9 * static_cast<double>(stamps_ns[to] - stamps_ns[from]);
  };
  std::vector<double> steps, speeds;
  for (std::size_t i = 1; i < walk.size(); ++i) steps.push_back(between(i - 1, i));
  if (steps.empty()) return;
  const double usual = statistics(steps).median;
  const auto isJoined = [&](std::size_t k) {  // with the sample behind it
    return k < steps.size() && steps[k] <= kLongest * usual;
  };
  for (std::size_t i = 0; i < walk.size(); ++i) {
    walk[i].seconds = isJoined(i) && steps[i] > 0 ? steps[i] : usual;
    const std::size_t before = i > 0 && isJoined(i - 1) ? i - 1 : i;
    const std::size_t after = isJoined(i) ? i + 1 : i;
    const double time = between(before, after);
    walk[i].speed = time > 0 ? (walk[after].position - walk[before].position).norm() / time : 0;
    speeds.push_back(walk[i].speed);
  }
  const auto high = std::ranges::next(speeds.begin(), std::ssize(speeds) * 95 / 100);
  std::ranges::nth_element(speeds, high);
  if (!metric || *high > kAnimal) return;
  units.speed_limit = kStanding;
  for (Sample& sample : walk) sample.seconds = sample.speed < kStanding ? 0 : sample.seconds;
}

RecordedUnits unitsAt(const PopulationHistory& population, const StampedPoses& poses,
                      const std::vector<std::size_t>& chosen, bool metric) {
  RecordedUnits units{{}, std::vector<std::vector<float>>(chosen.size())};
  std::vector<std::int64_t> stamps_ns;
  for (std::size_t i = 0; i < population.frames.size(); ++i) {
    const auto stamped = poses.find(population.frames[i]);
    if (stamped == poses.end()) continue;
    const auto& [pose, stamp_ns] = stamped->second;
    stamps_ns.push_back(stamp_ns);
    units.seconds = 1e-9 * static_cast<double>(stamp_ns - stamps_ns[0]);
    units.walk.push_back({{-pose.y, pose.x}, pose.theta, 0});
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      units.rates[k].push_back(population.activity[i][chosen[k]]);
    }
  }
  setTimes(units, stamps_ns, metric);
  return units;
}

double periodInMetres(const PopulationHistory& sheet) {
  const ArrayAxis& axis = sheet.info.axes[0];
  return axis.unit == "m" ? axis.period : 0;
}

double axisValue(const ArrayAxis& axis, std::size_t i) {
  const double value = axis.first + axis.step * static_cast<double>(i);
  return axis.period > 0 ? wrapPeriod(value, axis.period) : value;
}

double axisAngle(const ArrayAxis& axis, std::size_t i) {
  return axisValue(axis, i) * (axis.unit == "deg" ? std::numbers::pi / 180 : 1);
}

}  // namespace tolman::evaluation
