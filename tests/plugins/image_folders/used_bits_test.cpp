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

std::string said(int largest, int bits, int images = UsedBits::kJudged, bool is_last = false) {
  UsedBits used;
  for (int i = 0; i < images; ++i) used.add(largest);
  return used.warning(bits, is_last).value_or("");
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
  for (int i = 0; i < UsedBits::kJudged; ++i) used.add(100);
  CHECK(used.warning(16, false));
  CHECK_FALSE(used.warning(16, true));  // once
}

TEST_CASE("values beyond bits are told once") {
  UsedBits used;
  CHECK_FALSE(used.beyond(1023, 10));
  CHECK_FALSE(used.beyond(-1, 10));
  CHECK(used.beyond(1024, 10)->starts_with("has values of more than 10 bits"));
  CHECK_FALSE(used.beyond(5000, 10));
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
  const auto widthsOf = [](int many, int hot) {
    source_parameters::ValueWidths widths;
    for (int i = 0; i < many; ++i) widths.add(static_cast<std::uint16_t>(i % 4096));
    for (int i = 0; i < hot; ++i) widths.add(65535);
    return widths;
  };
  CHECK(source_parameters::ValueWidths().largest() == -1);
  CHECK(source_parameters::ValueWidths().usual() == -1);
  CHECK(widthsOf(99'990, 10).usual() == 4095);
  CHECK(widthsOf(99'990, 10).largest() == 65535);
  CHECK(widthsOf(99'990, 11).usual() == 65535);
  CHECK(widthsOf(9'000, 1).usual() == 65535);  // one in ten thousand is less than one
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
