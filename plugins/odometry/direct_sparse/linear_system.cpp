// SPDX-License-Identifier: BSD-3-Clause
// Parallel evaluation, ordered sums, and the dense solution.
#include "linear_system.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <span>

namespace tolman::direct_sparse {
namespace {

constexpr int kChunk = 128;  // points; fixed, for the same sums with any number of threads
/// How many points before its pixels are read a point is placed in an image and their memory asked
/// for. Chosen, not tuned.
constexpr std::size_t kAhead = 16;

using RelativeSum = Eigen::Matrix<double, 8, 9 + kFieldVariables>;

RelativeSum symmetric(const ChunkSystem::RelativeBlock& block) {
  RelativeSum sum;
  for (int r = 0; r < 8; ++r) {
    for (int c = 0; c < 9 + kFieldVariables; ++c) {
      const bool lower = c < r;
      sum(r, c) =
          lower ? block[indexOfSlot(c)][indexOfSlot(r)] : block[indexOfSlot(r)][indexOfSlot(c)];
    }
  }
  return sum;
}

void mapToAbsolute(int host, int target, const PairGeometry& pair, const RelativeSum& sum,
                   SystemMatrix& H, SystemVector& b) {
  const Eigen::Matrix<double, 8, 8> M = pair.relative_by_host.cast<double>();
  const auto D = sum.leftCols<8>();
  const Vector8d g = sum.col(8);
  const int h = kFrameVariables * host;
  const int t = kFrameVariables * target;
  const Eigen::Matrix<double, 8, 8> across = M.transpose() * D;
  H.block<8, 8>(t, t) += D;
  H.block<8, 8>(h, h) += across * M;
  H.block<8, 8>(h, t) += across;
  H.block<8, 8>(t, h) += across.transpose();
  b.segment<8>(t) += g;
  b.segment<8>(h) += M.transpose() * g;
  const Eigen::Matrix<double, 8, kFieldVariables> field = sum.rightCols<kFieldVariables>();
  const Eigen::Matrix<double, 8, kFieldVariables> across_field = M.transpose() * field;
  H.block<8, kFieldVariables>(t, kOffsetIndex) += field;
  H.block<8, kFieldVariables>(h, kOffsetIndex) += across_field;
  H.block<kFieldVariables, 8>(kOffsetIndex, t) += field.transpose();
  H.block<kFieldVariables, 8>(kOffsetIndex, h) += across_field.transpose();
}

/// The right image where errors of disparities displace the point, and derivatives of its column.
struct Displaced {
  StereoGeometry stereo;
  float disparity = 0;  ///< px, without errors
  ChunkSystem::FieldTerms by_field;
};

Displaced displaced(const DisparityField& field, const StereoGeometry& stereo, const Point& point) {
  Displaced there;
  there.stereo = stereo;
  there.disparity = stereo.focal_baseline * point.inverse_depth;
  const SmoothField::Terms terms = field.termsAt(static_cast<double>(point.u - there.disparity),
                                                 point.v, static_cast<double>(there.disparity));
  there.stereo.offset = static_cast<float>(field.sum(terms));
  there.by_field = terms.cast<float>();
  return there;
}

/// Slot of the newest keyframe, other than the host, that has a right image and sees the point; -1
/// without one.
int lastTarget(const Window& window, int host, const Point& point) {
  const std::vector<int>& order = window.order();
  for (auto slot = order.rbegin(); slot != order.rend(); ++slot) {
    if (*slot == host) continue;
    const bool sees = point.temporal[indexOfSlot(*slot)] == ResidualState::Good;
    if (sees && window.keyframe(*slot).has_right) return *slot;
  }
  return -1;
}

}  // namespace

std::vector<PointRange> allPoints(const Window& window) {
  std::vector<PointRange> ranges;
  for (const int slot : window.order()) {
    ranges.push_back({slot, 0, static_cast<int>(window.keyframe(slot).points.size())});
  }
  return ranges;
}

void LinearSystem::prepare(const CameraRig& rig, const Window& window,
                           const std::vector<PointRange>& points) {
  chunks_.clear();
  std::size_t count = 0;
  for (const PointRange& range : points) {
    for (int begin = range.begin; begin < range.end; begin += kChunk) {
      const int end = std::min(begin + kChunk, range.end);
      chunks_.push_back({{range.host, begin, end}, count});
      count += static_cast<std::size_t>(end - begin);
    }
  }
  if (systems_.size() < chunks_.size()) systems_.resize(chunks_.size());
  terms_.resize(count);
  pairs_.resize(kSlots * kSlots);
  stereos_.resize(kSlots);
  for (const int host : window.order()) {
    const Keyframe& keyframe = window.keyframe(host);
    stereos_[indexOfSlot(host)] = {static_cast<float>(rig.pinhole.fx * rig.baseline), 0,
                                   keyframe.right_gain, keyframe.right_offset};
    for (const int target : window.order()) {
      if (host == target) continue;
      pairs_[indexOfSlot(host * kSlots + target)] =
          pairGeometry(rig.pinhole, keyframe, window.keyframe(target));
    }
  }
}

void LinearSystem::build(const CameraRig& rig, const SystemSettings& settings, Window& window,
                         const std::vector<PointRange>& points) {
  prepare(rig, window, points);
  tbb::parallel_for(std::size_t{0}, chunks_.size(),
                    [&](std::size_t i) { evaluateChunk(rig, settings, window, i); });
  sumUp(window);
}

void LinearSystem::evaluateChunk(const CameraRig& rig, const SystemSettings& settings,
                                 Window& window, std::size_t i) {
  const Chunk& chunk = chunks_[i];
  ChunkSystem& system = systems_[i];
  system.clear(chunk.range.host);
  const std::size_t count = indexOfSlot(chunk.range.end - chunk.range.begin);
  const std::span<PointTerms> terms(terms_.data() + chunk.first_term, count);
  std::fill(terms.begin(), terms.end(), PointTerms());
  // One target after the other: the pixels of neighbouring points are close in its image, too.
  for (const int target : window.order()) {
    if (target != chunk.range.host) addTarget(rig, window, chunk, target, system, terms);
  }
  if (settings.lambda > 0) addRight(settings, window, chunk, system, terms);
  if (settings.lambda > 0) addSightings(rig, settings, window, chunk, system, terms);
  system.eliminate(terms);
}

void LinearSystem::addTarget(const CameraRig& rig, Window& window, const Chunk& chunk, int target,
                             ChunkSystem& system, std::span<PointTerms> terms) const {
  const int host = chunk.range.host;
  const PairGeometry& pair = pairs_[indexOfSlot(host * kSlots + target)];
  const GrayLevel& image = window.keyframe(target).left.level(0);
  Point* points = window.keyframe(host).points.data() + chunk.range.begin;
  std::array<PatternPlaces, kAhead> places;  // of the points from k on
  const auto place = [&](std::size_t k) {
    if (k >= terms.size() || points[k].temporal[indexOfSlot(target)] == ResidualState::Absent)
      return;
    placePattern(pair, image, points[k], places[k % kAhead]);
  };
  for (std::size_t k = 0; k < kAhead; ++k) place(k);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const PatternPlaces there = places[k % kAhead];
    place(k + kAhead);
    Point& point = points[k];
    ResidualState& state = point.temporal[indexOfSlot(target)];
    if (state == ResidualState::Absent) continue;
    if (!there.inside) {
      state = ResidualState::Outside;
      continue;
    }
    const PixelSums sums = temporalSums(pair, image, point.pattern, there);
    state = system.judge(sums, window.energy_threshold);
    if (state != ResidualState::Good) continue;
    const CentreJacobian J =
        centreJacobian(rig.pinhole, pair, point.u, point.v, point.inverse_depth);
    system.addTemporal(target, pair, sums, J, terms[k]);
  }
}

void LinearSystem::addRight(const SystemSettings& settings, Window& window, const Chunk& chunk,
                            ChunkSystem& system, std::span<PointTerms> terms) const {
  Keyframe& keyframe = window.keyframe(chunk.range.host);
  const StereoGeometry& stereo = stereos_[indexOfSlot(chunk.range.host)];
  PixelSums sums;
  Point* points = keyframe.points.data() + chunk.range.begin;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (k + kAhead < terms.size()) {
      prefetchStereo(stereo, keyframe.right.level(0), points[k + kAhead]);
    }
    Point& point = points[k];
    if (point.stereo == ResidualState::Absent) continue;
    const Displaced there = displaced(window.field, stereo, point);
    const bool inside = stereoSums(there.stereo, keyframe.right.level(0), point, sums);
    point.stereo = inside ? system.judge(sums, window.energy_threshold) : ResidualState::Outside;
    if (point.stereo != ResidualState::Good) continue;
    system.moments.add(sums.xx, there.disparity, there.by_field);
    system.addStereo(sums, stereo.focal_baseline, settings.lambda, there.by_field, terms[k]);
  }
}

void LinearSystem::addSightings(const CameraRig& rig, const SystemSettings& settings,
                                const Window& window, const Chunk& chunk, ChunkSystem& system,
                                std::span<PointTerms> terms) const {
  const Point* points = window.keyframe(chunk.range.host).points.data() + chunk.range.begin;
  std::array<SeenPoint, kAhead> seen;  // of the points from k on
  const auto find = [&](std::size_t k) {
    if (k >= terms.size()) return;
    seen[k % kAhead] = findSighting(rig, window, chunk.range.host, points[k]);
  };
  for (std::size_t k = 0; k < kAhead; ++k) find(k);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    auto [target, sighting, point] = seen[k % kAhead];
    find(k + kAhead);
    if (target < 0) continue;
    const Keyframe& keyframe = window.keyframe(target);
    point.pattern = patternAt(keyframe.left.level(0), sighting.u, sighting.v);
    const StereoGeometry& stereo = stereos_[indexOfSlot(target)];
    PixelSums sums;
    const Displaced there = displaced(window.field, stereo, point);
    if (!stereoSums(there.stereo, keyframe.right.level(0), point, sums)) continue;
    if (system.judge(sums, window.energy_threshold) != ResidualState::Good) continue;
    const PairGeometry& pair = pairs_[indexOfSlot(chunk.range.host * kSlots + target)];
    system.moments.add(sums.xx, there.disparity, there.by_field);
    system.addSighting(target, pair, sums, sighting, stereo.focal_baseline, settings.lambda,
                       there.by_field, terms[k]);
  }
}

LinearSystem::SeenPoint LinearSystem::findSighting(const CameraRig& rig, const Window& window,
                                                   int host, const Point& point) const {
  SeenPoint seen;
  const int target = lastTarget(window, host, point);
  if (target < 0) return seen;
  const Keyframe& keyframe = window.keyframe(target);
  const PairGeometry& pair = pairs_[indexOfSlot(host * kSlots + target)];
  const auto sighting = sight(rig.pinhole, pair, keyframe.left.level(0), point);
  if (!sighting) return seen;
  seen.target = target;
  seen.sighting = *sighting;
  seen.point.u = static_cast<float>(sighting->u);
  seen.point.v = static_cast<float>(sighting->v);
  seen.point.inverse_depth = sighting->inverse_depth;
  prefetchPattern(keyframe.left.level(0), sighting->u, sighting->v);
  prefetchStereo(stereos_[indexOfSlot(target)], keyframe.right.level(0), seen.point);
  return seen;
}

void LinearSystem::sumUp(const Window& window) {
  H_.setZero();
  b_.setZero();
  energy_ = 0;
  residuals_ = 0;
  moments_ = ScaleMoments<double>();
  using RowMajor = Eigen::Matrix<double, kVariables, kVariables, Eigen::RowMajor>;
  RowMajor schur = RowMajor::Zero();
  std::vector<RelativeSum> relative(kSlots * kSlots, RelativeSum::Zero());
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const ChunkSystem& system = systems_[i];
    for (const int target : window.order()) {
      if (!system.hasTarget(target)) continue;
      relative[indexOfSlot(system.host() * kSlots + target)] += symmetric(system.relative(target));
    }
    for (int r = 0; r < kVariables; ++r) {
      const float* row = system.schur()[indexOfSlot(r)].data();
      for (int c = r - r % kFrameVariables; c < kVariables; ++c) {
        schur(r, c) += static_cast<double>(row[c]);
      }
      b_[r] -= system.schurGradient(indexOfSlot(r));
    }
    H_.bottomRightCorner<kFieldVariables, kFieldVariables>() +=
        system.field_information.topRows<kFieldVariables>().cast<double>();
    b_.tail<kFieldVariables>() += system.field_gradient.cast<double>();
    moments_.add(system.moments);
    energy_ += system.energy;
    residuals_ += system.residuals;
  }
  for (const int host : window.order()) {
    for (const int target : window.order()) {
      const std::size_t pair = indexOfSlot(host * kSlots + target);
      if (host == target || relative[pair].isZero(0)) continue;
      mapToAbsolute(host, target, pairs_[pair], relative[pair], H_, b_);
    }
  }
  // Only the upper triangle was summed.
  H_ -= SystemMatrix(schur.selfadjointView<Eigen::Upper>());
}

double LinearSystem::applyToDepths(Window& window, const SystemVector& step) const {
  const Eigen::Matrix<float, kVariables, 1> x = step.cast<float>();
  double relative = 0;
  for (const Chunk& chunk : chunks_) {
    Keyframe& keyframe = window.keyframe(chunk.range.host);
    for (int k = chunk.range.begin; k < chunk.range.end; ++k) {
      const PointTerms& terms = terms_[chunk.first_term + indexOfSlot(k - chunk.range.begin)];
      Point& point = keyframe.points[indexOfSlot(k)];
      float dot = terms.gradient;
      for (int i = kOffsetIndex; i < kVariables; ++i) dot += terms.coupling[indexOfSlot(i)] * x[i];
      for (int slot = 0; slot < kSlots; ++slot) {
        if (((terms.slots >> static_cast<unsigned>(slot)) & 1U) == 0) continue;
        const float* c = terms.coupling.data() + kFrameVariables * slot;
        for (int i = 0; i < kFrameVariables; ++i) dot += c[i] * x[kFrameVariables * slot + i];
      }
      // Limits of a step, relative and in 1/m: chosen, not tuned.
      const float limit = 0.5F * point.inverse_depth + 0.01F;
      const float change = std::clamp(-dot / terms.information, -limit, limit);
      point.inverse_depth = std::max(point.inverse_depth + change, 1e-5F);
      relative += std::fabs(change) / (point.inverse_depth + 1e-3F);
    }
  }
  return terms_.empty() ? 0 : relative / static_cast<double>(terms_.size());
}

void LinearSystem::storeInformation(Window& window) const {
  for (const Chunk& chunk : chunks_) {
    Keyframe& keyframe = window.keyframe(chunk.range.host);
    for (int k = chunk.range.begin; k < chunk.range.end; ++k) {
      const PointTerms& terms = terms_[chunk.first_term + indexOfSlot(k - chunk.range.begin)];
      Point& point = keyframe.points[indexOfSlot(k)];
      point.information = terms.good > 0 ? terms.information : 0;
      point.seen_good += terms.good;
    }
  }
}

float LinearSystem::outlierThreshold() const {
  std::array<int, 128> histogram{};
  int count = 0;
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    for (std::size_t bin = 0; bin < histogram.size(); ++bin) {
      histogram[bin] += systems_[i].histogram[bin];
      count += systems_[i].histogram[bin];
    }
  }
  std::size_t bin = 0;
  for (int below = histogram[0]; bin + 1 < histogram.size() && 10 * below < 7 * count;) {
    below += histogram[++bin];
  }
  // Of the 70th percentile, as in DSO (Engel et al.)
  const float root = 13.0F + 0.75F * (static_cast<float>(bin) + 0.5F);
  return root * root;
}

SystemVector changes(const Window& window) {
  SystemVector x = SystemVector::Zero();
  for (const int slot : window.order()) {
    x.segment<kFrameVariables>(kFrameVariables * slot) = window.keyframe(slot).change;
  }
  x.tail<kFieldVariables>() = window.field.changes();
  return x;
}

SystemVector scaleDirection(const Window& window) {
  SystemVector direction = SystemVector::Zero();
  const Eigen::Isometry3d T_world_oldest = window.keyframe(window.order().front()).T_world_camera();
  for (const int slot : window.order()) {
    const Eigen::Isometry3d T_camera_oldest =
        window.keyframe(slot).T_camera_world() * T_world_oldest;
    direction.segment<3>(kFrameVariables * slot) = T_camera_oldest.translation();
  }
  return direction.stableNormalized();
}

SystemVector solveWith(const Window& window, const SystemMatrix& H, const SystemVector& b,
                       Scale scale, bool field_is_on) {
  constexpr double kHold =
      1e8;  // much more than any information: a standard deviation of 0.0004 px
  SystemMatrix whole = H + window.prior.H;
  SystemVector rhs = -(b + window.prior.b + window.prior.H * changes(window));
  // A common factor of the disparities is the calibration's to know: images of a drive do not.
  const SmoothField::Terms factor = window.moments.factorDirection();
  whole.bottomRightCorner<kFieldVariables, kFieldVariables>() +=
      kHold * factor * factor.transpose();
  rhs.tail<kFieldVariables>() -= kHold * factor * factor.dot(window.field.changes());
  // The pose of the whole window is not observable: the oldest keyframe is fixed.
  const int held = window.empty() ? kVariables : kFrameVariables * window.order().front();
  for (int i = 0; i < kVariables; ++i) {
    const bool is_held =
        (i >= held && i < held + kFrameVariables) || (i > kOffsetIndex && !field_is_on);
    if (whole(i, i) > 0 && !is_held) continue;
    whole.row(i).setZero();
    whole.col(i).setZero();
    whole(i, i) = 1;
    rhs[i] = 0;
  }
  const SystemVector units = (whole.diagonal().array() + 1e-9).rsqrt();  // keeps the scaling finite
  whole = units.asDiagonal() * whole * units.asDiagonal();
  whole.diagonal().array() += kMinDamping;
  if (scale == Scale::Free && window.size() > 1) {
    // The scale is not observable; without this, rounding errors change it by factors.
    const SystemVector direction = units.cwiseProduct(scaleDirection(window)).stableNormalized();
    whole += direction * direction.transpose();
  }
  const Eigen::LDLT<SystemMatrix> factors(whole);
  const SystemVector step = units.cwiseProduct(factors.solve(units.cwiseProduct(rhs)));
  return step.allFinite() ? step : SystemVector::Zero().eval();
}

SystemVector solve(const Window& window, const SystemMatrix& H, const SystemVector& b,
                   Scale scale) {
  return solveWith(window, H, b, scale, window.field.isOn());
}

SmoothField fieldIfOn(const Window& window, const SystemMatrix& H, const SystemVector& b,
                      Scale scale) {
  const SystemVector step = solveWith(window, H, b, scale, true);
  return {window.field.changes() + step.tail<kFieldVariables>()};
}

}  // namespace tolman::direct_sparse
