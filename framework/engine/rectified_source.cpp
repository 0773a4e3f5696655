// SPDX-License-Identifier: BSD-3-Clause
#include "engine/rectified_source.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include "base/text_file.hpp"
#include "engine/camera_check.hpp"
#include "engine/rectified_view.hpp"
#include "evaluation/association.hpp"
#include "evaluation/step_series.hpp"
#include "evaluation/trajectory.hpp"
#include "host/values.hpp"

namespace tolman::engine {

namespace {

namespace fs = std::filesystem;

constexpr double kNanoseconds = 1e9;  // of a second

bool isTruthFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// The 4x4 matrix of a calibration file that follows `key`, as EuRoC and Kalibr write it.
std::optional<Eigen::Isometry3d> matrixOf(const fs::path& file, const std::string& key) {
  const auto text = text_encoding::readText(file);
  const std::size_t found = text.isOk() ? text.value().find(key + ":") : std::string::npos;
  if (found == std::string::npos) return std::nullopt;
  const std::size_t begin = text.value().find('[', found);
  if (begin == std::string::npos) return std::nullopt;
  const char* at = text.value().c_str() + begin;
  std::array<double, 16> numbers{};
  for (double& number : numbers) {
    at += std::strcspn(at, "0123456789.-");
    while (*at == '-' && at[1] == ' ') at += 1 + std::strcspn(at + 1, "0123456789.-");
    char* end = nullptr;
    number = std::strtod(at, &end);
    if (end == at) return std::nullopt;
    at = end;
  }
  Eigen::Isometry3d T(Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data()));
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

/// A table of true poses, and the pose of its body in the raw left camera.
struct Table {
  fs::path file;
  Eigen::Isometry3d T_camera_body = Eigen::Isometry3d::Identity();
};

/// Of the first truth that a folder of EuRoC's layout has, with calibrations of both sensors.
std::optional<Table> tableIn(const fs::path& folder) {
  for (const fs::path& root : {folder / "mav0", folder}) {
    const auto T_body_camera = matrixOf(root / "cam0/sensor.yaml", "T_BS");
    auto T_camera_imu = matrixOf(folder / "camchain.yaml", "T_cam_imu");
    if (!T_camera_imu) T_camera_imu = matrixOf(folder / "dso/camchain.yaml", "T_cam_imu");
    if (!T_camera_imu && T_body_camera) T_camera_imu = T_body_camera->inverse();
    if (!T_camera_imu) continue;
    for (const char* name : {"state_groundtruth_estimate0/data.csv", "mocap0/data.csv",
                             "vicon0/data.csv", "leica0/data.csv", "gt_imu.csv"}) {
      const fs::path file = root / name;
      if (!isTruthFile(file)) continue;
      const auto T_body_sensor = matrixOf(file.parent_path() / "sensor.yaml", "T_BS");
      return Table{file, *T_camera_imu * T_body_sensor.value_or(Eigen::Isometry3d::Identity())};
    }
  }
  const fs::path of_tum = folder / "groundtruth.txt";
  if (isTruthFile(of_tum)) return Table{of_tum};
  return std::nullopt;
}

}  // namespace

Result<TruePath> TruePath::open(const config::EvaluationSettings& settings,
                                const std::string& source_path) {
  TruePath path;
  const bool body = !settings.body.empty() && settings.body != "estimate";
  if (body) {
    const auto given = evaluation::parseBody(settings.body);
    if (!given.isOk()) {
      return Status::invalidParameter("evaluation.body: " + given.status().message());
    }
    path.T_body_camera_ = given.value().pose().inverse();
    path.has_body_ = true;
  }
  const auto table =
      settings.truth.empty() && !source_path.empty() ? tableIn(source_path) : std::nullopt;
  if (settings.truth.empty() && !table) {
    if (settings.truth_offset == 0) return path;
    return Status::invalidParameter(
        "evaluation.truth_offset: the source has a truth of its own, at the times of its images; "
        "name a file by evaluation.truth, or leave it out");
  }
  path.file_ = table ? table->file : fs::path(settings.truth);
  Result<evaluation::Trajectory> poses = evaluation::readTrajectory(path.file_);
  if (!poses.isOk()) return poses.status();
  path.poses_ = std::move(poses).value();
  path.offset_ns_ = std::llround(settings.truth_offset * kNanoseconds);
  path.longest_gap_ns_ = evaluation::usualGap(path.poses_);
  path.nearest_ = settings.truth_match == config::TruthMatch::Nearest;
  path.is_point_ = table && !evaluation::hasOrientations(path.poses_);
  if (table && !body) path.T_body_raw_ = path.T_body_camera_ = table->T_camera_body.inverse();
  if (body && !evaluation::hasOrientations(path.poses_)) {
    return Status::invalidInput(path.file_.string() +
                                ": has positions alone, so that evaluation.body cannot be taken "
                                "off; score odometry.tum by `tolman eval --body` instead");
  }
  return path;
}

void TruePath::rectify(const Eigen::Matrix3d& R_rectified_raw) {
  if (T_body_raw_) T_body_camera_ = *T_body_raw_ * Eigen::Quaterniond(R_rectified_raw.transpose());
}

void TruePath::apply(Frame& frame) const {
  if (poses_.empty()) {  // the truth of the source, seen from its first body
    frame.T_world_camera_truth =
        T_body_camera_.inverse() * frame.T_world_camera_truth * T_body_camera_;
    return;
  }
  std::optional<Eigen::Isometry3d> pose;
  if (evaluation::hasStamps(poses_)) {
    const auto at = evaluation::poseAt(poses_, frame.stamp_ns + offset_ns_, longest_gap_ns_);
    if (at) pose = at->T_world_camera;
    if (at && nearest_) pose = poses_[at->before + (at->share > 0.5 ? 1 : 0)].T_world_camera;
  } else {
    const auto found = std::ranges::lower_bound(poses_, frame.source_index, {},
                                                &evaluation::TrajectoryPose::frame);
    if (found != poses_.end() && found->frame == frame.source_index) pose = found->T_world_camera;
  }
  frame.has_truth = pose.has_value();
  frame.T_world_camera_truth = Eigen::Isometry3d::Identity();
  const auto& first = poses_.front().T_world_camera;
  const Eigen::Isometry3d T = is_point_ ? Eigen::Isometry3d::Identity() : T_body_camera_;
  if (pose) frame.T_world_camera_truth = (first * T).inverse() * *pose * T;
}

std::string TruePath::pointProblem() const {
  const Eigen::Vector3d p = T_body_camera_.inverse().translation();
  if (!is_point_ || p.norm() < 1e-3) return "";
  return fmt::format(
      "has positions alone, of a point beside the camera, and errors contain its "
      "way about the camera; without it: `tolman eval {} odometry.tum "
      "--body={:.4f},{:.4f},{:.4f}`",
      file_.string(), p.x(), p.y(), p.z());
}

std::string TruePath::clockProblem(const Frame& frame) const {
  constexpr std::int64_t kFarAway = 3600'000'000'000;  // ns: longer than a wait for the truth
  if (poses_.empty() || !evaluation::hasStamps(poses_)) return "";
  const std::int64_t stamp = frame.stamp_ns + offset_ns_;
  if (stamp > poses_.front().stamp_ns - kFarAway && stamp < poses_.back().stamp_ns) return "";
  return fmt::format("the first image is of {:.3f} s and the true poses of {:.3f} to {:.3f} s",
                     static_cast<double>(stamp) / kNanoseconds,
                     static_cast<double>(poses_.front().stamp_ns) / kNanoseconds,
                     static_cast<double>(poses_.back().stamp_ns) / kNanoseconds);
}

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
  if (findings_ != nullptr) {
    if (auto finding = alternation_.add(frame.left)) {
      findings_->add("source", *std::move(finding));
    }
  }
  if (left_only_) frame.right = {};
  if (maps_.empty() && cut_.isWhole() && mask_.isEmpty()) return status;
  tbb::this_task_arena::isolate([&] { change(frame); });  // as withoutOtherTasks()
  return host::checkImages(frame, rig_);
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
