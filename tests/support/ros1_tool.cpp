// SPDX-License-Identifier: BSD-3-Clause
#include "support/ros1_tool.hpp"

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

#include "support/data.hpp"
#include "support/paths.hpp"

namespace tolman::test {
namespace fs = std::filesystem;

namespace {

/// Debian's Python, which has Debian's modules; another one in $PATH has not.
std::string tool() { return "/usr/bin/python3 '" + inSource("tests/support/ros1_tool.py") + "'"; }

std::string listed(const std::vector<double>& values) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const double value : values) text << " " << value;
  return text.str();
}

}  // namespace

bool ros1OrSkip() {
  static const bool here = std::system((tool() + " check >/dev/null 2>&1").c_str()) == 0;
  if (!here) {
    std::cerr << "SKIPPED: no python3-rosbag (scripts/install-dependencies --ros)\n";
    skips().push_back("python3-rosbag");
  }
  return here;
}

bool ros1LiveOrSkip() {
#ifdef TOLMAN_HAS_ROS1
  const std::string command =
      tool() + " check_live >/dev/null 2>&1 && command -v roscore >/dev/null";
  static const bool here = std::system(command.c_str()) == 0;
#else
  const bool here = false;
#endif
  if (!here) {
    std::cerr
        << "SKIPPED: no roscore, or a build without it (scripts/install-dependencies --ros)\n";
    skips().push_back("roscore");
  }
  return here;
}

void Ros1List::line(const std::string& kind, const std::string& topic, std::int64_t stamp_ns,
                    const std::string& rest) {
  lines_ += kind + " " + topic + " " + std::to_string(stamp_ns) + " " + rest + "\n";
}

void Ros1List::image(const std::string& topic, std::int64_t stamp_ns, int width, int height,
                     const std::string& encoding, const std::string& pixels) {
  const fs::path file = folder_ / ("pixels_" + std::to_string(files_++));
  std::ofstream(file, std::ios::binary) << pixels;
  line("image", topic, stamp_ns,
       std::to_string(width) + " " + std::to_string(height) + " " + encoding + " " + file.string());
}

void Ros1List::compressed(const std::string& topic, std::int64_t stamp_ns,
                          const std::string& format, const fs::path& file) {
  line("compressed", topic, stamp_ns, format + " " + file.string());
}

void Ros1List::camera(const std::string& topic, int width, int height, const std::string& model,
                      const std::vector<double>& D, const std::vector<double>& K,
                      const std::vector<double>& R, const std::vector<double>& P) {
  line("camera", topic, 1'000'000'000,
       std::to_string(width) + " " + std::to_string(height) + " " + model + " " +
           std::to_string(D.size()) + listed(D) + listed(K) + listed(R) + listed(P));
}

void Ros1List::imu(const std::string& topic, std::int64_t stamp_ns,
                   const std::vector<double>& values) {
  line("imu", topic, stamp_ns, listed(values));
}

void Ros1List::odometry(const std::string& topic, std::int64_t stamp_ns, double x, double y,
                        double theta) {
  line("odometry", topic, stamp_ns, listed({x, y, theta}));
}

void Ros1List::text(const std::string& topic, std::int64_t stamp_ns, const std::string& word) {
  line("string", topic, stamp_ns, word);
}

bool Ros1List::call(const std::string& command, const fs::path& out,
                    const std::string& options) const {
  const fs::path list = folder_ / "messages.txt";
  std::ofstream(list, std::ios::binary) << lines_;
  return std::system(
             (tool() + " " + command + " '" + list.string() + "' '" + out.string() + "' " + options)
                 .c_str()) == 0;
}

}  // namespace tolman::test
