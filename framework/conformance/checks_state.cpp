// SPDX-License-Identifier: BSD-3-Clause
// Saved state: the same future after load(), and damage that is found.
#include <array>
#include <sstream>

#include "conformance/check.hpp"
#include "conformance/lab.hpp"
#include "tolman/context.hpp"

namespace tolman::conformance {
namespace {

/// The first half of a run, and what was saved after it.
struct Half {
  Stimulus stimulus;
  std::unique_ptr<Actor> actor;
  std::size_t middle = 0;
  std::string bytes;
};

Half runHalf(Lab& lab) {
  Half half;
  half.stimulus = lab.stimulus();
  half.middle = half.stimulus.moments.size() / 2;
  half.actor = lab.living(half.stimulus.rig);
  if (!half.actor->keepsState()) lab.skip("it is no StateKeeper");
  lab.demand(half.actor->run(half.stimulus, 0, half.middle));
  std::ostringstream stream;
  lab.demand(half.actor->save(stream));
  half.bytes = stream.str();
  return half;
}

void checkState(Lab& lab) {
  Half half = runHalf(lab);
  const auto heir = lab.living(half.stimulus.rig);
  std::istringstream stream(half.bytes);
  lab.demand(heir->load(stream));
  heir->resume(*half.actor);
  half.actor->forget();
  for (Actor* actor : {half.actor.get(), heir.get()}) {
    lab.demand(actor->run(half.stimulus, half.middle), "after save and load");
    lab.demand(actor->finish(half.stimulus), "after save and load");
  }
  const auto difference = firstDifference(half.actor->transcript(), heir->transcript());
  if (difference) lab.error("the future after load() differs at " + *difference);
  lab.figure("saved state", static_cast<double>(half.bytes.size()) / 1024, "KiB");
}

std::vector<std::pair<std::string, std::string>> damagedCopies(const std::string& bytes,
                                                               std::uint64_t seed) {
  std::vector<std::pair<std::string, std::string>> copies = {{"nothing at all", ""},
                                                             {"foreign text", "once upon a time"}};
  for (const double share : {0.1, 0.5, 0.9}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    copies.emplace_back("cut off after " + std::to_string(size) + " bytes", bytes.substr(0, size));
  }
  copies.emplace_back("the last byte missing", bytes.substr(0, bytes.size() - 1));
  RandomStream random(seed);
  for (int i = 0; i < 16; ++i) {
    const std::size_t at = random.below(bytes.size());
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << random.below(8)));
    copies.emplace_back("one bit of byte " + std::to_string(at) + " flipped", std::move(flipped));
  }
  return copies;
}

void checkOneDamage(Lab& lab, const Half& half, const Transcript& fresh, const std::string& what,
                    const std::string& bytes) {
  lab.topic("load: " + what);
  std::istringstream stream(bytes);
  const Status status = half.actor->load(stream);
  if (status.isOk()) {
    lab.error("load() takes a damaged state: " + what);
    throw Stop();
  }
  if (status.code() != StatusCode::InvalidInput) {
    lab.warning(what + ": the failure is no InvalidInput: " + status.message());
  }
  half.actor->startAfresh();
  half.actor->forget();
  lab.demand(half.actor->run(half.stimulus, 0, half.middle), "after a load() that failed");
  if (const auto difference = firstDifference(fresh, half.actor->transcript())) {
    lab.error("after a load() that failed (" + what +
              ") it is not as after reset(): " + *difference);
    throw Stop();
  }
}

void checkDamage(Lab& lab) {
  Half half = runHalf(lab);
  half.stimulus = shortened(std::move(half.stimulus), half.middle);
  const Transcript fresh = half.actor->transcript();
  if (half.bytes.empty()) lab.skip("it saves nothing");
  for (const auto& [what, bytes] : damagedCopies(half.bytes, lab.options().seed)) {
    if (lab.spent() > 0.6) break;
    checkOneDamage(lab, half, fresh, what, bytes);
  }
}

constexpr std::array kChecks = {
    Check{"state", 2, kAllRoles, "after save() and load() the future is the same, bit by bit",
          "save all that decides the future, random streams too", &checkState},
    Check{"state-damaged", 2, kAllRoles,
          "load() of damaged bytes fails and leaves a reset instance",
          "StateWriter and StateReader find damage before any number is used", &checkDamage},
};

}  // namespace

std::span<const Check> stateChecks() { return kChecks; }

}  // namespace tolman::conformance
