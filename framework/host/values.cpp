// SPDX-License-Identifier: BSD-3-Clause
#include "host/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "config/limits.hpp"
#include "config/text.hpp"

namespace tolman::host {
namespace {

Status checkImage(const Image& image, const CameraRig& rig, const char* side) {
  const int width = image.width();
  const int height = image.height();
  if (image.empty()) {
    if (width == 0 && height == 0) return Status::ok();
    return Status::failed(
        fmt::format("the {} image has {}x{} px and no data", side, width, height));
  }
  if (width != rig.width || height != rig.height) {
    return Status::invalidInput(fmt::format("an image of {}x{} px; the rig has {}x{}", width,
                                            height, rig.width, rig.height));
  }
  if (image.format() != PixelFormat::Gray8 && image.format() != PixelFormat::Bgr8) {
    return Status::failed(fmt::format("the {} image has an unknown pixel format", side));
  }
  const std::ptrdiff_t row = std::ptrdiff_t{width} * bytesPerPixel(image.format());
  if (image.stride() >= row) return Status::ok();
  return Status::failed(fmt::format("the {} image has rows of {} bytes and a stride of {}", side,
                                    row, image.stride()));
}

}  // namespace

Status checkImages(const Frame& frame, const CameraRig& rig) {
  Status status = checkImage(frame.left, rig, "left");
  if (status.isOk()) status = checkImage(frame.right, rig, "right");
  if (!status.isOk() || !rig.isStereo()) return status;
  if (frame.left.empty() != frame.right.empty()) {
    return Status::failed(
        fmt::format("only the {} image of a pair; give both, or none and a 'defect' that says why",
                    frame.left.empty() ? "right" : "left"));
  }
  if (frame.left.empty() || frame.left.format() == frame.right.format()) return status;
  return Status::failed("the images of a pair have different pixel formats");
}

Status checkRig(const CameraRig& rig) {
  if (rig.width < 0 || rig.height < 0 || (rig.width == 0) != (rig.height == 0)) {
    return Status::invalidInput(
        fmt::format("the cameras have images of {}x{} px; give their width and height, or 0 and 0 "
                    "where there are no images",
                    rig.width, rig.height));
  }
  if (rig.baseline < 0) {
    return Status::invalidInput(
        fmt::format("the baseline of the cameras is {:.5g} m; it is the distance of the right "
                    "camera to the right of the left one: exchange the two cameras if they are "
                    "the wrong way round, or give 0 for a single one",
                    rig.baseline));
  }
  if (!rig.calibrated || (rig.pinhole.fx > 0 && rig.pinhole.fy > 0)) return Status::ok();
  return Status::invalidInput(fmt::format(
      "the focal lengths of the cameras are {:.5g} and {:.5g} px; they must be above 0: "
      "correct the calibration, or set `calibrated` to false where they are not known",
      rig.pinhole.fx, rig.pinhole.fy));
}

namespace {

Status checkName(std::string_view name) {
  const bool fits = !name.empty() && name.size() <= config::kLongestName;
  if (fits && config::isPrintable(name)) return Status::ok();
  return Status::failed(
      fmt::format("the array name '{}' is not of 1 to {} bytes of UTF-8 without control characters",
                  config::printable(name.substr(0, config::kLongestName)), config::kLongestName));
}

Status checkArray(const NamedArray& array) {
  if (Status status = checkName(array.name); !status.isOk()) return status;
  if (!config::shapeFits(array.shape, array.values.size())) {
    return Status::failed("array '" + array.name + "' has a size that differs from its shape");
  }
  if (std::ranges::all_of(array.values, [](float value) { return std::isfinite(value); })) {
    return Status::ok();
  }
  return Status::failed("array '" + array.name +
                        "' has NaN, infinity or a number beyond 3.4e38, the largest of 32 bits");
}

/// Whether two shapes differ at most in the length of the first axis.
bool differInLength(std::span<const int> a, std::span<const int> b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::ranges::equal(a.subspan(1), b.subspan(1));
}

Status changedShape(const NamedArray& array) {
  return Status::failed("array '" + array.name + "' changed its shape");
}

/// Checks the number of arrays, each array, and that names are unique.
template <class Named, class CheckOne>
Status checkEach(std::span<const Named> all, const CheckOne& check_one) {
  if (all.size() > config::kMaxArrays) {
    return Status::failed(
        fmt::format("{} arrays; at most {} are allowed", all.size(), config::kMaxArrays));
  }
  std::set<std::string_view> names;
  for (const Named& one : all) {
    if (Status status = check_one(one); !status.isOk()) return status;
    if (!names.insert(one.name).second) {
      return Status::failed("array '" + one.name + "' is given twice");
    }
  }
  return Status::ok();
}

}  // namespace

Status checkArrays(const std::vector<NamedArray>& arrays) {
  return checkEach(std::span(arrays), checkArray);
}

Status checkDescriptions(std::span<const ArrayInfo> arrays) {
  return checkEach(arrays, [](const ArrayInfo& info) {
    const Status status = checkName(info.name);
    return status.isOk() ? checkValues(info) : status;
  });
}

Status ArrayShapes::checkShapes(const std::vector<NamedArray>& arrays) {
  if (Status status = checkArrays(arrays); !status.isOk()) return status;
  for (const NamedArray& array : arrays) {
    const auto& [known, is_new] = known_.emplace(array.name, array.shape);
    if (!is_new && !differInLength(known->second, array.shape)) return changedShape(array);
  }
  return Status::ok();
}

Status ArrayShapes::check(const std::vector<NamedArray>& arrays) {
  if (Status status = checkArrays(arrays); !status.isOk()) return status;
  const bool is_first = known_.empty();
  std::size_t same = 0;
  for (const NamedArray& array : arrays) {
    const auto& [known, is_new] = known_.emplace(array.name, array.shape);
    if (is_new && !is_first) {
      return Status::failed("array '" + array.name +
                            "' was not there before; the names stay the same over a run");
    }
    if (known->second != array.shape) return changedShape(array);
    ++same;
  }
  if (same == known_.size()) return Status::ok();
  const auto missing = std::ranges::find_if(known_, [&](const auto& known) {
    return std::ranges::find(arrays, known.first, &NamedArray::name) == arrays.end();
  });
  return Status::failed("array '" + missing->first +
                        "' is missing; the names stay the same over a run");
}

}  // namespace tolman::host
