// SPDX-License-Identifier: BSD-3-Clause
// The same input gives the same answers, bit by bit: again, after reset(), with other threads.
#include <oneapi/tbb/global_control.h>

#include <array>
#include <thread>

#include "conformance/check.hpp"
#include "conformance/lab.hpp"

namespace tolman::conformance {
namespace {

Transcript live(Lab& lab, Actor& actor, const Stimulus& stimulus) {
  lab.demand(actor.run(stimulus));
  lab.demand(actor.finish(stimulus));
  return actor.transcript();
}

void compare(const Lab& lab, const Transcript& expected, const Transcript& found,
             const std::string& what) {
  if (const auto difference = firstDifference(expected, found)) {
    lab.error(what + " differs at " + *difference);
  }
}

/// Both alive at once, so that they lie at different addresses; later, so that clocks differ.
void checkDeterministic(Lab& lab) {
  const Stimulus stimulus = lab.stimulus();
  const auto first = lab.living(stimulus.rig);
  const auto second = lab.living(stimulus.rig);
  const Transcript expected = live(lab, *first, stimulus);
  compare(lab, expected, live(lab, *second, stimulus), "a second instance");
}

void checkInterleaved(Lab& lab) {
  const Stimulus stimulus = lab.stimulus();
  const auto alone = lab.living(stimulus.rig);
  const Transcript expected = live(lab, *alone, stimulus);
  const auto first = lab.living(stimulus.rig);
  const auto second = lab.living(stimulus.rig);
  for (std::size_t i = 0; i < stimulus.moments.size(); ++i) {
    lab.demand(first->run(stimulus, i, i + 1));
    lab.demand(second->run(stimulus, i, i + 1));
  }
  lab.demand(first->finish(stimulus));
  lab.demand(second->finish(stimulus));
  compare(lab, expected, first->transcript(), "an instance beside another");
  compare(lab, expected, second->transcript(), "an instance beside another");
}

void checkReset(Lab& lab) {
  const Stimulus stimulus = lab.stimulus();
  const auto actor = lab.living(stimulus.rig);
  const Transcript expected = live(lab, *actor, stimulus);
  lab.demand(actor->reset());
  actor->forget();
  compare(lab, expected, live(lab, *actor, stimulus), "a run after finish() and reset()");
  lab.demand(actor->reset());
  lab.demand(actor->run(stimulus, 0, stimulus.moments.size() / 2));
  lab.demand(actor->reset());
  actor->forget();
  compare(lab, expected, live(lab, *actor, stimulus), "a run after reset() in mid-run");
}

void checkThreads(Lab& lab) {
  const Stimulus stimulus = lab.stimulus();
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return live(lab, *lab.living(stimulus.rig), stimulus);
  };
  const Transcript expected = with(1);
  compare(lab, expected, with(4), "a run with 4 threads instead of 1");
  compare(lab, expected, with(3), "a run with 3 threads instead of 1");
}

/// The host calls one after the other, but not always from the same thread.
void checkMigration(Lab& lab) {
  const Stimulus stimulus = lab.stimulus();
  const Transcript expected = live(lab, *lab.living(stimulus.rig), stimulus);
  const auto wanderer = lab.living(stimulus.rig);
  for (std::size_t i = 0; i < stimulus.moments.size(); ++i) {
    Status status;
    std::thread([&] { status = wanderer->run(stimulus, i, i + 1); }).join();
    lab.demand(status, "called from another thread");
  }
  lab.demand(wanderer->finish(stimulus));
  compare(lab, expected, wanderer->transcript(), "a run that changes its thread");
}

void checkPadding(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  const Transcript expected = live(lab, *lab.living(stimulus.rig), stimulus);
  padRows(stimulus);
  compare(lab, expected, live(lab, *lab.living(stimulus.rig), stimulus),
          "a run with padded image rows");
}

constexpr std::array kChecks = {
    Check{"deterministic", 2, kAllRoles,
          "two instances with equal seed and input answer alike, bit by bit",
          "depend on input, parameters and context.seed alone: no clock, address, uninitialised "
          "memory",
          &checkDeterministic},
    Check{"interleaved", 2, kAllRoles, "two instances side by side do not disturb each other",
          "keep no state outside of the instance: no statics, no globals", &checkInterleaved},
    Check{"reset", 2, kAllRoles, "after reset() an instance answers like a fresh one, bit by bit",
          "reset() puts every member back to where configure() left it, random streams too",
          &checkReset},
    Check{"padded-rows", 2, kSeeing, "the stride of an image does not matter",
          "step from row to row with image.row(r) or image.stride()", &checkPadding},
    Check{"threads", 3, kAllRoles, "the number of threads does not matter, bit by bit",
          "sum in a fixed order: tbb::parallel_deterministic_reduce, or slots by index",
          &checkThreads},
    Check{"migration", 3, kAllRoles, "calls may come from different threads",
          "keep no state in thread-local variables", &checkMigration},
};

}  // namespace

std::span<const Check> repeatChecks() { return kChecks; }

}  // namespace tolman::conformance
