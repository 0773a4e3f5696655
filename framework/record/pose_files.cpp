// SPDX-License-Identifier: BSD-3-Clause
#include "record/pose_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace tolman::record {
namespace {

// A damaged frame number must not fill the disk with repeated lines.
constexpr std::int64_t kMaxFrames = 100'000'000;
constexpr std::int64_t kMaxGap = 1'000'000;

std::string kittiLine(const Eigen::Isometry3d& T) {
  std::string line;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (!line.empty()) line += ' ';
      line += numberText(T.matrix()(row, column));
    }
  }
  return line + "\n";
}

}  // namespace

std::string numberText(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0).ptr;
  return {text.data(), end};
}

std::string secondsText(std::int64_t time_ns) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  const auto bits = static_cast<std::uint64_t>(time_ns);
  const std::uint64_t size = time_ns < 0 ? -bits : bits;
  return fmt::format("{}{}.{:09}", time_ns < 0 ? "-" : "", size / kSecond, size % kSecond);
}

std::string poseText(const Eigen::Isometry3d& T) {
  Eigen::Quaterniond q = Eigen::Quaterniond(T.linear()).normalized();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  std::string text;
  for (int i = 0; i < 3; ++i) text += numberText(T.translation()[i]) + " ";
  for (int i = 0; i < 3; ++i) text += numberText(q.coeffs()[i]) + " ";
  return text + numberText(q.w());
}

std::string tumText(const evaluation::Trajectory& poses) {
  std::string text;
  for (const evaluation::TrajectoryPose& pose : poses) {
    text += secondsText(pose.stamp_ns) + " " + poseText(pose.T_world_camera) + "\n";
  }
  return text;
}

Result<std::string> kittiText(const evaluation::Trajectory& poses, std::int64_t frames) {
  std::string text;
  std::string line = kittiLine(Eigen::Isometry3d::Identity());
  std::int64_t next = 0;
  const auto repeatUntil = [&](std::int64_t frame) {
    if (frame < next || frame - next > kMaxGap || frame > kMaxFrames) {
      return Status::invalidInput(
          fmt::format("frame {} comes where frame {} was due; the record is damaged", frame, next));
    }
    for (; next < frame; ++next) text += line;
    return Status::ok();
  };
  for (const evaluation::TrajectoryPose& pose : poses) {
    if (Status status = repeatUntil(pose.frame); !status.isOk()) return status;
    line = kittiLine(pose.T_world_camera);
    text += line;
    ++next;
  }
  if (Status status = repeatUntil(std::max(next, frames)); !status.isOk()) return status;
  return text;
}

}  // namespace tolman::record
