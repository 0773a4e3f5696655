// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/bench.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <iterator>

#include "engine/chain.hpp"
#include "host/child_process.hpp"

namespace tolman::experiment {

namespace {

constexpr double kSecondsPerNs = 1e-9;

/// The largest memory of this process since the last reset, MiB.
double peakResidentMib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(line.find(':') + 1)) / 1024;  // kB
  }
  return 0;
}
void resetPeakResident() { std::ofstream("/proc/self/clear_refs") << "5"; }

/// Collects times of stages, and cancels the run after `frames`; later ones do not count.
class TimingListener : public engine::Listener, public Cancellation {
 public:
  TimingListener(const Clock& clock, const Cancellation& cancellation, std::int64_t frames,
                 const std::function<void()>& frame_done)
      : clock_(clock),
        cancellation_(cancellation),
        frames_(frames),
        frame_done_(frame_done),
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
    frame_done_();
    return Status::ok();
  }
  void onEvent(const engine::Event&) override {}
  Status onFinish(const std::vector<MotionRevision>&, const MapGraph&) override {
    return Status::ok();
  }

  BenchPass pass() const {
    BenchPass pass = pass_;
    pass.peak_mib = peakResidentMib();
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
  const std::function<void()>& frame_done_;
  std::int64_t begin_ns_;
  std::atomic<bool> complete_ = false;
  BenchPass pass_{"chain"};
  std::array<std::vector<std::int64_t>, kRoleNames.size()> durations_ns_;
};

BenchPass sourceAlone(engine::Assembly& assembly, std::int64_t frames, const Clock& clock,
                      const Cancellation& cancellation, const std::function<void()>& frame_done) {
  const int threads = engine::concurrency(assembly.system().config.general.threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  std::vector<std::int64_t> durations_ns;
  BenchPass pass{"source"};
  while (pass.frames != frames && !cancellation.requested()) {
    Frame frame;
    const std::int64_t begin_ns = clock.steadyNs();
    const Status status = assembly.source().next(frame);
    const std::int64_t duration_ns = clock.steadyNs() - begin_ns;
    if (status.code() == StatusCode::EndOfStream) break;
    engine::require(status, engine::FailureKind::Dataset);
    durations_ns.push_back(duration_ns);
    pass.seconds += static_cast<double>(duration_ns) * kSecondsPerNs;
    ++pass.frames;
    frame_done();
  }
  pass.peak_mib = peakResidentMib();
  pass.stages["source"] = evaluation::stageTiming(durations_ns);
  return pass;
}

BenchPass chain(engine::Assembly& assembly, TimingListener& timing) {
  const config::SystemConfig& config = assembly.system().config;
  config::PipelineSettings settings = config.pipeline;
  settings.mode = config::PipelineMode::Lossless;
  engine::Chain stages(assembly.stages(), assembly.policies(), timing);
  const engine::DriveResult result =
      engine::drive(stages, settings, config.general.threads, timing);
  if (result.failure) throw *result.failure;
  return timing.pass();
}

}  // namespace

Bench runBench(const engine::SystemOptions& system, const BenchOptions& options,
               engine::RunLog& log, const Cancellation& cancellation) {
  const engine::SteadyClock clock;
  Bench bench;
  const auto pass = [&](engine::Scope scope) {
    if (cancellation.requested()) return;
    resetPeakResident();
    engine::Assembly assembly(engine::checkSystem(system, scope), log, clock, cancellation);
    const host::ScratchFolder scratch("tolman-bench");
    if (scratch.path().empty()) {
      throw engine::Failure({engine::FailureKind::Record, host::kNoScratchFolder});
    }
    assembly.openArtefacts(scratch.path());
    bench.name = assembly.system().config.general.name;
    bench.source = assembly.sourceInfo().description;
    const auto frame_done = options.progress(assembly.sourceInfo().frames);
    TimingListener timing(clock, cancellation, options.frames, frame_done);
    BenchPass measured =
        scope == engine::Scope::Source
            ? sourceAlone(assembly, options.frames, clock, cancellation, frame_done)
            : chain(assembly, timing);
    if (cancellation.requested()) return;  // an incomplete pass
    if (measured.frames == 0) {
      throw engine::Failure({engine::FailureKind::Dataset, "source: gave no frame to measure"});
    }
    bench.passes.push_back(std::move(measured));
  };
  for (int i = 0; i < options.repeats; ++i) pass(engine::Scope::Source);
  const bool has_chain = !options.source_only && engine::hasChain(system);
  for (int i = 0; has_chain && i < options.repeats; ++i) pass(engine::Scope::WithoutObservers);
  bench.interrupted = cancellation.requested();
  return bench;
}

Table tableOf(const Bench& bench) {
  Table table{{"pass", "repeat", "frames", "frames/s", "ratio", "peak MiB"}, {}};
  table.keys = {"pass",  "repeat",   "frames", "seconds", "frames_per_second",
                "ratio", "peak_mib", "stages"};
  table.title = bench.name + ": " + bench.source;
  table.about = {
      {"name", bench.name}, {"source", bench.source}, {"interrupted", bench.interrupted}};
  std::vector<std::string_view> roles;  // that were measured
  std::ranges::copy_if(kRoleNames, std::back_inserter(roles), [&](std::string_view role) {
    return std::ranges::any_of(bench.passes, [&](const BenchPass& pass) {
      return pass.stages.contains(std::string(role));
    });
  });
  for (const std::string_view role : roles) table.heading.push_back(fmt::format("{} ms", role));
  std::map<std::string, std::vector<double>> rates;  // by kind
  for (const BenchPass& pass : bench.passes) {
    std::vector<double>& own = rates[pass.kind];
    own.push_back(pass.rate());
    const double ratio = own.front() > 0 ? pass.rate() / own.front() : 0;
    auto& row = table.rows.emplace_back(
        std::vector<std::string>{pass.kind, std::to_string(own.size()), std::to_string(pass.frames),
                                 fmt::format("{:.1f}", pass.rate()), fmt::format("{:.2f}", ratio),
                                 fmt::format("{:.0f}", pass.peak_mib)});
    Table::Json stages = Table::Json::object();
    for (const std::string_view role : roles) {
      const auto found = pass.stages.find(std::string(role));
      const bool known = found != pass.stages.end();
      row.push_back(
          known ? fmt::format("{:.2f}/{:.2f}", found->second.median_ms, found->second.p90_ms) : "");
      if (known) stages[found->first] = evaluation::toJson(found->second);
    }
    table.values.push_back({pass.kind, own.size(), pass.frames, pass.seconds, pass.rate(), ratio,
                            pass.peak_mib, stages});
  }
  if (!bench.passes.empty()) table.notes.emplace_back("stages: median/90 % of a frame");
  return table;
}

}  // namespace tolman::experiment
