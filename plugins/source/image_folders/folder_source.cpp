// SPDX-License-Identifier: BSD-3-Clause
#include "folder_source.hpp"

#include <algorithm>
#include <utility>

namespace tolman::image_folders {
namespace {

constexpr const char* kDepth = "depth.left";

}  // namespace

Status FolderSource::configure(const Context& context) {
  dataset_ = {};
  inspection_ = {};
  sequence_ = {};
  left_warnings_ = {};
  right_warnings_ = {};
  log_ = &context.log;
  next_frame_ = 0;
  ready_ = load(context.parameters, parameters_, dataset_, inspection_);
  if (ready_.isOk()) ready_ = inspection_.status();
  for (const Finding& finding : inspection_.findings()) context.findings.add(finding);
  if (!ready_.isOk()) return ready_;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  Result<FrameSequence> sequence = FrameSequence::make(parameters_, dataset_.stamps_ns);
  ready_ = sequence.status();
  if (sequence.isOk()) sequence_ = std::move(sequence).value();
  return ready_;
}

Status FolderSource::rawRig(RawRig& rig) {
  if (!ready_.isOk()) return ready_;
  rig = dataset_.raw;
  return Status::ok();
}

Status FolderSource::describe(std::vector<ArrayInfo>& arrays) const {
  if (dataset_.depth.empty()) return Status::ok();
  ArrayInfo& depth = arrays.emplace_back();
  depth.name = kDepth;
  depth.kind = ArrayKind::DepthImage;
  depth.unit = "m";
  depth.doc = "measured depth of the image along the optical axis; 0 where it was not measured";
  depth.axes.resize(2);
  depth.axes[0].name = "row";
  depth.axes[1].name = "column";
  return Status::ok();
}

Status FolderSource::reset() {
  next_frame_ = 0;
  return ready_;
}

Status FolderSource::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  info.description = descriptionOf(dataset_, sequence_.size());
  info.rig = dataset_.rig;
  info.frames = sequence_.size();
  info.has_truth = !dataset_.T_world_left.empty();
  return Status::ok();
}

Status FolderSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  if (next_frame_ >= sequence_.size()) return Status::endOfStream();
  frame.frame = next_frame_++;  // also after a failure, so that a caller can skip the frame
  frame.stamp_ns = sequence_.stampNs(frame.frame);
  frame.source_index = sequence_.sourceIndex(frame.frame);
  const auto index = static_cast<std::size_t>(frame.source_index);
  if (!dataset_.T_world_left.empty()) {
    // The world is the left camera at frame 0 of this run, not of the data set.
    const auto origin = static_cast<std::size_t>(sequence_.sourceIndex(0));
    frame.has_truth = true;
    frame.T_world_camera_truth =
        dataset_.T_world_left[origin].inverse() * dataset_.T_world_left[index];
  }
  Status status = readImages(index, frame);
  const bool is_last = next_frame_ == sequence_.size();
  if (const auto warning = used_bits_.warning(is_last, next_frame_ - 1)) {
    log_->warning(dataset_.left.front().parent_path().string() + ": " + *warning);
  }
  const bool damaged = status.code() == StatusCode::InvalidInput;
  if (!damaged || parameters_.on_corrupt == OnCorrupt::Stop) return status;
  frame.left = frame.right = {};
  if (!dataset_.depth.empty()) frame.sensors = {noDepth()};
  frame.defect = source_parameters::withoutAdvice(status.message());
  return Status::ok();
}

Result<Image> FolderSource::readImage(const std::filesystem::path& file, ImageWarnings& warnings) {
  const int bits = parameters_.bits;
  ImageNotes notes;
  if (used_bits_.isJudging()) notes.values.widths.emplace();
  Result<Image> image = readImageFile(file, parameters_.colour, dataset_.size(), bits, &notes);
  if (!image.isOk()) return image;
  for (const auto& warning : {warnings.ofOrientation(notes.orientation),
                              warnings.ofBits(notes.values.beyond_bits, bits)}) {
    if (warning) log_->warning(file.string() + ": " + *warning);
  }
  if (notes.values.widths) used_bits_.add(*notes.values.widths);
  return image;
}

Status FolderSource::readImages(std::size_t index, Frame& frame) {
  Result<Image> left = readImage(dataset_.left[index], left_warnings_);
  if (!left.isOk()) return left.status();
  frame.left = std::move(left).value();
  if (dataset_.right.empty()) return readDepth(index, frame);
  Result<Image> right = readImage(dataset_.right[index], right_warnings_);
  if (!right.isOk()) return right.status();
  frame.right = std::move(right).value();
  return readDepth(index, frame);
}

/// A depth array with all values 0: not measured.
NamedArray FolderSource::noDepth() const {
  const ImageSize size = dataset_.size();
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return {kDepth, {size.height, size.width}, std::vector<float>(pixels)};
}

Status FolderSource::readDepth(std::size_t index, Frame& frame) const {
  if (dataset_.depth.empty()) return Status::ok();
  const ImageSize size = dataset_.size();
  const auto values = readDepthFile(dataset_.depth[index], size);
  if (!values.isOk()) return values.status();
  NamedArray& depth = frame.sensors.emplace_back(noDepth());
  const double per_m = dataset_.depth_per_m;
  std::transform(values.value().begin(), values.value().end(), depth.values.begin(),
                 [&](std::uint16_t value) { return static_cast<float>(value / per_m); });
  return Status::ok();
}

Status FolderSource::inspect(std::vector<Finding>& findings) {
  const std::vector<Finding>& problems = inspection_.findings();
  findings.insert(findings.end(), problems.begin(), problems.end());
  if (!inspection_.hasErrors() && !ready_.isOk()) {
    findings.push_back({Finding::Severity::Error, "configuration", ready_.message()});
  }
  if (dataset_.rig.width > 0) {
    checkImageFiles(dataset_, findings);
    checkUsedBits(dataset_, parameters_.bits, findings);
  }
  if (!dataset_.left.empty()) {
    const auto all = static_cast<std::int64_t>(dataset_.left.size());
    findings.push_back({Finding::Severity::Note, dataset_.left.front().parent_path().string(),
                        descriptionOf(dataset_, ready_.isOk() ? sequence_.size() : all)});
  }
  return Status::ok();
}

}  // namespace tolman::image_folders
