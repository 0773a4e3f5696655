// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench.hpp"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <iostream>
#include <optional>

#include "app/progress_line.hpp"
#include "conformance/process_state.hpp"
#include "pipeline/run.hpp"
#include "plugins/scratch_folder.hpp"

namespace tolman::app {
namespace {

constexpr double kSecondsPerNs = 1e-9;

/// Collects what the recorder would have written as timing, and asks for the end after `frames`.
/// Frames that are then still in flight are finished and not counted.
class Stopwatch : public pipeline::Listener, public Cancellation {
 public:
  Stopwatch(const Clock& clock, const Cancellation& cancellation, std::int64_t frames,
            ProgressLine& progress)
      : clock_(clock),
        cancellation_(cancellation),
        frames_(frames),
        progress_(progress),
        begin_ns_(clock.steadyNs()) {}

  bool requested() const override { return complete_ || cancellation_.requested(); }

  Status onFrame(const Snapshot& snapshot) override {
    if (complete_) return Status::ok();
    const StageTimes& times = snapshot.stage_times_ns;
    for (std::size_t role = 0; role < times.size(); ++role) {
      if (times[role] > 0) durations_ns_.at(role).push_back(times[role]);
    }
    pass_.seconds = static_cast<double>(clock_.steadyNs() - begin_ns_) * kSecondsPerNs;
    complete_ = ++pass_.frames == frames_;
    progress_.step();
    return Status::ok();
  }
  void onEvent(const pipeline::Event&) override {}
  Status onFinish(const std::vector<MotionRevision>&, const MapGraph&) override {
    return Status::ok();
  }

  BenchPass pass() const {
    BenchPass pass = pass_;
    pass.peak_mib = conformance::peakResidentMib();
    for (std::size_t role = 0; role < durations_ns_.size(); ++role) {
      if (durations_ns_.at(role).empty()) continue;
      pass.stages[std::string(kRoleNames.at(role))] =
          evaluation::stageTiming(durations_ns_.at(role));
    }
    return pass;
  }

 private:
  const Clock& clock_;
  const Cancellation& cancellation_;
  std::int64_t frames_;
  ProgressLine& progress_;
  std::int64_t begin_ns_;
  std::atomic<bool> complete_ = false;
  BenchPass pass_;
  std::array<std::vector<std::int64_t>, kRoleNames.size()> durations_ns_;
};

class Runner {
 public:
  Runner(const SystemOptions& system, const BenchOptions& options, RunLog& log,
         const Cancellation& cancellation)
      : system_(system), options_(options), log_(log), cancellation_(cancellation) {}

  std::variant<Bench, Failure> run() {
    const bool chain = !options_.source_only && hasChain(system_);
    for (int i = 0; i < options_.repeats; ++i) {
      if (auto failure = pass(Scope::Source, bench_.source_passes)) return *failure;
    }
    for (int i = 0; chain && i < options_.repeats; ++i) {
      if (auto failure = pass(Scope::WithoutObservers, bench_.chain_passes)) return *failure;
    }
    bench_.interrupted = cancellation_.requested();
    return std::move(bench_);
  }

 private:
  using MaybeFailure = std::optional<Failure>;

  MaybeFailure pass(Scope scope, std::vector<BenchPass>& passes) {
    if (cancellation_.requested()) return std::nullopt;
    conformance::resetPeakResident();
    auto assembled = Assembly::open(system_, scope, log_, clock_, cancellation_);
    if (auto* failure = std::get_if<Failure>(&assembled)) return *failure;
    Assembly& assembly = *std::get<std::unique_ptr<Assembly>>(assembled);
    const plugins::ScratchFolder scratch("tolman-bench");
    assembly.openArtefacts(scratch.path());
    SourceInfo info;
    const Status informed = assembly.source().info(info);
    if (!informed.isOk()) return Failure{ExitCode::Dataset, informed.message()};
    bench_.name = assembly.system().config.general.name;
    bench_.source = info.description;
    ProgressLine progress(std::cerr, clock_, options_.audience,
                          framesToCome(options_.frames, info.frames));
    auto measured =
        scope == Scope::Source ? sourceAlone(assembly, progress) : chain(assembly, progress);
    (void)assembly.teardown();
    if (auto* failure = std::get_if<Failure>(&measured)) return *failure;
    // What an interruption has cut short says nothing.
    if (!cancellation_.requested()) passes.push_back(std::get<BenchPass>(measured));
    return std::nullopt;
  }

  std::variant<BenchPass, Failure> sourceAlone(Assembly& assembly, ProgressLine& progress) {
    const int threads = pipeline::concurrency(assembly.system().config.general.threads);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    std::vector<std::int64_t> durations_ns;
    BenchPass pass;
    while (pass.frames != options_.frames && !cancellation_.requested()) {
      Frame frame;
      const std::int64_t begin_ns = clock_.steadyNs();
      const Status status = assembly.source().next(frame);
      durations_ns.push_back(clock_.steadyNs() - begin_ns);
      if (status.code() == StatusCode::EndOfStream) {
        durations_ns.pop_back();
        break;
      }
      if (!status.isOk()) return Failure{ExitCode::Dataset, status.message()};
      pass.seconds += static_cast<double>(durations_ns.back()) * kSecondsPerNs;
      ++pass.frames;
      progress.step();
    }
    pass.peak_mib = conformance::peakResidentMib();
    pass.stages["source"] = evaluation::stageTiming(durations_ns);
    return pass;
  }

  std::variant<BenchPass, Failure> chain(Assembly& assembly, ProgressLine& progress) {
    const config::SystemConfig& config = assembly.system().config;
    config::PipelineSettings settings = config.pipeline;
    settings.mode = config::PipelineMode::Lossless;
    const pipeline::Policies policies{assembly.policy(Role::Odometry), assembly.policy(Role::Place),
                                      assembly.policy(Role::Cells), assembly.policy(Role::Map)};
    Stopwatch stopwatch(clock_, cancellation_, options_.frames, progress);
    pipeline::Chain stages({assembly.source(), assembly.odometry(), assembly.place(),
                            assembly.cells(), assembly.map()},
                           policies, stopwatch);
    const pipeline::Outcome outcome =
        pipeline::run(stages, settings, config.general.threads, stopwatch);
    if (outcome.status.isOk()) return stopwatch.pass();
    const bool data = outcome.status.message().starts_with(config.stages.front().instance + " (");
    return Failure{data ? ExitCode::Dataset : ExitCode::PluginFailed, outcome.status.message()};
  }

  const SystemOptions& system_;
  const BenchOptions& options_;
  RunLog& log_;
  const Cancellation& cancellation_;
  SteadyClock clock_;
  Bench bench_;
};

}  // namespace

std::variant<Bench, Failure> runBench(const SystemOptions& system, const BenchOptions& options,
                                      RunLog& log, const Cancellation& cancellation) {
  return Runner(system, options, log, cancellation).run();
}

}  // namespace tolman::app
