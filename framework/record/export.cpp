// SPDX-License-Identifier: BSD-3-Clause
#include "record/export.hpp"

#include <string>

#include "record/atomic_file.hpp"
#include "record/g2o_file.hpp"

namespace tolman::record {
namespace {

Result<std::string> contentOf(const RunReader& reader, std::string_view file) {
  if (file == "map.g2o") {
    const Result<MapGraph>& graph = reader.graph();
    return graph.isOk() ? Result<std::string>(g2oText(graph.value())) : graph.status();
  }
  const auto& poses = file.starts_with("odometry.") ? reader.odometry() : reader.map();
  if (!poses.isOk()) return poses.status();
  return file.ends_with(".tum") ? Result<std::string>(tumText(poses.value()))
                                : kittiText(poses.value());
}

}  // namespace

Result<std::vector<std::filesystem::path>> exportRun(const RunReader& reader,
                                                     const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> written;
  for (const std::string_view file : kExportedFiles) {
    const Result<std::string> content = contentOf(reader, file);
    if (!content.isOk()) return content.status();
    if (content.value().empty()) continue;
    const Status status = writeAtomically(folder / file, content.value());
    if (!status.isOk()) return status;
    written.push_back(folder / file);
  }
  if (written.empty()) {
    return Status::invalidInput(reader.directory().string() + ": holds nothing to export yet");
  }
  return written;
}

Result<std::vector<std::filesystem::path>> exportRun(const std::filesystem::path& run_directory,
                                                     const std::filesystem::path& folder) {
  const auto reader = RunReader::open(run_directory);
  return reader.isOk() ? exportRun(*reader.value(), folder) : reader.status();
}

}  // namespace tolman::record
