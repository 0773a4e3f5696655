// SPDX-License-Identifier: BSD-3-Clause
#include "image_sets.hpp"

#include <algorithm>
#include <utility>

namespace tolman::live_images {

void ImageSets::drop(std::deque<Arrived>& camera) {
  camera.pop_front();
  ++left_out_;
}

void ImageSets::add(std::size_t camera, Arrived image) {
  constexpr std::size_t kMax = 100;
  if (cameras_[camera].size() == kMax) drop(cameras_[camera]);
  cameras_[camera].push_back(std::move(image));
}

std::optional<ImageSet> ImageSets::take() {
  const auto is_empty = [](const auto& camera) { return camera.empty(); };
  while (std::ranges::none_of(cameras_, is_empty)) {
    const std::int64_t stamp_ns = cameras_.front().front().stamp_ns;
    const auto apart = std::ranges::find_if(cameras_, [&](const auto& camera) {
      return std::abs(camera.front().stamp_ns - stamp_ns) > tolerance_ns_;
    });
    if (apart != cameras_.end()) {
      drop(apart->front().stamp_ns < stamp_ns ? *apart : cameras_.front());
      continue;
    }
    ImageSet set;
    for (auto& camera : cameras_) {
      set.push_back(std::move(camera.front()));
      camera.pop_front();
    }
    return set;
  }
  return std::nullopt;
}

}  // namespace tolman::live_images
