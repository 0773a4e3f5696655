// SPDX-License-Identifier: BSD-3-Clause
#include "data_folder.hpp"

#include <cstdio>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

namespace tolman::image_folders {
namespace fs = std::filesystem;

DataFolder::DataFolder() {
  std::string times;
  std::string poses;
  for (int i = 0; i < kFrames; ++i) {
    const std::string name = "00000" + std::to_string(i) + ".png";
    writeImage("image_0/" + name, 64, 48, 2 * i);
    writeImage("image_1/" + name, 64, 48, 2 * i + 1);
    times += std::to_string(i) + ".000000e-01\n";
    poses += "1 0 0 0 0 1 0 0 0 0 1 " + std::to_string(i) + ".5\n";
  }
  write("calib.txt", matrixLine("P0", 0) + matrixLine("P1", -25));
  write("times.txt", times);
  write("poses.txt", poses);
}

void DataFolder::write(const std::string& name, const std::string& text) const {
  fs::create_directories(path(name).parent_path());
  std::ofstream(path(name), std::ios::binary) << text;
}

std::string DataFolder::read(const std::string& name) const {
  std::ostringstream text;
  text << std::ifstream(path(name), std::ios::binary).rdbuf();
  return text.str();
}

void DataFolder::truncate(const std::string& name, double part) const {
  const auto size = static_cast<double>(fs::file_size(path(name)));
  fs::resize_file(path(name), static_cast<std::uintmax_t>(size * part));
}

void DataFolder::writeImage(const std::string& name, int width, int height, int seed) const {
  cv::Mat pixels(height, width, CV_8UC1);
  cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
  random.fill(pixels, cv::RNG::UNIFORM, 0, 256);
  fs::create_directories(path(name).parent_path());
  if (!cv::imwrite(path(name).string(), pixels)) throw std::runtime_error("imwrite " + name);
}

std::string DataFolder::anonymous(std::string text) const {
  const std::string root = folder_.path().string();
  for (std::size_t at = text.find(root); at != std::string::npos; at = text.find(root)) {
    text.replace(at, root.size(), "DATA");
  }
  return text;
}

std::string matrixLine(const std::string& name, double p3, double fx) {
  char text[200];
  std::snprintf(text, sizeof text, "%s: %g 0 31.5 %.17g 0 %g 23.5 0 0 0 1 0\n", name.c_str(), fx,
                p3, fx);
  return text;
}

}  // namespace tolman::image_folders
