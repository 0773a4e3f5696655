// SPDX-License-Identifier: BSD-3-Clause
// Runs programs, and checks their output and files.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tolman::test {

struct Finished {
  int exit_code = -1;  ///< 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

/// A program that is running; its output goes to files in a folder of its own.
class Process {
 public:
  Process(const std::vector<std::string>& command, const std::filesystem::path& folder);
  void signal(int number) const;
  pid_t id() const { return pid_; }
  Finished wait();

 private:
  pid_t pid_ = -1;
  std::filesystem::path folder_;
};

/// Runs a command to its end.
Finished run(const std::vector<std::string>& command);

/// `tolman` of the build tree with these arguments.
Finished tolman(std::vector<std::string> arguments);
std::filesystem::path tolmanProgram();

std::string readText(const std::filesystem::path& file);
nlohmann::json readJson(const std::filesystem::path& file);
bool contains(const std::string& text, const std::string& part);

}  // namespace tolman::test
