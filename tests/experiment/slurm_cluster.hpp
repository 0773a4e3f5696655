// SPDX-License-Identifier: BSD-3-Clause
// Debian's slurmctld and slurmd on the loopback interface, as an ordinary user, without munge and
// accounts.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "end_to_end/process.hpp"
#include "support/data.hpp"

namespace tolman::test {

class SlurmCluster {
 public:
  /// Nothing where Slurm is not installed.
  static std::unique_ptr<SlurmCluster> start();
  ~SlurmCluster();
  SlurmCluster(const SlurmCluster&) = delete;
  SlurmCluster& operator=(const SlurmCluster&) = delete;

  /// Runs a command as the user of the cluster, with its configuration.
  Finished run(const std::vector<std::string>& command) const;
  /// Lets its user write there.
  void give(const std::filesystem::path& folder) const;
  /// Whether the node has come up.
  bool waitUntilIdle() const;
  /// Whether the queue has emptied.
  bool waitUntilDone() const;
  std::string logs() const;

 private:
  SlurmCluster();
  std::string configuration() const;
  std::vector<std::string> asUser(std::vector<std::string> command) const;

  TemporaryFolder folder_;
  bool drops_root_ = false;  ///< started by root: everything runs as `nobody`
  std::string previous_;     ///< SLURM_CONF
  std::unique_ptr<Process> controller_;
  std::unique_ptr<Process> node_;
};

}  // namespace tolman::test
