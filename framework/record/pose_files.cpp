// SPDX-License-Identifier: BSD-3-Clause
#include "record/pose_files.hpp"

#include <array>
#include <charconv>

namespace tolman::record {
namespace {

// A damaged frame number must not fill the disk with repeated lines.
constexpr std::int64_t kMaxFrames = 100'000'000;
constexpr std::int64_t kMaxGap = 1'000'000;

std::string stampText(std::int64_t stamp_ns) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  const bool negative = stamp_ns < 0;
  const auto bits = static_cast<std::uint64_t>(stamp_ns);
  const std::uint64_t size = negative ? -bits : bits;
  const std::string decimals = std::to_string(kSecond + size % kSecond).substr(1);
  std::string text = negative ? "-" : "";
  text += std::to_string(size / kSecond);
  return text + "." + decimals;
}

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

std::string poseText(const Eigen::Isometry3d& T) {
  Eigen::Quaterniond q = Eigen::Quaterniond(T.linear()).normalized();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  std::string text;
  for (int i = 0; i < 3; ++i) text += numberText(T.translation()[i]) + " ";
  for (int i = 0; i < 3; ++i) text += numberText(q.coeffs()[i]) + " ";
  return text + numberText(q.w());
}

std::string tumText(std::span<const StampedPose> poses) {
  std::string text;
  for (const StampedPose& pose : poses) {
    text += stampText(pose.stamp_ns) + " " + poseText(pose.T_world_camera) + "\n";
  }
  return text;
}

Result<std::string> kittiText(std::span<const StampedPose> poses) {
  std::string text;
  std::string line = kittiLine(Eigen::Isometry3d::Identity());
  std::int64_t next = 0;
  for (const StampedPose& pose : poses) {
    if (pose.frame < next || pose.frame - next > kMaxGap || pose.frame > kMaxFrames) {
      return Status::invalidInput("frame " + std::to_string(pose.frame) + " comes where frame " +
                                  std::to_string(next) + " was due; the record is damaged");
    }
    for (; next < pose.frame; ++next) text += line;
    line = kittiLine(pose.T_world_camera);
    text += line;
    ++next;
  }
  return text;
}

}  // namespace tolman::record
