// SPDX-License-Identifier: BSD-3-Clause
#include "engine/rectified_source.hpp"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/camera_check.hpp"
#include "engine/rectified_view.hpp"
#include "host/values.hpp"

namespace tolman::engine {

Status RectifiedSource::info(SourceInfo& info) {
  Status status = SourceStage::info(info);
  is_endless_ = status.isOk() && info.frames < 0;
  if (status.isOk()) status = instance().rawRig(raw_);
  given_ = info.rig;
  if (status.isOk()) {
    Result<ImageMask> mask = ImageMask::create(given_, images_.mask);
    status = mask.status();
    if (mask.isOk()) mask_ = std::move(mask).value();
  }
  if (status.isOk() && !raw_.cameras.empty()) status = prepare(info.rig);
  if (status.isOk()) status = prepareCut(info.rig);
  const std::string truth = truth_.isGiven() && !info.has_truth ? "with truth" : "";
  if (truth_.isGiven()) info.has_truth = true;
  for (const std::string& text : {text_, cutText(), truth}) {
    if (status.isOk() && !text.empty()) info.description += "; " + text;
  }
  return status;
}

std::vector<std::string> RectifiedSource::doubts() const {
  return cameraDoubts(raw_, raw_.cameras.empty() ? given_ : rig_);
}

Status RectifiedSource::prepareCut(CameraRig& rig) {
  Result<ImageCut> cut = ImageCut::create(rig, images_.crop, images_.scale);
  if (!cut.isOk()) return cut.status();
  cut_ = std::move(cut).value();
  rig = rig_ = cut_.rig();
  depth_arrays_.clear();
  if (cut_.isWhole() && maps_.empty()) return Status::ok();
  std::vector<ArrayInfo> arrays;
  const Status status = instance().describe(arrays);
  for (const ArrayInfo& array : arrays) {
    if (array.kind == ArrayKind::DepthImage) depth_arrays_.push_back(array.name);
  }
  return status;
}

Status RectifiedSource::prepare(CameraRig& rig) {
  maps_.clear();
  left_only_ = false;
  if (settings_.mode == config::RectificationMode::Off) {
    left_only_ = true;
    text_ = "raw images, not rectified, of the left camera alone";
    return Status::ok();
  }
  const auto view = chooseView(raw_, {settings_.scale, settings_.field_of_view});
  if (!view.isOk()) {
    return Status::invalidInput("the images cannot be rectified: " + view.status().message() +
                                " (`rectification.mode: off` gives the left images as they are)");
  }
  for (const RawCamera& camera : raw_.cameras) {
    if (camera.width == rig.width && camera.height == rig.height) continue;
    return Status::invalidInput("the calibration is of images of " + std::to_string(camera.width) +
                                "x" + std::to_string(camera.height) + " px, but they have " +
                                std::to_string(rig.width) + "x" + std::to_string(rig.height) +
                                "; give the calibration of these images");
  }
  const RectifiedView& chosen = view.value();
  rig = chosen.rig;
  truth_.rectify(chosen.R_rectified_raw.front());
  text_ = viewText(raw_, chosen);
  if (chosen.is_identity) return Status::ok();
  for (std::size_t i = 0; i < raw_.cameras.size(); ++i) {
    maps_.emplace_back(raw_.cameras[i], chosen.R_rectified_raw[i], chosen.rig);
  }
  return Status::ok();
}

Status RectifiedSource::next(Frame& frame) {
  Status status = SourceStage::next(frame);
  if (findings_ != nullptr) status = findings_->judge(status, frame.frame);
  if (!status.isOk()) return status;
  if (truth_.applies()) addTruth(frame);
  alternates_ = alternation_.add(frame.left) || alternates_;
  if (findings_ != nullptr) {
    if (auto finding = alternation()) findings_->add("source", *std::move(finding));
  }
  if (left_only_) frame.right = {};
  if (maps_.empty() && cut_.isWhole() && mask_.isEmpty()) return status;
  tbb::this_task_arena::isolate([&] { change(frame); });  // as withoutOtherTasks()
  return host::checkImages(frame, rig_);
}

std::optional<Finding> RectifiedSource::alternation() {
  if (!std::exchange(alternates_, false)) return std::nullopt;
  return Finding{Finding::Severity::Warning, "images",
                 "every second one has more texture, as of a projector that blinks "
                 "(emitter_on_off): its dots stand still in the camera",
                 "use the others: add " + std::to_string(alternation_.first()) +
                     " to source.first, and set source.step to 2",
                 Finding::Kind::Unusual};
}

void RectifiedSource::addTruth(Frame& frame) {
  truth_.apply(frame);
  if (std::exchange(checked_truth_, true) || findings_ == nullptr) return;
  const auto warn = [&](const std::string& problem, const char* remedy) {
    if (problem.empty()) return;
    findings_->add("evaluation", {Finding::Severity::Warning, truth_.file().string(), problem,
                                  remedy, Finding::Kind::Contradiction});
  };
  warn(truth_.clockProblem(frame), "set evaluation.truth_offset");
  warn(truth_.pointProblem(), "");
}

void RectifiedSource::change(Frame& frame) const {
  frame.left = mask_.apply(frame.left);
  frame.right = mask_.apply(frame.right);
  if (!maps_.empty()) {
    frame.left = maps_.front().apply(frame.left);
    frame.right = maps_.size() == 2 ? maps_.back().apply(frame.right) : Image();
  }
  frame.left = cut_.apply(frame.left);
  frame.right = cut_.apply(frame.right);
  for (NamedArray& sensor : frame.sensors) {
    if (std::ranges::find(depth_arrays_, sensor.name) == depth_arrays_.end()) continue;
    if (!maps_.empty()) maps_.front().apply(sensor);
    cut_.apply(sensor);
  }
}

}  // namespace tolman::engine
