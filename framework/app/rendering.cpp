// SPDX-License-Identifier: BSD-3-Clause
#include "app/rendering.hpp"

#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>

namespace tolman::dataset {
namespace {

// Number of frames in flight: one is read while the others are written. More only cost memory.
constexpr std::size_t kInFlight = 4;
// Largest number of warnings on the terminal; the summary counts all.
constexpr std::int64_t kMaxWarnings = 5;

}  // namespace

std::string depthArray(const std::vector<ArrayInfo>& arrays) {
  const auto depth = std::ranges::find(arrays, ArrayKind::DepthImage, &ArrayInfo::kind);
  return depth == arrays.end() ? "" : depth->name;
}

RenderOutcome Rendering::run(const Cancellation& cancellation) {
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
  finish();
  return outcome_;
}

/// The next frame that can be written; null at the end, after a failure, or when cancelled.
Rendering::JobPtr Rendering::next(const Cancellation& cancellation) {
  while (!cancellation.requested() && writing() && taken_ != options_.frames) {
    auto job = std::make_shared<Job>();
    Status status = source_(job->frame);
    if (status.code() == StatusCode::EndOfStream) return nullptr;
    ++taken_;
    const bool whole = status.isOk() && isWhole(job->frame);
    if (whole) status = check(job->frame);
    if (!status.isOk()) {
      outcome_.source = status;
      return nullptr;
    }
    if (!whole) {
      leaveOut(job->frame);
      continue;
    }
    job->index = outcome_.written++;
    drive_.stamps_ns.push_back(job->frame.stamp_ns);
    if (job->frame.has_truth) {
      drive_.truth.push_back({job->index, job->frame.stamp_ns, job->frame.T_world_camera_truth});
    }
    return job;
  }
  return nullptr;
}

bool Rendering::isWhole(const Frame& frame) const {
  const bool pair = !info_.rig.isStereo() || !frame.right.empty();
  return frame.defect.empty() && !frame.left.empty() && pair;
}

void Rendering::leaveOut(const Frame& frame) {
  const std::string reason = frame.defect.empty() ? "an image is missing" : frame.defect;
  const std::string message =
      "frame " + std::to_string(frame.frame) + " is left out, the folder cannot have a gap: ";
  const std::int64_t before = outcome_.left_out++;
  if (before < kMaxWarnings) log_.warning(message + reason);
  if (before == kMaxWarnings) log_.warning("more frames are left out; the summary counts them");
  on_frame_();
}

/// All images must have one format, and depth must be there where it was requested.
Status Rendering::check(const Frame& frame) {
  const std::string at = "frame " + std::to_string(frame.frame) + ": ";
  if (drive_.stamps_ns.empty()) format_ = frame.left.format();
  for (const Image* image : {&frame.left, &frame.right}) {
    if (image->empty() || image->format() == format_) continue;
    return Status::failed(at +
                          "the source changes between grey and colour; a KITTI folder has "
                          "one of the two");
  }
  if (options_.depth.empty()) return Status::ok();
  const auto depth = std::ranges::find(frame.sensors, options_.depth, &NamedArray::name);
  const std::vector<int> shape = {info_.rig.height, info_.rig.width};
  if (depth != frame.sensors.end() && depth->shape == shape) return Status::ok();
  return Status::failed(at + "the source gives no sensor array '" + options_.depth +
                        "' of the shape {height, width}; leave out --depth");
}

void Rendering::write(const Job& job) {
  const Status status = folder_.writeFrame(job.index, job.frame, options_.depth);
  if (!status.isOk()) {
    const std::lock_guard lock(folder_mutex_);
    if (outcome_.folder.isOk()) outcome_.folder = status;
  }
  on_frame_();
}

bool Rendering::writing() {
  const std::lock_guard lock(folder_mutex_);
  return outcome_.folder.isOk();
}

void Rendering::finish() {
  if (!outcome_.folder.isOk() || outcome_.written == 0) return;
  if (drive_.hasTruth()) outcome_.revisits = findRevisits(drive_.truth);
  if (!drive_.hasTruth() && info_.has_truth) {
    log_.warning("some frames have no true pose: poses.txt and loops.txt are not written");
  }
  const bool ended = !outcome_.interrupted && outcome_.source.isOk() && options_.frames < 0;
  if (ended && info_.frames > outcome_.written + outcome_.left_out) {
    log_.warning("the source ended after " + std::to_string(outcome_.written + outcome_.left_out) +
                 " of the " + std::to_string(info_.frames) + " frames that it had told");
  }
  outcome_.folder = folder_.writeTexts(info_.rig, drive_, outcome_.revisits);
}

}  // namespace tolman::dataset
