// SPDX-License-Identifier: BSD-3-Clause
// A small sweep over two motion logs in a temporary folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "end_to_end/process.hpp"
#include "support/data.hpp"

namespace tolman::test {

using Words = std::vector<std::string>;

struct Study {
  TemporaryFolder folder;

  Study();
  /// Two periods and two sequences with noise, and what `more` adds.
  void write(const std::string& more) const;
  /// The same with all but `base` given.
  void writeAll(const std::string& text) const;

  std::string file() const { return (folder.path() / "study.yaml").string(); }
  std::filesystem::path out(const std::string& name = "out") const { return folder.path() / name; }
  Words words(const Words& options = {}, const std::string& name = "out") const;
  Finished sweep(const Words& options = {}, const std::string& name = "out") const;
  /// Lines of `tolman sweep status`.
  std::string status(const std::string& name = "out") const;
  /// The folder of the run with this name.
  std::filesystem::path point(const std::string& run, const std::string& name = "out") const;
  /// Digests of the results by the name of the run.
  std::map<std::string, std::string> results(const std::string& name = "out") const;
};

}  // namespace tolman::test
