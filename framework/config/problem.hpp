// SPDX-License-Identifier: BSD-3-Clause
// Where a configured value was said, and what is wrong with it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tolman::config {

/// The place where a value was said.
struct Origin {
  enum class Kind : std::uint8_t { Default, File, CommandLine };
  Kind kind = Kind::Default;
  std::string file;       ///< path of the file, or "--set a.b=c" as typed; empty for a default
  int line = 0;           ///< from 1; 0 when the whole file is meant
  int column = 0;         ///< from 1
  std::string variables;  ///< environment variables that took part, e.g. "KITTI_ROOT, HOME"

  static Origin ofFile(std::string path) { return {Kind::File, std::move(path), 0, 0, {}}; }
};

/// "configs/a.yaml:4:13", "--set a.b=c" or "default".
std::string text(const Origin& origin);

/// One thing that is wrong, for a person.
struct Problem {
  Origin where;
  std::string key_path;  ///< e.g. "odometry.active_points"; empty for a whole file
  std::string message;
};
using Problems = std::vector<Problem>;

/// "configs/a.yaml:4:13: odometry.activ_points: unknown parameter; did you mean 'active_points'?"
std::string format(const Problem& problem);

/// One line each, by file and position; the command line comes last.
std::string format(Problems problems);

}  // namespace tolman::config
