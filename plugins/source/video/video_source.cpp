// SPDX-License-Identifier: BSD-3-Clause
#include "video_source.hpp"

#include <cmath>
#include <string>

namespace tolman::video {

namespace {

PictureSize halved(PictureSize size, PictureLayout layout) {
  if (layout == PictureLayout::SideBySide) size.width /= 2;
  if (layout == PictureLayout::TopBottom) size.height /= 2;
  return size;
}

/// The part of `picture` of this size that begins at column x and row y.
Image part(const Image& picture, int x, int y, PictureSize size) {
  const std::ptrdiff_t column = std::ptrdiff_t{x} * bytesPerPixel(picture.format());
  return {picture.row(y) + column, size.width,       size.height,
          picture.stride(),        picture.format(), picture.owner()};
}

}  // namespace

Result<PictureSize> cameraSize(PictureSize picture, PictureLayout layout) {
  const PictureSize size = halved(picture, layout);
  const bool whole = (layout != PictureLayout::SideBySide || size.width * 2 == picture.width) &&
                     (layout != PictureLayout::TopBottom || size.height * 2 == picture.height);
  if (whole && size.width > 0 && size.height > 0) return size;
  return Status::invalidParameter(
      "pictures of " + picture.text() + " are not two equal halves " +
      (layout == PictureLayout::SideBySide ? "side by side" : "one above the other") +
      "; correct layout");
}

Image leftImage(const Image& picture, PictureLayout layout) {
  if (picture.empty() || layout == PictureLayout::Mono) return picture;
  return part(picture, 0, 0, halved({picture.width(), picture.height()}, layout));
}

Image rightImage(const Image& picture, PictureLayout layout) {
  if (picture.empty() || layout == PictureLayout::Mono) return {};
  const PictureSize size = halved({picture.width(), picture.height()}, layout);
  const bool beside = layout == PictureLayout::SideBySide;
  return part(picture, beside ? size.width : 0, beside ? 0 : size.height, size);
}

namespace {

/// Contradictions between parameters.
Status checkCombination(const VideoParameters& p, PathKind kind) {
  const bool stereo = p.layout != PictureLayout::Mono;
  if (stereo && (!p.isGiven() || p.baseline == 0)) {
    return Status::invalidParameter("two cameras need a calibration; give pinhole and baseline");
  }
  if (!stereo && p.baseline > 0) {
    return Status::invalidParameter("baseline is given with layout: mono; set the layout");
  }
  if (kind != PathKind::Device && (p.width > 0 || p.height > 0)) {
    return Status::invalidParameter("width and height are those of a camera; remove them");
  }
  if (p.order != FrameOrder::Forward) {
    return Status::invalidParameter(p.path +
                                    ": a video is read forward only; remove order, or make a "
                                    "folder of images of it");
  }
  if (p.last >= 0 && p.last < p.first) {
    return Status::invalidParameter("last is before first; give a larger last, or -1 for the end");
  }
  return Status::ok();
}

}  // namespace

Status VideoSource::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  findings_ = &context.findings;
  cancellation_ = &context.cancellation;
  clock_ = &context.clock;
  return ready_ = prepare(context);
}

Status VideoSource::prepare(const Context& context) {
  const Parameters& p = parameters_;
  const Result<PathKind> kind = findKind(p.path, pipe_, context.cancellation);
  if (!kind.isOk()) return kind.status();
  kind_ = kind.value();
  if (Status status = checkCombination(p, kind_); !status.isOk()) return status;
  if (Status status = open(); !status.isOk()) return status;
  description_ = capture_->description();
  const Result<PictureSize> size = cameraSize(capture_->size(), p.layout);
  if (!size.isOk()) return size.status();
  const Result<CameraRig> rig = p.rig(size.value().width, size.value().height);
  if (!rig.isOk()) return rig.status();
  rig_ = rig.value();
  return Status::ok();
}

Status VideoSource::open() {
  const Parameters& p = parameters_;
  const CameraRequest request{{static_cast<int>(p.width), static_cast<int>(p.height)}, p.rate};
  Result<std::unique_ptr<Capture>> opened =
      kind_ == PathKind::Device ? openCamera(p.path, request, p.colour, *clock_)
                                : openVideo(p.path, pipe_.get(), p.colour, *cancellation_);
  if (opened.isOk()) capture_ = std::move(opened).value();
  return opened.status();
}

Status VideoSource::reset() {
  if (!ready_.isOk()) return ready_;
  next_frame_ = 0;
  if (next_picture_ == 0 || kind_ == PathKind::Device) return ready_;
  next_picture_ = 0;
  if (kind_ == PathKind::Pipe) {
    return ready_ = Status::unsupported(parameters_.path + ": a pipe cannot be read twice");
  }
  return ready_ = open();
}

Status VideoSource::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  info.description = description_;
  if (parameters_.layout != PictureLayout::Mono) info.description += ", stereo pairs";
  if (!rig_.calibrated) info.description += ", uncalibrated";
  info.rig = rig_;
  return Status::ok();
}

Status VideoSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  const Parameters& p = parameters_;
  while (p.last < 0 || next_picture_ <= p.last) {
    const std::int64_t index = next_picture_;
    const bool selected = index >= p.first && (index - p.first) % p.step == 0;
    Picture picture;
    const Status status = capture_->next(selected, picture);
    if (status.code() == StatusCode::EndOfStream) return atEnd();
    if (!status.isOk()) return status;
    ++next_picture_;
    if (!selected) continue;
    const auto stamp = stampNs(picture, index);
    if (!stamp.isOk()) return stamp.status();
    frame.stamp_ns = stamp.value();
    return give(picture, index, frame);
  }
  return Status::endOfStream();
}

Status VideoSource::atEnd() {
  if (const std::string defect = capture_->defectOfEnd(); !defect.empty()) {
    reportDamage(defect);
  }
  const std::string end = parameters_.path + " has " + std::to_string(next_picture_) + " pictures";
  if (next_picture_ == 0) return Status::invalidInput(end + "; name a video");
  if (parameters_.first < next_picture_ && parameters_.last < next_picture_) {
    return Status::endOfStream();
  }
  return Status::invalidParameter(end + "; choose first and last below that, or -1 for the end");
}

void VideoSource::reportDamage(std::string what) {
  findings_->add({Finding::Severity::Error, parameters_.path, std::move(what),
                  "copy or record it again", Finding::Kind::Damaged});
}

Result<std::int64_t> VideoSource::stampNs(const Picture& picture, std::int64_t index) const {
  if (parameters_.rate > 0 && kind_ != PathKind::Device) {
    return std::llround(static_cast<double>(index) * 1e9 / parameters_.rate);
  }
  if (picture.timed) return picture.stamp_ns;
  return Status::invalidInput(parameters_.path + ": does not state the time of picture " +
                              std::to_string(index) + "; set rate");
}

Status VideoSource::give(Picture& picture, std::int64_t index, Frame& frame) {
  frame.frame = next_frame_++;
  frame.source_index = index;
  if (!picture.defect.empty()) {
    reportDamage(picture.defect);
    frame.defect = parameters_.path + ": " + picture.defect;
    return Status::ok();
  }
  frame.left = leftImage(picture.image, parameters_.layout);
  frame.right = rightImage(picture.image, parameters_.layout);
  return Status::ok();
}

}  // namespace tolman::video
