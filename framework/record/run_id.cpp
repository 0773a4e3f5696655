// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_id.hpp"

#include "record/run_directory.hpp"

namespace tolman::record {

std::string runIdOf(const std::filesystem::path& directory) {
  const auto json = RunDirectory::readRunFile(directory);
  const auto id = json.find(kRunIdKey);  // end() also if it is not an object
  return id != json.end() && id->is_string() ? id->get<std::string>() : "";
}

Status isOfRun(const std::filesystem::path& file, std::string_view id, std::string_view run) {
  if (run.empty() || id == run) return Status::ok();
  return Status::invalidInput(file.string() +
                              ": is of another run than the run.json of this run directory; put "
                              "back the files of one run, or run it again");
}

}  // namespace tolman::record
