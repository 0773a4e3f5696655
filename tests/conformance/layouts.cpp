// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace tolman::test {
namespace {

namespace fs = std::filesystem;

/// Images of one side, in order.
std::vector<fs::path> imagesOf(const fs::path& side) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(side)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

}  // namespace

void writeEuroc(const fs::path& sequence, const fs::path& folder) {
  for (int camera = 0; camera < 2; ++camera) {
    const fs::path to = folder / "mav0" / fmt::format("cam{}", camera);
    fs::create_directories(to / "data");
    std::ofstream table(to / "data.csv");
    table << "#timestamp [ns],filename\n";
    std::int64_t stamp = 1'403'715'273'262'142'976;
    for (const fs::path& file : imagesOf(sequence / fmt::format("image_{}", camera))) {
      fs::copy_file(file, to / "data" / fmt::format("{}.png", stamp));
      table << stamp << "," << stamp << ".png\n";
      stamp += 50'000'000;
    }
    std::ofstream(to / "sensor.yaml")
        << "%YAML:1.0\nsensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1, 0, 0, "
        << 0.5 * camera
        << ", 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\nresolution: [160, 60]\n"
           "camera_model: pinhole\nintrinsics: [100, 100, 80, 30]\n"
           "distortion_model: radial-tangential\ndistortion_coefficients: [-0.1, 0.01, 0, 0]\n";
  }
}

void writeTum(const fs::path& sequence, const fs::path& folder) {
  fs::create_directories(folder / "rgb");
  fs::create_directories(folder / "depth");
  std::ofstream rgb(folder / "rgb.txt");
  std::ofstream depth(folder / "depth.txt");
  int second = 1305031102;
  for (const fs::path& file : imagesOf(sequence / "image_0")) {
    const std::string name = fmt::format("{}.000000.png", second);
    fs::copy_file(file, folder / "rgb" / name);
    cv::imwrite((folder / "depth" / name).string(), cv::Mat(60, 160, CV_16UC1, cv::Scalar(10'000)));
    rgb << second << ".000000 rgb/" << name << "\n";
    depth << second << ".000000 depth/" << name << "\n";
    ++second;
  }
}

void writeKittiRaw(const fs::path& sequence, const fs::path& folder) {
  std::ofstream calibration;
  for (int camera = 0; camera < 2; ++camera) {
    const fs::path to = folder / "drive" / fmt::format("image_0{}", camera);
    fs::create_directories(to / "data");
    std::ofstream stamps(to / "timestamps.txt");
    int number = 0;
    for (const fs::path& file : imagesOf(sequence / fmt::format("image_{}", camera))) {
      fs::copy_file(file, to / "data" / fmt::format("{:010}.png", number));
      stamps << fmt::format("2011-09-26 13:02:{:02}.000000000\n", number++);
    }
    if (camera == 0) calibration.open(folder / "calib_cam_to_cam.txt");
    const std::string c = fmt::format("_0{}", camera);
    calibration << "S" << c << ": 160 60\nK" << c << ": 100 0 80 0 100 30 0 0 1\nD" << c
                << ": -0.1 0 0 0 0\nR" << c << ": 1 0 0 0 1 0 0 0 1\nT" << c << ": "
                << -0.5 * camera << " 0 0\nS_rect" << c << ": 144 54\nR_rect" << c
                << ": 1 0 0 0 1 0 0 0 1\nP_rect" << c << ": 90 0 72 " << -45.0 * camera
                << " 0 90 27 0 0 0 1 0\n";
  }
}

}  // namespace tolman::test
