// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_data.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "base/must.hpp"
#include "base/record_rows.hpp"
#include "evaluation/association.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/score.hpp"
#include "record/digest.hpp"
#include "record/export.hpp"

namespace tolman::report {
namespace {

using evaluation::Alignment;

/// `auto`: similarity for a single camera, planar for a source without images, else rigid.
Alignment resolve(config::AlignmentChoice asked, const record::RunReader& reader) {
  const auto named = std::ranges::find(evaluation::kAlignmentNames, enumName(asked));
  if (named != evaluation::kAlignmentNames.end()) {
    return static_cast<Alignment>(named - evaluation::kAlignmentNames.begin());
  }
  const auto cameras = reader.records<CameraRig>();
  if (cameras.isOk() && !cameras.value().empty() && cameras.value()[0].width == 0) {
    return Alignment::Se2;
  }
  return must(reader.scaleKnown()) ? Alignment::Se3 : Alignment::Sim3;
}

/// The configured lengths; none if they depend on the length of the true path.
std::optional<evaluation::SegmentLengths> lengthsOf(const config::EvaluationSettings& settings) {
  if (!settings.segment_lengths.empty()) {
    return evaluation::SegmentLengths{"custom", settings.segment_lengths};
  }
  if (settings.segments == config::Segments::Kitti) return evaluation::kittiLengths();
  if (settings.segments == config::Segments::Short) return evaluation::shortLengths();
  return std::nullopt;
}

/// The poses from frame `first` on; earlier ones are of earlier sessions.
evaluation::Trajectory since(std::int64_t first, evaluation::Trajectory trajectory) {
  std::erase_if(trajectory, [&](const auto& pose) { return pose.frame < first; });
  return trajectory;
}

/// Sets the session of each pose: the motion from one session to the next is not known.
void markSessions(const std::vector<record::RecordedSession>& sessions,
                  evaluation::Trajectory& trajectory) {
  for (auto& pose : trajectory) {
    for (std::size_t i = 0; i < sessions.size(); ++i) {
      if (pose.frame >= sessions[i].first_frame) pose.session = i;
    }
  }
}

std::vector<evaluation::SessionFigures> sessionFigures(
    const std::vector<record::RecordedSession>& sessions, std::int64_t frames,
    const MapGraph& graph, const record::GraphParts& parts) {
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

/// Consistency of the motions since frame `first`, each with its last revision.
evaluation::MotionConsistency consistencyOf(const record::RunReader& reader, std::int64_t first,
                                            const evaluation::Trajectory& truth,
                                            Alignment alignment) {
  std::map<std::int64_t, MotionRevision> revisions;
  for (const MotionRevision& revision : must(reader.records<MotionRevision>())) {
    revisions[revision.frame] = revision;
  }
  evaluation::MotionErrors errors(truth, alignment == Alignment::Se2);
  must(record::guarded(reader.directory().string(), [&] {
    record::forEachRow<Motion>(reader.database(), "", [&](Motion motion) {
      if (motion.frame < first) return;
      if (const auto revised = revisions.find(motion.frame); revised != revisions.end()) {
        motion.T_previous_current = revised->second.T_previous_current;
        motion.covariance = revised->second.covariance;
      }
      errors.add(motion);
    });
  }));
  return errors.result();
}

/// Every n-th pose of a long trajectory, which bounds the time.
evaluation::Trajectory sampled(const evaluation::Trajectory& poses, std::size_t enough) {
  evaluation::Trajectory some;
  for (std::size_t i = 0; i < poses.size(); i += 1 + poses.size() / enough)
    some.push_back(poses[i]);
  return some;
}

evaluation::TrajectoryMetrics scored(const evaluation::Trajectory& truth,
                                     const evaluation::Trajectory& estimate, Alignment alignment,
                                     const std::optional<evaluation::SegmentLengths>& lengths) {
  evaluation::TrajectoryMetrics metrics = evaluation::score(truth, estimate, {alignment, lengths});
  constexpr std::size_t kEnough = 20'000;  // what is read wrongly or broken shows in them as in all
  metrics.warning =
      evaluation::doubtText(evaluation::doubts(truth, sampled(estimate, kEnough), alignment));
  return metrics;
}

/// Counts frames that `realtime` dropped as not tracked. They have no record, and so no truth.
void countDropped(evaluation::TrajectoryMetrics& metrics, const evaluation::Trajectory& poses,
                  std::int64_t last_given) {
  if (!metrics.scores || poses.empty()) return;
  const auto processed = static_cast<double>(poses.size());
  const std::int64_t last = std::max(poses.back().frame, last_given);
  const auto given = static_cast<double>(last - poses.front().frame + 1);
  metrics.scores->coverage *= processed / given;
}

std::string digestOf(const evaluation::Trajectory& truth) {
  if (truth.empty()) return "";
  record::Sha256 sha;
  for (const auto& pose : truth) {
    sha.add(std::as_bytes(std::span(&pose.frame, 1)));
    sha.add(std::as_bytes(std::span(pose.T_world_camera.matrix().data(), 16)));
  }
  return sha.digest();
}

/// A part that no loop joins is assumed to begin where the path ended, which adds to the errors.
void warnOfParts(evaluation::Metrics& metrics) {
  if (metrics.sessions.empty() || metrics.sessions.back().parts.size() <= 1) return;
  if (!metrics.map.warning.empty()) return;
  metrics.map.warning =
      evaluation::unjoinedText(metrics) +
      ": each is assumed to begin where the previous one ended, which adds to the errors";
}

/// No alignment fits a path of two units. Takes the place of other warnings: it is their cause.
void warnOfScales(const record::RunReader& reader, std::int64_t own, evaluation::Metrics& metrics) {
  const std::string text =
      "some tracked motions are in metres and others in arbitrary units (scale_known), so the "
      "lengths and errors mean nothing; see log.txt";
  if (must(reader.mixesScales(own))) metrics.odometry.warning = text;
  if (must(reader.mixesScales(0))) metrics.map.warning = text;
}

/// Whether the truth comes back to a place: nearer than 5 m after 20 m, or less on short paths.
bool returnsToPlace(const evaluation::Trajectory& truth) {
  const evaluation::Trajectory thinned = sampled(truth, 2000);
  const double path = evaluation::pathLength(thinned);
  const evaluation::RevisitRule rule{std::min(5.0, 0.05 * path), std::min(20.0, 0.2 * path)};
  return !evaluation::findRevisits(thinned, rule).empty();
}

/// How the run was found in the map of another; none of a run that has a map of its own. Errors
/// need the truth of both in one world frame.
std::optional<evaluation::LocalisationFigures> localisationOf(
    const record::RunReader& reader, const MapGraph& graph, std::int64_t first,
    const evaluation::Trajectory& truth, const config::EvaluationSettings& settings) {
  const std::string map = must(reader.localisedIn());
  if (map.empty()) return std::nullopt;
  const bool joint = settings.sessions == config::SessionScope::Joint;
  const evaluation::Trajectory unknown;
  evaluation::LocalisationCounter counter(graph.experiences, joint ? truth : unknown);
  const auto motions = must(reader.records<Motion>());
  const auto updates = must(reader.records<MapUpdate>());
  for (std::size_t i = 0; i < std::min(motions.size(), updates.size()); ++i) {
    if (motions[i].frame >= first) counter.add(motions[i], updates[i]);
  }
  evaluation::LocalisationFigures figures = counter.figures();
  figures.map = map;
  figures.reason = joint ? "no frame that was found has a true pose, and its place as well"
                         : "evaluation.sessions is not joint: the truths of both runs must be in "
                           "one world frame";
  return figures;
}

/// Fills the metrics, except those of the cells.
void measure(const record::RunReader& reader, const evaluation::Trajectory& truth,
             const config::EvaluationSettings& settings, RunData& run) {
  const auto lengths = lengthsOf(settings);
  evaluation::Metrics& metrics = run.metrics;
  metrics.alignment = resolve(settings.alignment, reader);
  const std::int64_t own = run.odometry.empty() ? 0 : run.odometry.front().frame;
  metrics.odometry = scored(since(own, truth), run.odometry, metrics.alignment, lengths);
  const std::int64_t last_given = must(reader.lastGivenFrame());
  countDropped(metrics.odometry, run.odometry, last_given);
  const record::GraphParts parts = record::partsOf(run.graph);
  metrics.parts = parts.count;
  metrics.sessions =
      sessionFigures(must(reader.sessions()), must(reader.nextFrame()), run.graph, parts);
  if (run.graph.experiences.empty()) {
    metrics.map.reason = "the map has no experience, so its poses are those of odometry";
  } else if (settings.sessions == config::SessionScope::Joint && parts.count > 1) {
    metrics.map.reason = evaluation::unjoinedText(metrics);
  } else {
    metrics.map = scored(truth, run.map, metrics.alignment, lengths);
    countDropped(metrics.map, run.odometry, last_given);
    warnOfParts(metrics);
  }
  warnOfScales(reader, own, metrics);
  for (evaluation::TrajectoryMetrics* of : {&metrics.odometry, &metrics.map}) {
    of->in_metres = run.record.in_metres || (of->scores && metrics.alignment == Alignment::Sim3);
  }
  metrics.motions = consistencyOf(reader, own, truth, metrics.alignment);
  const record::RunTotals totals = must(reader.totals());
  metrics.frames = totals.frames;
  metrics.templates = totals.templates;
  metrics.counts = evaluation::countsOf(run.graph, totals.loop_decisions);
  metrics.localisation = localisationOf(reader, run.graph, own, truth, settings);
  metrics.truth_sha256 = digestOf(truth);
  if (!truth.empty()) {
    metrics.returns = returnsToPlace(truth);
    metrics.loops =
        evaluation::loopFigures(run.record.loops, run.record.places, truth, settings.loop_height);
  }
  for (const auto& [stage, durations] : must(reader.timing())) {
    metrics.timing[stage] = evaluation::stageTiming(durations);
  }
}

/// Aligns the truth with the map in the world frame of the run. If that fails, run.truth is empty.
void alignTruth(RunData& run, const evaluation::Trajectory& truth) {
  run.has_metres = run.record.in_metres;
  const auto matches = evaluation::associateByFrame(run.map, truth);
  if (!matches.isOk()) return;
  const auto similarity = evaluation::align(matches.value(), run.metrics.alignment);
  if (!similarity.isOk()) return;
  run.truth = truth;
  for (auto& pose : run.truth) pose.T_world_camera = similarity.value().apply(pose.T_world_camera);
  if (run.metrics.alignment != Alignment::Sim3) return;
  run.metres = 1 / similarity.value().scale;
  run.has_metres = true;
}

/// With `evaluation.body: estimate` the truth becomes that of the camera.
void takeOffBody(RunData& run, evaluation::Trajectory& truth,
                 const config::EvaluationSettings& settings) {
  if (settings.body != "estimate") return;
  const auto matches = evaluation::associateByFrame(truth, run.odometry);
  if (matches.isOk()) run.metrics.body = evaluation::bodyOf(matches.value());
  if (!run.metrics.body) return;
  truth = evaluation::ofBody(std::move(truth), run.metrics.body->pose().inverse());
}

/// The errors of the map, or why cells have no true places: positions alone have no headings.
evaluation::TrajectoryMetrics scoresForCells(const RunData& run,
                                             const evaluation::Trajectory& truth) {
  evaluation::TrajectoryMetrics metrics = run.metrics.map;
  const auto matches = evaluation::associateByFrame(truth, run.map);
  if (!metrics.scores || !matches.isOk() || !evaluation::hasPositionsAlone(matches.value())) {
    return metrics;
  }
  metrics.scores.reset();
  metrics.reason = "the truth has positions alone";
  return metrics;
}

/// Errors of each matched frame after alignment. Takes the pairs, which are large.
ErrorSeries errorsOf(const evaluation::Trajectory& estimate,
                     evaluation::TrajectoryMetrics& metrics) {
  constexpr std::size_t kPoints = 400;  // of a figure
  ErrorSeries series;
  if (!metrics.scores) return series;
  series.metres = evaluation::positionErrors(*metrics.scores);
  const evaluation::Matches pairs = std::exchange(metrics.scores->pairs, {});
  for (const auto& pose : pairs.estimate) {
    series.seconds.push_back(1e-9 * static_cast<double>(pose.stamp_ns - estimate.front().stamp_ns));
  }
  series.steps = evaluation::stepSeries(pairs, std::max<std::size_t>(1, pairs.size() / kPoints));
  return series;
}

evaluation::CellHistory cellsOf(const record::RunReader& reader) {
  evaluation::CellHistory cells(must(reader.arrayInfos()));
  must(reader.visitCellArrays(
      [&](std::int64_t frame, NamedArray array) { cells.add(frame, std::move(array)); }));
  cells.dropEmpty();
  return cells;
}

std::string nameOf(const record::RunReader& reader) {
  const auto meta = must(reader.meta());
  const auto name = meta.find("name");
  return name == meta.end() ? "run" : name->second;
}

/// Trajectories and graph, and the true poses of the camera.
RunData trajectoriesOf(const record::RunReader& reader, const config::EvaluationSettings& settings,
                       evaluation::Trajectory& truth) {
  const auto sessions = must(reader.sessions());
  const std::int64_t own = sessions.empty() ? 0 : sessions.back().first_frame;
  const bool joint = settings.sessions == config::SessionScope::Joint;
  truth = since(joint ? 0 : own, must(reader.truth()));
  markSessions(sessions, truth);
  RunData data;
  data.name = nameOf(reader);
  data.odometry = since(own, must(reader.odometry()));
  data.map = since(joint ? 0 : own, must(reader.map()));
  markSessions(sessions, data.map);
  data.graph = must(reader.graph());
  takeOffBody(data, truth, settings);
  return data;
}

}  // namespace

Result<LoopRecord> readLoops(const record::RunReader& reader,
                             const config::EvaluationSettings& settings) {
  return resultOf([&] {
    evaluation::Trajectory truth;
    (void)trajectoriesOf(reader, settings, truth);
    return readLoops(reader, truth, settings.loop_height);
  });
}

Result<RunData> readRun(const record::RunReader& reader, const config::EvaluationSettings& settings,
                        std::uint64_t seed) {
  return resultOf([&] {
    evaluation::Trajectory truth;
    RunData data = trajectoriesOf(reader, settings, truth);
    data.record = readLoops(reader, truth, settings.loop_height);
    data.loops = storiesOf(data.record);
    measure(reader, truth, settings, data);
    data.odometry_error = errorsOf(data.odometry, data.metrics.odometry);
    data.map_error = errorsOf(data.map, data.metrics.map);
    alignTruth(data, truth);
    data.cells = cellsOf(reader);
    data.metrics.cells =
        evaluation::scoreCells(data.cells, data.map, data.truth, scoresForCells(data, truth), seed);
    return data;
  });
}

}  // namespace tolman::report
