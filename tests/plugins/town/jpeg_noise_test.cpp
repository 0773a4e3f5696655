// SPDX-License-Identifier: BSD-3-Clause
// Compression, compared with OpenCV's encoder and decoder.
#include "jpeg_noise.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "sensor.hpp"
#include "small_town.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

namespace {

Image picture() {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[30]);
  Sensor sensor;
  sensor.width = view.width;
  sensor.height = view.height;
  return expose(sensor, town.picture(view).radiance, 0);
}

/// Root mean square of the difference and its largest value, grey levels.
std::pair<double, int> difference(const Image& a, const Image& b) {
  double squares = 0;
  int largest = 0;
  for (int row = 0; row < a.height(); ++row) {
    for (int column = 0; column < a.width(); ++column) {
      const int d = a.row(row)[column] - b.row(row)[column];
      squares += d * d;
      largest = std::max(largest, std::abs(d));
    }
  }
  return {std::sqrt(squares / (a.width() * a.height())), largest};
}

Image throughOpenCv(const Image& image, int quality) {
  const cv::Mat view(image.height(), image.width(), CV_8UC1,
                     const_cast<std::uint8_t*>(image.data()),
                     static_cast<std::size_t>(image.stride()));
  std::vector<std::uint8_t> file;
  cv::imencode(".jpg", view, file, {cv::IMWRITE_JPEG_QUALITY, quality});
  const cv::Mat decoded = cv::imdecode(file, cv::IMREAD_GRAYSCALE);
  return Image::create(image.width(), image.height(), PixelFormat::Gray8, [&](std::uint8_t* out) {
    for (int row = 0; row < image.height(); ++row) {
      std::copy_n(decoded.ptr<std::uint8_t>(row), image.width(),
                  out + std::ptrdiff_t{row} * image.width());
    }
  });
}

}  // namespace

TEST_CASE("the loss is that of a JPEG library") {
  const Image sharp = picture();
  for (const int quality : {10, 50, 90}) {
    CAPTURE(quality);
    const Image ours = throughJpeg(sharp, quality);
    const Image theirs = throughOpenCv(sharp, quality);
    CHECK(difference(ours, theirs).first < 0.35 * difference(ours, sharp).first);
    CHECK(difference(ours, sharp).first == Approx(difference(theirs, sharp).first).epsilon(0.05));
  }
}

TEST_CASE("less quality, more loss; the best loses about a rounding step") {
  const Image sharp = picture();
  CHECK(difference(throughJpeg(sharp, 100), sharp).second <= 2);
  CHECK(difference(throughJpeg(sharp, 20), sharp).first >
        1.5 * difference(throughJpeg(sharp, 80), sharp).first);
}
