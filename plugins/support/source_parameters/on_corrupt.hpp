// SPDX-License-Identifier: BSD-3-Clause
// What a source does where its data are damaged.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace tolman::source_parameters {

enum class OnCorrupt : std::uint8_t {
  Stop,  ///< next() fails
  Skip,  ///< what can be read is used; a damaged image is a frame without images, with `defect`
};
inline constexpr std::array<std::string_view, 2> kOnCorruptNames = {"stop", "skip"};
constexpr std::span<const std::string_view> enumNames(OnCorrupt) { return kOnCorruptNames; }

}  // namespace tolman::source_parameters
