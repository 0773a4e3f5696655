// SPDX-License-Identifier: BSD-3-Clause
// A small valid sequence in a temporary folder, which tests read or damage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "folder_source.hpp"
#include "support/context.hpp"
#include "support/data.hpp"

namespace tolman::image_folders {

/// Four stereo pairs of 64x48 random grey pixels with calibration, times and poses, as KITTI has
/// it.
class DataFolder {
 public:
  static constexpr int kFrames = 4;
  DataFolder();

  std::filesystem::path path(const std::string& name = "") const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Cuts a file to `part` of its length.
  void truncate(const std::string& name, double part) const;
  void writeImage(const std::string& name, int width, int height, int seed = 0) const;
  void remove(const std::string& name) const { std::filesystem::remove_all(path(name)); }

  /// The folder's own path replaced by "DATA", for golden messages.
  std::string anonymous(std::string text) const;

 private:
  test::TemporaryFolder folder_;
};

/// "P0: ..." for a camera of 64x48 pixels whose fourth number is `p3`.
std::string matrixLine(const std::string& name, double p3, double fx = 50);

/// Configures `source` with `values`; the failure's message, or "".
std::string configure(FolderSource& source, ParameterValues values);

/// "Severity where: message" of each finding.
std::vector<std::string> inspect(FolderSource& source);

/// All frames until the end of the stream or a failure, whose message goes to `failure`.
std::vector<Frame> readAll(FolderSource& source, std::string& failure);

}  // namespace tolman::image_folders
