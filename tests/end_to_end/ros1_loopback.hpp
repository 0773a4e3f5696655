// SPDX-License-Identifier: BSD-3-Clause
// A roscore on the loopback interface, and nodes of ROS 1's Python modules (support/ros1_tool.py).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

namespace tolman::test {

/// A folder, an address, and what runs there; all of it ends with the object.
class Ros1Loopback {
 public:
  explicit Ros1Loopback(bool with_core = true);
  ~Ros1Loopback();
  Ros1Loopback(const Ros1Loopback&) = delete;
  Ros1Loopback& operator=(const Ros1Loopback&) = delete;

  const std::filesystem::path& folder() const { return folder_.path(); }
  std::string uri() const { return "http://127.0.0.1:" + std::to_string(port_); }
  /// Variables that a node needs.
  std::vector<std::string> environment() const;
  /// The words as a node's command.
  std::vector<std::string> command(const std::vector<std::string>& words) const;
  /// Starts the tool with these words.
  void tool(std::vector<std::string> words);
  void endCore() { end(core_); }

  static inline const std::string kTool = inSource("tests/support/ros1_tool.py");

 private:
  std::unique_ptr<Process> start(const std::string& name, const std::vector<std::string>& words);
  static void end(std::unique_ptr<Process>& process);

  TemporaryFolder folder_;
  int port_;
  std::unique_ptr<Process> core_;
  std::vector<std::unique_ptr<Process>> others_;
};

}  // namespace tolman::test
