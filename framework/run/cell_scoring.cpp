// SPDX-License-Identifier: BSD-3-Clause
#include "run/cell_scoring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "evaluation/population_code.hpp"
#include "run/sampled_population.hpp"

namespace tolman::run {
namespace {

using evaluation::CellFigures;
using evaluation::ModulePhase;
using evaluation::PositionDecoder;

constexpr std::size_t kShuffles = 200;
/// Shortest shift of a unit's activity (Boccara et al. 2010). A run shorter than ten times this is
/// shifted by at least a tenth.
constexpr double kLeastShift = 20;  // s
constexpr double kMargin = 0.1;     // of the extent, around the positions that a code may tell

Eigen::Vector2d positionOf(const StampedPose& at) { return {at.pose.x, at.pose.y}; }

/// A population with the errors of what it says.
struct ReadPopulation {
  explicit ReadPopulation(const ArrayInfo& info) : samples(info) {}
  SampledPopulation samples;
  std::vector<double> heading_errors;  ///< deg, of a ring
};

/// Takes the arrays of a run one by one.
class CellReading {
 public:
  CellReading(const std::vector<ArrayInfo>& infos, const report::RunData& data)
      : map_(stampedPosesOf(data.map)) {
    const auto& scores = data.metrics.map.scores;
    if (scores) {
      truth_ = stampedPosesOf(data.truth);
      scale_ = scores->scale;
    }
    for (const ArrayInfo& info : infos) {
      if (!SampledPopulation::accepts(info)) continue;
      populations_.emplace_back(info);
      if (populations_.back().samples.isRing()) continue;
      ++modules_;
      if (no_position_.empty()) no_position_ = evaluation::noPositionReason(info);
    }
    if (modules_ == 0) no_position_ = "no grid module was recorded";
  }

  bool empty() const { return populations_.empty(); }

  void take(const record::RecordedArray& row) {
    const auto population = std::ranges::find_if(
        populations_, [&](const ReadPopulation& p) { return p.samples.info().name == row.name; });
    if (population == populations_.end() || !map_.contains(row.frame)) return;
    const std::span<const float> rates(row.values.data(),
                                       static_cast<std::size_t>(row.values.size()));
    population->samples.add(row.frame, rates);
    if (truth_.empty()) return;
    population->samples.isRing() ? takeRing(row.frame, rates, *population)
                                 : takeSheet(row.frame, rates, population->samples.info());
  }

  CellFigures figures(const report::RunData& data, std::uint64_t seed) {
    CellFigures figures;
    figures.truth = !truth_.empty();
    if (!figures.truth) figures.reason = data.metrics.map.reason;
    figures.seed = seed;
    figures.shuffles = kShuffles;
    figures.position_m = evaluation::errorFigures(std::move(position_errors_));
    figures.position_reason = figures.truth ? no_position_ : figures.reason;
    if (modules_ == 1 && figures.position_m) figures.modulo_m = scale_ * period_;
    for (ReadPopulation& population : populations_) score(population, figures);
    return figures;
  }

 private:
  void takeRing(std::int64_t frame, std::span<const float> rates, ReadPopulation& ring) const {
    const auto at = truth_.find(frame);
    const ArrayAxis& axis = ring.samples.info().axes[0];
    const auto said = evaluation::populationVector(rates, axis);
    if (!said || at == truth_.end()) return;
    const double heading = *said * 2 * std::numbers::pi / axis.period;
    const double error = std::abs(wrapAngle(heading - at->second.pose.theta));
    ring.heading_errors.push_back(error * evaluation::kDegrees);
  }

  void takeSheet(std::int64_t frame, std::span<const float> rates, const ArrayInfo& info) {
    if (!no_position_.empty()) return;
    if (frame != frame_) phases_.clear();
    frame_ = frame;
    if (const auto phase = evaluation::modulePhase(rates, info)) phases_.push_back(*phase);
    if (phases_.size() != modules_) return;
    if (!decoder_) tieOrigin(positionOf(map_.at(frame)));
    const auto at = truth_.find(frame);
    if (at == truth_.end()) return;
    position_errors_.push_back(scale_ * decoder_->error(phases_, positionOf(at->second)));
  }

  /// The code's frame is that of the run: the map's pose at the first frame.
  void tieOrigin(const Eigen::Vector2d& position) {
    Eigen::AlignedBox2d box;
    for (const auto& [frame, at] : truth_) box.extend(positionOf(at));
    const Eigen::Vector2d margin =
        Eigen::Vector2d::Constant(kMargin * box.sizes().maxCoeff() + phases_[0].period / 2);
    decoder_.emplace(phases_, position, box.min() - margin, box.max() + margin);
    period_ = phases_[0].period;
  }

  void score(ReadPopulation& population, CellFigures& figures) const {
    const StampedPoses& poses = truth_.empty() ? map_ : truth_;
    const evaluation::RecordedUnits units = population.samples.units(poses);
    const double seconds = population.samples.seconds(poses);
    const double least = std::min(kLeastShift, seconds / 10);
    const double share = seconds > 0 ? least / seconds : 0.1;
    figures.least_shift_s = std::max(figures.least_shift_s, least);
    const evaluation::Shuffling shuffling{
        kShuffles,
        static_cast<std::size_t>(std::ceil(share * static_cast<double>(units.walk.size()))),
        figures.seed};
    const ArrayInfo& info = population.samples.info();
    if (population.samples.isRing()) {
      figures.rings.push_back({info.name, population.samples.size(),
                               evaluation::errorFigures(std::move(population.heading_errors)),
                               evaluation::scoreRing(units, shuffling)});
      return;
    }
    const ArrayAxis& axis = info.axes[0];
    figures.sheets.push_back(
        {info.name, population.samples.size(), axis.period, axis.unit,
         evaluation::scoreSheet(units, axis.unit == "m" ? axis.period : 0, shuffling)});
  }

  StampedPoses map_;
  StampedPoses truth_;  ///< in the frame of the map; empty where there is none
  double scale_ = 1;
  std::vector<ReadPopulation> populations_;
  std::size_t modules_ = 0;
  std::string no_position_;
  std::int64_t frame_ = -1;
  std::vector<ModulePhase> phases_;  ///< of frame_, so far
  std::optional<PositionDecoder> decoder_;
  double period_ = 0;
  std::vector<double> position_errors_;  ///< m
};

}  // namespace

Result<std::optional<CellFigures>> scoreCells(const record::RunReader& reader,
                                              const report::RunData& data, std::uint64_t seed) {
  const auto infos = reader.arrayInfos();
  if (!infos.isOk()) return infos.status();
  CellReading reading(infos.value(), data);
  if (reading.empty()) return std::optional<CellFigures>();
  bool any = false;
  const Status status = reader.visitCellArrays([&](const record::RecordedArray& row) {
    any = true;
    reading.take(row);
  });
  if (!status.isOk()) return status;
  if (!any) return std::optional<CellFigures>();
  return std::optional(reading.figures(data, seed));
}

}  // namespace tolman::run
