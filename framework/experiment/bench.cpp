// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/bench.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <atomic>
#include <fstream>
#include <string>

#include "engine/drive.hpp"
#include "host/scratch_folder.hpp"

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

/// Collects the times of the stages, and cancels the run after `frames`. Frames that are still in
/// flight then are finished and not counted.
class TimingListener : public engine::Listener, public Cancellation {
 public:
  TimingListener(const Clock& clock, const Cancellation& cancellation, std::int64_t frames,
                 const BenchProgress& progress)
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
    progress_.frame();
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
  const BenchProgress& progress_;
  std::int64_t begin_ns_;
  std::atomic<bool> complete_ = false;
  BenchPass pass_;
  std::array<std::vector<std::int64_t>, kRoleNames.size()> durations_ns_;
};

class ChainBench {
 public:
  ChainBench(const engine::SystemOptions& system, const BenchOptions& options, engine::RunLog& log,
             const Cancellation& cancellation)
      : system_(system), options_(options), log_(log), cancellation_(cancellation) {}

  Bench run() {
    const bool chain = !options_.source_only && engine::hasChain(system_);
    for (int i = 0; i < options_.repeats; ++i) pass(engine::Scope::Source, bench_.source_passes);
    for (int i = 0; chain && i < options_.repeats; ++i) {
      pass(engine::Scope::WithoutObservers, bench_.chain_passes);
    }
    bench_.interrupted = cancellation_.requested();
    return std::move(bench_);
  }

 private:
  void pass(engine::Scope scope, std::vector<BenchPass>& passes) {
    if (cancellation_.requested()) return;
    resetPeakResident();
    engine::Assembly assembly(engine::require(engine::checkSystem(system_, scope)), log_, clock_,
                              cancellation_);
    const host::ScratchFolder scratch("tolman-bench");
    if (scratch.path().empty()) {
      throw engine::Failure({engine::FailureKind::Record, host::kNoScratchFolder});
    }
    assembly.openArtefacts(scratch.path());
    bench_.name = assembly.system().config.general.name;
    bench_.source = assembly.sourceInfo().description;
    options_.progress.begin_pass(assembly.sourceInfo().frames);
    BenchPass measured = scope == engine::Scope::Source ? sourceAlone(assembly) : chain(assembly);
    options_.progress.end_pass();
    if (measured.frames == 0 && !cancellation_.requested()) {
      throw engine::Failure({engine::FailureKind::Dataset, "source: gave no frame to measure"});
    }
    if (!cancellation_.requested()) passes.push_back(std::move(measured));  // else: incomplete pass
  }

  BenchPass sourceAlone(engine::Assembly& assembly) {
    const int threads = engine::concurrency(assembly.system().config.general.threads);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    std::vector<std::int64_t> durations_ns;
    BenchPass pass;
    while (pass.frames != options_.frames && !cancellation_.requested()) {
      Frame frame;
      const std::int64_t begin_ns = clock_.steadyNs();
      const Status status = assembly.source().next(frame);
      const std::int64_t duration_ns = clock_.steadyNs() - begin_ns;
      if (status.code() == StatusCode::EndOfStream) break;
      engine::require(status, engine::FailureKind::Dataset);
      durations_ns.push_back(duration_ns);
      pass.seconds += static_cast<double>(duration_ns) * kSecondsPerNs;
      pass.rectifying_s += static_cast<double>(assembly.source().rectifyingNs()) * kSecondsPerNs;
      ++pass.frames;
      options_.progress.frame();
    }
    pass.peak_mib = peakResidentMib();
    pass.stages["source"] = evaluation::stageTiming(durations_ns);
    return pass;
  }

  BenchPass chain(engine::Assembly& assembly) {
    const config::SystemConfig& config = assembly.system().config;
    config::PipelineSettings settings = config.pipeline;
    settings.mode = config::PipelineMode::Lossless;
    TimingListener timing(clock_, cancellation_, options_.frames, options_.progress);
    engine::Chain stages(assembly.stages(), assembly.policies(), timing);
    const engine::DriveResult result =
        engine::drive(stages, settings, config.general.threads, timing);
    if (result.failure) throw *result.failure;
    return timing.pass();
  }

  const engine::SystemOptions& system_;
  const BenchOptions& options_;
  engine::RunLog& log_;
  const Cancellation& cancellation_;
  engine::SteadyClock clock_;
  Bench bench_;
};

}  // namespace

Bench runBench(const engine::SystemOptions& system, const BenchOptions& options,
               engine::RunLog& log, const Cancellation& cancellation) {
  return ChainBench(system, options, log, cancellation).run();
}

namespace {

double ratio(const std::vector<BenchPass>& passes, const BenchPass& pass) {
  const double first = passes.front().rate();
  return first > 0 ? pass.rate() / first : 0;
}

std::string passesText(std::string_view what, const std::vector<BenchPass>& passes) {
  std::string text;
  int repeat = 0;
  for (const BenchPass& pass : passes) {
    text += fmt::format("{:<12}{:>6}{:>8}{:>11.1f}{:>8.2f}{:>10.0f}\n", what, ++repeat, pass.frames,
                        pass.rate(), ratio(passes, pass), pass.peak_mib);
  }
  return text;
}

/// One line per stage, one pair of columns per repeat.
std::string stagesText(const std::vector<BenchPass>& passes) {
  std::string text = fmt::format("{:<12}  median and p90, ms a frame, of each repeat\n", "stage");
  for (const std::string_view role : kRoleNames) {
    if (!passes.front().stages.contains(std::string(role))) continue;
    text += fmt::format("{:<12}", role);
    for (const BenchPass& pass : passes) {
      const auto found = pass.stages.find(std::string(role));
      if (found == pass.stages.end()) continue;
      text += fmt::format("{:>11.2f}{:>9.2f}", found->second.median_ms, found->second.p90_ms);
    }
    text += "\n";
  }
  return text;
}

/// Time of rectification over the time of reading and decoding.
double rectificationRatio(const BenchPass& pass) {
  const double decoding_s = pass.seconds - pass.rectifying_s;
  return decoding_s > 0 ? pass.rectifying_s / decoding_s : 0;
}

/// One column per repeat; empty where nothing is rectified.
std::string rectificationText(const std::vector<BenchPass>& passes) {
  std::string text;
  for (const BenchPass& pass : passes) {
    if (pass.rectifying_s > 0) text += fmt::format("{:>8.2f}", rectificationRatio(pass));
  }
  return text.empty() ? text : "rectifying / reading and decoding:" + text + "\n";
}

nlohmann::ordered_json passesJson(const std::vector<BenchPass>& passes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BenchPass& pass : passes) {
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const auto& [role, timing] : pass.stages) stages[role] = evaluation::toJson(timing);
    list.push_back({{"frames", pass.frames},
                    {"seconds", pass.seconds},
                    {"frames_per_second", pass.rate()},
                    {"ratio", ratio(passes, pass)},
                    {"peak_mib", pass.peak_mib},
                    {"stages", stages}});
    if (pass.rectifying_s > 0) {
      list.back()["rectifying_over_decoding"] = rectificationRatio(pass);
    }
  }
  return list;
}

}  // namespace

std::string benchText(const Bench& bench) {
  std::string text = fmt::format("{}: {}\n", bench.name, bench.source);
  text += fmt::format("{:<12}{:>6}{:>8}{:>11}{:>8}{:>10}\n", "", "repeat", "frames", "frames/s",
                      "ratio", "peak MiB");
  text += passesText("source", bench.source_passes) + passesText("chain", bench.chain_passes);
  text += rectificationText(bench.source_passes);
  const auto& detailed = bench.chain_passes.empty() ? bench.source_passes : bench.chain_passes;
  return detailed.empty() ? text : text + "\n" + stagesText(detailed);
}

nlohmann::ordered_json benchJson(const Bench& bench) {
  return {{"name", bench.name},
          {"source", bench.source},
          {"interrupted", bench.interrupted},
          {"source_passes", passesJson(bench.source_passes)},
          {"chain_passes", passesJson(bench.chain_passes)}};
}

}  // namespace tolman::experiment
