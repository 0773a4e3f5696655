// SPDX-License-Identifier: BSD-3-Clause
// Collects the problems of a data set while it is read, so that all are reported at once.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::image_folders {

/// Findings in the order of discovery, at most 20 errors per file.
class Inspection {
 public:
  void error(const std::filesystem::path& file, std::string message);
  void error(const std::filesystem::path& file, int line, std::string message);
  /// "FILE: what", or "FILE:LINE: what".
  void error(const std::string& message);
  /// Adds a warning: something that may be intended. The data are used.
  void warning(const std::filesystem::path& file, std::string message);
  void warning(const std::filesystem::path& file, int line, std::string message);

  bool hasErrors() const { return !errors_of_file_.empty(); }
  const std::vector<Finding>& findings() const { return findings_; }
  /// Ok, or the first error and how many more there are.
  Status status() const;

 private:
  void add(const std::string& file, std::string where, std::string message);

  std::vector<Finding> findings_;
  std::map<std::string, int> errors_of_file_;
};

}  // namespace tolman::image_folders
