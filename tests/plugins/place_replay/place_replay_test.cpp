// SPDX-License-Identifier: BSD-3-Clause
// Replayed candidates: templates dense from 0, recognised ones with the right offset.
#include "place_replay.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "support/context.hpp"

using namespace tolman;
using namespace tolman::place_replay;
using tolman::test::TestContext;

namespace {

struct Replay {
  explicit Replay(const ParameterValues& values = {{"relative_pose", true}}) : context(values) {
    REQUIRE(place.configure(context).isOk());
  }
  /// Drives 1 m forward to the next frame and looks; `alike` are rows of place.candidate.
  PlaceObservation look(const std::vector<float>& alike = {}, bool looked = false) {
    Frame frame;
    frame.frame = frame.source_index = next++;
    if (looked) frame.sensors.push_back({"place.looked", {1}, {1}});
    frame.sensors.push_back({"place.candidate", {static_cast<int>(alike.size() / 4), 4}, alike});
    if (drive > 0) frame.sensors.push_back({"motion.drive", {1}, {drive}});
    Motion motion;
    motion.state = TrackingState::Tracking;
    motion.T_previous_current = fromPlanar({1, 0, 0});
    PlaceObservation observation;
    REQUIRE(place.observe(frame, &motion, observation).isOk());
    return observation;
  }

  TestContext context;
  PlaceReplay place;
  std::int64_t next = 0;
  float drive = 0;  ///< none is told
};

}  // namespace

TEST_CASE("every fifth view makes a template, the others say nothing") {
  Replay replay;
  for (int i = 0; i < 20; ++i) {
    const PlaceObservation seen = replay.look();
    CHECK(seen.frame == i);
    CHECK(seen.recognition == (i % 5 == 0 ? Recognition::Novel : Recognition::None));
    CHECK(seen.template_id == (i % 5 == 0 ? i / 5 : -1));
  }
}

TEST_CASE("where the source knows that the detector looked it did, and looks go on from there") {
  Replay replay;
  for (int i = 0; i < 20; ++i) {
    const bool looked = i == 7;  // not among 0, 5, 10
    const bool makes = i == 0 || i == 5 || i == 7 || i == 12 || i == 17;
    CHECK((replay.look({}, looked).recognition == Recognition::Novel) == makes);
  }
  const PlaceObservation seen = replay.look({7, 0, 0, 0});
  CHECK(seen.recognition == Recognition::Familiar);
  CHECK(seen.template_id == 2);
}

TEST_CASE("a candidate is its template seen again, with the offset turned round") {
  Replay replay;
  for (int i = 0; i < 10; ++i) replay.look();
  // From frame 10, the earlier frame 5 lies 2 m ahead: we are 2 m behind its template.
  const PlaceObservation seen = replay.look({5, 2, 0, 0});
  CHECK(seen.recognition == Recognition::Familiar);
  CHECK(seen.template_id == 1);
  REQUIRE(seen.has_relative_pose);
  CHECK(toPlanar(seen.T_template_current).x == Approx(-2));
  CHECK(toPlanar(seen.T_template_current).y == Approx(0).margin(1e-9));
  CHECK(seen.relative_yaw == Approx(0).margin(1e-9));
}

TEST_CASE("a recognised view makes its own template a frame later, and can be recognised") {
  Replay replay;
  for (int i = 0; i < 10; ++i) replay.look();
  CHECK(replay.look({5, 0, 0, 0}).recognition == Recognition::Familiar);  // frame 10
  const PlaceObservation own = replay.look();                             // frame 11
  CHECK(own.recognition == Recognition::Novel);
  CHECK(own.template_id == 2);
  for (int i = 12; i < 15; ++i) replay.look();
  // Frame 15 is where frame 10 was; the template was made 1 m ahead of that.
  const PlaceObservation again = replay.look({10, 0, 0, 0});
  CHECK(again.template_id == 2);
  CHECK(toPlanar(again.T_template_current).x == Approx(-1));
}

TEST_CASE("candidates whose view is not known are passed over") {
  Replay replay;
  CHECK(replay.look({99, 0, 0, 0}).recognition == Recognition::Novel);
  for (int i = 1; i < 5; ++i) replay.look();
  CHECK(replay.look({99, 0, 0, 0, 0, 0, 0, 0}).template_id == 0);
}

TEST_CASE("candidates that are lost because their view was left out are told once") {
  Replay replay;
  replay.look();
  replay.next = 10;  // the source passed by the frames 1 to 9
  replay.look({0, 0, 0, 0, 5, 0, 0, 0});
  CHECK(replay.context.log.empty());  // one of two is enough
  CHECK(replay.look({5, 0, 0, 0}).recognition == Recognition::Novel);
  replay.look({6, 0, 0, 0});
  CHECK(replay.context.log ==
        std::vector<std::string>{
            "image 11 resembles image 5, of which this run has no view (left out by the source's "
            "first or step, or dropped): such candidates are lost, this is the first"});
}

TEST_CASE("the offset is kept back unless asked for") {
  Replay replay(ParameterValues{});
  replay.look();
  CHECK_FALSE(replay.look({0, 1, 0, 0}).has_relative_pose);
}

TEST_CASE("reset forgets every template") {
  Replay replay;
  replay.look();
  REQUIRE(replay.place.reset().isOk());
  replay.next = 0;
  CHECK(replay.look({0, 0, 0, 0}).template_id == 0);
}

TEST_CASE("candidates can be dropped and look-alikes invented, by the seed") {
  const auto answers = [](const ParameterValues& values) {
    Replay replay(values);
    std::vector<std::int64_t> seen;
    for (int i = 0; i < 1000; ++i) {
      const float earlier = static_cast<float>(5 * (i / 100));
      const bool alike = i > 200 && i % 10 == 0;
      const PlaceObservation observation = alike ? replay.look({earlier, 1, 0, 0}) : replay.look();
      if (observation.recognition != Recognition::Familiar) continue;
      seen.push_back(i);
      if (i % 10 == 0 && alike) continue;
      CHECK(observation.template_id <= i - 100);               // invented ones are old
      CHECK(toPlanar(observation.T_template_current).x <= 0);  // a late template lies ahead
    }
    return seen;
  };
  const std::size_t all = answers({{"relative_pose", true}}).size();
  CHECK(all == 79);
  const std::size_t few = answers({{"relative_pose", true}, {"kept", 0.25}}).size();
  CHECK(few > 8);
  CHECK(few < 35);
  const ParameterValues lying = {
      {"relative_pose", true}, {"invented", 0.3}, {"invented_age", std::int64_t{100}}};
  const auto lies = answers(lying);
  CHECK(lies.size() > all + 180);
  CHECK(lies.size() < all + 320);
  CHECK(lies == answers(lying));
}

TEST_CASE("look-alikes can come in runs that follow an earlier path") {
  Replay replay({{"relative_pose", true},
                 {"view_step", std::int64_t{1}},
                 {"invented", 0.02},
                 {"invented_run", std::int64_t{20}}});
  std::vector<std::int64_t> frames;
  std::vector<std::int64_t> templates;
  for (int i = 0; i < 3000; ++i) {
    const PlaceObservation seen = replay.look();
    if (seen.recognition != Recognition::Familiar) continue;
    frames.push_back(i);
    templates.push_back(seen.template_id);
  }
  CHECK(frames.size() > 200);  // about one run of ten views in sixty frames
  CHECK(frames.size() < 1000);
  int following = 0;
  for (std::size_t k = 1; k < frames.size(); ++k) {
    following += frames[k] == frames[k - 1] + 1 && templates[k] == templates[k - 1] + 1 ? 1 : 0;
  }
  CHECK(following > 8 * static_cast<int>(frames.size()) / 10);
}

TEST_CASE("saved views are recognised in the next session, and the random stream goes on") {
  const ParameterValues values = {{"relative_pose", true},
                                  {"kept", 0.5},
                                  {"invented", 0.5},
                                  {"invented_run", GENERATE(as<std::int64_t>(), 1, 30)}};
  Replay saved(values);
  for (int i = 0; i < 203; ++i)
    saved.look(i > 20 && i % 5 == 0 ? std::vector<float>{10, 2, 0, 0} : std::vector<float>{});
  std::stringstream stream;
  REQUIRE(saved.place.save(stream).isOk());
  Replay loaded(values);
  REQUIRE(loaded.place.load(stream).isOk());
  loaded.next = saved.next;
  for (int i = 0; i < 100; ++i) {
    const PlaceObservation a = saved.look({10, 1, 0, 0});
    const PlaceObservation b = loaded.look({10, 1, 0, 0});
    CHECK(a.recognition == b.recognition);
    CHECK(a.template_id == b.template_id);
    CHECK(a.T_template_current.matrix() == b.T_template_current.matrix());
  }
}

TEST_CASE("views of another drive are forgotten, those of the same are not") {
  Replay saved;
  saved.drive = 7;
  for (int i = 0; i < 30; ++i) saved.look();
  std::stringstream stream;
  REQUIRE(saved.place.save(stream).isOk());
  for (const float drive : {7.0F, 0.0F, 8.0F}) {
    Replay loaded;
    stream.clear();
    stream.seekg(0);
    REQUIRE(loaded.place.load(stream).isOk());
    loaded.drive = drive;
    const PlaceObservation first = loaded.look({10, 0, 0, 0});
    CHECK((first.recognition == Recognition::Familiar) == (drive != 8));
    CHECK(first.template_id == (drive != 8 ? 2 : 6));  // templates go on from those saved
    CHECK(loaded.context.log.size() == (drive != 8 ? 0U : 1U));
  }
}

TEST_CASE("damaged views are refused and leave a fresh instance") {
  Replay saved;
  for (int i = 0; i < 30; ++i) saved.look();
  std::ostringstream stream;
  REQUIRE(saved.place.save(stream).isOk());
  const auto with = [](std::int64_t random_word) {
    StateWriter writer;  // four words, templates, drive, last look, owed, run, views
    for (int i = 0; i < 5; ++i) writer.put(i < 4 ? random_word : 0);
    writer.put(-1.0F);
    for (int i = 0; i < 5; ++i) writer.put(std::int64_t{0});
    std::ostringstream bytes;
    REQUIRE(writer.write(bytes, "TLMPLRPL", 4).isOk());
    return bytes.str();
  };
  Replay sound;
  std::istringstream whole(with(1));
  REQUIRE(sound.place.load(whole).isOk());
  const std::string zeros = with(0);  // a random stream of zeros would give zeros for ever
  for (const std::string& bytes : {std::string("nothing"), stream.str().substr(0, 100), zeros}) {
    Replay replay;
    std::istringstream damaged(bytes);
    CHECK(replay.place.load(damaged).code() == StatusCode::InvalidInput);
    CHECK(replay.look().template_id == 0);
  }
}
