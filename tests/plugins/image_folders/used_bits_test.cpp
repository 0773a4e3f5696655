// SPDX-License-Identifier: BSD-3-Clause
// Images of 16 bits whose camera has fewer.
#include "used_bits.hpp"

#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"
#include "images_source.hpp"

namespace tolman::image_folders {
namespace {

using source_parameters::UsedBits;

using source_parameters::ValueWidths;

/// Of an image of one value; -1: of an image of 8 bits.
ValueWidths widthsOf(int value) {
  ValueWidths widths;
  if (value >= 0) widths.add(static_cast<std::uint16_t>(value));
  return widths;
}

std::string said(int largest, int bits, int images = UsedBits::kJudged, bool is_last = false) {
  UsedBits used(bits);
  for (int i = 0; i < images; ++i) used.add(widthsOf(largest));
  return used.warning(is_last, images - 1).value_or("");
}

/// The warning of images with these largest values, which is asked for after each; its number
/// first.
std::string saidOf(const std::vector<int>& images, int bits = 16) {
  UsedBits used(bits);
  for (std::size_t i = 0; i < images.size(); ++i) {
    used.add(widthsOf(images[i]));
    const auto number = static_cast<std::int64_t>(i);
    const auto warning = used.warning(i + 1 == images.size(), number);
    if (warning) return std::to_string(i) + ": " + *warning;
  }
  return "";
}

std::vector<int> series(std::initializer_list<std::pair<int, int>> counts_and_values) {
  std::vector<int> values;
  for (const auto& [count, value] : counts_and_values) {
    values.insert(values.end(), static_cast<std::size_t>(count), value);
  }
  return values;
}

/// `count` images of 64x48 px with values up to `largest` in the folder `deep`.
void writeDeep(const DataFolder& data, int count, int largest) {
  std::filesystem::create_directories(data.path("deep"));
  for (int i = 0; i < count; ++i) {
    cv::Mat image(48, 64, CV_16UC1, cv::Scalar(largest / 2));
    image.at<std::uint16_t>(i, i) = static_cast<std::uint16_t>(largest);
    REQUIRE(cv::imwrite(data.path("deep").string() + "/" + std::to_string(10 + i) + ".png", image));
  }
}

struct Told {
  std::vector<std::string> log;
  std::vector<std::string> findings;
};

Told toldOf(const DataFolder& data, ParameterValues values = {}) {
  values["path"] = data.path().string();
  values["left"] = std::string("deep");
  test::TestContext services(std::move(values));
  ImagesSource source;
  REQUIRE(source.configure(services).isOk());
  std::string failure;
  (void)readAll(source, failure);
  CHECK(failure.empty());
  Told told{services.log, {}};
  for (const std::string& finding : inspect(source)) {
    if (finding.find("16 bits") != std::string::npos) told.findings.push_back(finding);
  }
  return told;
}

}  // namespace

TEST_CASE("the least number of bits of a camera that holds all values is named") {
  CHECK(said(1023, 16) ==
        "the values of the first 10 images of 16 bits stay below 1024, so that no grey level is "
        "above 3 of 255; set source.bits=10 (in a command without configuration: bits=10), unless "
        "the scene is that dark");
  for (const auto& [largest, bits] :
       {std::pair{200, 8}, {256, 10}, {1024, 12}, {4095, 12}, {4096, 14}, {16383, 14}}) {
    CHECK(said(largest, 16).find("source.bits=" + std::to_string(bits) + " ") != std::string::npos);
  }
  CHECK(said(4095, 14).find("source.bits=12 ") != std::string::npos);
}

TEST_CASE("nothing is said of images that fill the bits, of black ones, and of too few") {
  CHECK(said(16384, 16).empty());
  CHECK(said(65535, 16).empty());
  CHECK(said(1023, 10).empty());
  CHECK(said(4095, 12).empty());
  CHECK(said(0, 16).empty());
  CHECK(said(-1, 16).empty());  // 8 bits
  CHECK(said(1023, 16, 9).empty());
  CHECK(said(1023, 16, 3, true).starts_with("the values of the first 3 images"));
  UsedBits used;
  for (int i = 0; i < UsedBits::kJudged; ++i) used.add(widthsOf(100));
  CHECK(used.warning(false, 9));
  CHECK_FALSE(used.warning(true, 9));  // once
  CHECK_FALSE(used.isJudging());
}

TEST_CASE("values beyond bits are told once") {
  UsedBits used(10);
  CHECK_FALSE(used.beyond(1023));
  CHECK_FALSE(used.beyond(-1));
  CHECK(used.beyond(1024)->starts_with("has values of more than 10 bits"));
  CHECK_FALSE(used.beyond(5000));
}

TEST_CASE("images that use fewer bits after bright ones are told, at the tenth in a row") {
  CHECK(saidOf(series({{6, 65280}, {18, 4080}})) ==
        "15: the values of 10 images of 16 bits in a row, the last at frame 15, stay below 4096, "
        "so that no grey level is above 15 of 255, where earlier values reach 65280; if the camera "
        "was set to fewer bits there, read those images in a run of their own with source.bits=12, "
        "unless the scene is that dark");
  CHECK(saidOf(series({{500, 40000}, {12, 1000}})).starts_with("509: the values of 10 images"));
  CHECK(saidOf(series({{500, 40000}, {12, 1000}})).find("source.bits=10") != std::string::npos);
  CHECK(saidOf(series({{20, 40000}, {5, 4000}})).starts_with("24: the values of 5 images"));
}

TEST_CASE("shorter series, black images and shadows after bright images are no other camera") {
  CHECK(saidOf(series({{20, 40000}, {4, 4000}})).empty());
  CHECK(saidOf(series({{20, 40000}, {9, 4000}, {1, 40000}, {9, 4000}, {1, 40000}})).empty());
  CHECK(saidOf(series({{20, 40000}, {30, 0}})).empty());
  CHECK(saidOf(series({{20, 40000}, {30, 9000}})).empty());
  CHECK(saidOf(series({{20, 4000}, {30, 500}}), 12).empty());
  CHECK_FALSE(saidOf(series({{20, 4000}, {30, 250}}), 12).empty());
}

TEST_CASE("a folder that begins with bright images is told of by run and check") {
  const DataFolder data;
  std::filesystem::create_directories(data.path("deep"));
  for (int i = 0; i < 40; ++i) {
    const cv::Mat image(12, 16, CV_16UC1, cv::Scalar(i < 15 ? 60000 : 4000));
    const std::string name = data.path("deep").string() + "/" + std::to_string(10 + i) + ".png";
    REQUIRE(cv::imwrite(name, image));
  }
  const Told told = toldOf(data);
  REQUIRE(told.log.size() == 1);
  CHECK(told.log[0].find("the last at frame 24, stay below 4096") != std::string::npos);
  REQUIRE(told.findings.size() == 1);
  CHECK(told.findings[0].find("source.bits=12") != std::string::npos);
}

TEST_CASE("a folder of 10 bit images in files of 16 bits is told of by run and check") {
  const DataFolder data;
  writeDeep(data, 12, 1020);
  const Told told = toldOf(data);
  REQUIRE(told.log.size() == 1);
  CHECK(
      told.log[0].starts_with(data.path("deep").string() + ": the values of the first 10 images"));
  REQUIRE(told.findings.size() == 1);
  CHECK(told.findings[0].find("set source.bits=10") != std::string::npos);
  const Told right = toldOf(data, {{"bits", std::int64_t{10}}});
  CHECK(right.log.empty());
  CHECK(right.findings.empty());
}

TEST_CASE("a few hot pixels do not hide that the others use 12 bits") {
  const auto widthsWith = [](int many, int hot) {
    source_parameters::ValueWidths widths;
    for (int i = 0; i < many; ++i) widths.add(static_cast<std::uint16_t>(i % 4096));
    for (int i = 0; i < hot; ++i) widths.add(65535);
    return widths;
  };
  CHECK(source_parameters::ValueWidths().largest() == -1);
  CHECK(source_parameters::ValueWidths().usual() == -1);
  CHECK(widthsWith(99'990, 10).usual() == 4095);
  CHECK(widthsWith(99'990, 10).largest() == 65535);
  CHECK(widthsWith(99'990, 11).usual() == 65535);
  CHECK(widthsWith(9'000, 1).usual() == 65535);  // one in ten thousand is less than one
  const DataFolder data;
  std::filesystem::create_directories(data.path("deep"));
  for (int i = 0; i < 12; ++i) {
    cv::Mat image(120, 160, CV_16UC1, cv::Scalar(4000));
    image.at<std::uint16_t>(i, i) = 65535;
    const std::string name = data.path("deep").string() + "/" + std::to_string(10 + i) + ".png";
    REQUIRE(cv::imwrite(name, image));
  }
  const Told told = toldOf(data);
  REQUIRE(told.log.size() == 1);
  CHECK(told.log[0].find(": nearly all values of the first 10 images of 16 bits stay below 4096") !=
        std::string::npos);
  CHECK(told.log[0].find("set source.bits=12 ") != std::string::npos);
  REQUIRE(told.findings.size() == 1);
  const Told beyond = toldOf(data, {{"bits", std::int64_t{12}}});
  REQUIRE(beyond.log.size() == 1);  // of the true maximum
  CHECK(beyond.log[0].find("has 1 values of more than 12 bits") != std::string::npos);
}

TEST_CASE("fewer images than are judged are told of at the last one") {
  const DataFolder data;
  writeDeep(data, 4, 4000);
  const Told told = toldOf(data);
  REQUIRE(told.log.size() == 1);
  CHECK(told.log[0].find("first 4 images") != std::string::npos);
  CHECK(told.log[0].find("set source.bits=12") != std::string::npos);
}

}  // namespace tolman::image_folders
