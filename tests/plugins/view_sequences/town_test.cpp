// SPDX-License-Identifier: BSD-3-Clause
// The built-in town, driven twice: places are recognised by landmarks, and their poses are true.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/town_frames.hpp"
#include "tour.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

TEST_CASE("town: a second pass is recognised by landmarks, to decimetres and as well as it says") {
  CameraRig rig;
  const std::vector<Frame> frames = tolman::test::townFrames(60, 219, rig);
  REQUIRE(frames.size() == 160);
  Tour tour({{"landmarks", std::int64_t{400}}}, rig);
  CHECK(tour.log().empty());
  std::vector<Eigen::Isometry3d> made_at;
  int measured = 0;
  int wrong = 0;
  double normalised_errors = 0;
  // The second pass sees the street from between the frames of the first.
  for (const std::size_t first : {0U, 1U}) {
    for (std::size_t i = first; i < frames.size(); i += 2) {
      const bool starts = i == first;
      const double metres =
          starts ? 0
                 : (frames[i - 2].T_world_camera_truth.inverse() * frames[i].T_world_camera_truth)
                       .translation()
                       .norm();
      const PlaceObservation seen = tour.drive(frames[i], metres, starts);
      const Eigen::Isometry3d& here = frames[i].T_world_camera_truth;
      if (seen.recognition == Recognition::Novel) made_at.push_back(here);
      if (seen.recognition != Recognition::Familiar) continue;
      REQUIRE(seen.template_id < static_cast<std::int64_t>(made_at.size()));
      const Eigen::Isometry3d expected =
          made_at[static_cast<std::size_t>(seen.template_id)].inverse() * here;
      CAPTURE(first, i, seen.template_id, expected.translation().norm());
      CHECK(first == 1);
      wrong += expected.translation().norm() < 8 ? 0 : 1;
      if (!seen.has_relative_pose) continue;
      ++measured;
      const Vector6d error = logSe3(seen.T_template_current.inverse() * expected);
      CHECK(error.head<3>().norm() < 0.3);
      CHECK(error.tail<3>().norm() < 0.02);
      CHECK(seen.relative_yaw == Approx(toPlanar(expected).theta).margin(0.02));
      CHECK(seen.covariance.isApprox(seen.covariance.transpose()));
      normalised_errors += error.dot(seen.covariance.ldlt().solve(error));
    }
  }
  WARN("town: " << made_at.size() << " views stored, " << measured
                << " poses measured, mean normalised error " << normalised_errors / measured);
  CHECK(wrong == 0);
  CHECK(measured >= 8);
  // Six degrees of freedom.
  CHECK(normalised_errors / measured > 1.5);
  CHECK(normalised_errors / measured < 18);
}
