// SPDX-License-Identifier: BSD-3-Clause
// The orientation in EXIF data of JPEG and PNG files.
#include "orientation.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "data_folder.hpp"
#include "images_source.hpp"

namespace tolman::image_folders {
namespace {

using namespace std::string_literals;

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
std::string jpegWith(const std::string& tiff, const cv::Mat& pixels = cv::Mat::ones(4, 6, CV_8U)) {
  std::vector<std::uint8_t> encoded;
  cv::imencode(".jpg", pixels, encoded);
  const std::string jpeg(encoded.begin(), encoded.end());
  const std::string exif = "Exif\0\0"s + tiff;
  const auto length = exif.size() + 2;
  const std::string segment =
      "\xff\xe1"s + static_cast<char>(length >> 8U) + static_cast<char>(length & 255U) + exif;
  return jpeg.substr(0, 2) + segment + jpeg.substr(2);
}

int found(const std::string& file) {
  return orientationOf({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()});
}

}  // namespace

TEST_CASE("the orientation is read in both byte orders, as OpenCV reads it") {
  cv::Mat wide(4, 6, CV_8U);
  for (const bool big : {false, true}) {
    for (char orientation = 1; orientation <= 8; ++orientation) {
      const std::string file = jpegWith(tiffOf(orientation, big), wide);
      CHECK(found(file) == orientation);
      const cv::Mat shown = cv::imdecode(std::vector<char>(file.begin(), file.end()), 0);
      CHECK((shown.rows > shown.cols) == (orientation > 4));  // an independent reader
    }
    CHECK(found(jpegWith(tiffOf(9, big))) == 1);
    CHECK(found(jpegWith(tiffOf(0, big))) == 1);
  }
}

TEST_CASE("of cut and other files the orientation is that of the stored pixels") {
  const std::string file = jpegWith(tiffOf(6, false));
  for (std::size_t size = 0; size < file.size(); ++size) {
    const int orientation = found(file.substr(0, size));
    CHECK((orientation == 1 || orientation == 6));
  }
  CHECK(found(jpegWith("II*\0\xff\xff\xff\xff"s)) == 1);
  CHECK(found(jpegWith("II"s)) == 1);
  CHECK(found(jpegWith(""s)) == 1);
  std::vector<std::uint8_t> png;
  cv::imencode(".png", cv::Mat::ones(4, 6, CV_8U), png);
  CHECK(orientationOf(png) == 1);
  const std::string text(png.begin(), png.end());
  const std::string chunk = "\0\0\0\x26"s + "eXIf" + tiffOf(3, true) + "\0\0\0\0"s;
  CHECK(found(text.substr(0, 33) + chunk + text.substr(33)) == 3);
}

TEST_CASE("turned images are used as stored, with a warning") {
  const DataFolder data;
  const auto folder = data.path() / "turned";
  std::filesystem::create_directory(folder);
  for (const char* name : {"a.jpg", "b.jpg"}) {
    std::ofstream(folder / name) << jpegWith(tiffOf(6, true));
  }
  ImagesSource source;
  CHECK(configure(source, {{"path", data.path().string()}, {"left", "turned"s}}).empty());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  CHECK(info.rig.width == 6);
  std::vector<Finding> findings;
  REQUIRE(source.inspect(findings).isOk());
  REQUIRE(!findings.empty());
  CHECK(findings[0].severity == Finding::Severity::Warning);
  CHECK(findings[0].message.starts_with("is stored turned or mirrored (EXIF orientation 6)"));
}

TEST_CASE("a turned image among others is told when it is read, and by inspection") {
  const DataFolder data;
  const auto folder = data.path() / "some";
  std::filesystem::create_directory(folder);
  for (const auto& [name, orientation] : {std::pair("1.jpg", 1), std::pair("2.jpg", 9),
                                          std::pair("3.jpg", 6), std::pair("4.jpg", 8)}) {
    std::ofstream(folder / name) << jpegWith(tiffOf(static_cast<char>(orientation), true));
  }
  test::TestContext services({{"path", data.path().string()}, {"left", "some"s}});
  ImagesSource source;
  REQUIRE(source.configure(services).isOk());
  std::string failure;
  CHECK(readAll(source, failure).size() == 4);
  const std::string warning = (folder / "3.jpg").string() +
                              ": is stored otherwise than the first image (EXIF orientation 6 "
                              "after 1), and the pixels of both are used as stored; if the images "
                              "look alike in a viewer, turn the files, such as with `exiftran -ai` "
                              "or `jpegtran`";
  CHECK(services.log == std::vector<std::string>{warning});
  std::vector<Finding> findings;
  REQUIRE(source.inspect(findings).isOk());
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].severity == Finding::Severity::Warning);
  CHECK(findings[0].where + ": " + findings[0].message == warning);
}

}  // namespace tolman::image_folders
