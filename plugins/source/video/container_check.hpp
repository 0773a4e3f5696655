// SPDX-License-Identifier: BSD-3-Clause
// Damage of a video container that FFmpeg reads over.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tolman::video {

struct ContainerCheck {
  std::string defect;  ///< first contradiction, such as "is damaged at byte 1234"; empty: none
  std::optional<double> promised_s;  ///< length by the header, where only the check knows it
};

/// `format`: FFmpeg's name of it. Nothing is found in formats that have no check here.
ContainerCheck checkContainer(const std::filesystem::path& path, std::string_view format);

}  // namespace tolman::video
