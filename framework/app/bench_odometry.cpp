// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_odometry.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <iostream>
#include <memory>
#include <optional>

#include "app/progress_line.hpp"
#include "conformance/process_state.hpp"
#include "pipeline/run.hpp"
#include "pipeline/undisturbed.hpp"

namespace tolman::app {
namespace {

constexpr std::string_view kYardstick = "yardstick";

/// Time of the process's threads together, s.
double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Measures from its making on.
class Meter {
 public:
  explicit Meter(const Clock& clock)
      : clock_(clock), wall_ns_(clock.steadyNs()), cpu_s_(cpuSeconds()) {
    conformance::resetPeakResident();
  }
  DrivePass pass(std::int64_t frames) const {
    const double wall_s = 1e-9 * static_cast<double>(clock_.steadyNs() - wall_ns_);
    return {frames, wall_s, cpuSeconds() - cpu_s_, conformance::peakResidentMib()};
  }

 private:
  const Clock& clock_;
  std::int64_t wall_ns_;
  double cpu_s_;
};

/// One drive: frames from the source, and what becomes of them.
class Drive {
 public:
  Drive(Assembly& assembly, std::int64_t most, const Cancellation& cancellation,
        ProgressLine& progress)
      : assembly_(assembly), most_(most), cancellation_(cancellation), progress_(progress) {}

  /// The images alone, one after the other.
  void decode() {
    while (next()) progress_.step();
  }

  /// Frames are read ahead as a run reads them, and tracked in their order.
  void track() {
    const auto give = tbb::make_filter<void, FramePtr>(tbb::filter_mode::serial_in_order,
                                                       [this](tbb::flow_control& control) {
                                                         FramePtr frame = next();
                                                         if (!frame) control.stop();
                                                         return frame;
                                                       });
    const auto take = tbb::make_filter<FramePtr, void>(
        tbb::filter_mode::serial_in_order, [this](const FramePtr& frame) { track(*frame); });
    const int queue = assembly_.system().config.pipeline.queue;
    tbb::parallel_pipeline(static_cast<std::size_t>(queue), give & take);
    std::vector<MotionRevision> revisions;
    if (!failure_) note(ExitCode::PluginFailed, assembly_.odometry().finish(revisions));
  }

  std::int64_t frames() const { return given_; }
  const std::optional<Failure>& failure() const { return failure_; }

 private:
  using FramePtr = std::shared_ptr<Frame>;

  /// Null at the end, after a failure, or when cancelled.
  FramePtr next() {
    if (given_ == most_ || failed_ || cancellation_.requested()) return nullptr;
    auto frame = std::make_shared<Frame>();
    const Status status = assembly_.source().next(*frame);
    if (status.isOk()) {
      ++given_;
      return frame;
    }
    if (status.code() != StatusCode::EndOfStream) note(ExitCode::Dataset, status);
    return nullptr;
  }

  void track(const Frame& frame) {
    if (failed_) return;
    Motion motion;
    note(ExitCode::PluginFailed,
         pipeline::undisturbed([&] { return assembly_.odometry().track(frame, motion); }));
    progress_.step();
  }

  void note(ExitCode code, const Status& status) {
    if (status.isOk() || failed_.exchange(true)) return;
    failure_ = Failure{code, status.message()};
  }

  Assembly& assembly_;
  std::int64_t most_;
  const Cancellation& cancellation_;
  ProgressLine& progress_;
  std::int64_t given_ = 0;
  std::atomic<bool> failed_ = false;
  std::optional<Failure> failure_;  // written by the first that fails, read after the drive
};

class Runner {
 public:
  Runner(const SystemOptions& system, const BenchOptions& options, RunLog& log,
         const Cancellation& cancellation)
      : system_(system),
        yardstick_(system),
        options_(options),
        log_(log),
        cancellation_(cancellation) {
    yardstick_.overrides.push_back("source." + std::string(kYardstick) + "=true");
  }

  std::variant<OdometryBench, Failure> run() {
    if (auto failure = checkSource()) return *failure;
    for (int i = 0; i < options_.repeats; ++i) {
      if (auto failure = pass(yardstick_, Scope::Source, bench_.decoding)) return *failure;
      if (auto failure = pass(system_, Scope::SourceAndOdometry, bench_.odometry)) return *failure;
    }
    bench_.interrupted = cancellation_.requested();
    return std::move(bench_);
  }

 private:
  using MaybeFailure = std::optional<Failure>;

  MaybeFailure checkSource() const {
    auto checked = checkSystem(system_, Scope::SourceAndOdometry);
    if (auto* failure = std::get_if<Failure>(&checked)) return *failure;
    const plugins::LoadedPlugin& source = std::get<CheckedSystem>(checked).plugins.front();
    const bool decodes = std::any_of(source.schema.begin(), source.schema.end(),
                                     [](const auto& p) { return p.name == kYardstick; });
    if (decodes) return std::nullopt;
    return Failure{ExitCode::Configuration,
                   "source '" + source.manifest.id +
                       "' reads no image files, there is no decoding to compare with; write its "
                       "frames by 'tolman dataset render', and read them with source 'kitti'"};
  }

  MaybeFailure pass(const SystemOptions& system, Scope scope, std::vector<DrivePass>& passes) {
    if (cancellation_.requested()) return std::nullopt;
    auto assembled = Assembly::open(system, scope, log_, clock_, cancellation_);
    if (auto* failure = std::get_if<Failure>(&assembled)) return *failure;
    Assembly& assembly = *std::get<std::unique_ptr<Assembly>>(assembled);
    SourceInfo info;
    const Status informed = assembly.source().info(info);
    if (!informed.isOk()) return Failure{ExitCode::Dataset, informed.message()};
    bench_.name = assembly.system().config.general.name;
    bench_.source = info.description;
    auto measured = drive(assembly, scope, info.frames);
    (void)assembly.teardown();
    if (auto* failure = std::get_if<Failure>(&measured)) return *failure;
    // What an interruption has cut short says nothing.
    if (!cancellation_.requested()) passes.push_back(std::get<DrivePass>(measured));
    return std::nullopt;
  }

  std::variant<DrivePass, Failure> drive(Assembly& assembly, Scope scope, std::int64_t frames) {
    const bool alone = scope == Scope::Source;
    const std::int64_t most = options_.frames;
    ProgressLine progress(std::cerr, clock_, options_.audience, framesToCome(most, frames));
    Drive drive(assembly, most, cancellation_, progress);
    const int threads = alone ? 1 : pipeline::concurrency(assembly.system().config.general.threads);
    if (!alone) bench_.threads = threads;
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    const Meter meter(clock_);
    arena.execute([&] { alone ? drive.decode() : drive.track(); });
    const DrivePass pass = meter.pass(drive.frames());
    if (drive.failure()) return *drive.failure();
    return pass;
  }

  const SystemOptions& system_;
  SystemOptions yardstick_;
  const BenchOptions& options_;
  RunLog& log_;
  const Cancellation& cancellation_;
  SteadyClock clock_;
  OdometryBench bench_;
};

}  // namespace

std::variant<OdometryBench, Failure> runOdometryBench(const SystemOptions& system,
                                                      const BenchOptions& options, RunLog& log,
                                                      const Cancellation& cancellation) {
  return Runner(system, options, log, cancellation).run();
}

}  // namespace tolman::app
