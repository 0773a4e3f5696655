// SPDX-License-Identifier: BSD-3-Clause
// The plugin: answers, passes, yaw, arrays, determinism.
#include "view_sequences.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tour.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

Image blank(int level) {
  return tolman::test::gray(kPictureWidth, kPictureHeight, [&](int, int) { return level; });
}

/// Grey on the left, blocks on the right.
Image halfPicture() {
  const Image whole = placePicture(77);
  return tolman::test::gray(kPictureWidth, kPictureHeight, [&](int x, int y) {
    return x < kPictureWidth / 2 ? 90 : whole.row(y)[x];
  });
}

/// How many of the places 0 to count - 1 are recognised as themselves or their neighbours.
int recognised(Tour& tour, int count, bool starts, int moved_left = 0) {
  int right = 0;
  for (int place = 0; place < count; ++place) {
    const auto seen = tour.drive(placePicture(place, 7, moved_left), 1, starts && place == 0);
    right += seen.recognition == Recognition::Familiar && std::abs(seen.template_id - place) <= 1;
  }
  return right;
}

}  // namespace

TEST_CASE("each step stores a view with the next id; frames between are not looked at") {
  Tour tour;
  for (int i = 0; i < 60; ++i) {
    const PlaceObservation seen = tour.drive(placePicture(i / 4), 0.25, i == 0);
    CAPTURE(i);
    CHECK((seen.recognition == Recognition::Novel) == (i % 4 == 0));
    if (i % 4 == 0) CHECK(seen.template_id == i / 4);
    CHECK_FALSE(seen.has_relative_pose);
    CHECK(seen.relative_yaw == 0);
  }
}

TEST_CASE("standing still is no news") {
  Tour tour;
  tour.drive(placePicture(0), 0, true);
  for (int i = 0; i < 30; ++i) {
    CHECK(tour.drive(placePicture(i), 0).recognition == Recognition::None);
  }
  CHECK(tour.drive(placePicture(1), 1).template_id == 1);
}

TEST_CASE("an empty or blank picture is no observation; the next one is taken instead") {
  for (const Image& unusable : {Image(), blank(0), blank(128), blank(255)}) {
    Tour tour;
    for (int i = 0; i < 3; ++i) {
      CHECK(tour.drive(unusable, 0, i == 0).recognition == Recognition::None);
    }
    CHECK(tour.drive(placePicture(0), 0).template_id == 0);  // it still begins the pass
    CHECK(tour.drive(unusable, 1).recognition == Recognition::None);
    CHECK(tour.drive(placePicture(1), 0.1).template_id == 1);
    CHECK(tour.drive(placePicture(2), 0.5).recognition == Recognition::None);
  }
}

TEST_CASE("a second lap is familiar, a new street after it is not") {
  Tour tour(bold());
  for (int lap = 0; lap < 2; ++lap) {
    int familiar = 0;
    for (int place = 0; place < 80; ++place) {
      const auto seen = tour.drive(placePicture(place, lap), 1, lap == 0 && place == 0);
      REQUIRE(seen.recognition != Recognition::None);
      CHECK(seen.score >= 0);
      CHECK(seen.score <= 1);
      if (seen.recognition != Recognition::Familiar) continue;
      ++familiar;
      CHECK(std::abs(seen.template_id - place) <= 1);
      CHECK(seen.score <= 0.4);  // 1 - probability
    }
    CHECK(familiar >= lap * 65);
    CHECK(familiar <= lap * 80);
  }
  int familiar = 0;
  for (int place = 500; place < 560; ++place) {
    familiar += tour.drive(placePicture(place), 1).recognition == Recognition::Familiar ? 1 : 0;
  }
  CHECK(familiar <= 15);  // the costs of the lap return to 0
}

TEST_CASE("views of the last metres are not familiar, unless odometry restarted in between") {
  for (const bool restarts : {true, false}) {
    Tour tour(bold({{"recent", 70.0}}));
    for (int place = 0; place < 60; ++place) tour.drive(placePicture(place), 1, place == 0);
    const int right = recognised(tour, 60, restarts);
    if (restarts) {
      CHECK(right >= 45);
    } else {
      CHECK(right <= 1);
    }
  }
}

TEST_CASE("a restart resets the costs, not the views") {
  Tour tour(bold());
  for (int place = 0; place < 80; ++place) tour.drive(placePicture(place), 1, place == 0);
  CHECK(recognised(tour, 40, true) >= 28);
  // Carried to the far end: found there, from the views alone.
  int right = 0;
  for (int place = 50; place < 80; ++place) {
    const auto seen = tour.drive(placePicture(place, 9), 1, place == 50);
    right += seen.recognition == Recognition::Familiar && std::abs(seen.template_id - place) <= 1;
  }
  CHECK(right >= 18);
}

TEST_CASE("yaw is positive to the left, in the camera's own angles", "[figures]") {
  CameraRig calibrated;
  calibrated.width = kPictureWidth;
  calibrated.height = kPictureHeight;
  calibrated.calibrated = true;
  calibrated.pinhole = {200, 200, 0.5 * kPictureWidth, 0.5 * kPictureHeight};
  const double of_view = 0.5 * kPictureWidth / std::tan(30 * std::numbers::pi / 180);
  const std::pair<CameraRig, double> rigs[] = {{calibrated, 200.0}, {CameraRig{}, of_view}};
  for (const auto& [rig, focal] : rigs) {
    for (const int cells : {-2, -1, 0, 1, 2}) {
      Tour tour(bold({{"field_of_view", 60.0}}), rig);
      for (int place = 0; place < 60; ++place) tour.drive(placePicture(place), 1, place == 0);
      double sum = 0;
      int count = 0;
      for (int place = 0; place < 60; ++place) {
        const Image picture = placePicture(place, 3, cells * kPictureCell);
        const auto seen = tour.drive(picture, 1, place == 0);
        if (seen.recognition != Recognition::Familiar) continue;
        sum += seen.relative_yaw;
        ++count;
      }
      CAPTURE(focal, cells);
      REQUIRE(count > 30);
      CHECK(sum / count == Approx(-std::atan(cells * kPictureCell / focal)).margin(0.012));
    }
  }
}

TEST_CASE("after reset the same drive gives the same answers, bit by bit") {
  Tour tour(bold());
  const auto answers = [&] {
    tour.continueAt(0);
    std::vector<double> all;
    for (int i = 0; i < 120; ++i) {
      const auto seen = tour.drive(placePicture(i % 60, std::uint64_t(i)), 0.7, i == 0 || i == 75);
      all.insert(all.end(), {double(seen.template_id), seen.score, seen.relative_yaw});
    }
    return all;
  };
  const std::vector<double> first = answers();
  REQUIRE(tour.plugin().reset().isOk());
  CHECK(answers() == first);
}

TEST_CASE("codes instead of all views find the same places") {
  Tour all(bold());
  Tour by_codes(bold({{"exhaustive", std::int64_t{0}}}));
  int alike = 0;
  for (int i = 0; i < 300; ++i) {
    const Image picture = placePicture(i % 150, std::uint64_t(i));
    const auto a = all.drive(picture, 1, i == 0 || i == 150);
    const auto b = by_codes.drive(picture, 1, i == 0 || i == 150);
    alike += i >= 150 && a.recognition == Recognition::Familiar &&
             b.recognition == Recognition::Familiar && a.template_id == b.template_id;
  }
  CHECK(alike >= 120);
}

TEST_CASE("arrays have one shape from the start, and show the view and its template") {
  Tour tour(bold());
  std::vector<ArrayInfo> described;
  REQUIRE(tour.plugin().describe(described).isOk());
  REQUIRE(described.size() == 2);
  const auto arrays = [&] {
    std::vector<NamedArray> all;
    tour.plugin().arrays(all);
    REQUIRE(all.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(all[i].name == described[i].name);
      CHECK(all[i].shape == std::vector<int>{kRows, kColumns});
      CHECK(all[i].values.size() == kRows * kColumns);
      CHECK(described[i].axes.size() == 2);
      for (const float value : all[i].values) REQUIRE((value >= 0 && value <= 1));
    }
    return all;
  };
  CHECK(arrays()[0].values == std::vector<float>(kRows * kColumns, 0.0F));
  tour.drive(placePicture(0), 0, true);
  const auto first = arrays();
  CHECK(first[0].values == first[1].values);  // just stored
  for (int place = 1; place < 60; ++place) tour.drive(placePicture(place), 1);
  for (int place = 0; place < 30; ++place) tour.drive(placePicture(place), 1);
  const auto seen = tour.drive(placePicture(30), 1);
  REQUIRE(seen.recognition == Recognition::Familiar);
  REQUIRE(seen.template_id == 30);
  const auto familiar = arrays();
  CHECK(familiar[0].name == "view.current");
  CHECK(familiar[1].name == "view.template");
  CHECK(familiar[0].values == familiar[1].values);  // the same picture
  // Left and right are not exchanged: edges on the right half only.
  tour.drive(halfPicture(), 1);
  const auto half = arrays()[0].values;
  CHECK(half[0] == 0);
  CHECK(half[kColumns - 2] > 0.05);
}

TEST_CASE("without a motion the input is refused") {
  Tour tour;
  Frame frame;
  PlaceObservation seen;
  const Status status = tour.plugin().observe(frame, nullptr, seen);
  CHECK(status.code() == StatusCode::InvalidInput);
  CHECK(status.message() == "view_sequences needs the motion");
  CHECK(tour.plugin().input() == PlaceInput::FrameAndMotion);
}

TEST_CASE("a source without images: a warning that no place will be recognised") {
  const Tour tour;
  REQUIRE(tour.log().size() == 1);
  CHECK(tour.log().front() == "the source has no images, so no place will be recognised");
}

TEST_CASE("landmarks without a stereo pair: a warning with the remedy, and recognition as ever") {
  CameraRig one_camera;
  one_camera.width = 640;
  one_camera.height = 480;
  Tour tour(bold({{"landmarks", std::int64_t{300}}}), one_camera);
  REQUIRE(tour.log().size() == 1);
  CHECK(tour.log().front() ==
        "landmarks need a calibrated stereo pair; places are recognised by appearance alone: set "
        "landmarks to 0");
  for (int place = 0; place < 60; ++place) tour.drive(placePicture(place), 1, place == 0);
  CHECK(recognised(tour, 60, true) >= 45);
}
