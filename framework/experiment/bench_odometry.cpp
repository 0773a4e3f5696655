// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/bench_odometry.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <ctime>
#include <memory>

#include "engine/drive.hpp"
#include "engine/task_isolation.hpp"
#include "experiment/image_files.hpp"
#include "host/process_state.hpp"

namespace tolman::bench {
namespace {

/// CPU time of all threads of the process, s.
double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Measures time from its construction.
class Meter {
 public:
  explicit Meter(const Clock& clock)
      : clock_(clock), wall_ns_(clock.steadyNs()), cpu_s_(cpuSeconds()) {
    conformance::resetPeakResident();
  }
  BenchPass pass(std::size_t frames) const {
    const double wall_s = 1e-9 * static_cast<double>(clock_.steadyNs() - wall_ns_);
    return {static_cast<std::int64_t>(frames),
            wall_s,
            cpuSeconds() - cpu_s_,
            conformance::peakResidentMib(),
            {}};
  }

 private:
  const Clock& clock_;
  std::int64_t wall_ns_;
  double cpu_s_;
};

/// Source and odometry over the frames of one pass.
class OdometryPass {
 public:
  OdometryPass(run::Assembly& assembly, std::int64_t most, const Cancellation& cancellation,
               const BenchProgress& progress)
      : assembly_(assembly), most_(most), cancellation_(cancellation), progress_(progress) {}

  /// Frames are read ahead as in a run, and tracked in their order. Throws run::Failed, which
  /// oneTBB passes on from its tasks.
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
    run::require(assembly_.odometry().finish(revisions), run::FailureKind::Stage);
  }

  /// Frame::source_index of each frame.
  const std::vector<std::int64_t>& sourceIndices() const { return source_indices_; }

 private:
  using FramePtr = std::shared_ptr<Frame>;

  /// Null at the end, or when cancelled.
  FramePtr next() {
    const bool complete = static_cast<std::int64_t>(source_indices_.size()) == most_;
    if (complete || cancellation_.requested()) return nullptr;
    auto frame = std::make_shared<Frame>();
    const Status status = assembly_.source().next(*frame);
    if (status.code() == StatusCode::EndOfStream) return nullptr;
    run::require(status, run::FailureKind::Dataset);
    source_indices_.push_back(frame->source_index);
    return frame;
  }

  void track(const Frame& frame) {
    Motion motion;
    run::require(
        pipeline::withoutOtherTasks([&] { return assembly_.odometry().track(frame, motion); }),
        run::FailureKind::Stage);
    progress_.frame();
  }

  run::Assembly& assembly_;
  std::int64_t most_;
  const Cancellation& cancellation_;
  const BenchProgress& progress_;
  std::vector<std::int64_t> source_indices_;
};

/// Fresh stages for each odometry pass; the decoding pass after it reads the same images.
class OdometryComparison {
 public:
  OdometryComparison(const run::SystemOptions& system, const BenchOptions& options,
                     run::RunLog& log, const Cancellation& cancellation)
      : system_(system), options_(options), log_(log), cancellation_(cancellation) {}

  OdometryBench run() {
    for (int i = 0; i < options_.repeats && !cancellation_.requested(); ++i) {
      if (i == 0) findFiles();
      odometryPass();
      decodingPass();
    }
    bench_.interrupted = cancellation_.requested();
    return std::move(bench_);
  }

 private:
  /// Refuses stages that run in another process, because its CPU time would not be counted.
  static void refuseProcesses(const run::CheckedSystem& checked) {
    for (std::size_t i = 0; i < checked.config.stages.size(); ++i) {
      const config::StageConfig& stage = checked.config.stages[i];
      if (!checked.remotes.at(i)) continue;
      throw run::Failed({run::FailureKind::Configuration,
                         stage.instance + ": runs in a process of its own, whose time is not "
                                          "counted; set isolation to none"});
    }
  }

  run::Assembly open(run::Scope scope) {
    run::CheckedSystem checked = run::require(run::checkSystem(system_, scope));
    refuseProcesses(checked);
    return {std::move(checked), log_, clock_, cancellation_};
  }

  /// The files of the first frame that has an image.
  void findFiles() {
    run::Assembly assembly = open(run::Scope::Source);
    Frame frame;
    Status status;
    while (status.isOk() && frame.left.empty()) status = assembly.source().next(frame);
    const run::CheckedSystem& system = assembly.system();
    const host::LoadedPlugin& source = system.plugins.front();
    const auto& values = system.values.find(system.config.stages.front().instance)->second;
    if (status.isOk()) {
      auto found = ImageFiles::find(source.schema, values, frame);
      status = found.status();
      if (found.isOk()) files_ = std::move(found).value();
    }
    if (status.code() != StatusCode::Unsupported && status.code() != StatusCode::EndOfStream) {
      return run::require(status, run::FailureKind::Dataset);
    }
    throw run::Failed(
        {run::FailureKind::Configuration,
         "source '" + source.manifest.id +
             "' reads no image files, there is no decoding to compare with; write its "
             "frames by 'tolman dataset render', and read them with source 'kitti'"});
  }

  void odometryPass() {
    run::Assembly assembly = open(run::Scope::SourceAndOdometry);
    bench_.name = assembly.system().config.general.name;
    bench_.source = assembly.sourceInfo().description;
    bench_.threads = pipeline::concurrency(assembly.system().config.general.threads);
    OdometryPass pass(assembly, options_.frames, cancellation_, options_.progress);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(bench_.threads));
    tbb::task_arena arena(bench_.threads);
    options_.progress.begin_pass(assembly.sourceInfo().frames);
    const Meter meter(clock_);
    arena.execute([&] { pass.track(); });
    keep(meter.pass(pass.sourceIndices().size()), bench_.odometry);
    options_.progress.end_pass();
    source_indices_ = pass.sourceIndices();
  }

  /// The images of the odometry pass, one after the other on one thread.
  void decodingPass() {
    options_.progress.begin_pass(static_cast<std::int64_t>(source_indices_.size()));
    const Meter meter(clock_);
    for (const std::int64_t index : source_indices_) {
      if (cancellation_.requested()) break;
      run::require(files_.decode(index), run::FailureKind::Dataset);
      options_.progress.frame();
    }
    keep(meter.pass(source_indices_.size()), bench_.decoding);
    options_.progress.end_pass();
  }

  /// Keeps the pass unless it was interrupted: an incomplete pass cannot be compared.
  void keep(const BenchPass& pass, std::vector<BenchPass>& passes) const {
    if (!cancellation_.requested()) passes.push_back(pass);
  }

  const run::SystemOptions& system_;
  const BenchOptions& options_;
  run::RunLog& log_;
  const Cancellation& cancellation_;
  run::SteadyClock clock_;
  ImageFiles files_;
  std::vector<std::int64_t> source_indices_;
  OdometryBench bench_;
};

}  // namespace

OdometryBench runOdometryBench(const run::SystemOptions& system, const BenchOptions& options,
                               run::RunLog& log, const Cancellation& cancellation) {
  return OdometryComparison(system, options, log, cancellation).run();
}

}  // namespace tolman::bench
