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
#include "engine/checked_system.hpp"
#include "engine/drive.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

struct RenderCommand {
  Output out;
  std::int64_t frames = -1;  ///< most frames to take from the source; -1 for all
  bool depth = false;
};

struct RenderOutcome {
  Status source;  ///< Ok, or what ended the rendering early
  bool interrupted = false;
  std::int64_t written = 0;
  std::int64_t left_out = 0;  ///< frames without a sound image; they get no number in the folder
  std::vector<evaluation::Revisit> revisits;
};

/// Writes all frames, then the text files. After an interruption or a failure of the source the
/// text files are written, too, so that the images written so far are a valid data set. Throws
/// engine::Failure for a file that cannot be written.
class Rendering {
 public:
  /// `depth`: name of the sensor array to write as depth maps; empty for none.
  Rendering(engine::Assembly& assembly, const KittiFolder& folder, std::int64_t frames,
            std::string depth, Logger& log, ProgressLine& progress)
      : source_(assembly.source()),
        info_(assembly.sourceInfo()),
        folder_(folder),
        frames_(frames),
        depth_(std::move(depth)),
        log_(log),
        progress_(progress) {}

  RenderOutcome run(const Cancellation& cancellation) {
    constexpr int kInFlight = 4;  // frames: more only cost memory
    tbb::task_group writers;
    for (int i = 1; const std::shared_ptr<const Frame> frame = next(cancellation); ++i) {
      writers.run([this, frame, index = outcome_.written - 1] { write(index, *frame); });
      if (i % kInFlight == 0) writers.wait();
    }
    writers.wait();
    outcome_.interrupted = cancellation.requested();
    if (outcome_.interrupted && outcome_.source.code() == StatusCode::Cancelled) {
      outcome_.source = Status::ok();
    }
    if (outcome_.written > 0) writeTexts();
    return outcome_;
  }

 private:
  /// The next frame that can be written; null at the end, after a failure, or when cancelled.
  std::shared_ptr<const Frame> next(const Cancellation& cancellation) {
    while (!cancellation.requested() && taken_ != frames_) {
      const auto next = std::make_shared<Frame>();
      Frame& frame = *next;
      Status status = source_.next(frame);
      if (status.code() == StatusCode::EndOfStream) return nullptr;
      ++taken_;
      const bool has_pair = !info_.rig.isStereo() || !frame.right.empty();
      const bool is_whole = frame.defect.empty() && !frame.left.empty() && has_pair;
      if (status.isOk() && is_whole) status = requireDepth(frame, depth_);
      if (!status.isOk()) {
        outcome_.source = status;
        return nullptr;
      }
      if (!is_whole) {
        leaveOut(frame);
        continue;
      }
      const std::int64_t index = outcome_.written++;
      drive_.stamps_ns.push_back(frame.stamp_ns);
      if (frame.has_truth) {
        drive_.truth.push_back({index, frame.stamp_ns, frame.T_world_camera_truth});
      }
      return next;
    }
    return nullptr;
  }

  void leaveOut(const Frame& frame) {
    const std::string reason = frame.defect.empty() ? "an image is missing" : frame.defect;
    if (outcome_.left_out++ == 0) {
      log_.warning(
          fmt::format("frame {} is left out, the folder cannot have a gap: {}; the "
                      "summary counts such frames",
                      frame.frame, reason));
    }
    progress_.step();
  }

  void write(std::int64_t index, const Frame& frame) {
    const Status status = folder_.writeFrame(index, frame, depth_);
    const bool is_of_source = status.code() == StatusCode::InvalidInput;
    engine::require(status,
                    is_of_source ? engine::FailureKind::Dataset : engine::FailureKind::Record);
    progress_.step();
  }

  void writeTexts() {
    if (drive_.hasTruth()) {
      outcome_.revisits = evaluation::findRevisits(drive_.truth);
    } else if (info_.has_truth) {
      log_.warning("some frames have no true pose: poses.txt and loops.txt are not written");
    }
    engine::require(folder_.writeTexts(info_.rig, drive_, outcome_.revisits),
                    engine::FailureKind::Record);
  }

  engine::RectifiedSource& source_;
  const SourceInfo& info_;
  const KittiFolder& folder_;
  std::int64_t frames_;
  std::string depth_;
  Logger& log_;
  ProgressLine& progress_;
  DriveLog drive_;
  RenderOutcome outcome_;
  std::int64_t taken_ = 0;
};

/// Whether the source reads from `out`. Such a folder must not be replaced.
bool readsFrom(const engine::CheckedSystem& system, const std::filesystem::path& out) {
  const ParameterValues& values = system.values.at(system.config.stages.front().instance);
  return std::ranges::any_of(system.plugins.front().schema, [&](const ParameterInfo& info) {
    if (info.type != ParameterType::Path) return false;
    const std::string text = std::get<std::string>(values.at(info.name));
    return !text.empty() && (record::isInside(text, out) || record::isInside(out, text));
  });
}

void print(const RenderOutcome& outcome, const std::string& out, bool calibrated, double seconds,
           const Invocation& invocation) {
  const auto& revisits = outcome.revisits;
  const auto same =
      std::ranges::count(revisits, evaluation::Heading::Same, &evaluation::Revisit::heading);
  const auto opposite = std::ssize(revisits) - same;
  if (invocation.json) {
    std::cout << jsonText({{"folder", out},
                           {"frames", outcome.written},
                           {"left_out", outcome.left_out},
                           {"calibrated", calibrated},
                           {"revisits_same", same},
                           {"revisits_opposite", opposite},
                           {"interrupted", outcome.interrupted},
                           {"seconds", seconds}});
    return;
  }
  if (invocation.quiet) return;
  const double rate = seconds > 0 ? static_cast<double>(outcome.written) / seconds : 0;
  std::cout << row("folder", out)
            << row("frames",
                   fmt::format("{} written, {} left out", outcome.written, outcome.left_out))
            << row("revisits",
                   fmt::format("{} frames in the same direction, {} in the opposite one", same,
                               opposite))
            << row("time", fmt::format("{}, {:.1f} frames/s", durationText(seconds), rate));
  if (calibrated) return;
  std::cout << row("calib.txt", "none: read it by {plugin: images, path: " + out +
                                    ", left: image_0, stamps: times.txt}");
}

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
  if (readsFrom(checked, out)) {
    fail(ExitCode::Record, out + ": the source reads from there; choose another --out");
  }
  engine::RunLog log(invocation.quiet);
  const engine::SteadyClock clock;
  engine::Assembly assembly(std::move(checked), log, clock, interrupts);
  const SourceInfo& info = assembly.sourceInfo();
  if (info.rig.width == 0) {
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
  auto progress = std::make_unique<ProgressLine>(std::cerr, clock, terminalOf(invocation),
                                                 framesToCome(command.frames, info.frames));
  const RenderOutcome outcome =
      Rendering(assembly, folder, command.frames, depth, logger, *progress).run(interrupts);
  progress.reset();
  const double seconds = static_cast<double>(clock.steadyNs() - begin_ns) * 1e-9;
  for (const Status& status : assembly.teardown()) logger.warning(status.message());
  print(outcome, out, info.rig.calibrated, seconds, invocation);
  engine::require(outcome.source, engine::FailureKind::Dataset);
  if (outcome.interrupted) return ExitCode::Interrupted;
  if (outcome.written > 0) return ExitCode::Ok;
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
