// SPDX-License-Identifier: BSD-3-Clause
// True poses of files for the frames of any source.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "engine/rectified_source.hpp"
#include "support/data.hpp"
#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::engine;

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kEpochMs = 1403636500000;  // of the images' clock

/// Of a body, at a time in ms.
Eigen::Isometry3d bodyAt(double ms) {
  Vector6d twist;
  twist << 0.001 * ms, 0.0004 * ms, -0.0002 * ms, 0.0003 * ms, -0.0002 * ms, 0.0008 * ms;
  return expSe3(twist);
}

Frame frameAt(std::int64_t ms, std::int64_t index = 0) {
  Frame frame;
  frame.stamp_ns = ms * kMs;
  frame.source_index = index;
  return frame;
}

struct Folder {
  test::TemporaryFolder folder;

  std::string write(const std::string& name, const std::string& text) const {
    const auto path = folder.path() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path.string();
  }
  /// A table as EuRoC publishes it, every `step` ms from 1,000 to 2,000, without `gap` ms.
  std::string table(int step, int gap_from = 0, int gap_to = 0) const {
    std::string text =
        "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
        "q_RS_z [], v_RS_R_x [m s^-1]\n";
    for (int ms = 1000; ms <= 2000; ms += step) {
      if (ms > gap_from && ms < gap_to) continue;
      const Eigen::Isometry3d T = bodyAt(ms);
      const Eigen::Vector3d p = T.translation();
      const Eigen::Quaterniond q(T.linear());
      text += fmt::format("{}000000,{:.9f},{:.9f},{:.9f},{:.9f},{:.9f},{:.9f},{:.9f},0\n",
                          kEpochMs + ms, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
    }
    return text;
  }
};

/// Of cam0 in EuRoC's V1_01.
const char* const kCamera =
    "%YAML:1.0\nsensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n"
    "  data: [0.0148655429818, -0.999880929698, 0.00414029679422, -0.0216401454975,\n"
    "         0.999557249008, 0.0149672133247, 0.025715529948, -0.064676986768,\n"
    "        -0.0257744366974, 0.00375618835797, 0.999660727178, 0.00981073058949,\n"
    "         0.0, 0.0, 0.0, 1.0]\nrate_hz: 20\n";

Eigen::Isometry3d cameraInBody() {
  Eigen::Matrix4d T;
  T << 0.0148655429818, -0.999880929698, 0.00414029679422, -0.0216401454975, 0.999557249008,
      0.0149672133247, 0.025715529948, -0.064676986768, -0.0257744366974, 0.00375618835797,
      0.999660727178, 0.00981073058949, 0, 0, 0, 1;
  return Eigen::Isometry3d(T);
}

TruePath opened(const config::EvaluationSettings& settings, const std::string& folder = "") {
  auto path = TruePath::open(settings, folder);
  INFO(path.status().message());
  REQUIRE(path.isOk());
  return std::move(path).value();
}

}  // namespace

TEST_CASE("a folder of EuRoC finds its truth, which becomes that of the rectified camera") {
  const Folder folder;
  folder.write("mav0/cam0/sensor.yaml", kCamera);
  folder.write("mav0/state_groundtruth_estimate0/data.csv", folder.table(5));
  folder.write(
      "mav0/state_groundtruth_estimate0/sensor.yaml",
      "T_BS:\n  cols: 4\n  rows: 4\n  data: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n");
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.02, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const bool is_rectified = GENERATE(false, true);
  for (const std::string& source :
       {folder.folder.path().string(), (folder.folder.path() / "mav0").string()}) {
    TruePath path = opened({}, source);
    REQUIRE(path.isGiven());
    Eigen::Isometry3d T_body_camera = cameraInBody();
    if (is_rectified) {
      path.rectify(turn);
      path.rectify(turn);  // the source may be asked again
      T_body_camera = T_body_camera * Eigen::Quaterniond(turn.transpose());
    }
    const Eigen::Isometry3d first = bodyAt(1000) * T_body_camera;
    for (const int ms : {1000, 1037, 1999}) {
      Frame frame = frameAt(kEpochMs + ms);
      path.apply(frame);
      REQUIRE(frame.has_truth);
      const Eigen::Isometry3d expected = first.inverse() * bodyAt(ms) * T_body_camera;
      CHECK(frame.T_world_camera_truth.isApprox(expected, 1e-5));
    }
    Frame late = frameAt(kEpochMs + 2001);
    path.apply(late);
    CHECK_FALSE(late.has_truth);
  }
}

TEST_CASE("positions of a prism are taken as they are, and named as those of another point") {
  const Folder folder;
  folder.write("mav0/cam0/sensor.yaml", kCamera);
  std::string table = "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m]\n";
  for (int ms = 0; ms <= 100; ms += 50)
    table += fmt::format("{}000000,1,2,{}\n", kEpochMs + ms, ms);
  folder.write("mav0/leica0/data.csv", table);
  folder.write("mav0/leica0/sensor.yaml",
               "T_BS:\n  data: [1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n");
  TruePath path = opened({}, folder.folder.path().string());
  Frame frame = frameAt(kEpochMs + 75);
  path.apply(frame);
  CHECK(frame.T_world_camera_truth.isApprox(Eigen::Isometry3d(Eigen::Translation3d(0, 0, 75))));
  const Eigen::Vector3d prism = cameraInBody().inverse() * Eigen::Vector3d(0.1, 0, 0);
  CHECK_THAT(path.pointProblem(),
             Catch::Contains(fmt::format("--body={:.4f},{:.4f}", prism.x(), prism.y())));
  path = opened({}, "");
  CHECK(path.pointProblem().empty());
}

TEST_CASE("a named file has the truth of a part, never across a gap, at the clock of the images") {
  const Folder folder;
  config::EvaluationSettings settings;
  settings.truth = folder.write("poses.csv", folder.table(10, 1300, 1600));
  settings.truth_offset = 2;
  TruePath path = opened(settings);
  const auto truthAt = [&](std::int64_t ms) {
    Frame frame = frameAt(kEpochMs + ms - 2000);
    path.apply(frame);
    return frame;
  };
  CHECK_FALSE(truthAt(999).has_truth);
  CHECK(truthAt(1300).has_truth);
  CHECK_FALSE(truthAt(1301).has_truth);
  CHECK(truthAt(1600).has_truth);
  const Eigen::Isometry3d first = bodyAt(1000);
  CHECK(truthAt(1104).T_world_camera_truth.isApprox(first.inverse() * bodyAt(1104), 1e-4));
  settings.truth_match = config::TruthMatch::Nearest;
  path = opened(settings);
  CHECK(truthAt(1104).T_world_camera_truth.isApprox(first.inverse() * bodyAt(1100), 1e-6));
  CHECK(path.clockProblem(frameAt(kEpochMs - 900)).empty());
  CHECK_THAT(path.clockProblem(frameAt(5)), Catch::StartsWith("the first image is of 2.005 s"));
}

TEST_CASE("TUM's images find their truth, also that of a part of them") {
  const Folder folder;
  folder.write("groundtruth.txt", "1 0 0 0 0 0 0 1\n1.01 0 0 1 0 0 0 1\n");
  TruePath path = opened({}, folder.folder.path().string());
  Frame frame = frameAt(1005);
  path.apply(frame);
  CHECK(frame.T_world_camera_truth.translation().isApprox(Eigen::Vector3d(0, 0, 0.5)));
  frame.stamp_ns = 1020 * kMs;
  path.apply(frame);
  CHECK_FALSE(frame.has_truth);
  folder.write("groundtruth.txt", "damaged\n");
  CHECK_FALSE(TruePath::open({}, folder.folder.path().string()).isOk());
}

TEST_CASE("frame numbers are those of the data set; the body is taken off, of any truth") {
  const Folder folder;
  config::EvaluationSettings settings;
  settings.truth =
      folder.write("poses.txt", "3 1 0 0 0 0 1 0 0 0 0 1 0\n7 1 0 0 5 0 1 0 0 0 0 1 2\n");
  TruePath path = opened(settings);
  Frame frame = frameAt(0, 7);
  path.apply(frame);
  CHECK(frame.T_world_camera_truth.translation() == Eigen::Vector3d(5, 0, 2));
  frame.source_index = 4;
  path.apply(frame);
  CHECK_FALSE(frame.has_truth);

  settings.truth.clear();
  settings.body = "0,0,-1.5";
  path = opened(settings);
  CHECK_FALSE(path.isGiven());
  const Eigen::Isometry3d T_camera_body(Eigen::Translation3d(0, 0, -1.5));
  const Eigen::Isometry3d camera = bodyAt(800);  // seen from the first camera
  frame.has_truth = true;
  frame.T_world_camera_truth = T_camera_body.inverse() * camera * T_camera_body;
  path.apply(frame);
  CHECK(frame.T_world_camera_truth.isApprox(camera, 1e-9));
  settings.body = "0,0";
  CHECK_FALSE(TruePath::open(settings, "").isOk());
  settings.body = "0,0,1";
  settings.truth = folder.write("positions.txt", "1 0 0 0\n2 0 0 1\n");
  CHECK_THAT(TruePath::open(settings, "").status().message(),
             Catch::Contains("has positions alone"));
}
