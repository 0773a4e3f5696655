// SPDX-License-Identifier: BSD-3-Clause
// The source as the host calls it: frames, truth, parameters, disturbances.
#include "town_source.hpp"

#include <oneapi/tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "support/context.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::town;
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
  std::vector<Finding> findings;
  REQUIRE(source.inspect(findings).isOk());  // explains the failure
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == status.message());
  return std::string(status.message());
}

}  // namespace

TEST_CASE("an inspection tells the way of the camera, in a hall too") {
  TestContext context({{"scale", 0.2}, {"route", std::string("hall")}});
  TownSource source;
  REQUIRE(source.configure(context).isOk());
  std::vector<Finding> findings;
  REQUIRE(source.inspect(findings).isOk());
  REQUIRE_FALSE(findings.empty());
  double metres = 0;
  std::istringstream(findings[0].message.substr(findings[0].message.find("over ") + 5)) >> metres;
  CHECK(metres == Approx(52).margin(6));  // as of the walk itself, hall_test.cpp
}

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

TEST_CASE("without noise and light changes a place seen again looks the same") {
  // block ends where it began, on the same lane; the nearest later pose is centimetres away.
  const ParameterValues quiet = {{"noise", 0.0},
                                 {"exposure_change", 0.0},
                                 {"step", std::int64_t{1}},
                                 {"last", std::int64_t{0}}};
  const Drive start = drive(quiet);
  TestContext context(small({{"step", std::int64_t{1}}, {"scale", 0.1}}));
  TownSource scout;
  REQUIRE(scout.configure(context).isOk());
  const Drive all = drive(scout);
  std::int64_t best = 0;
  double nearest = 1e9;
  for (const Frame& frame : all.frames) {
    const double distance = frame.T_world_camera_truth.translation().norm();
    if (frame.frame > 200 && distance < nearest) {
      nearest = distance;
      best = frame.frame;
    }
  }
  REQUIRE(nearest < 0.6);
  ParameterValues again = quiet;
  again["first"] = again["last"] = best;
  const Drive back = drive(again);
  const auto a = bytes(start.frames[0].left);
  const auto b = bytes(back.frames[0].left);
  double mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean += std::abs(int(a[i]) - int(b[i]));
  mean /= static_cast<double>(a.size());
  const Drive elsewhere = drive({{"noise", 0.0}, {"first", best / 2}, {"last", best / 2}});
  const auto c = bytes(elsewhere.frames[0].left);
  double other = 0;
  for (std::size_t i = 0; i < a.size(); ++i) other += std::abs(int(a[i]) - int(c[i]));
  other /= static_cast<double>(a.size());
  INFO("mean difference " << mean << " grey levels, elsewhere " << other);
  CHECK(mean < 0.5 * other);
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

TEST_CASE("dropped frames leave gaps in time, corrupt ones arrive without an image") {
  const Drive whole = drive({{"step", std::int64_t{20}}, {"scale", 0.1}});
  const Drive d =
      drive({{"step", std::int64_t{20}}, {"scale", 0.1}, {"dropped", 0.3}, {"corrupt", 0.3}});
  CHECK(static_cast<std::int64_t>(d.frames.size()) == d.info.frames);
  CHECK(d.frames.size() < whole.frames.size());
  std::size_t corrupt = 0;
  for (std::size_t i = 0; i < d.frames.size(); ++i) {
    CHECK(d.frames[i].frame == static_cast<std::int64_t>(i));
    CHECK(d.frames[i].left.empty() == !d.frames[i].defect.empty());
    corrupt += d.frames[i].left.empty();
  }
  CHECK(corrupt > 0);
  CHECK(corrupt < d.frames.size());
}

TEST_CASE("each kind of trouble changes the pictures that it should") {
  const auto frameOf = [](ParameterValues values) {
    values["noise"] = 0.0;
    values["last"] = std::int64_t{0};
    return drive(values).frames[0];
  };
  const Frame plain = frameOf({});
  for (const auto& [name, value] :
       ParameterValues{{"baseline_error", 0.1}, {"rotation_error", 0.5}}) {
    const Frame off = frameOf({{name, value}});
    CHECK(bytes(off.left) == bytes(plain.left));
    CHECK(bytes(off.right) != bytes(plain.right));
  }
  for (const auto& [name, value] : ParameterValues{{"motion_blur", 0.5},
                                                   {"weather", std::string("fog")},
                                                   {"weather", std::string("overcast")},
                                                   {"hour", 18.0},
                                                   {"haze", 0.02},
                                                   {"vignetting", 0.6},
                                                   {"density", 0.0}}) {
    INFO(name);
    CHECK(bytes(frameOf({{name, value}}).left) != bytes(plain.left));
  }
}

TEST_CASE("motion blur is that of an exposure of the same time, and true depth that at the stamp") {
  const auto frameOf = [](ParameterValues values) {
    values["noise"] = 0.0;
    values["depth"] = true;
    values["traffic"] = 40.0;
    values["first"] = values["last"] = std::int64_t{60};
    return drive(values).frames[0];
  };
  const Frame sharp = frameOf({});
  const Frame blurred = frameOf({{"motion_blur", 0.1}});
  const Frame exposed =
      frameOf({{"exposure_time_ms", 100.0}, {"exposure_time_max_ms", 10.0}});  // at 10 Hz
  CHECK(bytes(blurred.left) != bytes(sharp.left));
  CHECK(bytes(blurred.left) == bytes(exposed.left));
  CHECK(bytes(blurred.right) == bytes(exposed.right));
  CHECK(blurred.sensors[0].values == sharp.sensors[0].values);
  CHECK(blurred.T_world_camera_truth.isApprox(sharp.T_world_camera_truth, 0));
}

namespace {

using List = std::vector<double>;

/// Everything that cameras can do, at once.
const ParameterValues kBadCameras = {{"warp_rms_px", 2.0},
                                     {"focal_length_error", List{0.01, -0.01}},
                                     {"principal_point_error_px", List{4, 0, 0, -4}},
                                     {"right_rotation_error_deg", List{0.1, 0.2, 0.3}},
                                     {"readout_time_ms", 30.0},
                                     {"exposure_time_ms", 3.0},
                                     {"exposure_time_max_ms", 20.0},
                                     {"motion_blur", 0.2},
                                     {"gain", List{1.2, 0.8}},
                                     {"gamma", List{0.8, 1.2}},
                                     {"vignetting_error", List{0.1, 0.3}},
                                     {"bloom", 0.05},
                                     {"dirt", 0.1},
                                     {"drops", 20.0},
                                     {"jpeg_quality", std::int64_t{60}},
                                     {"conditions", std::string("all = night rain; pass 2 = day "
                                                                "snow bare exchanged")}};

}  // namespace

TEST_CASE("each disturbance of the cameras changes the pictures, and the truth never") {
  const auto frameOf = [](ParameterValues values) {
    values["noise"] = 0.0;
    values["first"] = values["last"] = std::int64_t{120};
    return drive(values);
  };
  const Drive plain = frameOf({{"hour", 19.0}});
  for (const auto& [name, value] : kBadCameras) {
    ParameterValues values = {{"hour", 19.0}, {name, value}};
    if (name == "exposure_time_max_ms") values["exposure_time_ms"] = 3.0;
    const Drive off = frameOf(values);
    INFO(name);
    CHECK(bytes(off.frames[0].right) != bytes(plain.frames[0].right));
    const bool right_only = name == "right_rotation_error_deg";
    CHECK((bytes(off.frames[0].left) == bytes(plain.frames[0].left)) == right_only);
    CHECK(off.info.rig.pinhole.fx == plain.info.rig.pinhole.fx);
    CHECK(off.info.rig.baseline == plain.info.rig.baseline);
    CHECK(off.frames[0].T_world_camera_truth.isApprox(plain.frames[0].T_world_camera_truth, 0));
  }
}

TEST_CASE("with all disturbances the bytes are the same for any number of threads") {
  const Drive many = drive(kBadCameras);
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Drive single = drive(kBadCameras);
  REQUIRE(many.frames.size() == single.frames.size());
  for (std::size_t i = 0; i < many.frames.size(); ++i) {
    CHECK(bytes(many.frames[i].left) == bytes(single.frames[i].left));
    CHECK(bytes(many.frames[i].right) == bytes(single.frames[i].right));
  }
  ParameterValues other = kBadCameras;
  other["camera_seed"] = std::int64_t{2};
  CHECK(bytes(drive(other).frames[0].left) != bytes(many.frames[0].left));
}

TEST_CASE("amplified images are noisier") {
  const auto spread = [](double longest) {
    const Drive d = drive({{"hour", 23.0},
                           {"exposure_time_ms", 0.5},
                           {"exposure_time_max_ms", longest},
                           {"last", std::int64_t{0}}});
    const Image& image = d.frames[0].left;
    double sum = 0;  // of differences between neighbours in the sky
    for (int c = 100; c < 140; ++c) sum += std::abs(image.row(2)[c] - image.row(2)[c + 1]);
    return sum;
  };
  CHECK(spread(1) > 1.5 * spread(500));
}

TEST_CASE("conditions change the frames that they name, and the truth of none") {
  const ParameterValues still = {{"noise", 0.0}, {"exposure_change", 0.0}};
  const Drive plain = drive(still);
  const CameraRoute route = builtInRoute("block", {}).value();
  for (const char* words : {"night", "dusk", "rain", "fog", "snow", "bare", "exchanged"}) {
    ParameterValues values = still;
    values["conditions"] = std::string("100-200 m = ") + words;
    const Drive changed = drive(values);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < plain.frames.size(); ++i) {
      const double s =
          changed.frames[i].T_world_camera_truth.isApprox(plain.frames[i].T_world_camera_truth, 0)
              ? drivenMetres(route)[60 * i]
              : -1;
      INFO(words << " after " << s << " m");
      const bool same = bytes(changed.frames[i].left) == bytes(plain.frames[i].left);
      if (s < 90 || s > 210) CHECK(same);
      differing += same ? 0 : 1;
    }
    // On block few cars are parked, and none in sight of these frames.
    if (words != std::string("exchanged")) CHECK(differing >= 1);
  }
  CHECK(refusal({{"conditions", std::string("pass 2: night")}}).find("write 'pass 2 ='") !=
        std::string::npos);
}

TEST_CASE("oncoming cars move") {
  const ParameterValues busy = {{"traffic", 60.0}, {"noise", 0.0}, {"exposure_change", 0.0}};
  const ParameterValues empty = {{"noise", 0.0}, {"exposure_change", 0.0}};
  const Drive with = drive(busy);
  const Drive without = drive(empty);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < with.frames.size(); ++i) {
    differing += bytes(with.frames[i].left) != bytes(without.frames[i].left);
  }
  CHECK(differing >= with.frames.size() / 2);
}

namespace {

/// Everything that moves and mirrors.
const ParameterValues kLife = {{"pedestrians", 80.0},       {"cyclists", 30.0}, {"wind", 9.0},
                               {"crossing_traffic", 1.0},   {"glass", 1.0},     {"puddles", 1.0},
                               {"traffic_headlights", true}};

}  // namespace

TEST_CASE("each kind of life in the street changes pictures, and the truth never") {
  ParameterValues base = {{"noise", 0.0},
                          {"exposure_change", 0.0},
                          {"traffic", 60.0},
                          {"route", std::string("district")},
                          {"step", std::int64_t{120}}};
  const auto differing = [&](const Drive& a, const Drive& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.frames.size(); ++i) {
      count += bytes(a.frames[i].left) != bytes(b.frames[i].left);
      CHECK(a.frames[i].T_world_camera_truth.isApprox(b.frames[i].T_world_camera_truth, 0));
    }
    return count;
  };
  const Drive plain = drive(base);
  for (const auto& [name, value] : kLife) {
    ParameterValues values = base;
    values[name] = value;
    INFO(name);
    if (name == "traffic_headlights") {
      CHECK(differing(drive(values), plain) == 0);  // by day lamps are off
      values["conditions"] = base["conditions"] = std::string("all = night");
      CHECK(differing(drive(values), drive(base)) > 0);
      base.erase("conditions");
    } else {
      CHECK(differing(drive(values), plain) > 0);
    }
  }
}

TEST_CASE("what moves depends on the time only, not on frames before, nor on threads") {
  ParameterValues values = kLife;
  values["conditions"] = std::string("150-300 m = night bare");
  const Drive whole = drive(values);
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Drive single = drive(values);
  for (std::size_t i = 0; i < whole.frames.size(); ++i) {
    CHECK(bytes(whole.frames[i].left) == bytes(single.frames[i].left));
  }
  values["noise"] = 0.0;
  values["step"] = std::int64_t{1};
  values["first"] = std::int64_t{176};
  values["last"] = std::int64_t{180};
  const Drive after = drive(values);
  values["first"] = std::int64_t{180};
  const Drive alone = drive(values);
  // Noise is that of the exposure's number, so it is off here.
  CHECK(bytes(after.frames.back().left) == bytes(alone.frames.back().left));
}

TEST_CASE("backward and pingpong turn the drive round with rising stamps") {
  const Drive there = drive({{"order", std::string("pingpong")}, {"scale", 0.1}});
  for (std::size_t i = 1; i < there.frames.size(); ++i) {
    CHECK(there.frames[i].stamp_ns > there.frames[i - 1].stamp_ns);
  }
  CHECK(there.frames.front().source_index == there.frames.back().source_index);
  const Drive back = drive({{"order", std::string("backward")}, {"scale", 0.1}});
  CHECK(back.frames.back().source_index == 0);
}

TEST_CASE("what cannot be driven is refused with a remedy") {
  CHECK(refusal({{"route", std::string("moon")}}).find("block, eights") != std::string::npos);
  CHECK(refusal({{"route", std::string("./no/such.txt")}}).find("./no/such.txt") !=
        std::string::npos);
  CHECK(refusal({{"first", std::int64_t{99999}}}).find("choose a smaller one") !=
        std::string::npos);
  CHECK(refusal({{"scale", 0.05}, {"height", std::int64_t{100}}}) ==
        "scale leaves an image below 32 px; choose a larger one");
  CHECK(refusal({{"width", std::int64_t{8192}}, {"height", std::int64_t{8192}}, {"scale", 4.0}}) ==
        "scale makes images of 32768 x 32768 px, and 8192 x 8192 px are rendered at most; choose a "
        "smaller width, height or scale");
  CHECK(refusal({{"gamma", std::vector<double>{1, 1, 1}}}) ==
        "gamma has 3 values; give 2: [left, right]");
}

TEST_CASE("real routes of KITTI render whole", "[data]") {
  for (const char* name : {"00", "05", "06", "07"}) {
    const auto file = tolman::test::dataOrSkip(std::string("kitti_poses/") + name + ".txt");
    if (!file) return;
    const Drive d = drive({{"route", file->string()}, {"step", std::int64_t{97}}, {"scale", 0.1}});
    CHECK(d.frames.size() >= 11);
    for (const Frame& frame : d.frames) REQUIRE_FALSE(frame.left.empty());
  }
}
