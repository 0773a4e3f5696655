// SPDX-License-Identifier: BSD-3-Clause
// JPEG data, undamaged and damaged. The undamaged ones are compared with cv::imdecode.
#include "jpeg_decoder.hpp"

#include <jpeglib.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>  // for jpeglib.h
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tolman/context.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::coded_images {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Smooth structure and some noise, as images of cameras have it.
cv::Mat blurredPicture(int type) {
  cv::Mat pixels(96, 128, type);
  cv::RNG(7).fill(pixels, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(pixels, pixels, {7, 7}, 2);
  return pixels;
}

Bytes encoded(int type, const std::vector<int>& options = {}) {
  Bytes bytes;
  cv::imencode(".jpg", blurredPicture(type), bytes, options);
  return bytes;
}

/// Where the entropy-coded data of the first scan begin: after the segment SOS.
std::size_t dataBegin(const Bytes& bytes) {
  constexpr std::uint8_t kSos[] = {0xff, 0xda};
  const auto marker = std::search(bytes.begin(), bytes.end(), std::begin(kSos), std::end(kSos));
  const auto at = static_cast<std::size_t>(marker - bytes.begin());
  return at + 2 + bytes.at(at + 2) * 256U + bytes.at(at + 3);
}

/// As printers want it: four colours, all of one value.
Bytes fourColours(int width, int height) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* memory = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): libjpeg's type
  jpeg_mem_dest(&jpeg, &memory, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = 4;
  jpeg.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  Bytes row(static_cast<std::size_t>(width) * 4, 100);
  JSAMPROW rows = row.data();
  for (int y = 0; y < height; ++y) jpeg_write_scanlines(&jpeg, &rows, 1);
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  const Bytes bytes(memory, memory + size);
  std::free(memory);
  return bytes;
}

double difference(const Image& image, const cv::Mat& expected) {
  return cv::norm(asMat(image), expected, cv::NORM_INF);
}

}  // namespace

TEST_CASE("sound JPEG data give the pixels that OpenCV gives") {
  const int type = GENERATE(CV_8UC1, CV_8UC3);
  const int progressive = GENERATE(0, 1);
  const int restart = GENERATE(0, 4);  // MCUs between restart markers
  const Bytes bytes = encoded(
      type, {cv::IMWRITE_JPEG_PROGRESSIVE, progressive, cv::IMWRITE_JPEG_RST_INTERVAL, restart});
  CAPTURE(type, progressive, restart);
  const Result<Image> grey = decodeJpeg(bytes, false);
  REQUIRE(grey.isOk());
  CHECK(difference(grey.value(), cv::imdecode(bytes, cv::IMREAD_GRAYSCALE)) <= 1);
  const Result<Image> colour = decodeJpeg(bytes, true);
  REQUIRE(colour.isOk());
  CHECK(difference(colour.value(), cv::imdecode(bytes, cv::IMREAD_COLOR)) <= 1);
}

TEST_CASE("damaged entropy-coded data are a failure where OpenCV shows a wrong image") {
  const Bytes sound = encoded(CV_8UC1);
  const cv::Mat expected = cv::imdecode(sound, cv::IMREAD_GRAYSCALE);
  const std::size_t begin = dataBegin(sound);
  int shown_by_opencv = 0;
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomStream random(seed);
    Bytes bytes = sound;
    // A damaged sector: 32 bytes in a row.
    const std::size_t first = begin + random.below(bytes.size() - begin - 34);
    for (std::size_t i = 0; i < 32; ++i) {
      bytes[first + i] = static_cast<std::uint8_t>(random.below(256));
    }
    const cv::Mat shown = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
    shown_by_opencv += !shown.empty() && cv::norm(shown, expected, cv::NORM_INF) > 30 ? 1 : 0;
    const Result<Image> image = decodeJpeg(bytes, false);
    if (image.isOk()) continue;
    ++refused;
    CHECK(image.status().code() == StatusCode::InvalidInput);
    CHECK(image.status().message().starts_with("cannot be decoded, its data are damaged (libjpeg"));
  }
  CAPTURE(shown_by_opencv, refused);
  CHECK(shown_by_opencv > 90);
  CHECK(refused > 75);  // without a check sum some changes are legal code
}

TEST_CASE("JPEG data for printing are refused as such, not as damaged") {
  for (const bool colour : {false, true}) {
    CHECK(decodeJpeg(fourColours(64, 48), colour).status().message() ==
          "is a JPEG file for printing (CMYK); convert it to grey or RGB");
  }
}

TEST_CASE("pictures of a Motion JPEG may leave out the usual tables of codes") {
  Bytes bytes = encoded(CV_8UC3);
  for (std::size_t at = 2; at + 4 < dataBegin(bytes) - 2;) {  // segment by segment
    const std::size_t size = 2 + bytes[at + 2] * 256U + bytes[at + 3];
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const bool is_table = bytes[at + 1] == 0xc4;
    if (is_table) bytes.erase(begin, begin + static_cast<std::ptrdiff_t>(size));
    at += is_table ? 0 : size;
  }
  CHECK(bytes.size() + 300 < encoded(CV_8UC3).size());
  CHECK(decodeJpeg(bytes, true).isOk());
}

TEST_CASE("truncated JPEG data are a failure at every length") {
  const Bytes sound = encoded(CV_8UC3);
  for (std::size_t size = 0; size + 2 < sound.size(); size += 37) {
    CAPTURE(size, sound.size());
    CHECK_FALSE(decodeJpeg(std::span(sound).first(size), true).isOk());
  }
}

}  // namespace tolman::coded_images
