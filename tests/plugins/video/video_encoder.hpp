// SPDX-License-Identifier: BSD-3-Clause
// Writes videos with FFmpeg's libraries, with options that OpenCV's writer does not have.
#pragma once

#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace tolman::video {

using Options = std::map<std::string, std::string>;

/// Writes grey pictures of 8 or 16 bits at 10 Hz; the name's ending chooses the container. `codec`
/// is FFmpeg's name of an encoder.
void encodeVideo(const std::filesystem::path& file, const std::string& codec,
                 const std::vector<cv::Mat>& pictures, const Options& codec_options = {},
                 const Options& container_options = {});

}  // namespace tolman::video
