// SPDX-License-Identifier: BSD-3-Clause
#include "app/results.hpp"

#include <stdexcept>
#include <utility>

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

void must(const Status& status) {
  if (!status.isOk()) throw std::runtime_error(status.message());
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

struct Paths {
  evaluation::Trajectory truth;
  evaluation::Trajectory odometry;
  evaluation::Trajectory map;
};

Paths pathsOf(const record::RunReader& reader) {
  return {toTrajectory(must(reader.truth())), toTrajectory(must(reader.odometry())),
          toTrajectory(must(reader.map()))};
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

evaluation::Metrics measure(const record::RunReader& reader, const Paths& paths,
                            const config::EvaluationSettings& settings) {
  const auto lengths = lengthsOf(settings);
  evaluation::Metrics metrics;
  metrics.alignment = resolve(settings.alignment, reader);
  metrics.odometry =
      evaluation::scoreTrajectory(paths.truth, paths.odometry, metrics.alignment, lengths);
  metrics.map = evaluation::scoreTrajectory(paths.truth, paths.map, metrics.alignment, lengths);
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

MapPicture pictureOf(const record::RunReader& reader, Paths paths, Alignment alignment) {
  MapPicture picture;
  const auto meta = must(reader.meta());
  const auto name = meta.find("name");
  picture.title = name == meta.end() ? "map" : name->second;
  picture.truth = truthOnMap(paths.truth, paths.map, alignment);
  picture.odometry = std::move(paths.odometry);
  picture.map = std::move(paths.map);
  picture.graph = must(reader.graph());
  return picture;
}

}  // namespace

Result<evaluation::Metrics> writeResults(const std::filesystem::path& directory,
                                         const config::EvaluationSettings& settings) {
  const auto opened = record::RunReader::open(directory);
  if (!opened.isOk()) return opened.status();
  const record::RunReader& reader = *opened.value();
  try {
    (void)must(record::exportRun(reader, directory));
    Paths paths = pathsOf(reader);
    const evaluation::Metrics metrics = measure(reader, paths, settings);
    must(record::writeAtomically(directory / "metrics.json",
                                 evaluation::toJson(metrics).dump(2) + "\n"));
    const MapPicture picture = pictureOf(reader, std::move(paths), metrics.alignment);
    must(record::writeAtomically(directory / "map.svg", svgText(picture)));
    must(record::writeResultsDigest(directory));
    return metrics;
  } catch (const std::exception& error) {
    return Status::invalidInput(error.what());
  }
}

}  // namespace tolman::app
