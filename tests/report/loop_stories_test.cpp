// SPDX-License-Identifier: BSD-3-Clause
// Why loops were closed or missed, as text, on a small record.
#include <catch2/catch.hpp>

#include "report/run_data.hpp"

using namespace tolman;
using namespace tolman::report;

namespace {

/// 100 frames, a metre each; views are new up to frame 50.
LoopRecord walk() {
  LoopRecord record;
  for (std::int64_t i = 0; i < 100; ++i) {
    PlaceObservation place;
    place.frame = i;
    if (i < 50) {
      place.recognition = Recognition::Novel;
      place.template_id = i;
    }
    record.places.push_back(place);
    record.decisions.emplace_back().frame = i;
    evaluation::TrajectoryPose pose;
    pose.frame = i;
    pose.T_world_camera.translation().z() = static_cast<double>(i);
    record.odometry.push_back(pose);
  }
  return record;
}

void addCandidate(LoopRecord& record, std::size_t frame, std::int64_t id, double score) {
  Candidate& candidate = record.places[frame].candidates.emplace_back();
  candidate.template_id = id;
  candidate.score = score;
  candidate.limit = 0.1;
  candidate.agreeing = 14;
  candidate.compared = 40;
  candidate.needed = 18;
}

void addChange(LoopRecord& record, std::size_t frame, std::int64_t id, Fate fate, double share,
               std::int64_t views, double unsupported) {
  record.decisions[frame].hypotheses.push_back(
      {id, fate, 3, 0, 0, share, 0.98, views, unsupported});
}

void makeFamiliar(LoopRecord& record, std::size_t frame, std::int64_t id) {
  record.places[frame].recognition = Recognition::Familiar;
  record.places[frame].template_id = id;
}

/// A kept link at 70, a rejected one at 75, a hypothesis that dies, and a view that is not
/// recognised.
LoopRecord fourStories() {
  LoopRecord record = walk();
  makeFamiliar(record, 70, 10);
  addChange(record, 70, 0, Fate::Accepted, 0.991, 1, 0);
  record.loops.push_back({0, 70, 10, false, 1.25, 10.5, 0.14, 0.9, true});
  makeFamiliar(record, 75, 12);
  addChange(record, 75, 1, Fate::Accepted, 0.985, 2, 0);
  record.loops.push_back({1, 75, 12, true, 14, 31.0, std::nullopt, std::nullopt, false});
  makeFamiliar(record, 80, 20);
  addChange(record, 80, 2, Fate::Born, 0.4, 1, 0);
  makeFamiliar(record, 81, 20);
  addChange(record, 81, 2, Fate::Grew, 0.62, 2, 1);
  addChange(record, 93, 2, Fate::Faded, 0.0003, 2, 12);
  makeFamiliar(record, 71, 11);
  addChange(record, 71, 3, Fate::Accepted, 0.99, 1, 0);  // no link
  makeFamiliar(record, 85, 25);
  addChange(record, 85, 4, Fate::Born, 1e-9, 1, 0);  // never near
  addCandidate(record, 95, 30, 0.29);
  addCandidate(record, 96, 30, 0.25);   // the same story, nearer to the limit
  addCandidate(record, 55, 45, 0.105);  // on the path just driven
  return record;
}

}  // namespace

TEST_CASE("stories of loops: kept, rejected, not accepted, not recognised") {
  const auto stories = storiesOf(fourStories());
  REQUIRE(stories.size() == 4);
  CHECK(stories[0].text() ==
        "Frame 70 closes a loop to frame 10. Place recognition found it familiar. The cells' "
        "hypothesis reached a share of 0.991 (needs 0.98) after 1 view and was accepted at frame "
        "70. The finished map is 1.2 standard deviations from the link. By the true poses it is "
        "right: its measured pose is 0.14 m off, 0.9 of its standard deviations; its ends are 10.5 "
        "m apart.");
  CHECK(stories[1].text() ==
        "Frame 75 closed a loop to frame 12, which the map rejected. Place recognition found it "
        "familiar. The cells' hypothesis reached a share of 0.985 (needs 0.98) after 2 views and "
        "was accepted at frame 75. The finished map is 14.0 standard deviations from the link, too "
        "far for its robust loss. By the true poses it is FALSE: its ends are 31.0 m apart.");
  CHECK(stories[2].text() ==
        "Frame 81 was not closed to frame 20. Place recognition found it familiar. The cells' "
        "hypothesis reached a share of 0.620 (needs 0.98) after 2 views and died at frame 93, 12 m "
        "after its last view.");
  CHECK(stories[3].text() ==
        "Frame 96 was not closed to frame 30. Place recognition gave no answer: its best candidate "
        "has a score of 0.25 (at most 0.1 is familiar), 14 of 40 landmarks agree (needs 18).");
  CHECK(stories[3].cells() == std::vector<std::string>{"96", "30", "not recognised", "0.25 (0.1)",
                                                       "14 (18)", "–", "–", "–", "–"});
  CHECK(stories[0].cells().size() == storyHeadings().size());
  CHECK(stories[1].json()["link"]["true"] == false);
  CHECK(stories[2].json()["hypothesis"]["fate"] == "faded");
}

TEST_CASE("every frame has its story, also where nothing happened") {
  const LoopRecord record = fourStories();
  CHECK(storyOf(record, 60)->text() ==
        "Frame 60 closes no loop, and none was near. Place recognition gave no answer.");
  CHECK(
      storyOf(record, 71)
          ->text()
          .starts_with("Frame 71 returned to frame 11; a link so near the last one was not due. "));
  CHECK(storyOf(record, 80)->ending == Ending::Undecided);
  CHECK(storyOf(record, 80)->hypothesis->best.share == 0.62);
  CHECK(storyOf(record, 70)->ending == Ending::Kept);
  CHECK_FALSE(storyOf(record, 100));
}

TEST_CASE("two views stand side by side; without one there is no picture") {
  const std::vector<std::uint8_t> grey(12, 128);
  const Image view(grey.data(), 4, 3, 4, PixelFormat::Gray8, nullptr);
  LoopStory story;
  story.frame = 7;
  story.earlier = 3;
  const std::string svg = pairFigure(story, view, view);
  CHECK(svg.find(">frame 3<") < svg.find(">frame 7<"));
  CHECK(svg.find("data:image/png") != std::string::npos);
  CHECK(pairFigure(story, view, {}).empty());
}
