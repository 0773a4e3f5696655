// SPDX-License-Identifier: BSD-3-Clause
#include "template_bank.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace tolman::view_templates {

FixedCell toFixed(float cell) { return static_cast<FixedCell>(std::lround(cell * kOne)); }

std::int64_t TemplateBank::add(const LocalView& view) {
  if (view.cells.size() != cellsPerTemplate()) throw std::invalid_argument("view of another size");
  for (const float cell : view.cells) cells_.push_back(toFixed(cell));
  means_.push_back(view.mean);
  return size() - 1;
}

void TemplateBank::clear() {
  cells_.clear();
  means_.clear();
}

void TemplateBank::restore(std::vector<FixedCell> cells, std::vector<double> means) {
  if (cells.size() != means.size() * cellsPerTemplate()) {
    throw std::invalid_argument("as many cells as the means need");
  }
  cells_ = std::move(cells);
  means_ = std::move(means);
}

using namespace landmarks;

const Corners& LandmarkMemory::cornersOf(const Frame& frame) {
  if (!has_corners_) frame_corners_ = findCorners(grayOf(frame.left), corners_);
  has_corners_ = true;
  return frame_corners_;
}

void LandmarkMemory::add(const Frame& frame) {
  Landmarks landmarks;
  if (!frame.right.empty() && hasStereo()) {
    landmarks = findLandmarks(grayOf(frame.left), grayOf(frame.right), rig_, cornersOf(frame));
  }
  templates_.push_back(std::move(landmarks));
}

bool LandmarkMemory::hasEnough(std::int64_t id) const {
  return static_cast<int>(templates_[static_cast<std::size_t>(id)].points.size()) >= least_;
}

std::optional<MeasuredPose> LandmarkMemory::locate(const Frame& frame, std::int64_t id,
                                                   landmarks::Agreement& agreement) {
  const Landmarks& landmarks = templates_[static_cast<std::size_t>(id)];
  const Corners& corners = cornersOf(frame);
  return poseOf(findAgain(landmarks, corners), rig_.pinhole, least_, corners.sigma, &agreement);
}

void LandmarkMemory::save(StateWriter& writer) const {
  writer.put(static_cast<std::uint64_t>(templates_.size()));
  for (const Landmarks& landmarks : templates_) {
    writer.put(static_cast<std::uint64_t>(landmarks.points.size()));
    for (std::size_t i = 0; i < landmarks.points.size(); ++i) {
      const cv::Point3f& p = landmarks.points[i];
      writer.putAll<float>(std::vector<float>{p.x, p.y, p.z});
      writer.putAll(std::span<const std::uint8_t>(
          landmarks.descriptions.ptr<std::uint8_t>(static_cast<int>(i)), kDescriptionBytes));
    }
  }
}

bool LandmarkMemory::load(StateReader& reader) {
  constexpr std::size_t kBytesEach = 3 * sizeof(float) + kDescriptionBytes;
  templates_.clear();
  has_corners_ = false;
  const auto count = reader.get<std::uint64_t>();
  if (count > reader.remaining() / sizeof(std::uint64_t)) return false;
  for (std::uint64_t t = 0; t < count; ++t) {
    const auto points = reader.get<std::uint64_t>();
    if (points > reader.remaining() / kBytesEach) return false;
    Landmarks landmarks;
    landmarks.descriptions.create(static_cast<int>(points), kDescriptionBytes, CV_8U);
    for (std::uint64_t i = 0; i < points; ++i) {
      std::array<float, 3> p{};
      reader.getAll<float>(p);
      landmarks.points.emplace_back(p[0], p[1], p[2]);
      reader.getAll(std::span<std::uint8_t>(
          landmarks.descriptions.ptr<std::uint8_t>(static_cast<int>(i)), kDescriptionBytes));
    }
    templates_.push_back(std::move(landmarks));
  }
  return true;
}

}  // namespace tolman::view_templates
