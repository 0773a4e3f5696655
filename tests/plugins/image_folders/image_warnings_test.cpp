// SPDX-License-Identifier: BSD-3-Clause
// Each cause is told once.
#include "image_warnings.hpp"

#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"
#include "images_source.hpp"

namespace tolman::image_folders {

TEST_CASE("the orientation is told of the first image, and where it changes") {
  ImageWarnings upright;
  CHECK_FALSE(upright.ofOrientation(1));
  CHECK(upright.ofOrientation(3)->starts_with("is stored otherwise than the first image"));
  CHECK_FALSE(upright.ofOrientation(6));
  ImageWarnings turned;
  CHECK(turned.ofOrientation(6)->starts_with("is stored turned or mirrored (EXIF orientation 6)"));
  CHECK_FALSE(turned.ofOrientation(6));
  CHECK(turned.ofOrientation(1)->find("(EXIF orientation 1 after 6)") != std::string::npos);
  CHECK_FALSE(turned.ofOrientation(1));
}

TEST_CASE("values beyond the parameter bits are counted in the first such image") {
  const DataFolder data;
  const auto write = [&](const char* name, int value, int many) {
    cv::Mat image(48, 64, CV_16UC1, cv::Scalar(100));
    image.row(7).colRange(0, many) = cv::Scalar(value);
    std::filesystem::create_directories(data.path("deep"));
    REQUIRE(cv::imwrite(data.path("deep").string() + "/" + name, image));
  };
  write("1.png", 4095, 9);  // all of 12 bits
  write("2.png", 4096, 5);
  write("3.png", 65535, 7);
  const auto logged = [&](ParameterValues values) {
    values["path"] = data.path().string();
    values["left"] = std::string("deep");
    test::TestContext services(std::move(values));
    ImagesSource source;
    REQUIRE(source.configure(services).isOk());
    std::string failure;
    REQUIRE(readAll(source, failure).size() == 3);
    return services.log;
  };
  CHECK(logged({{"bits", 12}}) ==
        std::vector<std::string>{
            data.path("deep/2.png").string() +
            ": has 5 values of more than 12 bits, which become white (255); set bits to as many as "
            "the camera has, or remove it"});
  CHECK(logged({{"bits", 16}}).empty());
  CHECK(logged({{"bits", 13}}).size() == 1);
}

}  // namespace tolman::image_folders
