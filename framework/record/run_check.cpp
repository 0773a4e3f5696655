// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_check.hpp"

#include <set>
#include <string>

#include "record/digest.hpp"
#include "record/run_directory.hpp"

namespace tolman::record {

namespace fs = std::filesystem;

Status checkConfig(const fs::path& run_directory, const nlohmann::ordered_json& run_file) {
  const auto digest = run_file.find(kConfigDigest);  // end() also if it is no object
  if (digest == run_file.end()) return Status::ok();
  const fs::path file = run_directory / "config.resolved.yaml";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    return Status::invalidInput(file.string() + ": is missing; put it back, or run it again");
  }
  const Result<std::string> found = fileDigest(file);
  if (!found.isOk()) {
    return Status::invalidInput(found.status().message() + "; check its permissions");
  }
  if (*digest == found.value()) return Status::ok();
  return Status::invalidInput(
      file.string() + ": has changed since the run was recorded; put it back, or run it again");
}

Status checkEndFiles(const fs::path& run_directory) {
  if (!RunDirectory::hasEnded(run_directory)) return Status::ok();
  std::set<std::string> files = {"metrics.json", "results.sha256"};
  for (const auto& [file, digest] : resultsDigests(run_directory)) files.insert(file);
  std::string missing;
  for (const std::string& file : files) {
    std::error_code ignored;
    if (fs::exists(run_directory / file, ignored)) continue;
    missing += (missing.empty() ? "" : ", ") + file;
  }
  if (missing.empty()) return Status::ok();
  return Status::invalidInput(run_directory.string() +
                              ": the run has ended, but files of its end are missing: " + missing +
                              "; put them back, or repeat the run with `tolman rerun`");
}

}  // namespace tolman::record
