// SPDX-License-Identifier: BSD-3-Clause
#include "folder_source.hpp"

#include <algorithm>
#include <utility>

#include "coded_image.hpp"
#include "data_error.hpp"
#include "image_file.hpp"

namespace tolman::image_folders {
namespace {

constexpr const char* kDepth = "depth.left";

std::string pixelsText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height) + " pixels";
}

}  // namespace

Status FolderSource::configure(const Context& context) {
  dataset_ = {};
  sequence_ = {};
  is_orientation_reported_ = false;
  findings_ = &context.findings;
  next_frame_ = 0;
  try {
    ready_ = prepare(context);
  } catch (const source_parameters::DataError& error) {
    ready_ = error.status();
  }
  return ready_;
}

Status FolderSource::prepare(const Context& context) {
  Status status = load(context, parameters_, dataset_);
  if (!status.isOk()) return status;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  leaveOutUnusable(dataset_, *findings_);
  Result<FrameSequence> sequence = FrameSequence::make(parameters_, dataset_.stamps_ns);
  if (sequence.isOk()) sequence_ = std::move(sequence).value();
  return sequence.status();
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
  return readFrame(index, frame);
}

/// Of a damaged image both images of the pair are left out: one alone would look like a single
/// camera.
Status FolderSource::readFrame(std::size_t index, Frame& frame) {
  const auto leaveOut = [&](const std::filesystem::path& file, const Status& status) {
    const std::string defect = file.string() + ": " + status.message();
    if (status.code() != StatusCode::InvalidInput) return Status(status.code(), defect);
    findings_->add({Finding::Severity::Error, file.string(), status.message(),
                    "copy or record it again", Finding::Kind::Damaged});
    frame.left = frame.right = {};
    frame.defect = defect;
    return Status::ok();
  };
  if (!dataset_.depth.empty()) {
    const auto pixels = static_cast<std::size_t>(dataset_.rig.width) *
                        static_cast<std::size_t>(dataset_.rig.height);
    frame.sensors = {
        {kDepth, {dataset_.rig.height, dataset_.rig.width}, std::vector<float>(pixels)}};
    const Status status = readDepth(dataset_.depth[index], frame.sensors.front());
    if (!status.isOk()) return leaveOut(dataset_.depth[index], status);
  }
  Result<Image> left = readImage(dataset_.left[index]);
  if (!left.isOk()) return leaveOut(dataset_.left[index], left.status());
  frame.left = std::move(left).value();
  if (dataset_.right.empty()) return Status::ok();
  Result<Image> right = readImage(dataset_.right[index]);
  if (!right.isOk()) return leaveOut(dataset_.right[index], right.status());
  frame.right = std::move(right).value();
  return Status::ok();
}

Result<Image> FolderSource::readImage(const std::filesystem::path& file) {
  const Result<std::vector<std::uint8_t>> bytes = readBytes(file);
  if (!bytes.isOk()) return bytes.status();
  Result<Image> image = coded_images::decodeImage(bytes.value(), parameters_.colour, used_bits_);
  if (!image.isOk()) return image;
  const int width = image.value().width();
  const int height = image.value().height();
  if (width != dataset_.rig.width || height != dataset_.rig.height) {
    return Status::invalidInput("has " + pixelsText(width, height) + ", but the first image has " +
                                pixelsText(dataset_.rig.width, dataset_.rig.height));
  }
  if (auto finding = used_bits_.endImage(file.string())) findings_->add(*std::move(finding));
  if (!is_orientation_reported_ && coded_images::orientationOf(bytes.value()) != 1) {
    is_orientation_reported_ = true;
    findings_->add({Finding::Severity::Warning, file.string(),
                    "is stored turned or mirrored (EXIF orientation), and the pixels are used as "
                    "stored",
                    "if the calibration is of upright images, turn the files, such as with "
                    "`exiftran -ai` or `jpegtran`"});
  }
  return image;
}

Status FolderSource::readDepth(const std::filesystem::path& file, NamedArray& depth) const {
  const Result<coded_images::DepthValues> read = readDepthFile(file);
  if (!read.isOk()) return read.status();
  const auto& [width, height, values] = read.value();
  if (width != dataset_.rig.width || height != dataset_.rig.height) {
    return Status::invalidInput("has " + pixelsText(width, height) + ", but the images have " +
                                pixelsText(dataset_.rig.width, dataset_.rig.height));
  }
  const double per_m = dataset_.depth_per_m;
  std::ranges::transform(values, depth.values.begin(),
                         [&](std::uint16_t value) { return static_cast<float>(value / per_m); });
  return Status::ok();
}

}  // namespace tolman::image_folders
