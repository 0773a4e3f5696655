// SPDX-License-Identifier: BSD-3-Clause
// Saved state: equal answers after load(), and detection of damage.
#include <array>
#include <map>
#include <sstream>
#include <utility>

#include "conformance/check.hpp"
#include "tolman/context.hpp"

namespace tolman::conformance {
namespace {

/// An instance after the first half of its input, and its saved state.
struct SavedRun {
  InputSequence sequence;
  std::unique_ptr<TestInstance> instance;
  std::size_t middle = 0;
  std::string bytes;
};

SavedRun runAndSave(CheckContext& context) {
  SavedRun run;
  run.sequence = context.sequence();
  run.middle = run.sequence.inputs.size() / 2;
  run.instance = context.configured(run.sequence.rig);
  if (!run.instance->keepsState()) context.skip("it does not implement StateKeeper");
  context.require(run.instance->run(run.sequence, 0, run.middle));
  std::ostringstream stream;
  context.require(run.instance->save(stream));
  run.bytes = stream.str();
  return run;
}

/// An instance that was loaded with what `instance` saved.
std::unique_ptr<TestInstance> restoredFrom(CheckContext& context, TestInstance& instance,
                                           const CameraRig& rig, std::size_t& size) {
  std::stringstream stream;
  context.require(instance.save(stream));
  size = stream.str().size();
  auto restored = context.configured(rig);
  context.require(restored->load(stream));
  restored->continueRun(instance);
  return restored;
}

/// Saves early, half way and late, because a missing part of the state may not affect the answers
/// after one of these frames.
void checkState(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  const auto instance = context.configured(sequence.rig);
  if (!instance->keepsState()) context.skip("it does not implement StateKeeper");
  std::map<std::size_t, std::unique_ptr<TestInstance>> restored;  // by the next frame
  std::size_t next = 0;
  std::size_t size = 0;
  for (const std::size_t tenths : {2U, 5U, 8U}) {
    const std::size_t first = std::exchange(next, tenths * sequence.inputs.size() / 10);
    context.require(instance->run(sequence, first, next));
    restored[next] = restoredFrom(context, *instance, sequence.rig, size);
  }
  context.measured("saved state", static_cast<double>(size) / 1024, "KiB");
  context.require(instance->run(sequence, next), "after save");
  context.require(instance->finish(sequence), "after save");
  for (const auto& [frame, other] : restored) {
    context.require(other->run(sequence, frame), "after save and load");
    context.require(other->finish(sequence), "after save and load");
    if (const auto difference =
            firstDifference(instance->transcript(), other->transcript(), frame)) {
      context.error("saved before frame " + std::to_string(frame) +
                    ", answers after load() differ at " + *difference);
      return;
    }
  }
}

std::vector<std::pair<std::string, std::string>> damagedCopies(const std::string& bytes,
                                                               std::uint64_t seed) {
  std::vector<std::pair<std::string, std::string>> copies = {
      {"empty", ""}, {"unrelated text", "once upon a time"}};
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

void checkDamagedCopy(CheckContext& context, const SavedRun& run, const Transcript& fresh,
                      const std::string& what, const std::string& bytes) {
  context.currentInput("load: " + what);
  std::istringstream stream(bytes);
  const Status status = run.instance->load(stream);
  if (status.isOk()) {
    context.error("load() accepts a damaged state: " + what);
    throw CheckEnded();
  }
  if (status.code() != StatusCode::InvalidInput) {
    context.warning(what + ": the status is not InvalidInput: " + status.message());
  }
  run.instance->beginRun();
  run.instance->clearTranscript();
  context.require(run.instance->run(run.sequence, 0, run.middle), "after a load() that failed");
  if (const auto difference = firstDifference(fresh, run.instance->transcript())) {
    context.error("after a load() that failed (" + what +
                  ") it is not in the state after reset(): " + *difference);
    throw CheckEnded();
  }
}

void checkDamage(CheckContext& context) {
  SavedRun run = runAndSave(context);
  run.sequence = shortened(std::move(run.sequence), run.middle);
  const Transcript fresh = run.instance->transcript();
  if (run.bytes.empty()) context.skip("its saved state is empty");
  for (const auto& [what, bytes] : damagedCopies(run.bytes, context.task().seed)) {
    if (context.timeUsed() > 0.6) break;
    checkDamagedCopy(context, run, fresh, what, bytes);
  }
}

constexpr std::array kStateChecks = {
    Check{"state", 2, kAllRoles, "after save() and load() all later answers are bitwise equal",
          "save everything that later answers depend on, random streams included", &checkState},
    Check{"state-damaged", 2, kAllRoles,
          "load() of damaged bytes fails and leaves the instance as after reset()",
          "StateWriter and StateReader detect damage before a value is used", &checkDamage},
};

}  // namespace

std::span<const Check> stateChecks() { return kStateChecks; }

}  // namespace tolman::conformance
