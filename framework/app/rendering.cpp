// SPDX-License-Identifier: BSD-3-Clause
#include "app/rendering.hpp"

#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace tolman::app {
namespace {

class Rendering {
 public:
  Rendering(const RenderSource& source, const KittiFolder& folder, const RenderOptions& options,
            Logger& log)
      : source_(source), folder_(folder), options_(options), log_(log) {}

  RenderOutcome run(const Cancellation& cancellation) {
    constexpr std::size_t kInFlight = 4;  // frames: more only cost memory
    const auto give = tbb::make_filter<void, JobPtr>(tbb::filter_mode::serial_in_order,
                                                     [&](tbb::flow_control& control) {
                                                       JobPtr job = next(cancellation);
                                                       if (!job) control.stop();
                                                       return job;
                                                     });
    const auto take = tbb::make_filter<JobPtr, void>(tbb::filter_mode::parallel,
                                                     [this](const JobPtr& job) { write(*job); });
    tbb::parallel_pipeline(kInFlight, give & take);
    outcome_.interrupted = cancellation.requested();
    if (outcome_.interrupted && outcome_.source.code() == StatusCode::Cancelled) {
      outcome_.source = Status::ok();
    }
    if (outcome_.folder.isOk() && outcome_.written > 0) writeTexts();
    return outcome_;
  }

 private:
  /// A frame and its number in the folder.
  struct Job {
    std::int64_t index = 0;
    Frame frame;
  };
  using JobPtr = std::shared_ptr<Job>;

  /// The next frame that can be written; null at the end, after a failure, or when cancelled.
  JobPtr next(const Cancellation& cancellation) {
    while (!cancellation.requested() && canWrite() && taken_ != options_.frames) {
      auto job = std::make_shared<Job>();
      Frame& frame = job->frame;
      Status status = source_.next(frame);
      if (status.code() == StatusCode::EndOfStream) return nullptr;
      ++taken_;
      const bool has_pair = !source_.info.rig.isStereo() || !frame.right.empty();
      const bool is_whole = frame.defect.empty() && !frame.left.empty() && has_pair;
      if (status.isOk() && is_whole) status = check(frame);
      if (!status.isOk()) {
        outcome_.source = status;
        return nullptr;
      }
      if (!is_whole) {
        leaveOut(frame);
        continue;
      }
      job->index = outcome_.written++;
      drive_.stamps_ns.push_back(frame.stamp_ns);
      if (frame.has_truth) {
        drive_.truth.push_back({job->index, frame.stamp_ns, frame.T_world_camera_truth});
      }
      return job;
    }
    return nullptr;
  }

  void leaveOut(const Frame& frame) {
    const std::string reason = frame.defect.empty() ? "an image is missing" : frame.defect;
    if (outcome_.left_out++ == 0) {
      log_.warning("frame " + std::to_string(frame.frame) +
                   " is left out, the folder cannot have a gap: " + reason +
                   "; the summary counts such frames");
    }
    source_.on_frame();
  }

  /// All images must have one format, and depth must be there where it was requested.
  Status check(const Frame& frame) {
    const std::string at = "frame " + std::to_string(frame.frame) + ": ";
    if (drive_.stamps_ns.empty()) format_ = frame.left.format();
    if (frame.left.format() != format_) {
      return Status::failed(at +
                            "the source changes between grey and colour; a KITTI folder has one of "
                            "the two");
    }
    if (options_.depth.empty()) return Status::ok();
    const auto depth = std::ranges::find(frame.sensors, options_.depth, &NamedArray::name);
    const std::vector<int> shape = {source_.info.rig.height, source_.info.rig.width};
    if (depth != frame.sensors.end() && depth->shape == shape) return Status::ok();
    return Status::failed(at + "the source gives no sensor array '" + options_.depth +
                          "' of the shape {height, width}; leave out --depth");
  }

  void write(const Job& job) {
    const Status status = folder_.writeFrame(job.index, job.frame, options_.depth);
    if (!status.isOk()) {
      const std::lock_guard lock(mutex_);
      if (outcome_.folder.isOk()) outcome_.folder = status;
    }
    source_.on_frame();
  }

  bool canWrite() {
    const std::lock_guard lock(mutex_);
    return outcome_.folder.isOk();
  }

  void writeTexts() {
    if (drive_.hasTruth()) {
      outcome_.revisits = evaluation::findRevisits(drive_.truth);
    } else if (source_.info.has_truth) {
      log_.warning("some frames have no true pose: poses.txt and loops.txt are not written");
    }
    outcome_.folder = folder_.writeTexts(source_.info.rig, drive_, outcome_.revisits);
  }

  const RenderSource& source_;
  const KittiFolder& folder_;
  const RenderOptions& options_;
  Logger& log_;
  DriveLog drive_;
  RenderOutcome outcome_;
  std::mutex mutex_;  // of outcome_.folder
  std::int64_t taken_ = 0;
  PixelFormat format_ = PixelFormat::Gray8;
};

}  // namespace

std::string depthArray(const std::vector<ArrayInfo>& arrays) {
  const auto depth = std::ranges::find(arrays, ArrayKind::DepthImage, &ArrayInfo::kind);
  return depth == arrays.end() ? "" : depth->name;
}

RenderOutcome render(const RenderSource& source, const KittiFolder& folder,
                     const RenderOptions& options, Logger& log, const Cancellation& cancellation) {
  return Rendering(source, folder, options, log).run(cancellation);
}

}  // namespace tolman::app
