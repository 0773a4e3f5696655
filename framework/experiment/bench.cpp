// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/bench.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>

#include "engine/chain.hpp"
#include "evaluation/metrics.hpp"
#include "host/child_process.hpp"

namespace tolman::experiment {
namespace {

/// Collects times of stages, and cancels the drive after `frames`; later ones do not count.
class TimingListener : public engine::Listener, public Cancellation {
 public:
  TimingListener(const Cancellation& cancellation, const BenchOptions& options, std::int64_t known)
      : cancellation_(cancellation),
        frames_(options.frames),
        frame_done_(options.progress(known)),
        begin_ns_(clock_.steadyNs()) {}

  bool requested() const override { return complete_ || cancellation_.requested(); }

  Status onFrame(const Snapshot& snapshot) override {
    if (complete_) return Status::ok();
    for (std::size_t role = 0; role < durations_ns.size(); ++role) {
      const std::int64_t ns = snapshot.stage_times_ns[role];
      if (ns > 0) durations_ns.at(role).push_back(ns);
    }
    seconds = static_cast<double>(clock_.steadyNs() - begin_ns_) * 1e-9;
    complete_ = ++frames == frames_;
    frame_done_();
    return Status::ok();
  }
  void onEvent(const engine::Event&) override {}
  Status onFinish(const std::vector<MotionRevision>&, const MapGraph&) override {
    return Status::ok();
  }

  std::array<std::vector<std::int64_t>, kRoleNames.size()> durations_ns;
  std::int64_t frames = 0;
  double seconds = 0;

 private:
  engine::SteadyClock clock_;
  const Cancellation& cancellation_;
  std::int64_t frames_;
  std::function<void()> frame_done_;
  std::int64_t begin_ns_;
  std::atomic<bool> complete_ = false;
};

}  // namespace

BenchTable runBench(const engine::SystemOptions& system, const BenchOptions& options,
                    engine::RunLog& log, const Cancellation& cancellation) {
  const engine::SteadyClock clock;
  engine::Assembly assembly(engine::checkSystem(system, engine::Scope::WithoutObservers), log,
                            clock, cancellation);
  const host::ScratchFolder scratch("tolman-bench");
  if (scratch.path().empty()) {
    throw engine::Failure({engine::FailureKind::Record, host::kNoScratchFolder});
  }
  assembly.openArtefacts(scratch.path());
  TimingListener timing(cancellation, options, assembly.sourceInfo().frames);
  const config::SystemConfig& config = assembly.system().config;
  config::PipelineSettings settings = config.pipeline;
  settings.mode = config::PipelineMode::Lossless;
  engine::Chain stages(assembly.stages(), assembly.policies(), timing);
  const engine::DriveResult driven =
      engine::drive(stages, settings, config.general.threads, timing);
  if (driven.failure) throw *driven.failure;
  if (timing.frames == 0 && !cancellation.requested()) {
    throw engine::Failure({engine::FailureKind::Dataset, "source: gave no frame to measure"});
  }
  BenchTable measured{{{"stage", "mean ms", "median ms", "95 % ms", "of source"}, {}},
                      cancellation.requested()};
  Table& table = measured.table;
  table.title = fmt::format("{}: {}; {} frames in {:.2f} s, {:.1f} a second", config.general.name,
                            assembly.sourceInfo().description, timing.frames, timing.seconds,
                            static_cast<double>(timing.frames) / std::max(timing.seconds, 1e-9));
  table.keys = {"stage", "mean_ms", "median_ms", "p95_ms", "of_source"};
  table.about = {{"name", config.general.name},
                 {"source", assembly.sourceInfo().description},
                 {"frames", timing.frames},
                 {"seconds", timing.seconds},
                 {"interrupted", measured.interrupted}};
  const double source_ms = evaluation::stageTiming(timing.durations_ns[0]).mean_ms;
  for (std::size_t role = 0; role < kRoleNames.size(); ++role) {
    if (timing.durations_ns.at(role).empty()) continue;
    const auto t = evaluation::stageTiming(timing.durations_ns.at(role));
    const double ratio = source_ms > 0 ? t.mean_ms / source_ms : 0;
    const std::string stage(kRoleNames.at(role));
    table.values.push_back({stage, t.mean_ms, t.median_ms, t.p95_ms, ratio});
    table.rows.push_back({stage, fmt::format("{:.3f}", t.mean_ms),
                          fmt::format("{:.3f}", t.median_ms), fmt::format("{:.3f}", t.p95_ms),
                          fmt::format("{:.2f}", ratio)});
  }
  return measured;
}

}  // namespace tolman::experiment
