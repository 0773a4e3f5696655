// SPDX-License-Identifier: BSD-3-Clause
// The source as the host calls it: frames, truth, parameters, conditions, cameras at an angle.
#include <oneapi/tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "support/context.hpp"
#include "support/data.hpp"
#include "town_source.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::test::TemporaryFolder;
using tolman::test::TestContext;

namespace {

/// KITTI's camera at a fifth of its size, every 60th frame of `block`.
ParameterValues small(ParameterValues more = {}) {
  more.try_emplace("scale", 0.2);
  more.try_emplace("step", std::int64_t{60});
  return more;
}

struct Drive {
  SourceInfo info;
  std::vector<Frame> frames;
};

Drive drive(TownSource& source) {
  Drive result;
  REQUIRE(source.info(result.info).isOk());
  for (;;) {
    Frame frame;
    const Status status = source.next(frame);
    if (status.code() == StatusCode::EndOfStream) return result;
    REQUIRE(status.isOk());
    result.frames.push_back(frame);
  }
}

Drive drive(const ParameterValues& values, std::uint64_t seed = 1) {
  TestContext context(small(values), seed);
  TownSource source;
  const Status status = source.configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  return drive(source);
}

std::vector<std::uint8_t> bytes(const Image& image) {
  return {image.data(), image.data() + image.stride() * image.height()};
}

std::string refusal(const ParameterValues& values) {
  TestContext context(values);
  TownSource source;
  const Status status = source.configure(context);
  REQUIRE_FALSE(status.isOk());
  return std::string(status.message());
}

}  // namespace

TEST_CASE("frames come as announced, with stereo images, rising stamps and truth") {
  const Drive d = drive({});
  CHECK(d.info.rig.width == 248);
  CHECK(d.info.rig.height == 75);
  CHECK(d.info.rig.baseline == 0.5372);
  CHECK(d.info.has_truth);
  REQUIRE(static_cast<std::int64_t>(d.frames.size()) == d.info.frames);
  REQUIRE(d.frames.size() >= 6);
  CHECK(d.frames[0].T_world_camera_truth.isApprox(Eigen::Isometry3d::Identity(), 1e-9));
  for (std::size_t i = 0; i < d.frames.size(); ++i) {
    const Frame& frame = d.frames[i];
    CHECK(frame.frame == static_cast<std::int64_t>(i));
    CHECK(frame.source_index == static_cast<std::int64_t>(60 * i));
    CHECK(frame.stamp_ns == static_cast<std::int64_t>(i) * 6'000'000'000);
    CHECK(frame.left.width() == 248);
    CHECK(frame.right.height() == 75);
    CHECK(bytes(frame.left) != bytes(frame.right));
  }
}

TEST_CASE("the same bytes after reset, for any number of threads; others for another seed") {
  TestContext context(small());
  TownSource source;
  REQUIRE(source.configure(context).isOk());
  const Drive first = drive(source);
  REQUIRE(source.reset().isOk());
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Drive second = drive(source);
  const Drive third = drive({});
  const Drive noise = drive({}, 2);
  const Drive town = drive({{"seed", std::int64_t{9}}});
  REQUIRE(first.frames.size() == second.frames.size());
  for (std::size_t i = 0; i < first.frames.size(); ++i) {
    CHECK(bytes(first.frames[i].left) == bytes(second.frames[i].left));
    CHECK(bytes(first.frames[i].right) == bytes(second.frames[i].right));
    CHECK(bytes(first.frames[i].left) == bytes(third.frames[i].left));
    CHECK(bytes(first.frames[i].left) != bytes(noise.frames[i].left));
    CHECK(bytes(first.frames[i].left) != bytes(town.frames[i].left));
  }
}

TEST_CASE("mono leaves the right camera out, depth comes on demand") {
  const Drive d = drive({{"mono", true}, {"depth", true}});
  CHECK_FALSE(d.info.rig.isStereo());
  CHECK(d.frames[0].right.empty());
  REQUIRE(d.frames[0].sensors.size() == 1);
  const NamedArray& depth = d.frames[0].sensors[0];
  CHECK(depth.name == "depth.left");
  CHECK(depth.shape == std::vector<int>{75, 248});
  REQUIRE(depth.values.size() == 75 * 248);
  // The lowest row looks at the road: 1.65 m below, at a known angle.
  const Pinhole& k = d.info.rig.pinhole;
  CHECK(static_cast<double>(depth.values[74 * 248 + 130]) ==
        Approx(1.65 * k.fy / (74 - k.cy)).epsilon(0.03));
}

TEST_CASE("faults leave gaps in time, and frames without an image") {
  const Drive whole = drive({{"step", std::int64_t{20}}, {"scale", 0.1}});
  const Drive d = drive({{"step", std::int64_t{20}}, {"scale", 0.1}, {"faults", 0.3}});
  CHECK(static_cast<std::int64_t>(d.frames.size()) == d.info.frames);
  CHECK(d.frames.size() < whole.frames.size());
  std::size_t empty = 0;
  for (std::size_t i = 0; i < d.frames.size(); ++i) {
    CHECK(d.frames[i].frame == static_cast<std::int64_t>(i));
    CHECK(d.frames[i].left.empty() == !d.frames[i].defect.empty());
    empty += d.frames[i].left.empty();
  }
  CHECK(empty > 0);
  CHECK(empty < d.frames.size());
}

namespace {

using List = std::vector<double>;

/// Everything that can differ from a sunny morning with exact cameras.
const ParameterValues kTrouble = {
    {"rig_error", List{0.01, 0.05, 0.1, 0.2, 0.3, 30}},
    {"camera_error", 5.0},
    {"exposure_ms", List{30}},
    {"traffic", 60.0},
    {"conditions", std::string("18:00 haze; pass 1 = rain snow bare")}};

}  // namespace

TEST_CASE("each trouble changes the pictures, and neither truth nor calibration") {
  const auto frameOf = [](ParameterValues values) {
    values["noise"] = 0.0;
    values["first"] = values["last"] = std::int64_t{120};
    return drive(values);
  };
  const Drive plain = frameOf({});
  for (const auto& [name, value] : kTrouble) {
    const Drive off = frameOf({{name, value}});
    INFO(name);
    CHECK(bytes(off.frames[0].left) != bytes(plain.frames[0].left));
    CHECK(bytes(off.frames[0].right) != bytes(plain.frames[0].right));
    CHECK(off.info.rig.pinhole.fx == plain.info.rig.pinhole.fx);
    CHECK(off.info.rig.baseline == plain.info.rig.baseline);
    CHECK(off.frames[0].T_world_camera_truth.isApprox(plain.frames[0].T_world_camera_truth, 0));
  }
  const Drive turned = frameOf({{"rig_error", List{0, 0, 0.5}}});
  CHECK(bytes(turned.frames[0].left) == bytes(plain.frames[0].left));
}

TEST_CASE("with all trouble the bytes are the same for any number of threads") {
  const Drive many = drive(kTrouble);
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Drive single = drive(kTrouble);
  for (std::size_t i = 0; i < many.frames.size(); ++i) {
    CHECK(bytes(many.frames[i].left) == bytes(single.frames[i].left));
    CHECK(bytes(many.frames[i].right) == bytes(single.frames[i].right));
  }
}

TEST_CASE("an open shutter blurs the image, and true depth is that at the stamp") {
  const auto frameOf = [](ParameterValues values) {
    values["noise"] = 0.0;
    values["depth"] = true;
    values["traffic"] = 40.0;
    values["first"] = values["last"] = std::int64_t{60};
    return drive(values).frames[0];
  };
  const Frame sharp = frameOf({});
  const Frame blurred = frameOf({{"exposure_ms", List{10}}});
  const Frame limited = frameOf({{"exposure_ms", List{100, 10}}});
  CHECK(bytes(blurred.left) != bytes(sharp.left));
  CHECK(bytes(blurred.left) == bytes(limited.left));
  CHECK(blurred.sensors[0].values == sharp.sensors[0].values);
}

TEST_CASE("amplified images are noisier") {
  const auto spread = [](double longest) {
    const Drive d = drive({{"conditions", std::string("23:00")},
                           {"exposure_ms", List{0.5, longest}},
                           {"last", std::int64_t{0}}});
    const Image& image = d.frames[0].left;
    double sum = 0;  // of differences between neighbours in the sky
    for (int c = 100; c < 140; ++c) sum += std::abs(image.row(2)[c] - image.row(2)[c + 1]);
    return sum;
  };
  CHECK(spread(1) > 1.5 * spread(500));
}

TEST_CASE("conditions change the passes that they name") {
  const ParameterValues still = {{"noise", 0.0}, {"exposure_change", 0.0}};
  const Drive plain = drive(still);
  const std::vector<int> passes = passNumbers(builtInRoute("block", {}).value());
  for (const char* words : {"night", "dusk", "rain", "overcast", "snow"}) {
    ParameterValues values = still;
    values["conditions"] = std::string("pass 2 = ") + words;
    const Drive changed = drive(values);
    for (std::size_t i = 0; i < plain.frames.size(); ++i) {
      INFO(words << " at " << 60 * i);
      const bool same = bytes(changed.frames[i].left) == bytes(plain.frames[i].left);
      if (passes[60 * i] == 2) CHECK_FALSE(same);
      // Lenses have drops, or bloom, on all of a drive with rain or a night.
      const bool has_lens = words == std::string("rain") || words == std::string("night");
      if (passes[60 * i] == 1 && !has_lens) CHECK(same);
    }
  }
}

TEST_CASE("a frame depends on its time only, not on the frames before") {
  ParameterValues values = {{"traffic", 60.0}, {"noise", 0.0}, {"step", std::int64_t{1}}};
  values["first"] = std::int64_t{176};
  values["last"] = std::int64_t{180};
  const Drive after = drive(values);
  values["first"] = std::int64_t{180};
  CHECK(bytes(after.frames.back().left) == bytes(drive(values).frames.back().left));
}

TEST_CASE("what cannot be driven is refused with a remedy") {
  const auto refuses = [](const char* name, ParameterValue value, const char* with) {
    const std::string message = refusal({{name, std::move(value)}});
    INFO(message);
    CHECK(message.find(with) != std::string::npos);
  };
  refuses("route", std::string("moon"), "block, eights");
  refuses("route", std::string("./no/such.txt"), "./no/such.txt");
  refuses("first", std::int64_t{99999}, "choose a smaller one");
  refuses("conditions", std::string("pass 2: night"), "'pass' is no condition");
  refuses("camera", List{100, 100, 90, 90, 50, 50}, "give [width, height");
  refuses("camera", List{20000, 20000, 90, 90, 50, 50, 1}, "8192 x 8192 px at most");
  refuses("mount", List{0}, "from 0.5 to 4 m");
  refuses("rig_error", List{0, 0, 0, 0, 0, 0, 0}, "give at most");
  refuses("exposure_ms", List{}, "give [time]");
}

namespace {

std::vector<Frame> framesOf(ParameterValues values, CameraRig& rig, int count) {
  values.try_emplace("scale", 0.2);
  values.try_emplace("depth", true);
  TestContext context(values);
  TownSource source;
  const Status status = source.configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  rig = info.rig;
  std::vector<Frame> frames(static_cast<std::size_t>(count));
  for (Frame& frame : frames) REQUIRE(source.next(frame).isOk());
  return frames;
}

double depthAt(const Frame& frame, int row, int column) {
  const NamedArray& depth = frame.sensors.at(0);
  return static_cast<double>(depth.values[static_cast<std::size_t>(row * depth.shape[1] + column)]);
}

/// Share of the points of one frame that the other sees at the same place, if it sees there at all.
double agreement(const Frame& from, const Frame& to, const Eigen::Isometry3d& T_to_from,
                 const CameraRig& rig) {
  const Pinhole& k = rig.pinhole;
  int seen = 0;
  int equal = 0;
  for (int row = 0; row < rig.height; ++row) {
    for (int column = 0; column < rig.width; ++column) {
      const double depth = depthAt(from, row, column);
      if (depth <= 0 || depth > 40) continue;
      const Eigen::Vector3d point =
          T_to_from * (depth * Eigen::Vector3d((column - k.cx) / k.fx, (row - k.cy) / k.fy, 1));
      if (point.z() < 1) continue;
      const long u = std::lround(k.fx * point.x() / point.z() + k.cx);
      const long v = std::lround(k.fy * point.y() / point.z() + k.cy);
      if (u < 0 || u >= rig.width || v < 0 || v >= rig.height) continue;
      ++seen;
      const double there = depthAt(to, static_cast<int>(v), static_cast<int>(u));
      if (std::abs(there - point.z()) < 0.05 * point.z()) ++equal;
    }
  }
  CHECK(seen > 1000);
  return static_cast<double>(equal) / seen;
}

/// A way over level ground that rises by 4 m, pitching and rolling, as a KITTI pose file.
std::vector<Eigen::Isometry3d> writeFlight(const std::filesystem::path& file, double rise) {
  std::ofstream stream(file);
  stream.precision(17);
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 60; ++i) {
    Vector6d turn = Vector6d::Zero();
    turn[3] = 0.3 * std::sin(0.3 * i);
    turn[5] = 0.2 * std::sin(0.2 * i);
    poses.push_back(expSe3(turn));
    poses.back().translation() = Eigen::Vector3d(0, -rise * i / 60.0, i);
    const Eigen::Isometry3d& T = poses.back();
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 4; ++c) stream << T.matrix()(r, c) << (r * c == 6 ? '\n' : ' ');
    }
  }
  return poses;
}

}  // namespace

TEST_CASE("a camera mounted at an angle sees the same places, in its own axes") {
  CameraRig rig;
  const Frame level = framesOf({}, rig, 1)[0];
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  Vector6d up = Vector6d::Zero();
  up[3] = radians(-8);
  Vector6d right = Vector6d::Zero();
  right[5] = radians(20);
  const Eigen::Isometry3d T_level_tilted = expSe3(up) * expSe3(right);
  const auto frames = framesOf({{"mount", std::vector<double>{1.65, -8, 20}}}, rig, 2);
  CHECK(agreement(frames[0], level, T_level_tilted, rig) > 0.9);
  CHECK(agreement(level, frames[0], T_level_tilted.inverse(), rig) > 0.9);
  // Truth is that of the camera: it moves along the road, which is not its own z axis.
  const Eigen::Isometry3d moved =
      T_level_tilted * frames[1].T_world_camera_truth * T_level_tilted.inverse();
  const auto straight = framesOf({}, rig, 2);
  CHECK(moved.isApprox(straight[1].T_world_camera_truth, 1e-9));
}

TEST_CASE("a flight has the poses of its file over streets on level ground") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "flight.txt";
  const auto poses = writeFlight(file, 4);
  CameraRig rig;
  const ParameterValues values = {{"route", file.string()}, {"flight", true}};
  const auto frames = framesOf(values, rig, 45);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    CHECK(frames[i].T_world_camera_truth.isApprox(poses[0].inverse() * poses[i], 1e-6));
  }
  const Eigen::Isometry3d T_to_from =
      frames[21].T_world_camera_truth.inverse() * frames[20].T_world_camera_truth;
  CHECK(agreement(frames[20], frames[21], T_to_from, rig) > 0.8);
  // The ground right below is where the height says.
  const Frame& high = frames[30];
  const Eigen::Isometry3d& T = high.T_world_camera_truth;
  const int column = rig.width / 2;
  const int row = rig.height - 1;
  const Eigen::Vector3d seen = T * (depthAt(high, row, column) *
                                    Eigen::Vector3d((column - rig.pinhole.cx) / rig.pinhole.fx,
                                                    (row - rig.pinhole.cy) / rig.pinhole.fy, 1));
  CHECK(seen.y() == Approx(1.65).margin(0.2));
}

TEST_CASE("a flight into the ground is refused") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "flight.txt";
  writeFlight(file, -2);
  TestContext context({{"route", file.string()}, {"flight", true}});
  TownSource source;
  const Status status = source.configure(context);
  CHECK(status.message().find("m above the ground; give mount a larger height") !=
        std::string::npos);
}
