// SPDX-License-Identifier: BSD-3-Clause
// Gradient statistics of the town compared with those of real streets, if the data are available.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "support/context.hpp"
#include "support/data.hpp"
#include "town_source.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

/// Of one image, or the mean of several.
struct Statistics {
  double mean_grey = 0;
  double mean_gradient = 0;  ///< grey levels a pixel
  double selectable = 0;     ///< share of pixels above the threshold of direct sparse odometry

  void add(const Statistics& other, double weight) {
    mean_grey += weight * other.mean_grey;
    mean_gradient += weight * other.mean_gradient;
    selectable += weight * other.selectable;
  }
};

float gradientAt(const cv::Mat& image, int x, int y) {
  const float dx = 0.5F * static_cast<float>(image.at<uchar>(y, x + 1) - image.at<uchar>(y, x - 1));
  const float dy = 0.5F * static_cast<float>(image.at<uchar>(y + 1, x) - image.at<uchar>(y - 1, x));
  return std::hypot(dx, dy);
}

constexpr int kBlock = 32;

/// Gradients of one block and its threshold: the median, capped at 48, plus 7.
struct Block {
  std::vector<float> gradients;
  float threshold = 0;
};

Block blockAt(const cv::Mat& image, int column, int row) {
  Block block;
  for (int y = 0; y < kBlock; ++y) {
    for (int x = 0; x < kBlock; ++x) {
      const int px = std::clamp(column * kBlock + x, 1, image.cols - 2);
      const int py = std::clamp(row * kBlock + y, 1, image.rows - 2);
      block.gradients.push_back(gradientAt(image, px, py));
    }
  }
  std::vector<float> sorted = block.gradients;
  std::nth_element(sorted.begin(), sorted.begin() + kBlock * kBlock / 2, sorted.end());
  block.threshold = std::min(sorted[kBlock * kBlock / 2], 48.0F) + 7;
  return block;
}

Statistics statisticsOf(const cv::Mat& image) {
  const int columns = image.cols / kBlock;
  const int rows = image.rows / kBlock;
  std::vector<Block> blocks;
  for (int i = 0; i < columns * rows; ++i) {
    blocks.push_back(blockAt(image, i % columns, i / columns));
  }
  Statistics result;
  std::size_t above = 0;
  for (int i = 0; i < columns * rows; ++i) {
    float threshold = 0;  // mean over the 3 x 3 neighbouring blocks
    int count = 0;
    for (int r = std::max(i / columns - 1, 0); r <= std::min(i / columns + 1, rows - 1); ++r) {
      for (int c = std::max(i % columns - 1, 0); c <= std::min(i % columns + 1, columns - 1); ++c) {
        threshold += blocks[static_cast<std::size_t>(r * columns + c)].threshold;
        ++count;
      }
    }
    for (const float g : blocks[static_cast<std::size_t>(i)].gradients) {
      above += g > threshold / static_cast<float>(count);
      result.mean_gradient += static_cast<double>(g);
    }
  }
  const double pixels = static_cast<double>(blocks.size()) * kBlock * kBlock;
  result.mean_gradient /= pixels;
  result.selectable = static_cast<double>(above) / pixels;
  result.mean_grey = cv::mean(image)[0];
  return result;
}

Statistics ofClip(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "image_0")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  Statistics sum;
  constexpr std::size_t kTaken = 5;
  for (std::size_t i = 0; i < kTaken; ++i) {
    const std::size_t index = i * files.size() / kTaken;
    sum.add(statisticsOf(cv::imread(files[index].string(), cv::IMREAD_GRAYSCALE)), 1.0 / kTaken);
  }
  return sum;
}

Statistics ofTown(const char* route, std::int64_t step) {
  tolman::test::TestContext context(
      {{"route", std::string(route)}, {"step", step}, {"mono", true}});
  TownSource source;
  REQUIRE(source.configure(context).isOk());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  Statistics sum;
  for (Frame frame; source.next(frame).isOk(); frame = {}) {
    const cv::Mat image(frame.left.height(), frame.left.width(), CV_8U,
                        const_cast<std::uint8_t*>(frame.left.data()));
    sum.add(statisticsOf(image), 1.0 / static_cast<double>(info.frames));
  }
  return sum;
}

}  // namespace

TEST_CASE("the town's pictures have the gradients of a real street", "[data]") {
  Statistics real;
  constexpr std::array<const char*, 3> kClips = {"06", "raw_0001", "00_left"};
  for (const char* clip : kClips) {
    const auto folder = tolman::test::dataOrSkip(std::string("kitti_clips/") + clip);
    if (!folder) return;
    real.add(ofClip(*folder), 1.0 / kClips.size());
  }
  for (const auto& [route, step] : {std::pair("block", 90), std::pair("district", 250)}) {
    const Statistics town = ofTown(route, step);
    INFO(route << ": grey " << town.mean_grey << ", gradient " << town.mean_gradient
               << ", selectable " << town.selectable << "; real: " << real.mean_grey << ", "
               << real.mean_gradient << ", " << real.selectable);
    CHECK(town.mean_grey == Approx(real.mean_grey).epsilon(0.25));
    CHECK(town.mean_gradient == Approx(real.mean_gradient).epsilon(0.3));
    CHECK(town.selectable == Approx(real.selectable).epsilon(0.25));
  }
}
