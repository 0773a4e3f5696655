// SPDX-License-Identifier: BSD-3-Clause
// Gaps: tracking restarts at an unknown pose. Also saved maps with arbitrary bytes.
#include <sstream>

#include "chain_arrangement.hpp"
#include "map_fixture.hpp"
#include "tolman/state_stream.hpp"

using namespace tolman;
using namespace tolman::experience_map;

namespace {

/// Tracking restarts at an unknown pose; the cells create an experience.
void restartTracking(Fixture& f) {
  Motion motion = f.motion(Eigen::Isometry3d::Identity());
  motion.state = TrackingState::Initialising;
  f.feed(motion, f.decision(Action::CreateExperience, f.created++));
}

/// A street along z with an experience every 5 m, and the same street again from 20 m on, seen from
/// a session without the map of the first one.
void streetTwice(Fixture& f) {
  for (int i = 0; i < 11; ++i) f.create(step(i == 0 ? 0 : 5));
  restartTracking(f);
  for (int i = 0; i < 4; ++i) f.create(step(5));
}

std::string bytesOf(const Fixture& f) {
  std::ostringstream stream;
  REQUIRE(f.map.save(stream).isOk());
  return stream.str();
}

Status loadInto(Fixture& f, const std::string& bytes) {
  std::istringstream stream(bytes);
  return f.map.load(stream);
}

/// As if the rest of the run were the same.
void resume(Fixture& f, const Fixture& old) {
  f.frame = old.frame;
  f.created = old.created;
  f.current = old.current;
}

}  // namespace

TEST_CASE("parts are joined with the earliest, and through each other") {
  PathParts parts({0, 10, 20, 30});
  CHECK(parts.of(9) == 0);
  CHECK(parts.of(10) == 1);
  CHECK(parts.of(99) == 3);
  parts.join(3, 2);
  CHECK(parts.first(3) == 2);
  CHECK_FALSE(parts.joined(0, 3));
  parts.join(2, 0);
  CHECK(parts.joined(0, 3));
  CHECK(parts.first(1) == 1);
}

TEST_CASE("no link leads over a gap, and frames before and after have poses") {
  Fixture f;
  streetTwice(f);
  REQUIRE(f.map.finish({}).isOk());
  const MapGraph graph = f.graph();
  CHECK(graph.experiences.size() == 16);
  CHECK(graph.links.size() == 14);
  for (const Link& link : graph.links) CHECK((link.from < 11) == (link.to < 11));
  CHECK(f.poseOf(11).translation().z() == Approx(50));  // as if it began where the other ended
}

TEST_CASE("the first measured loop lays the new part onto the old one") {
  Fixture f;
  streetTwice(f);
  // 20 m on in the second street is 1 m behind experience 8, at 40 m, seen turned by half a turn.
  f.closeMeasured(step(5), 8, fromPlanar({-1, 0, 3.0}));
  const Eigen::Isometry3d T_expected = fromPlanar({39, 0, 3.0});
  CHECK(difference(f.poseOf(16), T_expected) < 1e-6);
  REQUIRE(f.map.finish({}).isOk());
  CHECK(difference(f.poseOf(16), T_expected) < 1e-3);
  const Eigen::Isometry3d T_woken = T_expected * fromPlanar({25, 0, 0}).inverse();
  CHECK(difference(f.poseOf(11), T_woken) < 1e-3);
  CHECK(distance(f.poseOf(10), fromPlanar({50, 0, 0})) < 1e-3);  // the old part did not move
}

TEST_CASE("a false loop joins two parts wrongly until true ones outweigh it") {
  Fixture f;
  streetTwice(f);
  f.closeMeasured(step(5), 2, fromPlanar({0, 0, 1.0}));  // a look-alike
  for (int i = 0; i < 6; ++i) {
    f.create(step(2));
    f.closeMeasured(step(3), 3 + i, fromPlanar({0.5, 0, 0}));
  }
  REQUIRE(f.map.finish({}).isOk());
  const Eigen::Isometry3d T_true = fromPlanar({15.5, 0, 0});
  CHECK(distance(f.poseOf(18), T_true) < 0.1);
  const MapGraph graph = f.graph();
  REQUIRE(graph.rejected.size() == 1);
  for (const Link& link : graph.links) CHECK((link.weight < 0.1) == graph.isRejected(link));
}

TEST_CASE("a part may join a part that has joined") {
  Fixture f;
  streetTwice(f);
  restartTracking(f);  // third part
  f.create(step(5));
  f.closeMeasured(step(5), 12, fromPlanar({0, 0, 0.5}));  // with the second
  f.create(step(5));
  f.closeMeasured(step(5), 4, fromPlanar({0, 2, -0.5}));  // and with the first
  REQUIRE(f.map.finish({}).isOk());
  CHECK(distance(f.poseOf(f.frame - 1), fromPlanar({20, 2, 0})) < 0.05);
}

TEST_CASE("a loaded map goes on as the saved one, over a gap too") {
  Fixture saved;
  streetTwice(saved);
  saved.closeMeasured(step(5), 8, fromPlanar({-1, 0, 0.1}));
  Fixture loaded;
  REQUIRE(loadInto(loaded, bytesOf(saved)).isOk());
  resume(loaded, saved);
  for (Fixture* f : {&saved, &loaded}) {
    restartTracking(*f);
    f->create(step(5));
    f->closeMeasured(step(5), 3, fromPlanar({0.3, 0.1, 0}));
    f->close(step(5), 4);
    REQUIRE(f->map.finish({}).isOk());
  }
  for (std::int64_t k = 0; k < saved.frame; ++k) {
    CHECK(saved.poseOf(k).matrix() == loaded.poseOf(k).matrix());
  }
  CHECK(saved.graph().links.size() == loaded.graph().links.size());
}
