// SPDX-License-Identifier: BSD-3-Clause
#include "backward_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tolman::view_sequences {
namespace {

// Turns of the structure that are tried: streets are driven nearly along their direction. Their
// number and the step below are chosen, not tuned.
constexpr std::size_t kYaws = 5;

double yawOf(double index) { return 0.08 * (index - (kYaws - 1) / 2.0); }  // rad

// Least probability of a place whose pose is measured. It is below that of an answer, because an
// answer must agree with an earlier measurement. Chosen, not tuned.
constexpr double kMeasuredFrom = 0.5;
// Least correlation of the structure of the same street: 97 of 100 right places reach it.
// Chosen on district (docs/report/places.md).
constexpr double kMinCorrelation = 0.28;
// Correction along the street: a camera sees only the near sides of objects, so structure of the
// opposite direction fits best about a metre too far back. Measured on district (1.0 m), checked on
// a route of another town (0.8 m).
constexpr double kNearSides = 1.0;  // m
// Standard deviations of the measured pose. Those to the side and of the yaw were measured on
// district. That along the street is larger, because the thickness of objects differs.
constexpr double kSigmaSide = 0.4;    // m
constexpr double kSigmaHeight = 0.5;  // m; not measured
constexpr double kSigmaAlong = 1.2;   // m
constexpr double kSigmaTilt = 0.05;   // rad; not measured
constexpr double kSigmaYaw = 0.06;    // rad

Matrix6d covarianceOfStructure() {
  Vector6d sigma;
  sigma << kSigmaSide, kSigmaHeight, kSigmaAlong, kSigmaTilt, kSigmaYaw, kSigmaTilt;
  return sigma.cwiseAbs2().asDiagonal();
}

}  // namespace

void BackwardPlaces::move(const Motion& motion) {
  if (!canMeasure()) return;
  if (!motion.scale_known) street_.restart();  // points at unknown distances cannot be joined
  street_.move(motion.T_previous_current);
}

void BackwardPlaces::step(const PathStep& step, const Frame& frame) {
  if (!canMeasure()) return;
  if (step.begins_pass) {
    street_.restart();
    search_.beginPass();
    agreement_.forget();
  }
  path_ = step.path;
  if (street_.wantsPoints(step.path)) street_.add(stereo_.pointsOf(frame), step.path);
  current_ = street_.levels();
  if (!current_) return search_.step(nullptr, step.path, step.advance);
  mean_.add(*current_);
  const StructureQuery query(*current_, mean_);
  search_.step(&query, step.path, step.advance);
}

void BackwardPlaces::add(double path, std::int64_t predecessor) {
  if (!canMeasure()) return;
  search_.add(current_, path, predecessor);
  const PlanarPose pose = toPlanar(street_.pose());
  for (const double value : {pose.x, pose.y, pose.theta})
    poses_.push_back(static_cast<float>(value));
}

void BackwardPlaces::join(std::int64_t from, std::int64_t to) {
  if (canMeasure()) search_.join(from, to);
}

std::optional<BackwardPlace> BackwardPlaces::find(double probability) {
  if (!canMeasure() || !current_) return {};
  const std::optional<PlaceCandidate> candidate = search_.best();
  if (!candidate || candidate->probability < std::min(probability, kMeasuredFrom)) return {};
  const std::optional<BackwardPlace> place = located(*candidate);
  if (!place) return {};
  const float* stored = poses_.data() + 3 * place->view;
  const PlanarPose on_path =
      compose({stored[0], stored[1], stored[2]}, toPlanar(place->T_template_current));
  const bool agrees = agreement_.add(path_, on_path, toPlanar(street_.pose()));
  return agrees && candidate->probability >= probability ? place : std::nullopt;
}

/// The fit at the turn at which the structures agree best.
BackwardPlaces::TurnedFit BackwardPlaces::bestFit(const StructureDeviation& stored) const {
  std::array<StructureFit, kYaws> fits;
  std::size_t at = 0;
  for (std::size_t i = 0; i < kYaws; ++i) {
    const auto levels = street_.levels(yawOf(static_cast<double>(i)));
    if (levels) fits[i] = fitStructure(turned(mean_.deviationOf(*levels)), stored);
    if (fits[i].correlation > fits[at].correlation) at = i;
  }
  if (at == 0 || at + 1 == kYaws) return {};
  const double between =
      peakOf(fits[at - 1].correlation, fits[at].correlation, fits[at + 1].correlation);
  return {fits[at], yawOf(static_cast<double>(at) + between)};
}

/// The measured pose at a candidate. Empty if the structures do not agree, or agree better for the
/// same driving direction.
std::optional<BackwardPlace> BackwardPlaces::located(const PlaceCandidate& candidate) const {
  const StructureDeviation stored = mean_.deviationOf(search_.levelsOf(candidate.view));
  const TurnedFit best = bestFit(stored);
  if (!best.fit.within || best.fit.correlation < kMinCorrelation) return {};
  const StructureFit same = fitStructure(mean_.deviationOf(*current_), stored);
  if (same.correlation > best.fit.correlation) return {};
  BackwardPlace place{candidate.view, candidate.probability, {}, covarianceOfStructure()};
  place.T_template_current.setIdentity();
  place.T_template_current.translation() << best.fit.lateral, 0, best.fit.ahead + kNearSides;
  place.T_template_current.linear() = expSo3({0, std::numbers::pi - best.yaw, 0});
  return place;
}

void BackwardPlaces::save(StateWriter& writer) const {
  writer.put(static_cast<std::uint8_t>(current_.has_value()));
  if (current_) writer.putAll<std::uint8_t>(*current_);
  street_.save(writer);
  mean_.save(writer);
  writer.put(path_);
  writer.putAll<float>(poses_);
  agreement_.save(writer);
  if (canMeasure()) search_.save(writer);
}

bool BackwardPlaces::load(StateReader& reader, std::int64_t views) {
  current_.reset();
  if (reader.get<std::uint8_t>() != 0) reader.getAll<std::uint8_t>(current_.emplace());
  if (!street_.load(reader) || !mean_.load(reader)) return false;
  path_ = reader.get<double>();
  const auto values = canMeasure() ? static_cast<std::uint64_t>(3 * views) : 0;
  if (values > reader.remaining() / sizeof(float)) return false;
  poses_.resize(values);
  reader.getAll<float>(poses_);
  const bool sound = std::isfinite(path_) &&
                     std::ranges::all_of(poses_, [](float value) { return std::isfinite(value); });
  return sound && agreement_.load(reader) && (!canMeasure() || search_.load(reader, views));
}

}  // namespace tolman::view_sequences
