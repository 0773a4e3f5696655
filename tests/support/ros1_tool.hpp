// SPDX-License-Identifier: BSD-3-Clause
// Bags of ROS 1 written by ROS 1's Python modules (ros1_tool.py), for tests of their readers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tolman::test {

/// Whether Debian's python3-rosbag is there; a skip is printed where it is not.
bool ros1OrSkip();
/// Whether roscore, its Python modules and the plugins `ros1` and `ros1_publisher` are there.
bool ros1LiveOrSkip();

/// Messages for the tool, see there.
class Ros1List {
 public:
  explicit Ros1List(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void image(const std::string& topic, std::int64_t stamp_ns, int width, int height,
             const std::string& encoding, const std::string& pixels);
  void compressed(const std::string& topic, std::int64_t stamp_ns, const std::string& format,
                  const std::filesystem::path& file);
  void camera(const std::string& topic, int width, int height, const std::string& model,
              const std::vector<double>& D, const std::vector<double>& K,
              const std::vector<double>& R, const std::vector<double>& P);
  void imu(const std::string& topic, std::int64_t stamp_ns, const std::vector<double>& values);
  void odometry(const std::string& topic, std::int64_t stamp_ns, double x, double y, double theta);
  void text(const std::string& topic, std::int64_t stamp_ns, const std::string& word);

  /// Writes the list, and calls the tool: "bag OUT bz2". False where it fails.
  bool call(const std::string& command, const std::filesystem::path& out,
            const std::string& options = "") const;

 private:
  void line(const std::string& kind, const std::string& topic, std::int64_t stamp_ns,
            const std::string& rest);
  std::filesystem::path folder_;  ///< for pixels and the list
  std::string lines_;
  int files_ = 0;
};

}  // namespace tolman::test
