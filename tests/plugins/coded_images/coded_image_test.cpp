// SPDX-License-Identifier: BSD-3-Clause
// PNG and JPEG images of a file or message, and the orientation in their EXIF data.
#include "coded_image.hpp"

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "tolman/image_cv.hpp"

namespace tolman::coded_images {
namespace {

using namespace std::string_literals;

std::span<const std::uint8_t> bytesOf(const std::string& file) {
  return {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
}

std::string encodedAs(const char* extension, const cv::Mat& pixels) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, pixels, bytes);
  return {bytes.begin(), bytes.end()};
}

Result<Image> decode(const std::string& file, bool colour = false) {
  source_parameters::UsedBits bits;
  return decodeImage(bytesOf(file), colour, bits);
}

/// A TIFF structure with a directory of a width and the orientation.
std::string tiffOf(char orientation, bool big) {
  if (big) {
    return "MM\0*\0\0\0\x08\0\x02"s + "\x01\0\0\x03\0\0\0\x01\0\x09\0\0"s +
           "\x01\x12\0\x03\0\0\0\x01\0"s + orientation + "\0\0\0\0\0\0"s;
  }
  return "II*\0\x08\0\0\0\x02\0"s + "\0\x01\x03\0\x01\0\0\0\x09\0\0\0"s +
         "\x12\x01\x03\0\x01\0\0\0"s + orientation + "\0\0\0\0\0\0\0"s;
}

/// A JPEG file with this EXIF data.
std::string jpegWith(const std::string& tiff) {
  const std::string jpeg = encodedAs(".jpg", cv::Mat::ones(4, 6, CV_8U));
  const std::string exif = "Exif\0\0"s + tiff;
  const auto length = exif.size() + 2;
  const std::string segment =
      "\xff\xe1"s + static_cast<char>(length >> 8U) + static_cast<char>(length & 255U) + exif;
  return jpeg.substr(0, 2) + segment + jpeg.substr(2);
}

}  // namespace

TEST_CASE("sound images come as OpenCV reads them") {
  cv::Mat pixels(48, 64, CV_8UC3);
  cv::RNG(3).fill(pixels, cv::RNG::UNIFORM, 0, 256);
  for (const char* extension : {".png", ".jpg"}) {
    for (const bool colour : {false, true}) {
      const std::string file = encodedAs(extension, pixels);
      const Result<Image> image = decode(file, colour);
      REQUIRE(image.isOk());
      CHECK(image.value().format() == (colour ? PixelFormat::Bgr8 : PixelFormat::Gray8));
      const cv::Mat expected = cv::imdecode(std::vector<char>(file.begin(), file.end()),
                                            colour ? cv::IMREAD_COLOR : cv::IMREAD_GRAYSCALE);
      CHECK(cv::norm(asMat(image.value()), expected, cv::NORM_INF) <= 1);
    }
  }
}

TEST_CASE("cut files and others are refused at every length") {
  for (const char* extension : {".png", ".jpg"}) {
    const std::string file = encodedAs(extension, cv::Mat::ones(48, 64, CV_8U) * 100);
    for (std::size_t size = 0; size + 12 < file.size(); size += 7) {
      CAPTURE(extension, size);
      CHECK_FALSE(decode(file.substr(0, size)).isOk());
    }
  }
  CHECK(decode("<html>").status().message() == "is neither a PNG nor a JPEG image");
  CHECK(decode("").status().message() == "is empty");
}

TEST_CASE("the orientation is read in both byte orders, as OpenCV reads it") {
  for (const bool big : {false, true}) {
    for (char orientation = 1; orientation <= 8; ++orientation) {
      const std::string file = jpegWith(tiffOf(orientation, big));
      CHECK(orientationOf(bytesOf(file)) == orientation);
      const cv::Mat shown = cv::imdecode(std::vector<char>(file.begin(), file.end()), 0);
      CHECK((shown.rows > shown.cols) == (orientation > 4));  // an independent reader
      CHECK(decode(file).value().width() == 6);               // as stored
    }
    CHECK(orientationOf(bytesOf(jpegWith(tiffOf(9, big)))) == 1);
  }
  const std::string png = encodedAs(".png", cv::Mat::ones(4, 6, CV_8U));
  CHECK(orientationOf(bytesOf(png)) == 1);
  const std::string chunk = "\0\0\0\x26"s + "eXIf" + tiffOf(3, true) + "\0\0\0\0"s;
  CHECK(orientationOf(bytesOf(png.substr(0, 33) + chunk + png.substr(33))) == 3);
  const std::string file = jpegWith(tiffOf(6, false));
  for (std::size_t size = 0; size < 60; ++size) {
    const int orientation = orientationOf(bytesOf(file.substr(0, size)));
    CHECK((orientation == 1 || orientation == 6));
  }
}

}  // namespace tolman::coded_images
