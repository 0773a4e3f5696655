// SPDX-License-Identifier: BSD-3-Clause
// Writes videos with OpenCV, and reads sources to their end.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "support/context.hpp"
#include "video_source.hpp"

namespace tolman::video {

/// A grey picture of one level, which tells its number: 10 + 4 * index.
cv::Mat flatPicture(int index, int width = 64, int height = 48);
/// The number of the picture that such an image shows.
int numberOf(const Image& image);

/// Writes the pictures at `rate` Hz; `codec` is the four letters of the coder.
void writeVideo(const std::filesystem::path& file, const std::string& codec, double rate,
                const std::vector<cv::Mat>& pictures);
/// The same of `count` flat pictures.
void writeFlatVideo(const std::filesystem::path& file, int count, double rate = 10,
                    const std::string& codec = "FFV1");

/// Leaves the first `part` of the bytes of a file.
void cutFile(const std::filesystem::path& file, double part);

/// A configured source and what it gave.
struct Played {
  explicit Played(const std::filesystem::path& path, ParameterValues values = {});
  /// Numbers of the flat pictures, -1 for a frame without an image.
  std::vector<int> numbers() const;
  std::vector<std::int64_t> stamps() const;

  test::TestContext context;
  VideoSource source;
  SourceInfo info;
  std::vector<Frame> frames;
  std::string message;  ///< of the failure of configure() or next(); empty after the end
};

}  // namespace tolman::video
