// SPDX-License-Identifier: BSD-3-Clause
// Calls in every legal order, valid answers in a plain run, repeated runs, saved state, and side
// effects on the process.
#include <oneapi/tbb/global_control.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include "conformance/check.hpp"
#include "conformance/test_instance.hpp"
#include "tolman/context.hpp"

namespace tolman::conformance {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kFew = 6;  // frames

void checkUnused(CheckContext& context) {
  const auto never_configured = TestInstance::make(context.plugin());
  context.require(never_configured->destroy());
  const InputSequence nothing = shortened(context.sequence(), 0);
  const auto configured = context.configured(nothing.rig);
  context.require(configured->destroy());
  const auto finished = context.configured(nothing.rig);
  context.require(finished->finish(nothing));
  const auto again = context.configured(nothing.rig);
  context.require(again->reset());
  context.require(again->reset());
  context.require(again->finish(nothing));
  context.require(again->destroy());
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
  if (!instance->reached().name.empty()) {
    context.note(std::to_string(instance->reached().count) + " " + instance->reached().name);
  }
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

// Equal input gives bitwise equal answers: in a second instance, after reset(), with other threads.

Transcript answersOf(CheckContext& context, TestInstance& instance, const InputSequence& sequence) {
  context.require(instance.run(sequence));
  context.require(instance.finish(sequence));
  return instance.transcript();
}

void compare(const CheckContext& context, const Transcript& expected, const Transcript& found,
             const std::string& what) {
  if (const auto difference = firstDifference(expected, found)) {
    context.error(what + " differs at " + *difference);
  }
}

/// The instances exist at the same time, at different addresses, and run one after the other, at
/// different times; then two alternately.
void checkDeterministic(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  std::array<std::unique_ptr<TestInstance>, 4> instances;
  for (auto& instance : instances) instance = context.configured(sequence.rig);
  const auto& [first, second, third, fourth] = instances;
  const Transcript expected = answersOf(context, *first, sequence);
  compare(context, expected, answersOf(context, *second, sequence), "a second instance");
  for (std::size_t i = 0; i < sequence.inputs.size(); ++i) {
    context.require(third->run(sequence, i, i + 1));
    context.require(fourth->run(sequence, i, i + 1));
  }
  for (const auto* one : {&third, &fourth}) {
    context.require((*one)->finish(sequence));
    compare(context, expected, (*one)->transcript(), "an instance that alternates with another");
  }
}

void checkReset(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  const auto instance = context.configured(sequence.rig);
  const Transcript expected = answersOf(context, *instance, sequence);
  context.require(instance->reset());
  instance->clearTranscript();
  compare(context, expected, answersOf(context, *instance, sequence),
          "a run after finish() and reset()");
  // State that reset() does not clear can be without effect after the same drive, because it has
  // the same values. So reset() is also tested after another drive.
  const auto elsewhere = context.configured(sequence.rig);
  context.require(elsewhere->run(context.otherSequence()), "another drive");
  context.require(elsewhere->reset());
  elsewhere->clearTranscript();
  compare(context, expected, answersOf(context, *elsewhere, sequence),
          "a run after reset() during another drive");
}

/// The host makes one call at a time, but not always from the same thread.
void checkThreads(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return context.runOnce(sequence);
  };
  const Transcript expected = with(1);
  compare(context, expected, with(4), "a run with 4 threads instead of 1");
  compare(context, expected, with(3), "a run with 3 threads instead of 1");
  const auto instance = context.configured(sequence.rig);
  for (std::size_t i = 0; i < sequence.inputs.size(); ++i) {
    Status status;
    std::thread([&] { status = instance->run(sequence, i, i + 1); }).join();
    context.require(status, "called from another thread");
  }
  context.require(instance->finish(sequence));
  compare(context, expected, instance->transcript(), "a run with calls from several threads");
}

void checkPadding(CheckContext& context) {
  InputSequence sequence = context.sequence();
  const Transcript expected = context.runOnce(sequence);
  padRows(sequence);
  compare(context, expected, context.runOnce(sequence), "a run with padded image rows");
}

/// An instance that was loaded with what `instance` saved.
std::unique_ptr<TestInstance> restoredFrom(CheckContext& context, TestInstance& instance,
                                           const CameraRig& rig) {
  auto restored = context.configured(rig);
  const Result<std::string> saved = instance.save();
  context.require(saved.status());
  context.require(restored->load(saved.value()));
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
  for (const std::size_t tenths : {2U, 5U, 8U}) {
    const std::size_t first = std::exchange(next, tenths * sequence.inputs.size() / 10);
    context.require(instance->run(sequence, first, next));
    restored[next] = restoredFrom(context, *instance, sequence.rig);
  }
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

/// Two passes in the saved map of one: no answer may say that it has grown, nor may its size.
void checkLocaliser(CheckContext& context) {
  constexpr std::size_t kRounding = 16384;  // bytes that depend on the place, not on time
  const InputSequence sequence = context.sequence();
  if (!context.manifest().hasExtra("localise")) context.skip("it does not declare Localiser");
  const auto learned = context.configured(sequence.rig);
  context.require(learned->run(sequence));
  const Result<std::string> map = learned->save();
  context.require(map.status());
  const auto instance = TestInstance::make(context.completePlugin());
  context.require(instance->configure(sequence.rig, true));
  context.require(instance->load(map.value()));
  instance->continueRun(*learned);
  for (int pass = 0; pass < 2; ++pass) {
    context.require(instance->run(sequence), "in a map that stays as it is");
  }
  const Result<std::string> after = instance->save();
  context.require(after.status());
  const std::size_t grown = after.value().size();
  if (grown <= map.value().size() + kRounding) return;
  context.error("its state grew from " + std::to_string(map.value().size()) + " to " +
                std::to_string(grown) + " bytes while it localised");
}

// Side effects of a plugin on its process: global state, output, threads, files.

/// What the host does not restore (KeptState), by name.
std::map<std::string, std::string> processState() {
  std::error_code error;
  std::map<std::string, std::string> state = {
      {"working directory", fs::current_path(error).string()}};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    state["environment variable " + text.substr(0, text.find('='))] = text;
  }
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) != 0) continue;
    state["handler of signal " + std::to_string(number)] =
        std::to_string(reinterpret_cast<std::uintptr_t>(action.sa_handler));
  }
  return state;
}

/// Number of threads. Waits up to 0.5 s for it to fall to `expected`.
std::size_t threadCount(std::size_t expected) {
  using namespace std::chrono_literals;
  std::size_t count = 0;
  for (int i = 0; i < 50; ++i) {
    const fs::directory_iterator tasks("/proc/self/task");
    count = static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
    if (count <= expected) break;
    std::this_thread::sleep_for(10ms);
  }
  return count;
}

/// The target of each open file descriptor.
std::map<int, std::string> openFiles() {
  std::map<int, std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    const std::string target = fs::read_symlink(entry.path(), error).string();
    const bool is_this_list = target.starts_with("/proc/") && target.ends_with("/fd");
    if (!error && !is_this_list) files[std::stoi(entry.path().filename())] = target;
  }
  return files;
}

/// What this process has written to stdout and stderr.
std::string outputOf(const CheckContext& context) {
  std::cout.flush();
  std::fflush(nullptr);
  std::ifstream file(context.task().folder / kOutputFile);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The state at the end equals that before the library was opened. The interpreter of a program is
/// the host's own, and writes the stack at a fault: it is opened first.
void checkGlobals(CheckContext& context) {
  if (!context.manifest().program.empty()) (void)context.plugin();
  const std::size_t written = outputOf(context).size();
  const auto before = processState();
  const InputSequence sequence = context.sequence();
  const auto instance = context.configured(sequence.rig);
  context.require(instance->run(sequence));
  context.require(instance->finish(sequence));
  context.require(instance->destroy());
  std::map<std::string, std::string> changed;
  std::ranges::set_symmetric_difference(before, processState(),
                                        std::inserter(changed, changed.end()));
  for (const auto& [name, text] : changed) context.error(name + " was changed");
  std::set<std::string> restored = context.plugin().loaded.changed;
  restored.insert(instance->changed().begin(), instance->changed().end());
  for (const std::string& name : restored)
    context.error(name + " was changed; the host restored it");
  const std::string output = outputOf(context).substr(written, 200);
  if (!output.empty()) context.error("wrote to stdout or stderr: '" + output + "'");
}

/// The first instance may create pools and caches that stay; the second must release all that it
/// acquires. oneTBB gets no workers, so every other thread is the plugin's own.
void checkLeaks(CheckContext& context) {
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const InputSequence sequence = shortened(context.sequence(), 8);
  const std::size_t at_first = threadCount(1);
  context.runOnce(sequence);
  const std::size_t before = threadCount(at_first);
  const std::map<int, std::string> files_before = openFiles();
  const auto instance = context.configured(sequence.rig);
  context.require(instance->run(sequence));
  context.require(instance->finish(sequence));
  const std::size_t after_finish = threadCount(before);
  context.require(instance->destroy());
  const std::size_t after = threadCount(before);
  if (after > before) {
    context.error(
        "left a thread running: " + std::to_string(after - before) + " more with each instance",
        "join threads in finish() and in the destructor");
  } else if (after_finish > before) {
    context.error("a thread still runs after finish()", "join threads in finish()");
  }
  for (const auto& [descriptor, target] : openFiles()) {
    if (!files_before.contains(descriptor)) context.error("left a file open: " + target);
  }
}

constexpr std::array kLifeChecks = {
    Check{"life-unused", 1, kAllRoles,
          "may be destroyed before and right after configure(); finish() and reset() work without "
          "any frame",
          "initialise every member; the destructor must not need configure(), nor finish() a frame",
          &checkUnused},
    Check{"answers", 1, kAllRoles, "exactly one valid answer to each frame of a plain run",
          "see the contract in roles.hpp and records.hpp", &checkAnswers},
    Check{
        "life-again", 1, kAllRoles,
        "works again after finish() and reset(), and after reset() during a run; may be destroyed "
        "without finish()",
        "reset() restores every member to its value after configure()", &checkAgain, true},
    Check{"source-end", 1, kSource, "gives the number of frames of info(), then always EndOfStream",
          "return Status::endOfStream() after the last frame, always", &checkEnd},
    Check{"deterministic", 2, kAllRoles,
          "instances with equal seed and input give bitwise equal answers, also if they alternate",
          "depend only on input, parameters and context.seed: no clock, address, static or "
          "uninitialised memory",
          &checkDeterministic, true},
    Check{"reset", 2, kAllRoles, "after reset() an instance gives bitwise the answers of a new one",
          "reset() restores every member, random streams included, to its value after configure()",
          &checkReset, true},
    Check{"padded-rows", 2, kWithImages, "answers do not depend on the stride of an image",
          "address rows with image.row(r) or image.stride()", &checkPadding},
    Check{"threads", 3, kAllRoles,
          "answers do not depend on the number of threads, nor on the calling thread",
          "sum in a fixed order: tbb::parallel_deterministic_reduce, or slots by index; no "
          "thread-local variables",
          &checkThreads, true},
    Check{"state", 2, kAllRoles, "after save() and load() all later answers are bitwise equal",
          "save everything that later answers depend on, random streams included", &checkState},
    Check{"localise", 2, bit(Role::Place) | bit(Role::Cells),
          "with context.localise it uses a saved map, and nothing is added to it",
          "answer None instead of Novel, and Stay with experience -1 instead of a new experience",
          &checkLocaliser},
    Check{"globals", 2, kAllRoles,
          "does not change locale, signals, rounding, working directory, environment; writes no "
          "output",
          "use the logger, the random stream and the clock of the context", &checkGlobals},
    Check{"leaks", 2, kAllRoles, "leaves no thread running and no file open",
          "close files and join threads in the destructor at the latest", &checkLeaks},
};

}  // namespace

std::span<const Check> lifeChecks() { return kLifeChecks; }

}  // namespace tolman::conformance
