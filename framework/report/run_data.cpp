// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_data.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "evaluation/alignment.hpp"
#include "evaluation/association.hpp"
#include "record/graph_parts.hpp"

namespace tolman::report {
namespace {

using evaluation::Alignment;

template <class T>
const T& must(const Result<T>& result) {
  if (!result.isOk()) throw std::runtime_error(result.status().message());
  return result.value();
}

template <class T>
T must(Result<T>&& result) {
  (void)must(std::as_const(result));
  return std::move(result).value();
}

/// The poses of the record as those of the evaluation: neither folder may know the other.
evaluation::Trajectory toTrajectory(const std::vector<record::StampedPose>& poses) {
  evaluation::Trajectory trajectory;
  trajectory.reserve(poses.size());
  for (const auto& pose : poses) {
    trajectory.push_back({pose.frame, pose.stamp_ns, pose.T_world_camera});
  }
  return trajectory;
}

/// `auto`: similarity for a single camera, planar for a source without images, else rigid.
Alignment resolve(config::Alignment asked, const record::RunReader& reader) {
  switch (asked) {
    case config::Alignment::Se3:
      return Alignment::Se3;
    case config::Alignment::Se2:
      return Alignment::Se2;
    case config::Alignment::Sim3:
      return Alignment::Sim3;
    case config::Alignment::None:
      return Alignment::None;
    case config::Alignment::Auto:
      break;
  }
  const auto cameras = reader.records<CameraRig>();
  if (cameras.isOk() && !cameras.value().empty() && cameras.value()[0].width == 0) {
    return Alignment::Se2;
  }
  return must(reader.scaleKnown()) ? Alignment::Se3 : Alignment::Sim3;
}

/// Nothing: by the length of the truth.
std::optional<evaluation::SegmentLengths> lengthsOf(const config::EvaluationSettings& settings) {
  if (!settings.segment_lengths.empty()) {
    return evaluation::SegmentLengths{"custom", settings.segment_lengths};
  }
  if (settings.segments == config::Segments::Kitti) return evaluation::kittiLengths();
  if (settings.segments == config::Segments::Short) return evaluation::shortLengths();
  return std::nullopt;
}

/// Frames before `first` are of earlier sessions.
evaluation::Trajectory since(std::int64_t first, evaluation::Trajectory trajectory) {
  std::erase_if(trajectory, [&](const auto& pose) { return pose.frame < first; });
  return trajectory;
}

std::vector<evaluation::SessionFigures> sessionFigures(const std::vector<record::Session>& sessions,
                                                       std::int64_t frames, const MapGraph& graph,
                                                       const record::GraphParts& parts) {
  std::vector<evaluation::SessionFigures> figures;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const std::int64_t first = sessions[i].first_frame;
    const std::int64_t end = i + 1 < sessions.size() ? sessions[i + 1].first_frame : frames;
    evaluation::SessionFigures session{sessions[i].name, first, end - first, 0, {}};
    for (const Experience& experience : graph.experiences) {
      if (experience.frame < first || experience.frame >= end) continue;
      ++session.experiences;
      const auto part = parts.of_experience[static_cast<std::size_t>(experience.id)];
      if (std::ranges::find(session.parts, part) == session.parts.end()) {
        session.parts.push_back(part);
      }
    }
    figures.push_back(std::move(session));
  }
  return figures;
}

struct Paths {
  evaluation::Trajectory truth;
  evaluation::Trajectory odometry;
  evaluation::Trajectory map;
};

evaluation::Metrics measure(const record::RunReader& reader, const Paths& paths,
                            const config::EvaluationSettings& settings) {
  const auto lengths = lengthsOf(settings);
  evaluation::Metrics metrics;
  metrics.alignment = resolve(settings.alignment, reader);
  metrics.odometry =
      evaluation::scoreTrajectory(paths.truth, paths.odometry, metrics.alignment, lengths);
  const MapGraph& graph = must(reader.graph());
  const record::GraphParts parts = record::partsOf(graph);
  metrics.parts = parts.count;
  metrics.sessions =
      sessionFigures(must(reader.sessions()), must(reader.nextFrame()), graph, parts);
  if (settings.sessions == config::SessionScope::Joint && parts.count > 1) {
    metrics.map.reason = evaluation::unjoinedText(metrics);
  } else {
    metrics.map = evaluation::scoreTrajectory(paths.truth, paths.map, metrics.alignment, lengths);
  }
  const auto counters = must(reader.counters());
  metrics.frames = counters.frames;
  metrics.templates = counters.templates;
  metrics.experiences = counters.experiences;
  metrics.loops = counters.loops;
  const auto timing = must(reader.timing());
  for (const auto& [stage, durations] : timing) {
    metrics.timing[stage] = evaluation::stageTiming(durations);
  }
  return metrics;
}

/// The truth where the map's alignment puts it: in the run's own world frame.
evaluation::Trajectory truthOnMap(const evaluation::Trajectory& truth,
                                  const evaluation::Trajectory& map, Alignment alignment) {
  const auto matches = evaluation::associateByFrame(map, truth);
  if (!matches.isOk()) return {};
  const auto similarity = evaluation::align(matches.value(), alignment);
  if (!similarity.isOk()) return {};
  evaluation::Trajectory moved = truth;
  for (auto& pose : moved) pose.T_world_camera = similarity.value().apply(pose.T_world_camera);
  return moved;
}

/// How far each matched frame is off after alignment.
ErrorSeries errorsOf(const evaluation::Trajectory& truth, const evaluation::Trajectory& estimate,
                     Alignment alignment) {
  ErrorSeries series;
  const auto matches = evaluation::associateByFrame(truth, estimate);
  if (!matches.isOk()) return series;
  const auto similarity = evaluation::align(matches.value(), alignment);
  if (!similarity.isOk()) return series;
  const auto aligned = evaluation::aligned(matches.value(), similarity.value());
  const bool planar = alignment == Alignment::Se2;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    Eigen::Vector3d off = aligned.estimate[i].T_world_camera.translation() -
                          aligned.truth[i].T_world_camera.translation();
    if (planar) off.y() = 0;
    const auto stamp = aligned.estimate[i].stamp_ns - estimate.front().stamp_ns;
    series.seconds.push_back(static_cast<double>(stamp) * 1e-9);
    series.metres.push_back(off.norm());
  }
  return series;
}

std::string nameOf(const record::RunReader& reader) {
  const auto meta = must(reader.meta());
  const auto name = meta.find("name");
  return name == meta.end() ? "run" : name->second;
}

}  // namespace

Result<RunData> readRun(const record::RunReader& reader,
                        const config::EvaluationSettings& settings) {
  try {
    const auto sessions = must(reader.sessions());
    const std::int64_t own = sessions.empty() ? 0 : sessions.back().first_frame;
    const bool joint = settings.sessions == config::SessionScope::Joint;
    Paths paths{since(joint ? 0 : own, toTrajectory(must(reader.truth()))),
                since(own, toTrajectory(must(reader.odometry()))),
                since(joint ? 0 : own, toTrajectory(must(reader.map())))};
    RunData data;
    data.name = nameOf(reader);
    data.metrics = measure(reader, paths, settings);
    data.truth = truthOnMap(paths.truth, paths.map, data.metrics.alignment);
    data.odometry_error = errorsOf(paths.truth, paths.odometry, data.metrics.alignment);
    data.map_error = errorsOf(paths.truth, paths.map, data.metrics.alignment);
    data.odometry = std::move(paths.odometry);
    data.map = std::move(paths.map);
    data.graph = must(reader.graph());
    return data;
  } catch (const std::exception& error) {
    return Status::invalidInput(error.what());
  }
}

}  // namespace tolman::report
