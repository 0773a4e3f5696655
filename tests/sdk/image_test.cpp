// SPDX-License-Identifier: BSD-3-Clause
#include "tolman/image.hpp"

#include <catch2/catch.hpp>

#include "tolman/image_cv.hpp"

using namespace tolman;

TEST_CASE("an image owns its pixels through every copy") {
  Image copy;
  {
    const Image image = Image::create(3, 2, PixelFormat::Gray8, [](std::uint8_t* pixel) {
      for (int i = 0; i < 6; ++i) pixel[i] = static_cast<std::uint8_t>(10 * i);
    });
    copy = image;
    CHECK(copy.data() == image.data());
  }
  CHECK(copy.row(1)[2] == 50);
  CHECK(copy.stride() == 3);
  CHECK(Image().empty());
  CHECK(Image::create(2, 2, PixelFormat::Bgr8, [](std::uint8_t*) {}).stride() == 6);
}

TEST_CASE("a foreign owner is released with the last view") {
  auto owner = std::make_shared<std::vector<std::uint8_t>>(12, std::uint8_t{7});
  const std::weak_ptr<std::vector<std::uint8_t>> watch = owner;
  auto image = std::make_unique<Image>(owner->data(), 4, 3, 4, PixelFormat::Gray8, owner);
  owner.reset();
  CHECK_FALSE(watch.expired());
  CHECK(image->row(2)[3] == 7);
  image.reset();
  CHECK(watch.expired());
}

TEST_CASE("cv::Mat and Image share pixels, rows with gaps included") {
  cv::Mat whole(4, 10, CV_8UC1, cv::Scalar(1));
  const cv::Mat part = whole.colRange(2, 7);
  const Image image = asImage(part);
  CHECK(image.width() == 5);
  CHECK(image.stride() == 10);
  CHECK(image.data() == part.data);
  const cv::Mat back = asMat(image);
  CHECK(back.data == part.data);
  CHECK(back.size() == part.size());
  whole.release();
  CHECK(image.row(3)[4] == 1);  // the view keeps OpenCV's buffer alive
  CHECK(asMat(Image()).empty());
  CHECK(asImage(cv::Mat()).empty());
  CHECK_THROWS_AS(asImage(cv::Mat(2, 2, CV_32F)), std::invalid_argument);
}
