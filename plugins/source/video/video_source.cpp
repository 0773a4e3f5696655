// SPDX-License-Identifier: BSD-3-Clause
#include "video_source.hpp"

#include <algorithm>
#include <cmath>

#include "camera_device.hpp"
#include "video_file.hpp"

namespace tolman::video {
namespace {

template <class T>
Result<std::unique_ptr<Capture>> asCapture(Result<std::unique_ptr<T>> opened) {
  if (!opened.isOk()) return opened.status();
  return std::unique_ptr<Capture>(std::move(opened).value());
}

/// Contradictions between parameters.
Status checkCombination(const VideoParameters& p, PathKind kind) {
  const bool stereo = p.layout != PictureLayout::Mono;
  if (stereo && (!p.isGiven() || p.baseline == 0)) {
    return Status::invalidParameter("two cameras need a calibration; give fx and baseline");
  }
  if (!stereo && p.baseline > 0) {
    return Status::invalidParameter("baseline is given with layout: mono; set the layout");
  }
  if (kind != PathKind::Device && (p.width > 0 || p.height > 0)) {
    return Status::invalidParameter("width and height are those of a camera; remove them");
  }
  if (kind != PathKind::File && p.order != FrameOrder::Forward) {
    return Status::invalidParameter(p.path + " can be read forward only; remove order");
  }
  return Status::ok();
}

OpenCapture makeOpen(const VideoParameters& p, PathKind kind, int pipe, const Context& context) {
  if (kind == PathKind::Device) {
    const CameraRequest request{{static_cast<int>(p.width), static_cast<int>(p.height)}, p.rate};
    return [&p, request, &clock = context.clock] {
      return asCapture(CameraDevice::open(p.path, request, p.colour, clock));
    };
  }
  return [&p, pipe, &cancellation = context.cancellation] {
    return asCapture(VideoFile::open(p.path, pipe, {p.colour, p.bits}, cancellation));
  };
}

}  // namespace

Status VideoSource::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  log_ = &context.log;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  return ready_ = prepare(context);
}

Status VideoSource::prepare(const Context& context) {
  const Result<PathKind> kind = findKind(parameters_.path, pipe_, context.cancellation);
  if (!kind.isOk()) return kind.status();
  kind_ = kind.value();
  if (Status status = checkCombination(parameters_, kind_); !status.isOk()) return status;
  open_ = makeOpen(parameters_, kind_, pipe_.get(), context);
  Result<std::unique_ptr<Capture>> opened = open_();
  if (!opened.isOk()) return opened.status();
  capture_ = std::move(opened).value();
  description_ = capture_->description();
  if (Status status = makeRig(capture_->size()); !status.isOk()) return status;
  if (Status status = checkBounds(context); !status.isOk()) return status;
  return parameters_.order == FrameOrder::Forward ? Status::ok() : makeSequence();
}

Status VideoSource::makeRig(PictureSize picture) {
  const Result<PictureSize> size = cameraSize(picture, parameters_.layout);
  if (!size.isOk()) return size.status();
  const VideoParameters& p = parameters_;
  rig_ = {};
  rig_.width = size.value().width;
  rig_.height = size.value().height;
  if (!p.isGiven()) return Status::ok();
  rig_.calibrated = true;
  rig_.pinhole = p.pinhole(rig_.width, rig_.height);
  rig_.baseline = p.baseline;
  if (rig_.pinhole.cx < rig_.width && rig_.pinhole.cy < rig_.height) return Status::ok();
  return Status::invalidParameter("the principal point cx, cy is outside of the " +
                                  std::to_string(rig_.width) + "x" + std::to_string(rig_.height) +
                                  " image; give the calibration of this camera");
}

Status VideoSource::makeSequence() {
  reader_ = std::make_unique<FrameReader>(open_);
  std::vector<Picture> pictures;
  StreamEnd end;
  if (Status status = reader_->readTimes(pictures, end); !status.isOk()) return status;
  const bool used =
      parameters_.last < 0 || parameters_.last >= static_cast<std::int64_t>(pictures.size());
  if (Status status = used ? judgeEnd(end) : Status::ok(); !status.isOk()) return status;
  std::vector<std::int64_t> stamps;
  for (const Picture& picture : pictures) {
    const auto stamp = stampNs(picture, static_cast<std::int64_t>(stamps.size()));
    if (!stamp.isOk()) return stamp.status();
    stamps.push_back(stamp.value());
  }
  Result<FrameSequence> sequence = FrameSequence::make(parameters_, stamps);
  if (!sequence.isOk()) return sequence.status();
  sequence_ = std::move(sequence).value();
  return Status::ok();
}

Status VideoSource::reset() {
  if (!ready_.isOk()) return ready_;
  next_frame_ = 0;
  if (next_picture_ == 0 || kind_ == PathKind::Device) return ready_;
  next_picture_ = 0;
  if (kind_ == PathKind::Pipe) {
    return ready_ = Status::unsupported(parameters_.path + ": a pipe cannot be read twice");
  }
  Result<std::unique_ptr<Capture>> opened = open_();
  if (!opened.isOk()) return ready_ = opened.status();
  capture_ = std::move(opened).value();
  return ready_;
}

Status VideoSource::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  info.description = description_;
  if (parameters_.layout != PictureLayout::Mono) info.description += ", stereo pairs";
  if (!rig_.calibrated) info.description += ", uncalibrated";
  info.rig = rig_;
  if (reader_ != nullptr) info.frames = sequence_.size();
  return Status::ok();
}

Status VideoSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  return reader_ != nullptr ? nextOfSequence(frame) : nextForward(frame);
}

Status VideoSource::nextOfSequence(Frame& frame) {
  if (next_frame_ >= sequence_.size()) return Status::endOfStream();
  const std::int64_t index = sequence_.sourceIndex(next_frame_);
  Picture picture;
  if (Status status = reader_->read(index, picture); !status.isOk()) return status;
  frame.stamp_ns = sequence_.stampNs(next_frame_);
  return give(picture, index, frame);
}

Status VideoSource::nextForward(Frame& frame) {
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

Status VideoSource::checkBounds(const Context& context) const {
  if (kind_ != PathKind::File || (parameters_.first == 0 && parameters_.last < 0)) {
    return Status::ok();
  }
  if (parameters_.last >= 0 && parameters_.last < parameters_.first) {
    return Status::invalidParameter("last is " + std::to_string(parameters_.last) +
                                    ", before first = " + std::to_string(parameters_.first) +
                                    "; for the reverse order use order: backward");
  }
  auto opened = VideoFile::open(parameters_.path, -1, {}, context.cancellation);
  if (!opened.isOk()) return opened.status();
  return beyondEnd(opened.value()->countPackets());
}

Status VideoSource::beyondEnd(std::int64_t pictures) const {
  const std::string end = parameters_.path + " ends with frame " + std::to_string(pictures - 1);
  if (parameters_.first >= pictures) {
    return Status::invalidParameter("first is " + std::to_string(parameters_.first) + ", but " +
                                    end + "; choose a smaller one");
  }
  if (parameters_.last >= pictures) {
    return Status::invalidParameter("last is " + std::to_string(parameters_.last) + ", but " + end +
                                    "; choose a smaller one, or -1 for the end");
  }
  return Status::ok();
}

Status VideoSource::judgeEnd(const StreamEnd& end) {
  if (!end.warning.empty()) log_->warning(end.warning);
  if (end.defect.empty()) return Status::ok();
  if (parameters_.on_corrupt == OnCorrupt::Stop) return Status::invalidInput(end.defect);
  log_->warning(end.defect);
  return Status::ok();
}

/// EndOfStream after the last picture, or a failure if the stream ended too early.
Status VideoSource::atEnd() {
  if (next_picture_ == 0) return Status::invalidInput(parameters_.path + ": has no pictures");
  if (Status status = judgeEnd(capture_->end()); !status.isOk()) return status;
  if (Status status = beyondEnd(next_picture_); !status.isOk()) return status;
  return Status::endOfStream();
}

Result<std::int64_t> VideoSource::stampNs(const Picture& picture, std::int64_t index) const {
  if (parameters_.rate > 0 && kind_ != PathKind::Device) {
    return std::llround(static_cast<double>(index) * 1e9 / parameters_.rate);
  }
  if (picture.timed) return picture.stamp_ns;
  return Status::invalidInput(parameters_.path + ": says no time of picture " +
                              std::to_string(index) + "; set rate");
}

Status VideoSource::give(Picture& picture, std::int64_t index, Frame& frame) {
  frame.frame = next_frame_++;
  frame.source_index = index;
  if (!picture.defect.empty()) {
    if (parameters_.on_corrupt == OnCorrupt::Stop) {
      return Status::invalidInput(parameters_.path + ": " + picture.defect +
                                  "; copy or record it again, or leave it out by on_corrupt: skip");
    }
    frame.defect = parameters_.path + ": " + picture.defect;
    return Status::ok();
  }
  used_bits_.add(picture.widths);
  for (const auto& warning :
       {used_bits_.beyond(picture.widths.largest()), used_bits_.warning(false, frame.frame)}) {
    if (warning) log_->warning(parameters_.path + ": " + *warning);
  }
  frame.left = leftImage(picture.image, parameters_.layout);
  frame.right = rightImage(picture.image, parameters_.layout);
  return Status::ok();
}

void VideoSource::inspectPictures(std::vector<Finding>& findings) {
  std::vector<Picture> pictures;
  StreamEnd end;
  const Status status = FrameReader(open_).readTimes(pictures, end);
  const auto damaged = std::count_if(pictures.begin(), pictures.end(), [](const Picture& picture) {
    return !picture.defect.empty();
  });
  std::string text = description_ + ", " + std::to_string(pictures.size()) + " pictures";
  if (!rig_.calibrated) text += ", uncalibrated";
  findings.push_back({Finding::Severity::Note, parameters_.path, text});
  if (damaged > 0) {
    findings.push_back(
        {Finding::Severity::Error, parameters_.path,
         std::to_string(damaged) + (damaged == 1 ? " picture is" : " pictures are") +
             " damaged; copy or record it again, or leave them out by on_corrupt: skip"});
  }
  if (!pictures.empty() && !pictures.back().timed && parameters_.rate == 0) {
    findings.push_back(
        {Finding::Severity::Error, parameters_.path, "says no times of its pictures; set rate"});
  }
  if (!end.defect.empty()) findings.push_back({Finding::Severity::Error, "", end.defect});
  if (!end.warning.empty()) findings.push_back({Finding::Severity::Warning, "", end.warning});
  if (!status.isOk()) findings.push_back({Finding::Severity::Error, "", status.message()});
}

Status VideoSource::inspect(std::vector<Finding>& findings) {
  if (capture_ == nullptr || kind_ != PathKind::File) {
    findings.push_back(ready_.isOk()
                           ? Finding{Finding::Severity::Note, parameters_.path, description_}
                           : Finding{Finding::Severity::Error, "", ready_.message()});
    return Status::ok();
  }
  inspectPictures(findings);
  const bool told = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.severity == Finding::Severity::Error;
  });
  if (!ready_.isOk() && !told) {
    findings.push_back({Finding::Severity::Error, "configuration", ready_.message()});
  }
  return Status::ok();
}

}  // namespace tolman::video
