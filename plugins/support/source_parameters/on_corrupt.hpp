// SPDX-License-Identifier: BSD-3-Clause
// The reaction of a source to damaged data.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::source_parameters {

enum class OnCorrupt : std::uint8_t {
  Stop,  ///< next() fails
  Skip,  ///< damaged data are skipped; a damaged image gives a frame without images, with `defect`
};
inline constexpr std::array<std::string_view, 2> kOnCorruptNames = {"stop", "skip"};
constexpr std::span<const std::string_view> enumNames(OnCorrupt) { return kOnCorruptNames; }

/// The message of a failure without the remedies at its end, if on_corrupt: skip is one of them:
/// for those who have chosen it.
inline std::string withoutAdvice(const std::string& message) {
  const std::size_t advice = message.rfind("on_corrupt: skip");
  return advice == std::string::npos ? message : message.substr(0, message.rfind(';', advice));
}

/// The last step of a source's next(). `status`: whether the frame's images could be read.
inline Status finishFrame(const Status& status, OnCorrupt on_corrupt, Frame& frame) {
  if (status.isOk() || on_corrupt == OnCorrupt::Stop) return status;
  frame.left = frame.right = {};
  frame.defect = withoutAdvice(status.message());
  return Status::ok();
}

}  // namespace tolman::source_parameters
