// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_answers.hpp"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace tolman::recorded_answers {

namespace {

/// run.json there; no object where it is missing or damaged.
nlohmann::json runFile(const std::string& run) {
  std::ifstream stream(std::filesystem::path(run) / "run.json");
  return nlohmann::json::parse(stream, nullptr, false);
}

std::string partOf(const std::string& status, std::int64_t promised, std::int64_t recorded) {
  const bool interrupted = status == "interrupted";
  if (recorded >= promised || (!interrupted && status != "failed")) return "";
  return "has " + std::to_string(recorded) + " of the " + std::to_string(promised) +
         " frames of its source, because its run " +
         (interrupted ? "was interrupted; `tolman run --resume` goes on with it"
                      : "failed; run it again for all of them");
}

/// The recorded frames must be 0, 1, 2 ...
std::int64_t framesOf(const record::Database& database) {
  record::Statement row(database, "SELECT count(*), coalesce(max(\"frame\"), -1) FROM \"frame\"");
  row.step();
  const std::int64_t count = row.next().getInt64();
  record::Statement sessions(database, "SELECT count(*) FROM \"session\"");
  sessions.step();
  if (row.next().getInt64() == count - 1 && sessions.next().getInt64() <= 1) return count;
  throw std::domain_error("a run that dropped frames or continued a map has no replay");
}

}  // namespace

RecordedAnswers::Tables::Tables(const std::string& file)
    : database(record::openDatabase(file, record::Access::ReadOnly)),
      frames(database, "WHERE \"frame\" = ?"),
      motions(database, "WHERE \"frame\" = ?"),
      places(database, "WHERE \"frame\" = ?"),
      exact(database, "WHERE \"frame\" = ? AND \"of\" = ?"),
      points(database,
             "SELECT \"points\" FROM \"motion\" WHERE \"frame\" <= ? AND length(\"points\") > 0 "
             "ORDER BY \"frame\" DESC LIMIT 1") {}

Status RecordedAnswers::damaged(const std::string& what) const {
  return Status::invalidInput(file_ + ": " + what);
}

Status RecordedAnswers::open(const std::string& run) {
  file_ = (std::filesystem::path(run) / "run.sqlite").string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file_, ignored)) {
    return damaged("is not there; give the directory of a run with `record.replay: true`");
  }
  return record::guarded(file_, [&] { readRun(run); });
}

void RecordedAnswers::readRun(const std::string& run) {
  const nlohmann::json json = runFile(run);
  const std::string status = json.is_object() ? json.value("status", "") : "";
  if (status == "running") {
    throw std::domain_error("the run has not ended: `tolman run --resume` goes on with it");
  }
  {
    const record::Database database = record::openDatabase(file_, record::Access::ReadOnly);
    if (!database.tableExists(record::ExactPoses::kRecord)) {
      throw std::domain_error("has no exact poses; record the run with `record.replay: true`");
    }
    if (record::entryOf(database, "schema_version") != std::to_string(record::kSchemaVersion)) {
      throw std::domain_error("was written by a version with other records; record the run again");
    }
  }
  const Tables& tables = tables_.emplace(file_);
  source_ = {};
  sensors_.clear();
  record::forEachRow<CameraRig>(tables.database, "",
                                [&](const CameraRig& rig) { source_.rig = rig; });
  record::forEachRow<record::RecordedSession>(
      tables.database, "",
      [&](const record::RecordedSession& session) { source_.description = session.source; });
  const std::string sensors = record::entryOf(tables.database, record::kSensorsKey);
  record::forEachRow<record::RecordedArrayInfo>(
      tables.database, "WHERE rowid <= " + sensors,
      [&](const record::RecordedArrayInfo& row) { sensors_.push_back(record::fromRow(row)); });
  source_.frames = framesOf(tables.database);
  const auto source = json.is_object() ? json.find("source") : json.end();
  if (source == json.end() || !source->is_object()) return;
  source_.has_truth = source->value("has_truth", false);
  part_ = partOf(status, source->value("frames", std::int64_t{-1}), source_.frames);
}

template <Record R>
Status RecordedAnswers::readRow(record::RowsOf<R> Tables::*rows, std::int64_t frame, R& answer) {
  if (frame == frames() && !part_.empty()) return damaged(part_);
  if (!tables_ || frame < 0 || frame >= frames()) {
    return damaged("has no frame " + std::to_string(frame) + "; take source, odometry and place " +
                   "of one record, in a run that continues no map");
  }
  return record::guarded(file_, [&] {
    bool found = false;
    ((*tables_).*rows).each([&](R&& row) { answer = std::move(row), found = true; }, frame);
    tables_->exact.each([&](const record::ExactPoses& row) { record::restorePoses(row, answer); },
                        frame, std::string(R::kRecord));
    if (!found)
      throw std::domain_error("has no " + std::string(R::kRecord) + " of frame " +
                              std::to_string(frame));
  });
}

Status RecordedAnswers::read(std::int64_t frame, Frame& answer) {
  return readRow(&Tables::frames, frame, answer);
}

/// Checks that the recorded answers are of this drive. Frame number and time are not enough: they
/// are often equal in different drives.
Status RecordedAnswers::isOfRun(const Frame& frame) {
  Frame then;
  if (Status status = read(frame.frame, then); !status.isOk()) return status;
  const bool has_truth = then.has_truth && frame.has_truth;
  if (then.stamp_ns == frame.stamp_ns && then.source_index == frame.source_index &&
      (!has_truth || then.T_world_camera_truth.matrix() == frame.T_world_camera_truth.matrix())) {
    return Status::ok();
  }
  return damaged("frame " + std::to_string(frame.frame) +
                 " has another time, place in the data set or true pose than in this run; take " +
                 "source, odometry and place of one record");
}

void RecordedAnswers::restorePoints(Motion& motion) {
  if (motion.points.cols() == 0 && motion.points_frame >= 0) {
    if (motion.points_frame != points_frame_) {
      points_.resize(Eigen::NoChange, 0);
      tables_->points.bindNext(motion.frame);
      while (tables_->points.step()) {
        record::Codec<decltype(points_)>::read(tables_->points, points_);
      }
    }
    motion.points = points_;
  }
  points_frame_ = motion.points_frame;
  points_ = motion.points;
}

Status RecordedAnswers::read(const Frame& frame, Motion& answer) {
  Status status = isOfRun(frame);
  if (status.isOk()) status = readRow(&Tables::motions, frame.frame, answer);
  if (!status.isOk()) return status;
  return record::guarded(file_, [&] { restorePoints(answer); });
}

Status RecordedAnswers::read(const Frame& frame, PlaceObservation& answer) {
  const Status status = isOfRun(frame);
  return status.isOk() ? readRow(&Tables::places, frame.frame, answer) : status;
}

Status RecordedAnswers::read(std::vector<MotionRevision>& revisions) {
  return record::guarded(file_, [&] {
    Motion after_the_last;
    record::forEachRow<MotionRevision>(
        tables_->database, "WHERE \"announced_at\" IS NULL",
        [&](const MotionRevision& row) { after_the_last.revisions.push_back(row); });
    tables_->exact.each(
        [&](const record::ExactPoses& row) { record::restorePoses(row, after_the_last); }, frames(),
        std::string(Motion::kRecord));
    revisions = std::move(after_the_last.revisions);
  });
}

}  // namespace tolman::recorded_answers
