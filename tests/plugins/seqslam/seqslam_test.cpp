// SPDX-License-Identifier: BSD-3-Clause
// The plugin on walks past random pictures.
#include "walk.hpp"

using namespace tolman;
using namespace tolman::seqslam;
using namespace tolman::seqslam::test;

TEST_CASE("a walk is recognised when it is repeated, by another light, from the tenth image on") {
  Walk walk;
  for (int place = 0; place < 60; ++place) {
    const PlaceObservation seen = walk.see(placePicture(place));
    CHECK(seen.recognition == Recognition::Novel);
    CHECK(seen.template_id == place);
  }
  int right = 0;
  for (int place = 20; place < 50; ++place) {
    const PlaceObservation seen = walk.see(placePicture(place, 7, 0.6));
    if (place < 29) continue;
    right += seen.recognition == Recognition::Familiar && seen.template_id == place ? 1 : 0;
    CHECK(seen.score < 0.4);
    CHECK(seen.relative_yaw == 0);
    CHECK_FALSE(seen.has_relative_pose);
  }
  CHECK(right == 21);
}

TEST_CASE("other places, and the same ones backwards, are not recognised") {
  Walk walk;
  walk.see(0, 60);
  for (int place = 200; place < 240; ++place) {
    CHECK(walk.see(placePicture(place)).recognition == Recognition::Novel);
  }
  for (int place = 59; place >= 0; --place) {
    CHECK(walk.see(placePicture(place, 3)).recognition == Recognition::Novel);
  }
}

TEST_CASE("places of the last images are not recognised, however alike") {
  for (const bool recent : {false, true}) {
    Walk walk({{"recent", std::int64_t{recent ? 100 : 10}}});
    walk.see(0, 60);
    int familiar = 0;
    for (int place = 10; place < 40; ++place) {
      familiar += walk.see(placePicture(place, 1)).recognition == Recognition::Familiar ? 1 : 0;
    }
    CHECK((familiar > 0) == !recent);
  }
}

TEST_CASE("the quotient decides how sure an answer must be") {
  int before = 0;
  for (const double quotient : {0.0, 0.6, 1.0}) {
    Walk walk({{"quotient", quotient}});
    walk.see(0, 30);
    int familiar = 0;
    for (int place = 0; place < 60; ++place) {
      const PlaceObservation seen = walk.see(placePicture(place % 30, std::uint64_t(place)));
      familiar += seen.recognition == Recognition::Familiar ? 1 : 0;
      CHECK((seen.recognition == Recognition::Familiar) ==
            (seen.score <= quotient && seen.score < 1));
    }
    CHECK(familiar >= before);
    before = familiar;
  }
  CHECK(before > 30);
}

TEST_CASE("missing, blank and dark images are no view and do not break a sequence") {
  Walk walk;
  walk.see(0, 60);
  int right = 0;
  for (int place = 20; place < 50; ++place) {
    const PlaceObservation seen = walk.see(placePicture(place, 2));
    right += seen.recognition == Recognition::Familiar && seen.template_id == place ? 1 : 0;
    CHECK(walk.see(Image()).recognition == Recognition::None);
    CHECK(walk.see(tolman::test::gray(128, 64, [](int, int) { return 0; })).template_id == -1);
    CHECK(walk.see(tolman::test::gray(90, 40, [](int, int) { return 200; })).template_id == -1);
  }
  CHECK(right >= 20);
}
