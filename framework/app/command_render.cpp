// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset render: the frames of any source or recording as a KITTI folder, for any other
// program. Images are encoded and written while the source makes the next ones.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "app/kitti_folder.hpp"
#include "app/options.hpp"
#include "app/program.hpp"
#include "engine/chain.hpp"
#include "engine/checked_system.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

struct RenderCommand {
  Output out;
  std::int64_t frames = -1;  ///< most frames to take from the source; -1 for all
  bool depth = false;
};

/// Writes all frames, then the text files: also after an interruption or a failure of the source,
/// so that the images written so far are a data set. Throws engine::Failure for a file that cannot
/// be written.
class Rendering {
 public:
  /// `depth`: name of the sensor array to write as depth maps; empty for none.
  Rendering(engine::Assembly& assembly, const KittiFolder& folder, std::string depth, Logger& log,
            ProgressLine& progress)
      : source_(assembly.source()),
        info_(assembly.sourceInfo()),
        folder_(folder),
        depth_(std::move(depth)),
        log_(log),
        progress_(progress) {}

  /// Of `most` frames, -1 for all. Why the source ended early, or Ok.
  Status run(std::int64_t most, const Cancellation& cancellation) {
    constexpr int kInFlight = 4;  // frames: more only cost memory
    tbb::task_group writers;
    Status status;
    for (std::int64_t taken = 0; taken != most && !cancellation.requested(); ++taken) {
      const auto frame = std::make_shared<Frame>();
      status = source_.next(*frame);
      if (status.isOk() && isWhole(*frame)) status = requireDepth(*frame, depth_);
      if (!status.isOk()) break;
      progress_.step();
      if (!isWhole(*frame)) {
        leaveOut(*frame);
        continue;
      }
      const std::int64_t index = written();
      stamps_ns_.push_back(frame->stamp_ns);
      if (frame->has_truth) {
        truth_.push_back({index, frame->stamp_ns, frame->T_world_camera_truth});
      }
      writers.run([this, frame, index] { write(index, *frame); });
      if (index % kInFlight == kInFlight - 1) writers.wait();
    }
    writers.wait();
    if (written() > 0) writeTexts();
    const bool is_end = status.code() == StatusCode::EndOfStream ||
                        (status.code() == StatusCode::Cancelled && cancellation.requested());
    return is_end ? Status::ok() : status;
  }

  std::int64_t written() const { return std::ssize(stamps_ns_); }

  void print(const std::string& out, double seconds, bool interrupted,
             const Invocation& invocation) const {
    const auto same =
        std::ranges::count(revisits_, evaluation::Heading::Same, &evaluation::Revisit::heading);
    const auto opposite = std::ssize(revisits_) - same;
    if (invocation.json) {
      std::cout << jsonText({{"folder", out},
                             {"frames", written()},
                             {"left_out", left_out_},
                             {"calibrated", info_.rig.calibrated},
                             {"revisits_same", same},
                             {"revisits_opposite", opposite},
                             {"interrupted", interrupted},
                             {"seconds", seconds}});
    } else if (!invocation.quiet) {
      std::cout << row("folder", out)
                << row("frames", fmt::format("{} written, {} left out", written(), left_out_))
                << row("revisits",
                       fmt::format("{} frames in the same direction, {} in the opposite one", same,
                                   opposite))
                << row("time", durationText(seconds));
      if (info_.rig.calibrated) return;
      std::cout << row("calib.txt", "none: read it by {plugin: images, path: " + out +
                                        ", left: image_0, stamps: times.txt}");
    }
  }

 private:
  bool isWhole(const Frame& frame) const {
    const bool has_pair = !info_.rig.isStereo() || !frame.right.empty();
    return frame.defect.empty() && !frame.left.empty() && has_pair;
  }

  void leaveOut(const Frame& frame) {
    if (left_out_++ > 0) return;
    log_.warning(
        fmt::format("frame {} is left out, the folder cannot have a gap: {}; the summary counts "
                    "such frames",
                    frame.frame, frame.defect.empty() ? "an image is missing" : frame.defect));
  }

  void write(std::int64_t index, const Frame& frame) const {
    const Status status = folder_.writeFrame(index, frame, depth_);
    const bool is_of_source = status.code() == StatusCode::InvalidInput;
    engine::require(status,
                    is_of_source ? engine::FailureKind::Dataset : engine::FailureKind::Record);
  }

  void writeTexts() {
    if (info_.has_truth && std::ssize(truth_) < written()) {
      log_.warning("some frames have no true pose: poses.txt and loops.txt are not written");
      truth_.clear();
    }
    revisits_ = evaluation::findRevisits(truth_);
    engine::require(folder_.writeTexts(info_.rig, stamps_ns_, truth_, revisits_),
                    engine::FailureKind::Record);
  }

  engine::RectifiedSource& source_;
  const SourceInfo& info_;
  const KittiFolder& folder_;
  std::string depth_;
  Logger& log_;
  ProgressLine& progress_;
  std::vector<std::int64_t> stamps_ns_;
  evaluation::Trajectory truth_;
  std::vector<evaluation::Revisit> revisits_;
  std::int64_t left_out_ = 0;  ///< frames without a sound image; they get no number in the folder
};

/// The array of depth maps, which --depth has asked for.
std::string depthOf(engine::Assembly& assembly) {
  std::vector<ArrayInfo> arrays;
  engine::require(assembly.source().instance().describe(arrays), engine::FailureKind::Dataset);
  const std::string depth = depthArray(arrays);
  if (!depth.empty()) return depth;
  fail(ExitCode::Dataset, "the source gives no depth maps; leave out --depth");
}

ExitCode execute(const RenderCommand& command, engine::SystemOptions system,
                 const Invocation& invocation) {
  const std::string& out = command.out.path;
  const engine::Interrupts interrupts;  // before anything that starts threads
  if (command.depth) system.overrides.emplace_back("source.depth=true");
  auto checked = engine::checkSystem(system, engine::Scope::Source);
  for (const std::string& data : engine::inputPaths(checked).present) {
    if (!record::isInside(data, out) && !record::isInside(out, data)) continue;
    fail(ExitCode::Record, out + ": the source reads from there; choose another --out");
  }
  engine::RunLog log(invocation.quiet);
  const engine::SteadyClock clock;
  engine::Assembly assembly(std::move(checked), log, clock, interrupts);
  if (assembly.sourceInfo().rig.width == 0) {
    fail(ExitCode::Dataset, "the source gives no images; a KITTI folder is made of them");
  }
  const std::string depth = command.depth ? depthOf(assembly) : "";
  const auto folder =
      engine::require(KittiFolder::create(out, command.out.replace), engine::FailureKind::Record);
  const int threads = engine::concurrency(assembly.system().config.general.threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  engine::StageLogger logger(log, "render");
  const std::int64_t begin_ns = clock.steadyNs();
  auto progress =
      std::make_unique<ProgressLine>(std::cerr, clock, terminalOf(invocation),
                                     framesToCome(command.frames, assembly.sourceInfo().frames));
  Rendering rendering(assembly, folder, depth, logger, *progress);
  const Status source = rendering.run(command.frames, interrupts);
  progress.reset();
  const double seconds = static_cast<double>(clock.steadyNs() - begin_ns) * 1e-9;
  for (const Status& status : assembly.teardown()) logger.warning(status.message());
  rendering.print(out, seconds, interrupts.requested(), invocation);
  engine::require(source, engine::FailureKind::Dataset);
  if (interrupts.requested()) return ExitCode::Interrupted;
  if (rendering.written() > 0) return ExitCode::Ok;
  fail(ExitCode::Dataset, "the source gave no frame with a sound image");
}

}  // namespace

void addRenderCommand(CLI::App& dataset, Invocation& invocation) {
  CLI::App& command = *dataset.add_subcommand(
      "render", "Write the frames of a source or recording, rectified, as a KITTI folder");
  auto reader = std::make_shared<SystemOptionsReader>(command);
  auto render = std::make_shared<RenderCommand>();
  render->out
      .add(command, "FOLDER", "Folder to write", "Replace an earlier rendering in the folder")
      ->required();
  addOption(command, "--frames", render->frames, "N", "Take at most this many frames")
      ->check(positive);
  command.add_flag("--depth", render->depth, "Write depth maps too (16 bits, m * 256)");
  command.callback([reader, render, &invocation] {
    invocation.exit_code = execute(*render, reader->read(invocation, Use::Copy), invocation);
  });
}

}  // namespace tolman::app
