// SPDX-License-Identifier: BSD-3-Clause
// Calls in every legal order, and valid answers in a plain run.
#include <array>

#include "conformance/check.hpp"
#include "conformance/check_context.hpp"

namespace tolman::conformance {
namespace {

constexpr std::size_t kFew = 6;  // frames

void checkUnused(CheckContext& context) {
  TestInstance never_configured(context.plugin());
  context.require(never_configured.destroy());
  const auto configured = context.configured(context.sequence().rig);
  context.require(configured->destroy());
}

void checkNoFrames(CheckContext& context) {
  const InputSequence nothing = shortened(context.sequence(), 0);
  const auto instance = context.configured(nothing.rig);
  context.require(instance->finish(nothing));
  const auto again = context.configured(nothing.rig);
  context.require(again->reset());
  context.require(again->reset());
  context.require(again->finish(nothing));
  context.require(again->destroy());
}

void checkCutShort(CheckContext& context) {
  const InputSequence few = shortened(context.sequence(), kFew);
  const auto instance = context.configured(few.rig);
  context.require(instance->run(few));
  context.require(instance->destroy(), "destroyed during a run");
}

void checkAgain(CheckContext& context) {
  const InputSequence few = shortened(context.sequence(), kFew);
  const auto instance = context.configured(few.rig);
  for (const char* when : {"first run", "after finish and reset", "after another reset"}) {
    context.require(instance->run(few), when);
    context.require(instance->finish(few), when);
    context.require(instance->reset(), when);
  }
  context.require(instance->run(few, 0, 2), "before a reset during a run");
  context.require(instance->reset(), "reset during a run");
  context.require(instance->run(few), "after a reset during a run");
  context.require(instance->destroy());
}

void checkAnswers(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  const auto instance = context.configured(sequence.rig);
  context.require(instance->run(sequence));
  context.require(instance->finish(sequence));
  const Measurement reached = instance->reached();
  if (!reached.name.empty()) context.measured(reached.name, reached.value, reached.unit);
  context.require(instance->destroy());
}

/// After the last frame a source returns EndOfStream at every call.
void checkEnd(CheckContext& context) {
  constexpr int kMaxFrames = 200;
  const InputSequence sequence = context.sequence();
  const auto instance = context.configured(sequence.rig);
  for (int k = 0; k < kMaxFrames && !instance->ended(); ++k) {
    if (context.timeUsed() > 0.5) break;
    const Status status = instance->process(sequence.inputs.front());
    if (status.code() != StatusCode::EndOfStream) context.require(status);
  }
  if (!instance->ended())
    context.skip("the data are longer than the kit reads; select fewer frames with --set");
  const Status beyond = instance->process(sequence.inputs.front());
  if (beyond.code() == StatusCode::EndOfStream) return;
  context.error("after the end it returns " +
                (beyond.isOk() ? std::string("one more frame") : beyond.message()));
}

constexpr std::array kLifeChecks = {
    Check{"life-unused", 1, kAllRoles, "may be destroyed before and right after configure()",
          "initialise every member; the destructor must not need configure()", &checkUnused},
    Check{"life-no-frames", 1, kAllRoles, "finish() and reset() work without any frame",
          "finish() may be called before the first frame", &checkNoFrames},
    Check{"answers", 1, kAllRoles, "exactly one valid answer to each frame of a plain run",
          "see the contract in roles.hpp and records.hpp", &checkAnswers},
    Check{"life-cut-short", 1, kAllRoles, "may be destroyed during a run, without finish()",
          "the destructor must release what finish() would", &checkCutShort},
    Check{"life-again", 1, kAllRoles,
          "works again after finish() and reset(), and after reset() during a run",
          "reset() restores every member to its value after configure()", &checkAgain, true},
    Check{"source-end", 1, kSource, "gives the number of frames of info(), then always EndOfStream",
          "return Status::endOfStream() after the last frame, always", &checkEnd},
};

}  // namespace

std::span<const Check> lifeChecks() { return kLifeChecks; }

}  // namespace tolman::conformance
