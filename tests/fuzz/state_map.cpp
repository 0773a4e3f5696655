// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the saved state of `experience_map`, and frames after it that create an experience,
// close a loop and stay.
#include "experience_map.hpp"
#include "small_plugins.hpp"
#include "state.hpp"

namespace {

using namespace tolman;

void drive(Map& map, std::int64_t first, std::int64_t experiences) {
  for (std::int64_t i = 0; i < 3; ++i) {
    const Motion motion = fuzz::straightMotion(first + i);
    Decision decision;
    decision.frame = motion.frame;
    decision.stamp_ns = motion.stamp_ns;
    decision.action = i == 0 ? Action::CreateExperience : i == 1 ? Action::CloseLoop : Action::Stay;
    decision.experience = i == 0 ? experiences : 0;
    MapUpdate update;
    const Status status = map.update(motion, decision, update);
    fuzz::checkAnswer(status, update);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::Small<experience_map::ExperienceMap> map({});
  if (!fuzz::loadState(map.plugin, "TLMEXMAP", 4, {data, size}).isOk()) return 0;
  fuzz::checkSaved(map.plugin);
  MapGraph graph;
  fuzz::require(map.plugin.graph(graph).isOk(), "no graph of an accepted state");
  drive(map.plugin, std::int64_t{1} << 61, static_cast<std::int64_t>(graph.experiences.size()));
  (void)map.plugin.finish({});
  graph = {};
  fuzz::checkAnswer(map.plugin.graph(graph), graph);
  return 0;
}
