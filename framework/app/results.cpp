// SPDX-License-Identifier: BSD-3-Clause
#include "app/results.hpp"

#include "app/map_picture.hpp"
#include "evaluation/alignment.hpp"
#include "evaluation/association.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/export.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

using evaluation::Alignment;

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
  const auto motions = reader.records<Motion>();
  const bool metric =
      !motions.isOk() || motions.value().empty() || motions.value().back().scale_known;
  return metric ? Alignment::Se3 : Alignment::Sim3;
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

template <class T>
T must(Result<T> result) {
  if (!result.isOk()) throw std::runtime_error(result.status().message());
  return std::move(result).value();
}

evaluation::Metrics measureOpened(const record::RunReader& reader,
                                  const config::EvaluationSettings& settings) {
  const auto truth = toTrajectory(must(reader.truth()));
  const auto lengths = lengthsOf(settings);
  evaluation::Metrics metrics;
  metrics.alignment = resolve(settings.alignment, reader);
  metrics.odometry = evaluation::scoreTrajectory(truth, toTrajectory(must(reader.odometry())),
                                                 metrics.alignment, lengths);
  metrics.map = evaluation::scoreTrajectory(truth, toTrajectory(must(reader.map())),
                                            metrics.alignment, lengths);
  const auto counters = must(reader.counters());
  metrics.frames = counters.frames;
  metrics.templates = counters.templates;
  metrics.experiences = counters.experiences;
  metrics.loops = counters.loops;
  for (const auto& [stage, durations] : must(reader.timing())) {
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

Status drawMap(const std::filesystem::path& directory, Alignment alignment) {
  const auto opened = record::RunReader::open(directory);
  if (!opened.isOk()) return opened.status();
  const record::RunReader& reader = *opened.value();
  MapPicture picture;
  const auto meta = must(reader.meta());
  const auto name = meta.find("name");
  picture.title = name == meta.end() ? "map" : name->second;
  picture.odometry = toTrajectory(must(reader.odometry()));
  picture.map = toTrajectory(must(reader.map()));
  picture.truth = truthOnMap(toTrajectory(must(reader.truth())), picture.map, alignment);
  picture.graph = must(reader.graph());
  return record::writeAtomically(directory / "map.svg", svgText(picture));
}

}  // namespace

Result<evaluation::Metrics> measure(const std::filesystem::path& directory,
                                    const config::EvaluationSettings& settings) {
  const auto reader = record::RunReader::open(directory);
  if (!reader.isOk()) return reader.status();
  try {
    return measureOpened(*reader.value(), settings);
  } catch (const std::exception& error) {
    return Status::invalidInput(error.what());
  }
}

Result<evaluation::Metrics> writeResults(const std::filesystem::path& directory,
                                         const config::EvaluationSettings& settings) {
  const auto exported = record::exportRun(directory, directory);
  if (!exported.isOk()) return exported.status();
  auto metrics = measure(directory, settings);
  if (!metrics.isOk()) return metrics;
  const std::string json = evaluation::toJson(metrics.value()).dump(2) + "\n";
  Status status = record::writeAtomically(directory / "metrics.json", json);
  if (status.isOk()) status = drawMap(directory, metrics.value().alignment);
  if (status.isOk()) status = record::writeResultsDigest(directory);
  if (!status.isOk()) return status;
  return metrics;
}

}  // namespace tolman::app
