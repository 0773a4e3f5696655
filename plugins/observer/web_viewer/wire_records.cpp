// SPDX-License-Identifier: BSD-3-Clause
#include "wire_records.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tolman::web_viewer {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kSecondsPerNs = 1e-9;
constexpr double kMsPerNs = 1e-6;
constexpr std::size_t kTimedStages = 5;  // all roles but the observers

using Choices = std::span<const std::string_view>;

/// Frame index and time are equal in all records of a frame, so each has only one column.
bool isJoinKey(std::string_view field) { return field == "frame" || field == "stamp_ns"; }

/// Calls visit(record name, Field, choices, value) for each scalar field. The fields of a missing
/// record are visited, too: their values are NaN.
template <Record R, class Visit>
void visitScalars(const R* record, const Visit& visit) {
  static const R kMissing;
  visitFields(record != nullptr ? *record : kMissing, [&](const Field& field, const auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_arithmetic_v<Member> || NamedEnum<Member>) {
      if (isJoinKey(field.name)) return;
      Choices choices;
      if constexpr (NamedEnum<Member>) choices = enumNames(member);
      visit(R::kRecord, field, choices, record != nullptr ? static_cast<double>(member) : kUnknown);
    }
  });
}

template <class Visit>
void visitPosition(const char* name, const std::optional<Eigen::Isometry3d>& T_world_camera,
                   const Visit& visit) {
  const Eigen::Vector3d p = T_world_camera ? Eigen::Vector3d(T_world_camera->translation())
                                           : Eigen::Vector3d::Constant(kUnknown);
  visit(name, Field{"x", "m", "position, to the right at the first frame"}, Choices(), p.x());
  visit(name, Field{"y", "m", "position, downwards at the first frame"}, Choices(), p.y());
  visit(name, Field{"z", "m", "position, forward at the first frame"}, Choices(), p.z());
}

/// Of the hypotheses that a frame changed the one that its view supports, else any; null: none.
const PlaceHypothesis* shownHypothesis(const Decision* decision) {
  if (decision == nullptr || decision->hypotheses.empty()) return nullptr;
  const auto byView = [](const PlaceHypothesis& h) { return h.fate <= Fate::Accepted; };
  const auto found = std::ranges::find_if(decision->hypotheses, byView);
  return found != decision->hypotheses.end() ? &*found : &decision->hypotheses.front();
}

/// Poses of a frame in the world of the run, and what follows from them; absent where not known.
struct RowPoses {
  std::optional<Eigen::Isometry3d> odometry;
  std::optional<Eigen::Isometry3d> map;
  std::optional<Eigen::Isometry3d> truth;
  std::optional<Eigen::Isometry3d> anchor;  ///< the experience of the frame, as the map had it then
  std::optional<PoseError> measured;
};

/// Visits each column with its value, always in the same order.
template <class Visit>
void visitColumns(const Snapshot& snapshot, const RowPoses& poses, const Visit& visit) {
  const Frame& frame = *snapshot.frame;
  visit("frame", Field{"frame", "", "index in the run"}, Choices(),
        static_cast<double>(frame.frame));
  visit("frame", Field{"time", "s", "data time of the exposure"}, Choices(),
        static_cast<double>(frame.stamp_ns) * kSecondsPerNs);
  visitScalars(snapshot.frame, visit);
  visitScalars(snapshot.motion, visit);
  visitScalars(snapshot.place, visit);
  const PlaceObservation* place = snapshot.place;
  visitScalars(place != nullptr && !place->candidates.empty() ? &place->candidates[0] : nullptr,
               visit);
  visitScalars(snapshot.decision, visit);
  visitScalars(shownHypothesis(snapshot.decision), visit);
  visitScalars(snapshot.map, visit);
  visitPosition("odometry", poses.odometry, visit);
  visitPosition("map", poses.map, visit);
  visitPosition("truth", poses.truth, visit);
  visitPosition("anchor", poses.anchor, visit);
  visit("anchor", Field{"yaw", "rad", "heading of the experience"}, Choices(),
        poses.anchor ? toPlanar(*poses.anchor).theta : kUnknown);
  const PoseError error = poses.measured.value_or(PoseError{kUnknown, kUnknown});
  visit("measured", Field{"error", "m", "measured pose, from the true one"}, Choices(),
        error.metres);
  visit("measured", Field{"sigmas", "", "the same in standard deviations"}, Choices(),
        error.sigmas);
  for (std::size_t stage = 0; stage < kTimedStages; ++stage) {
    const std::int64_t ns = snapshot.stage_times_ns[stage];
    visit("duration", Field{kRoleNames[stage], "ms", "wall time of the stage"}, Choices(),
          ns > 0 ? static_cast<double>(ns) * kMsPerNs : kUnknown);
  }
}

std::vector<RowColumn> listColumns() {
  const Frame frame;
  Snapshot snapshot;
  snapshot.frame = &frame;
  std::vector<RowColumn> columns;
  visitColumns(snapshot, {},
               [&](std::string_view record, const Field& field, Choices choices, double) {
                 columns.push_back({std::string(record) + "." + std::string(field.name),
                                    std::string(field.unit), std::string(field.doc), choices});
               });
  return columns;
}

}  // namespace

const std::vector<RowColumn>& rowColumns() {
  static const std::vector<RowColumn> kColumns = listColumns();
  return kColumns;
}

void RowMaker::append(const Snapshot& snapshot, std::vector<double>& values) {
  const Frame& frame = *snapshot.frame;
  RowPoses poses;
  if (snapshot.motion != nullptr) {
    if (begun_) {
      T_world_camera_ = normalised(T_world_camera_ * snapshot.motion->T_previous_current);
    }
    begun_ = true;
    poses.odometry = T_world_camera_;
  }
  if (snapshot.map != nullptr) poses.map = snapshot.map->T_world_camera;
  if (snapshot.map != nullptr && snapshot.map->experience >= 0) {
    poses.anchor = *poses.map * snapshot.map->T_experience_camera.inverse();
  }
  if (frame.has_truth) {
    if (!T_world_truth_) T_world_truth_ = T_world_camera_ * frame.T_world_camera_truth.inverse();
    poses.truth = *T_world_truth_ * frame.T_world_camera_truth;
    if (snapshot.place != nullptr) poses.measured = judge(*snapshot.place, *poses.truth);
  }
  visitColumns(snapshot, poses, [&](std::string_view, const Field&, Choices, double value) {
    values.push_back(value);
  });
}

/// As the evaluation judges loops: only where the truth has orientations.
std::optional<PoseError> RowMaker::judge(const PlaceObservation& place,
                                         const Eigen::Isometry3d& T_truth) {
  if (true_templates_.empty()) first_turn_ = T_truth.linear();
  turned_ = turned_ || !T_truth.linear().isApprox(first_turn_, 1e-9);
  if (place.recognition == Recognition::Novel) {
    true_templates_.try_emplace(place.template_id, T_truth);
  }
  const auto then = true_templates_.find(place.template_id);
  const bool measured = place.recognition == Recognition::Familiar && place.has_relative_pose;
  if (!turned_ || !measured || then == true_templates_.end()) return std::nullopt;
  const Eigen::Isometry3d T_true = then->second.inverse() * T_truth;
  const Eigen::Vector3d off = (place.T_template_current.inverse() * T_true).translation();
  const Eigen::Matrix3d covariance = place.covariance.topLeftCorner<3, 3>();
  return PoseError{off.norm(), std::sqrt(std::max(0.0, off.dot(covariance.ldlt().solve(off))))};
}

}  // namespace tolman::web_viewer
