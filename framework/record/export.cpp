// SPDX-License-Identifier: BSD-3-Clause
#include "record/export.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "record/map_file.hpp"
#include "record/output_places.hpp"
#include "record/pose_files.hpp"

namespace tolman::record {
namespace {

/// The frames of a session: `first` to `end` - 1.
struct Span {
  std::int64_t first = 0;
  std::int64_t end = INT64_MAX;
};

Result<Span> spanOf(const RunReader& reader, std::int64_t session) {
  const auto sessions = reader.sessions();
  if (!sessions.isOk()) return sessions.status();
  const auto count = static_cast<std::int64_t>(sessions.value().size());
  if (session < 0) session = std::max<std::int64_t>(count - 1, 0);
  if (session >= std::max<std::int64_t>(count, 1)) {
    return Status::invalidParameter(reader.directory().string() + ": has no session " +
                                    std::to_string(session) + "; the last is " +
                                    std::to_string(count - 1));
  }
  Span span;
  if (count == 0) return span;
  const auto at = static_cast<std::size_t>(session);
  span.first = sessions.value()[at].first_frame;
  if (session + 1 < count) span.end = sessions.value()[at + 1].first_frame;
  return span;
}

evaluation::Trajectory within(evaluation::Trajectory poses, const Span& span) {
  std::erase_if(poses, [&](const evaluation::TrajectoryPose& pose) {
    return pose.frame < span.first || pose.frame >= span.end;
  });
  for (evaluation::TrajectoryPose& pose : poses) pose.frame -= span.first;
  return poses;
}

Result<std::string> contentOf(const RunReader& reader, std::string_view file, const Span& span) {
  if (file == "map.g2o") {
    const Result<MapGraph>& graph = reader.graph();
    return graph.isOk() ? Result<std::string>(g2oText(graph.value())) : graph.status();
  }
  const auto& all = file.starts_with("odometry.") ? reader.odometry() : reader.map();
  if (!all.isOk()) return all.status();
  const evaluation::Trajectory poses = within(all.value(), span);
  if (poses.empty()) return std::string();
  if (file.ends_with(".tum")) return tumText(poses);
  const Result<std::int64_t> last = reader.lastGivenFrame();
  if (!last.isOk()) return last.status();
  return kittiText(poses, std::min(last.value() + 1, span.end) - span.first);
}

}  // namespace

Result<std::vector<std::filesystem::path>> exportRun(const RunReader& reader,
                                                     const std::filesystem::path& folder,
                                                     std::int64_t session) {
  const Result<Span> span = spanOf(reader, session);
  if (!span.isOk()) return span.status();
  std::vector<OutputFile> files;
  std::vector<std::filesystem::path> written;
  Status unreadable;
  for (const std::string_view file : kExportedFiles) {
    Result<std::string> content = contentOf(reader, file, span.value());
    unreadable = content.status();
    if (!content.isOk()) break;  // what came before it is saved
    if (content.value().empty()) continue;
    written.push_back(folder / file);
    files.push_back({written.back(), std::move(content).value()});
  }
  if (written.empty() && unreadable.isOk()) {
    return Status::invalidInput(reader.directory().string() + ": holds nothing to export yet");
  }
  if (Status status = writeTogether(files, "--out"); !status.isOk()) return status;
  if (!unreadable.isOk()) return unreadable;
  return written;
}

Result<std::vector<std::filesystem::path>> exportRun(const std::filesystem::path& run_directory,
                                                     const std::filesystem::path& folder,
                                                     std::int64_t session) {
  const auto reader = RunReader::open(run_directory);
  return reader.isOk() ? exportRun(*reader.value(), folder, session) : reader.status();
}

}  // namespace tolman::record
