// SPDX-License-Identifier: BSD-3-Clause
#include "record/export.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <charconv>
#include <utility>

#include "record/atomic_file.hpp"

namespace tolman::record {
namespace {

void add(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0).ptr;
  text.append(digits.data(), end);
}

void addPose(std::string& text, const Eigen::Isometry3d& T) {
  Eigen::Quaterniond q = Eigen::Quaterniond(T.linear()).normalized();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  for (int i = 0; i < 3; ++i) {
    add(text, T.translation()[i]);
    text += ' ';
  }
  for (int i = 0; i < 4; ++i) {
    add(text, q.coeffs()[i]);
    if (i < 3) text += ' ';
  }
}

std::string kittiLine(const Eigen::Isometry3d& T) {
  std::string line;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (!line.empty()) line += ' ';
      add(line, T.matrix()(row, column));
    }
  }
  return line + "\n";
}

}  // namespace

std::string numberText(double value) {
  std::string text;
  add(text, value);
  return text;
}

std::string secondsText(std::int64_t time_ns) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  const auto bits = static_cast<std::uint64_t>(time_ns);
  const std::uint64_t size = time_ns < 0 ? -bits : bits;
  return fmt::format("{}{}.{:09}", time_ns < 0 ? "-" : "", size / kSecond, size % kSecond);
}

std::string tumText(const evaluation::Trajectory& poses) {
  std::string text;
  for (const evaluation::TrajectoryPose& pose : poses) {
    text += secondsText(pose.stamp_ns) + " ";
    addPose(text, pose.T_world_camera);
    text += '\n';
  }
  return text;
}

std::string kittiText(const evaluation::Trajectory& poses, std::int64_t frames) {
  std::string text;
  std::string line = kittiLine(Eigen::Isometry3d::Identity());
  std::int64_t next = 0;
  for (const evaluation::TrajectoryPose& pose : poses) {
    for (; next < pose.frame; ++next) text += line;
    line = kittiLine(pose.T_world_camera);
    text += line;
    ++next;
  }
  for (; next < frames; ++next) text += line;
  return text;
}

GraphParts partsOf(const MapGraph& graph) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> links(
      graph.experiences.size());
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) continue;
    add_edge(static_cast<std::size_t>(link.from), static_cast<std::size_t>(link.to), links);
  }
  GraphParts parts{std::vector<std::int64_t>(graph.experiences.size()), 0};
  parts.count = boost::connected_components(links, parts.of_experience.data());
  return parts;
}

Matrix6d g2oInformation(const Link& link) {
  constexpr double kVarianceFloor = 1e-10;
  const Matrix6d symmetric = (link.covariance + link.covariance.transpose()) / 2;
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(symmetric);
  const Vector6d inverse = solver.eigenvalues().cwiseMax(kVarianceFloor).cwiseInverse();
  Vector6d jacobian;  // rotation vector = 2 * quaternion vector
  jacobian << 1, 1, 1, 2, 2, 2;
  const Matrix6d information =
      solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
  return link.weight * (jacobian.asDiagonal() * information * jacobian.asDiagonal());
}

std::string g2oText(const MapGraph& graph) {
  std::string text;
  const GraphParts parts = partsOf(graph);
  if (parts.count > 1) {
    text += "# " + std::to_string(parts.count) +
            " parts that no link joins: their relative poses are unknown\n";
  }
  for (const Experience& experience : graph.experiences) {
    text += "VERTEX_SE3:QUAT " + std::to_string(experience.id) + " ";
    addPose(text, experience.T_world_experience);
    text += '\n';
  }
  if (!graph.experiences.empty()) text += "FIX 0\n";
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) continue;
    text += "EDGE_SE3:QUAT " + std::to_string(link.from) + " " + std::to_string(link.to) + " ";
    addPose(text, link.T_from_to);
    const Matrix6d information = g2oInformation(link);
    for (int row = 0; row < 6; ++row) {
      for (int column = row; column < 6; ++column) {
        text += ' ';
        add(text, information(row, column));
      }
    }
    text += '\n';
  }
  return text;
}

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
  if (Status status = writeOutputs(files); !status.isOk()) return status;
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
