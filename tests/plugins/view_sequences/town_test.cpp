// SPDX-License-Identifier: BSD-3-Clause
// The built-in town, driven twice, also by night: places are recognised by landmarks, and their
// poses are true.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/town_frames.hpp"
#include "tour.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

/// What was measured on a second pass, which sees the street from between the frames of the first.
struct SecondPass {
  std::size_t stored = 0;
  int wrong = 0;  ///< familiar views of a place 8 m away or farther
  int measured = 0;
  double largest_error = 0;  ///< m
  double largest_turn = 0;   ///< rad, of poses
  double normalised_errors = 0;
};

SecondPass driveTwice(const ParameterValues& light_of_second) {
  const ParameterValues drive = {
      {"scale", 0.5}, {"first", std::int64_t{60}}, {"last", std::int64_t{219}}};
  CameraRig rig;
  const std::vector<Frame> frames = tolman::test::townFrames(drive, rig);
  REQUIRE(frames.size() == 160);
  ParameterValues other = drive;
  other.insert(light_of_second.begin(), light_of_second.end());
  const std::vector<Frame> later =
      light_of_second.empty() ? frames : tolman::test::townFrames(other, rig);
  Tour tour({{"landmarks", std::int64_t{400}}}, rig);
  CHECK(tour.log().empty());
  std::vector<Eigen::Isometry3d> made_at;
  SecondPass result;
  for (const std::size_t first : {0U, 1U}) {
    for (std::size_t i = first; i < frames.size(); i += 2) {
      const bool starts = i == first;
      const Eigen::Isometry3d& here = frames[i].T_world_camera_truth;
      const double metres =
          starts ? 0 : (frames[i - 2].T_world_camera_truth.inverse() * here).translation().norm();
      const PlaceObservation seen = tour.drive(first == 0 ? frames[i] : later[i], metres, starts);
      if (seen.recognition == Recognition::Novel) made_at.push_back(here);
      if (seen.recognition != Recognition::Familiar) continue;
      REQUIRE(seen.template_id < static_cast<std::int64_t>(made_at.size()));
      const Eigen::Isometry3d expected =
          made_at[static_cast<std::size_t>(seen.template_id)].inverse() * here;
      CAPTURE(first, i, seen.template_id, expected.translation().norm());
      CHECK(first == 1);
      result.wrong += expected.translation().norm() < 8 ? 0 : 1;
      if (!seen.has_relative_pose) continue;
      ++result.measured;
      const Vector6d error = logSe3(seen.T_template_current.inverse() * expected);
      result.largest_error = std::max(result.largest_error, error.head<3>().norm());
      result.largest_turn = std::max(result.largest_turn, error.tail<3>().norm());
      CHECK(seen.relative_yaw == Approx(toPlanar(expected).theta).margin(0.02));
      CHECK(seen.covariance.isApprox(seen.covariance.transpose()));
      result.normalised_errors += error.dot(seen.covariance.ldlt().solve(error));
    }
  }
  result.stored = made_at.size();
  return result;
}

}  // namespace

TEST_CASE("town: a second pass is recognised by landmarks, to decimetres and as well as it says") {
  const SecondPass day = driveTwice({});
  WARN("town: " << day.stored << " views stored, " << day.measured
                << " poses measured, mean normalised error "
                << day.normalised_errors / day.measured);
  CHECK(day.wrong == 0);
  CHECK(day.measured >= 8);
  CHECK(day.largest_error < 0.3);
  CHECK(day.largest_turn < 0.02);
  // Six degrees of freedom.
  CHECK(day.normalised_errors / day.measured > 1);
  CHECK(day.normalised_errors / day.measured < 12);
}

TEST_CASE("town: a second pass by night is recognised by the edges around landmarks") {
  const SecondPass night = driveTwice(
      {{"conditions", std::string("night")}, {"exposure_ms", std::vector<double>{0.5, 15}}});
  WARN("town by night: " << night.stored << " views stored, " << night.measured
                         << " poses measured, largest error " << night.largest_error
                         << " m, mean normalised error "
                         << night.normalised_errors / night.measured);
  CHECK(night.wrong == 0);
  CHECK(night.measured >= 8);
  CHECK(night.largest_error < 0.6);
  CHECK(night.largest_turn < 0.02);
  CHECK(night.normalised_errors / night.measured < 18);
}
