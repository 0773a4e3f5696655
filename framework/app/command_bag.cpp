// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset export: the frames of any source or recording as a bag of ROS, which the observer
// `bag_writer` writes.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "app/options.hpp"
#include "app/program.hpp"
#include "config/values.hpp"
#include "engine/checked_system.hpp"

namespace tolman::app {
namespace {

struct BagCommand {
  std::string bag;
  std::int64_t frames = -1;  ///< most frames to take from the source; -1 for all
};

/// Gives the frames of a source to an observer; no stage is between them.
class Export {
 public:
  explicit Export(engine::Assembly& assembly)
      : source_(assembly.source()), observer_(assembly.observers().front().stage) {
    RunInfo run;
    run.name = "export";
    run.source = assembly.sourceInfo();
    engine::require(source_.instance().describe(run.arrays), engine::FailureKind::Dataset);
    engine::require(observer_.begin(run), engine::FailureKind::Record);
  }

  /// Whether there was a frame.
  bool writeNext() {
    Frame frame;
    const Status status = source_.next(frame);
    if (status.code() == StatusCode::EndOfStream || status.code() == StatusCode::Cancelled) {
      return false;
    }
    engine::require(status, engine::FailureKind::Dataset);
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion_;
    snapshot.place = &place_;
    snapshot.decision = &decision_;
    snapshot.map = &map_;
    snapshot.cells = &cells_;
    engine::require(observer_.observe(snapshot), engine::FailureKind::Record);
    return true;
  }

  void finish() { engine::require(observer_.finish({}), engine::FailureKind::Record); }

 private:
  engine::RectifiedSource& source_;
  host::ObserverStage& observer_;
  Motion motion_;  ///< of frame -1, as the others: there is none
  PlaceObservation place_;
  Decision decision_;
  MapUpdate map_;
  std::vector<NamedArray> cells_;
};

ExitCode execute(const BagCommand& command, engine::SystemOptions system,
                 const Invocation& invocation) {
  const engine::Interrupts interrupts;  // before anything that starts threads
  const std::string bag = std::filesystem::absolute(command.bag).string();
  system.overrides.push_back("observers=[{plugin: bag_writer, path: " + config::writeText(bag) +
                             "}]");
  engine::RunLog log(invocation.quiet);
  const engine::SteadyClock clock;
  engine::Assembly assembly(engine::checkSystem(system, engine::Scope::SourceAndObservers), log,
                            clock, interrupts);
  const std::int64_t begin_ns = clock.steadyNs();
  std::int64_t frames = 0;
  auto progress =
      std::make_unique<ProgressLine>(std::cerr, clock, terminalOf(invocation),
                                     framesToCome(command.frames, assembly.sourceInfo().frames));
  Export to_bag(assembly);
  while (!interrupts.requested() && frames != command.frames && to_bag.writeNext()) {
    ++frames;
    progress->step();
  }
  to_bag.finish();
  progress.reset();
  const double seconds = static_cast<double>(clock.steadyNs() - begin_ns) * 1e-9;
  engine::StageLogger logger(log, "export");
  for (const Status& status : assembly.teardown()) logger.warning(status.message());
  if (invocation.json) {
    std::cout << jsonText({{"bag", command.bag},
                           {"frames", frames},
                           {"interrupted", interrupts.requested()},
                           {"seconds", seconds}});
  } else if (!invocation.quiet) {
    std::cout << row("bag", command.bag) << row("frames", std::to_string(frames))
              << row("time", durationText(seconds));
  }
  if (interrupts.requested()) return ExitCode::Interrupted;
  if (frames > 0) return ExitCode::Ok;
  fail(ExitCode::Dataset, "the source gave no frame");
}

}  // namespace

void addBagCommand(CLI::App& dataset, Invocation& invocation) {
  CLI::App& command = *dataset.add_subcommand(
      "export", "Write the frames of a source or recording, rectified, as a bag of ROS");
  auto reader = std::make_shared<SystemOptionsReader>(command);
  auto asked = std::make_shared<BagCommand>();
  addOption(command, "--bag", asked->bag, "FILE", "NAME.mcap (ROS 2) or NAME.bag (ROS 1) to write")
      ->required();
  addOption(command, "--frames", asked->frames, "N", "Take at most this many frames")
      ->check(positive);
  command.callback([reader, asked, &invocation] {
    if (std::filesystem::exists(asked->bag)) {
      fail(ExitCode::Record, asked->bag + ": exists; remove it, or choose another --bag");
    }
    invocation.exit_code = execute(*asked, reader->read(invocation, Use::Copy), invocation);
  });
}

}  // namespace tolman::app
