// SPDX-License-Identifier: BSD-3-Clause
// The source images: one or two folders, with and without calibration; the order of its images.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "data_folder.hpp"
#include "image_file.hpp"

namespace tolman::image_folders {
namespace {

using Images = Opened<ImagesParameters>;

const ParameterValues kLeft = {{"left", std::string("image_0")}};
const ParameterValues kPair = {{"left", std::string("image_0")}, {"right", std::string("image_1")}};

ParameterValues with(ParameterValues values, const ParameterValues& more) {
  values.insert(more.begin(), more.end());
  return values;
}

/// The names of empty images in the order in which they are read; the refusal after "! ".
std::string orderOf(const std::vector<std::string>& names) {
  const test::TemporaryFolder folder;
  for (const std::string& name : names) std::ofstream(folder.path() / name) << "x";
  std::string text;
  try {
    for (const auto& image : numberedImages(folder.path())) text += image.stem().string() + " ";
  } catch (const std::exception& error) {
    return "! " + std::string(error.what()).substr(folder.path().string().size() + 2);
  }
  return text;
}

}  // namespace

TEST_CASE("names of one prefix and a number are read in the order of the numbers") {
  CHECK(orderOf({"10.png", "9.png", "100.jpg"}) == "9 10 100 ");
  CHECK(orderOf({"img_0010.png", "img_0009.png", ".cover.png", "notes.txt"}) ==
        "img_0009 img_0010 ");
  CHECK(orderOf({"left_2_rect.png", "left_10_rect.png"}) == "left_2_rect left_10_rect ");
  CHECK(orderOf({"cam0_11.png", "cam0_12.png", "cam0_112.png"}) == "cam0_11 cam0_12 cam0_112 ");
  CHECK(orderOf({"1305031102.175304.png", "1305031102.043267.png", "1305031101.943.png"})
            .starts_with("! "));
  CHECK(orderOf({"1305031102.175304.png", "1305031102.043267.png"}) ==
        "1305031102.043267 1305031102.175304 ");
  CHECK(orderOf({"1.50.png", "2.50.png", "10.50.png"}) == "1.50 2.50 10.50 ");
  CHECK(orderOf({"frame.9.png", "frame.10.png"}) == "frame.9 frame.10 ");
  CHECK(orderOf({"only.png"}) == "only ");
}

TEST_CASE("other names are refused, because their order would be a guess") {
  CHECK(orderOf({"left_1.png", "right_1.png"}) ==
        "! has images whose order is not clear from their names, such as left_1.png and "
        "right_1.png; rename them to one prefix and a number each, or read them by the source "
        "`images` with their order in a file (list), or with their times as names "
        "(stamps_in_names)");
  for (const std::vector<std::string>& names : {std::vector<std::string>{"0a.png", "0b.png"},
                                                {"-1.png", "1.png"},
                                                {"1.1.png", "1.10.png"},
                                                {"1.png", "preview.png"},
                                                {"1e-5.png", "2e-6.png"},
                                                {"1_2.png", "3_4.png"}}) {
    CAPTURE(names[0]);
    CHECK(orderOf(names).starts_with("! has images whose order"));
  }
  CHECK(orderOf({"1.png", "01.png", "2.png"}) ==
        "! has two images of one number, 01.png and 1.png; remove one of them, or put the images "
        "of each camera into a folder of their own");
  CHECK(orderOf({"1.png", "1.jpg", "2.png"}).starts_with("! has two images of one number"));
  CHECK(orderOf({}) == "! has no .png or .jpg images; check the path");
}

TEST_CASE("a list gives the order of any names, and the right images go with the left ones") {
  const DataFolder data;
  for (const char* folder : {"image_0/", "image_1/"}) {
    std::filesystem::rename(data.path(folder + std::string("000000.png")),
                            data.path(folder + std::string("first.png")));
    std::filesystem::rename(data.path(folder + std::string("000003.png")),
                            data.path(folder + std::string("a.png")));
  }
  const ParameterValues values = with(
      kPair,
      {{"pinhole", std::vector<double>{40}}, {"baseline", 0.2}, {"list", std::string("list.csv")}});
  data.write("list.csv", "file,light\nfirst.png,0\nimage_0/a.png,1\n000001.png,1\n");
  const Images listed(data, values);
  CHECK(listed.message.empty());
  REQUIRE(listed.frames.size() == 3);
  const DataFolder original;
  const Images plain(original,
                     with(kPair, {{"pinhole", std::vector<double>{40}}, {"baseline", 0.2}}));
  REQUIRE(plain.frames.size() == 4);
  for (const auto& [listed_index, index] : {std::pair(0, 0), std::pair(1, 3), std::pair(2, 1)}) {
    const Frame& frame = listed.frames[static_cast<std::size_t>(listed_index)];
    const Frame& same = plain.frames[static_cast<std::size_t>(index)];
    CHECK(std::equal(frame.left.row(0), frame.left.row(0) + 64, same.left.row(0)));
    CHECK(std::equal(frame.right.row(0), frame.right.row(0) + 64, same.right.row(0)));
  }
  CHECK(listed.findings ==
        std::vector<std::string>{"error DATA/image_1/000002.png: has no partner of the same name "
                                 "from the other camera"});
  data.write("list.csv", "first.png\nnothing\n");
  CHECK(Images(data, values).message == "DATA/list.csv:2: names no image; correct it");
}

TEST_CASE("one uncalibrated folder, found where none is named") {
  const DataFolder data;
  const Images mono(data, kLeft);
  CHECK(mono.message.empty());
  CHECK(mono.info.description ==
        "images, 4 images of one camera of 64x48 px at 10.0 Hz, uncalibrated");
  CHECK_FALSE(mono.info.rig.calibrated);
  REQUIRE(mono.frames.size() == 4);
  CHECK(mono.frames[3].stamp_ns == 300'000'000);
  CHECK(mono.frames[3].right.empty());
  CHECK(Images(data).message == "DATA/: has no .png or .jpg images; check the path");
  data.writeImage("top.png", 8, 8);
  CHECK(Images(data).frames.size() == 1);
  std::filesystem::rename(data.path("image_0"), data.path("images"));
  CHECK(Images(data).frames.size() == 4);
}

TEST_CASE("a rectified pair, calibrated by a file or by numbers") {
  const DataFolder data;
  const Images by_file(data, with(kPair, {{"calibration", std::string("calib.txt")}}));
  CHECK(by_file.message.empty());
  CHECK(by_file.info.rig.baseline == Approx(0.5));
  CHECK_FALSE(by_file.frames[0].right.empty());
  const Images by_numbers(
      data, with(kPair, {{"pinhole", std::vector<double>{40, 40, 31.5, 20}}, {"baseline", 0.2}}));
  const CameraRig& rig = by_numbers.info.rig;
  CHECK(rig.calibrated);
  CHECK(rig.pinhole.fx == 40);
  CHECK(rig.pinhole.fy == 40);
  CHECK(rig.pinhole.cx == 31.5);
  CHECK(rig.pinhole.cy == 20);
  CHECK(rig.baseline == 0.2);
}

TEST_CASE("a raw pair with the calibration of another program") {
  const DataFolder data;
  const std::string camera =
      "image_width: 64\nimage_height: 48\ncamera_matrix: {rows: 3, cols: 3, data: [50, 0, 31, 0, "
      "50, 23, 0, 0, 1]}\ndistortion_coefficients: [-0.1, 0, 0, 0, 0]\n";
  data.write("left.yaml", camera);
  data.write("right.yml", camera + "R: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [-0.2, 0, 0]\n");
  const Images pair(data, with(kPair, {{"calibration", std::string("left.yaml")},
                                       {"calibration_right", std::string("right.yml")}}));
  CHECK(pair.message.empty());
  REQUIRE(pair.raw.cameras.size() == 2);
  CHECK(pair.raw.cameras[1].T_reference_camera.translation().x() == 0.2);
  CHECK_FALSE(pair.info.rig.calibrated);
  CHECK_FALSE(pair.info.rig.isStereo());
  data.write("left.yaml", "nothing: here\n");
  CHECK_THAT(Images(data, with(kPair, {{"calibration", std::string("left.yaml")}})).message,
             Catch::StartsWith("DATA/left.yaml: is no calibration of Kalibr"));
}

TEST_CASE("stamps from a file, in other units, and in the names of the images") {
  const DataFolder data;
  data.write("frames.csv", "name,t\na,0.5\nb,0.75\nc,1\nd,2\n");
  const Images table(data, with(kLeft, {{"stamps", std::string("frames.csv")},
                                        {"stamps_column", std::string("t")}}));
  CHECK(table.frames[1].stamp_ns == 750'000'000);
  data.write("us.txt", "1403715273262142\n1403715273312143\n1403715273362142\n1403715273412143\n");
  const ParameterValues in_us = with(kLeft, {{"stamps", std::string("us.txt")}});
  CHECK(Images(data, with(in_us, {{"stamps_unit", std::string("us")}})).frames[1].stamp_ns ==
        1403715273312143000);
  CHECK_THAT(Images(data, in_us).message, Catch::Contains("set stamps_unit (of `images`)"));
  const ParameterValues in_names =
      with(kLeft, {{"stamps_in_names", true}, {"stamps_unit", std::string("ms")}});
  CHECK(Images(data, in_names).frames[1].stamp_ns == 1'000'000);
  std::filesystem::rename(data.path("image_0/000000.png"), data.path("image_0/1.5e1.png"));
  const Images sorted(data, in_names);
  CHECK(sorted.frames[3].stamp_ns == 15'000'000);
  data.writeImage("image_0/later.png", 64, 48);
  CHECK_THAT(Images(data, in_names).message,
             Catch::StartsWith("DATA/image_0/later.png: 'later' is no time in ms"));
}

TEST_CASE("response and vignette of TUM's monocular sets make grey levels proportional to light") {
  const DataFolder data;
  std::string response;  // light is the square of the grey level, from 10 upwards
  for (int i = 0; i < 256; ++i) response += std::to_string(10 + i * i) + " ";
  data.write("pcalib.txt", response + "\n");
  data.write("times.txt", "00000 1.25 0.5\n00001 1.5 4\n00002 1.75 4\n00003 2.0 4\n");
  const ParameterValues given =
      with(kLeft, {{"response", std::string("pcalib.txt")}, {"stamps", std::string("times.txt")}});
  const Images plain(data, with(kLeft, {{"stamps", std::string("times.txt")}}));
  const Images even(data, given);
  REQUIRE(even.frames.size() == 4);
  CHECK(even.frames[0].stamp_ns == 1'250'000'000);
  REQUIRE(even.frames[1].sensors.size() == 1);
  CHECK(even.frames[1].sensors[0].name == "exposure.left");
  CHECK(even.frames[1].sensors[0].values == std::vector<float>{4});
  const auto light = [&](int x, int y) {
    const double grey = plain.frames[0].left.row(y)[x];
    return grey * grey / 255;
  };
  for (const int x : {0, 31, 63})
    CHECK(even.frames[0].left.row(20)[x] == std::lround(light(x, 20)));

  cv::Mat vignette(48, 64, CV_16U, cv::Scalar(50000));
  vignette.col(0) = 25000;
  cv::imwrite(data.path("vignette.png").string(), vignette);
  const Images bright(data, given);
  CHECK(bright.frames[0].left.row(20)[31] == even.frames[0].left.row(20)[31]);
  CHECK(bright.frames[0].left.row(20)[0] == std::lround(std::min(2 * light(0, 20), 255.0)));

  data.writeImage("vignette.png", 32, 48);
  CHECK_THAT(Images(data, given).message, Catch::Contains("vignette.png: has 32x48 pixels"));
  data.write("pcalib.txt", "1 2 3\n");
  CHECK_THAT(Images(data, given).message, Catch::Contains("has 3 numbers instead of"));
}

TEST_CASE("contradictions of parameters are refused") {
  const DataFolder data;
  const auto refusal = [&](const ParameterValues& values) {
    const Images images(data, values);
    CHECK(images.code == StatusCode::InvalidParameter);
    return images.message;
  };
  const std::string uncalibrated =
      "two cameras need a calibration; give the file, or pinhole and baseline";
  CHECK(refusal(kPair) == uncalibrated);
  CHECK(refusal(with(kPair, {{"pinhole", std::vector<double>{40}}})) == uncalibrated);
  CHECK(refusal({{"baseline", 0.2}}) == "baseline is given without right; name the right folder");
  CHECK(refusal(with(kPair, {{"calibration", std::string("calib.txt")},
                             {"pinhole", std::vector<double>{4}}})) ==
        "calibration and pinhole or baseline are both given; keep one");
  CHECK(refusal({{"stamps_column", std::string("t")}}) ==
        "stamps_column is given without stamps; name the file");
  CHECK(
      refusal(with(kLeft, {{"pinhole", std::vector<double>{40, 40, 640, 20}}})) ==
      "the principal point of pinhole is outside of the image of 64x48 px; give the calibration of "
      "this camera");
}

}  // namespace tolman::image_folders
