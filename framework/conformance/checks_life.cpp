// SPDX-License-Identifier: BSD-3-Clause
// The life cycle in every legal order, and sound answers in a plain run.
#include <array>

#include "conformance/check.hpp"
#include "conformance/lab.hpp"

namespace tolman::conformance {
namespace {

constexpr std::size_t kFew = 6;  // frames

void checkUnused(Lab& lab) {
  Actor never_configured(lab.specimen());
  lab.demand(never_configured.destroy());
  const auto configured = lab.living(lab.stimulus().rig);
  lab.demand(configured->destroy());
}

void checkNoFrames(Lab& lab) {
  const Stimulus nothing = shortened(lab.stimulus(), 0);
  const auto actor = lab.living(nothing.rig);
  lab.demand(actor->finish(nothing));
  const auto again = lab.living(nothing.rig);
  lab.demand(again->reset());
  lab.demand(again->reset());
  lab.demand(again->finish(nothing));
  lab.demand(again->destroy());
}

void checkCutShort(Lab& lab) {
  const Stimulus few = shortened(lab.stimulus(), kFew);
  const auto actor = lab.living(few.rig);
  lab.demand(actor->run(few));
  lab.demand(actor->destroy(), "destroyed in mid-run");
}

void checkAgain(Lab& lab) {
  const Stimulus few = shortened(lab.stimulus(), kFew);
  const auto actor = lab.living(few.rig);
  for (const char* when : {"first run", "after finish and reset", "after another reset"}) {
    lab.demand(actor->run(few), when);
    lab.demand(actor->finish(few), when);
    lab.demand(actor->reset(), when);
  }
  lab.demand(actor->run(few, 0, 2), "before a reset in mid-run");
  lab.demand(actor->reset(), "reset in mid-run");
  lab.demand(actor->run(few), "after a reset in mid-run");
  lab.demand(actor->destroy());
}

void checkAnswers(Lab& lab) {
  const Stimulus stimulus = lab.stimulus();
  const auto actor = lab.living(stimulus.rig);
  lab.demand(actor->run(stimulus));
  lab.demand(actor->finish(stimulus));
  lab.demand(actor->destroy());
}

/// Asked beyond the end, a source says so again.
void checkEnd(Lab& lab) {
  constexpr int kMost = 200;  // frames
  const Stimulus stimulus = lab.stimulus();
  const auto actor = lab.living(stimulus.rig);
  for (int k = 0; k < kMost && !actor->ended(); ++k) {
    if (lab.spent() > 0.5) break;
    const Status status = actor->work(stimulus.moments.front());
    if (status.code() != StatusCode::EndOfStream) lab.demand(status);
  }
  if (!actor->ended()) lab.skip("the data are longer than the kit reads; choose less with --set");
  const Status beyond = actor->work(stimulus.moments.front());
  if (beyond.code() == StatusCode::EndOfStream) return;
  lab.error("after the end it gives " +
            (beyond.isOk() ? std::string("one more frame") : beyond.message()));
}

constexpr std::array kChecks = {
    Check{"life-unused", 1, kAllRoles, "may be destroyed before and right after configure()",
          "initialise every member; the destructor must not need configure()", &checkUnused},
    Check{"life-no-frames", 1, kAllRoles, "finish() and reset() work without any frame",
          "finish() may come before the first frame", &checkNoFrames},
    Check{"answers", 1, kAllRoles, "exactly one sound answer to each frame of a plain run",
          "see the contract in roles.hpp and records.hpp", &checkAnswers},
    Check{"life-cut-short", 1, kAllRoles, "may be destroyed in mid-run, without finish()",
          "the destructor must release what finish() would", &checkCutShort},
    Check{"life-again", 1, kAllRoles,
          "works again after finish() and reset(), and after reset() in mid-run",
          "reset() puts every member back to where configure() left it", &checkAgain},
    Check{"source-end", 1, kSource,
          "gives as many frames as info() says, then EndOfStream for good",
          "return Status::endOfStream() after the last frame, always", &checkEnd},
};

}  // namespace

std::span<const Check> lifeChecks() { return kChecks; }

}  // namespace tolman::conformance
