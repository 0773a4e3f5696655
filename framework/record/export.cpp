// SPDX-License-Identifier: BSD-3-Clause
#include "record/export.hpp"

#include <string>

#include "record/atomic_file.hpp"
#include "record/g2o_file.hpp"
#include "record/run_reader.hpp"

namespace tolman::record {
namespace {

Result<std::string> posesAs(std::string_view file, const Result<std::vector<StampedPose>>& poses) {
  if (!poses.isOk()) return poses.status();
  return file.ends_with(".tum") ? Result<std::string>(tumText(poses.value()))
                                : kittiText(poses.value());
}

Result<std::string> contentOf(const RunReader& reader, std::string_view file) {
  if (file == "map.g2o") {
    const Result<MapGraph> graph = reader.graph();
    return graph.isOk() ? Result<std::string>(g2oText(graph.value())) : graph.status();
  }
  if (file.starts_with("odometry.")) return posesAs(file, reader.odometry());
  if (file.starts_with("trajectory.")) return posesAs(file, reader.map());
  return Status::invalidParameter(std::string(file) + ": is none of the files of an export");
}

}  // namespace

Result<std::vector<std::filesystem::path>> exportRun(const std::filesystem::path& run_directory,
                                                     const std::filesystem::path& folder,
                                                     const std::vector<std::string_view>& files) {
  const auto reader = RunReader::open(run_directory);
  if (!reader.isOk()) return reader.status();
  std::vector<std::filesystem::path> written;
  for (const std::string_view file : files) {
    const Result<std::string> content = contentOf(*reader.value(), file);
    if (!content.isOk()) return content.status();
    if (content.value().empty()) continue;
    const Status status = writeAtomically(folder / file, content.value());
    if (!status.isOk()) return status;
    written.push_back(folder / file);
  }
  if (written.empty()) {
    return Status::invalidInput(run_directory.string() + ": holds nothing to export yet");
  }
  return written;
}

}  // namespace tolman::record
