// SPDX-License-Identifier: BSD-3-Clause
// Origins of configured values, and the problems found in them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tolman::config {

/// Where a value was set.
struct Origin {
  enum class Kind : std::uint8_t { Default, File, CommandLine };
  Kind kind = Kind::Default;
  std::string file;       ///< path of the file, or "--set a.b=c" as typed; empty for a default
  int line = 0;           ///< from 1; 0 for the whole file
  int column = 0;         ///< from 1
  std::string variables;  ///< expanded in the value, e.g. "KITTI_ROOT (not set), HOME"

  static Origin ofFile(std::string path) { return {Kind::File, std::move(path), 0, 0, {}}; }
};

/// "configs/a.yaml:4:13", "--set a.b=c" or "default".
std::string text(const Origin& origin);

struct Problem {
  enum class Kind : std::uint8_t {
    Value,   ///< a file, a key or a value
    Plugin,  ///< a plugin that is named cannot be used
  };
  Origin where;
  std::string key_path;  ///< e.g. "odometry.active_points"; empty for a whole file
  std::string message;
  Kind kind = Kind::Value;
};
using Problems = std::vector<Problem>;

/// "configs/a.yaml:4:13: odometry.activ_points: unknown parameter; did you mean 'active_points'?"
std::string format(const Problem& problem);

/// One line each, sorted by file and position; the command line last.
std::string format(Problems problems);

}  // namespace tolman::config
