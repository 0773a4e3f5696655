// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_reader.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/named_value.hpp"
#include "config/values.hpp"
#include "record/digest.hpp"
#include "record/run_directory.hpp"

namespace tolman::record {

namespace {

/// std::domain_error where ids are not 0, 1, 2, ... without gaps.
template <Record R>
std::vector<R> rowsById(const Database& database) {
  std::vector<R> rows;
  forEachRow<R>(database, "", [&](const R& row) {
    if (row.id != static_cast<std::int64_t>(rows.size())) {
      throw std::domain_error(std::string(R::kRecord) + " " + std::to_string(rows.size()) +
                              " is missing");
    }
    rows.push_back(row);
  });
  return rows;
}

using Revisions = std::unordered_map<std::int64_t, Eigen::Isometry3d>;

Revisions lastRevisions(const Database& database) {
  Revisions revisions;
  forEachRow<MotionRevision>(database, "", [&](const MotionRevision& revision) {
    revisions[revision.frame] = revision.T_previous_current;
  });
  return revisions;
}

/// Frames whose odometry was lost or initialising. The last frame before the first tracked one of a
/// session, whatever its state, is the session's origin and counts as tracked: the first tracked
/// motion begins there. Before later ones the pose is unknown.
std::set<std::int64_t> untrackedFrames(const Database& database) {
  std::set<std::int64_t> beginnings;
  forEachRow<RecordedSession>(
      database, "", [&](const RecordedSession& row) { beginnings.insert(row.first_frame); });
  std::set<std::int64_t> frames;
  std::int64_t origin = -1;
  bool has_tracked = false;
  Statement rows(database, "SELECT \"frame\", \"state\" FROM \"motion\" ORDER BY \"frame\"");
  while (rows.step()) {
    const std::int64_t frame = rows.next().getInt64();
    const std::string state = rows.next().getString();
    if (beginnings.contains(frame)) {
      has_tracked = false;
      origin = -1;
    }
    if (state == enumName(TrackingState::Tracking)) {
      frames.erase(std::exchange(origin, -1));
      has_tracked = true;
    } else {
      frames.insert(frame);
      origin = has_tracked ? -1 : frame;
    }
  }
  return frames;
}

/// The single number that a query returns.
std::int64_t integerOf(const Database& database, const std::string& query) {
  Statement row(database, query);
  row.step();
  return row.next().getInt64();
}

std::int64_t count(const Database& database, const std::string& table_and_condition) {
  return integerOf(database, "SELECT count(*) FROM " + table_and_condition);
}

}  // namespace

Result<std::unique_ptr<RunReader>> RunReader::open(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "run.sqlite";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return Status::invalidInput(
        directory.string() + ": " +
        config::absence(file,
                        "is no run directory, it holds no run.sqlite; give the folder that a run "
                        "has written"));
  }
  if (Status status = verify(directory); !status.isOk()) return status;
  std::unique_ptr<RunReader> reader;
  const Status status =
      guarded(file.string(), [&] { reader.reset(new RunReader(directory, file)); });
  if (!status.isOk()) return Status::invalidInput(status.message());
  return reader;
}

bool canBeReplayed(const std::filesystem::path& directory) {
  if (!RunDirectory::hasEnded(directory)) return false;
  const auto reader = RunReader::open(directory);
  return reader.isOk() && reader.value()->database().tableExists(ExactPoses::kRecord);
}

RunReader::RunReader(std::filesystem::path directory, const std::filesystem::path& file)
    : directory_(std::move(directory)),
      name_(file.string()),
      database_(openDatabase(file, Access::ReadOnly)) {
  database_.exec("BEGIN");  // all reads see one state
  if (!database_.tableExists("run"))
    throw std::domain_error("is no run database; it has no table `run`");
  const std::string version = entryOf(database_, "schema_version");
  if (version == std::to_string(kSchemaVersion)) return;
  throw std::domain_error("has schema version " + (version.empty() ? "none" : version) +
                          ", this program reads " + std::to_string(kSchemaVersion) +
                          "; run again to record it anew");
}

Result<std::vector<ArrayInfo>> RunReader::arrayInfos() const {
  return answered(name_, [&] {
    std::vector<ArrayInfo> infos;
    forEachRow<RecordedArrayInfo>(
        database_, "", [&](const RecordedArrayInfo& row) { infos.push_back(fromRow(row)); });
    return infos;
  });
}

Result<std::map<std::string, std::string>> RunReader::meta() const {
  return answered(name_, [&] {
    std::map<std::string, std::string> facts;
    Statement rows(database_, "SELECT \"key\", \"value\" FROM \"run\"");
    while (rows.step()) {
      const std::string key = rows.next().getString();
      facts[key] = rows.next().getString();
    }
    return facts;
  });
}

Result<std::map<std::string, std::vector<std::int64_t>>> RunReader::timing() const {
  return answered(name_, [&] {
    std::map<std::string, std::vector<std::int64_t>> durations;
    forEachRow<RecordedTiming>(database_, "", [&](const RecordedTiming& row) {
      durations[row.stage].push_back(row.duration_ns);
    });
    return durations;
  });
}

const Result<evaluation::Trajectory>& RunReader::odometry() const {
  return once(odometry_, [&] {
    evaluation::Trajectory poses;
    std::set<std::int64_t> beginnings;
    forEachRow<RecordedSession>(
        database_, "", [&](const RecordedSession& row) { beginnings.insert(row.first_frame); });
    const Revisions revisions = lastRevisions(database_);
    const std::set<std::int64_t> untracked = untrackedFrames(database_);
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
    forEachRow<Motion>(database_, "", [&](const Motion& motion) {
      const auto revised = revisions.find(motion.frame);
      const Eigen::Isometry3d& T_previous_current =
          revised != revisions.end() ? revised->second : motion.T_previous_current;
      if (beginnings.contains(motion.frame)) {
        T_world_camera.setIdentity();
      } else if (!poses.empty()) {
        T_world_camera = normalised(T_world_camera * T_previous_current);
      }
      poses.push_back(
          {motion.frame, motion.stamp_ns, T_world_camera, !untracked.contains(motion.frame)});
    });
    return poses;
  });
}

const Result<evaluation::Trajectory>& RunReader::map() const {
  return once(map_, [&] {
    evaluation::Trajectory poses;
    const auto experiences = rowsById<Experience>(database_);
    const auto known = static_cast<std::int64_t>(experiences.size());
    std::unordered_map<std::int64_t, Eigen::Isometry3d> settled;
    const std::set<std::int64_t> untracked = untrackedFrames(database_);
    const bool localised = !entryOf(database_, kLocalisedKey).empty();
    forEachRow<FinalPose>(database_, "",
                          [&](const FinalPose& row) { settled[row.frame] = row.T_world_camera; });
    forEachRow<MapUpdate>(database_, "", [&](const MapUpdate& update) {
      Eigen::Isometry3d T_world_camera = update.T_world_camera;
      if (const auto final_pose = settled.find(update.frame); final_pose != settled.end()) {
        T_world_camera = final_pose->second;
      } else if (update.experience >= 0 && update.experience < known) {
        const auto& experience = experiences[static_cast<std::size_t>(update.experience)];
        T_world_camera = experience.T_world_experience * update.T_experience_camera;
      } else if (localised) {
        return;  // the place is unknown
      }
      poses.push_back(
          {update.frame, update.stamp_ns, T_world_camera, !untracked.contains(update.frame)});
    });
    return poses;
  });
}

Result<std::vector<RecordedSession>> RunReader::sessions() const {
  return records<RecordedSession>();
}

Result<std::int64_t> RunReader::nextFrame() const {
  return answered(name_, [&] {
    return integerOf(database_, "SELECT coalesce(max(\"frame\"), -1) FROM \"frame\"") + 1;
  });
}

Result<std::int64_t> RunReader::lastGivenFrame() const {
  return answered(name_, [&] {  // realtime reports a dropped frame by an event
    return integerOf(
        database_,
        "SELECT max(coalesce((SELECT max(\"frame\") FROM \"frame\"), -1), coalesce((SELECT "
        "max(\"frame\") FROM \"event\" WHERE \"source\" = 'pipeline' AND \"message\" LIKE "
        "'frame dropped%'), -1))");
  });
}

Result<std::string> RunReader::localisedIn() const {
  return answered(name_, [&] { return entryOf(database_, kLocalisedKey); });
}

Result<std::int64_t> RunReader::newestExperience() const {
  return answered(name_, [&] {
    return integerOf(database_,
                     "SELECT coalesce((SELECT \"experience\" FROM \"map_update\" ORDER BY "
                     "\"frame\" DESC LIMIT 1), -1)");
  });
}

Result<evaluation::Trajectory> RunReader::truth() const {
  return answered(name_, [&] {
    evaluation::Trajectory poses;
    forEachRow<Frame>(database_, "WHERE \"has_truth\" <> 0", [&](const Frame& frame) {
      poses.push_back({frame.frame, frame.stamp_ns, frame.T_world_camera_truth});
    });
    return poses;
  });
}

const Result<MapGraph>& RunReader::graph() const {
  return once(graph_, [&] {
    MapGraph graph;
    graph.experiences = rowsById<Experience>(database_);
    const auto count = static_cast<std::int64_t>(graph.experiences.size());
    for (const RecordedLink& link : rowsById<RecordedLink>(database_)) {
      if (std::min(link.from, link.to) < 0 || std::max(link.from, link.to) >= count) {
        throw std::domain_error("link " + std::to_string(link.id) + " ends at no experience");
      }
      if (!(link.duration >= 0)) {
        throw std::domain_error("link " + std::to_string(link.id) + " has a duration below 0");
      }
      graph.links.push_back(link);
      if (link.rejected) graph.rejected.push_back(link.id);
    }
    if (database_.tableExists(LinkResidual::kRecord)) {  // not in older records
      for (const LinkResidual& row : rowsById<LinkResidual>(database_)) {
        graph.residuals.push_back(row.sigmas);
      }
    }
    graph.version =
        integerOf(database_, "SELECT coalesce(max(\"version\"), 0) FROM \"map_update\"");
    return graph;
  });
}

Result<bool> RunReader::scaleKnown() const {
  return answered(name_, [&] {
    Statement last(database_, "SELECT \"scale_known\" FROM \"motion\" ORDER BY rowid DESC LIMIT 1");
    return !last.step() || last.next().getInt64() != 0;
  });
}

Result<std::optional<TrackedScale>> RunReader::lastScale(std::int64_t end) const {
  return answered(name_, [&]() -> std::optional<TrackedScale> {
    Statement last(database_,
                   "SELECT \"frame\", \"scale_known\" FROM \"motion\" WHERE \"frame\" < ? AND "
                   "\"state\" = 'tracking' ORDER BY \"frame\" DESC LIMIT 1");
    last.bindNext(end);
    if (!last.step()) return std::nullopt;
    const std::int64_t frame = last.next().getInt64();
    return TrackedScale{frame, last.next().getInt64() != 0};
  });
}

Result<bool> RunReader::mixesScales(std::int64_t first) const {
  return answered(name_, [&] {
    return integerOf(database_,
                     "SELECT count(DISTINCT \"scale_known\" <> 0) FROM \"motion\" WHERE "
                     "\"state\" = 'tracking' AND \"frame\" >= " +
                         std::to_string(first)) > 1;
  });
}

Result<RunTotals> RunReader::totals() const {
  return answered(name_, [&] {
    return RunTotals{count(database_, "\"frame\""),
                     count(database_, "\"place\" WHERE \"recognition\" = 'novel'"),
                     count(database_, "\"decision\" WHERE \"action\" = 'close_loop'")};
  });
}

namespace {

constexpr const char* kOfFrame = "WHERE \"frame\" = ?";

/// The last frame to read; of an unfinished run the one before the newest.
std::int64_t lastShown(const Database& database, bool unfinished) {
  const char* newest =
      unfinished ? " WHERE \"frame\" < (SELECT max(\"frame\") FROM \"frame\")" : "";
  Statement row(database,
                std::string("SELECT coalesce(max(\"frame\"), -1) FROM \"frame\"") + newest);
  row.step();
  return row.next().getInt64();
}

template <class T>
const T* pointerTo(const std::optional<T>& value) {
  return value ? &*value : nullptr;
}

}  // namespace

Snapshot RecordedFrame::snapshot() const {
  Snapshot snapshot;
  snapshot.frame = &frame;
  snapshot.motion = pointerTo(motion);
  snapshot.place = pointerTo(place);
  snapshot.decision = pointerTo(decision);
  snapshot.map = pointerTo(map);
  snapshot.cells = cells.empty() ? nullptr : &cells;
  snapshot.stage_times_ns = stage_times_ns;
  snapshot.events = &events;
  return snapshot;
}

Result<std::unique_ptr<Replay>> Replay::open(const RunReader& reader, ReplayPosition position,
                                             bool unfinished) {
  std::unique_ptr<Replay> replay;
  const Status status = guarded((reader.directory() / "run.sqlite").string(), [&] {
    replay.reset(new Replay(reader, std::move(position), unfinished));
  });
  if (!status.isOk()) return status;
  return replay;
}

Replay::Replay(const RunReader& reader, ReplayPosition position, bool unfinished)
    : name_((reader.directory() / "run.sqlite").string()),
      position_(std::move(position)),
      unfinished_(unfinished),
      end_(lastShown(reader.database(), unfinished)),
      frames_(reader.database(),
              "WHERE \"frame\" = (SELECT min(\"frame\") FROM \"frame\" WHERE \"frame\" > ?)"),
      motions_(reader.database(), kOfFrame),
      places_(reader.database(), kOfFrame),
      decisions_(reader.database(), kOfFrame),
      maps_(reader.database(), kOfFrame),
      arrays_(reader.database(), std::string(kOfFrame) + " AND \"source\" = 'cells'") {
  forEachRow<RecordedTiming>(
      reader.database(), "WHERE \"frame\" > " + std::to_string(position_.frame),
      [&](const RecordedTiming& row) {
        const auto role = valueNamed<Role>(row.stage);
        if (role) times_[row.frame][static_cast<std::size_t>(*role)] = row.duration_ns;
      });
  forEachRow<RecordedEvent>(reader.database(), "WHERE rowid > " + std::to_string(position_.events),
                            [&](const RecordedEvent& row) { events_.push_back(row); });
}

Result<bool> Replay::next(RecordedFrame& recorded) {
  if (position_.frame >= end_) return false;
  recorded = RecordedFrame();
  const Status status = guarded(name_, [&] { fill(recorded); });
  if (!status.isOk()) return status;
  return true;
}

/// Events without a frame (-1) belong to the next one, those after the last to the last.
void Replay::fill(RecordedFrame& recorded) {
  const auto take = [](auto& into) { return [&into](auto&& row) { into = std::move(row); }; };
  frames_.each(take(recorded.frame), position_.frame);
  const std::int64_t frame = position_.frame = recorded.frame.frame;
  motions_.each(take(recorded.motion), frame);
  if (recorded.motion) restorePoints(*recorded.motion);
  places_.each(take(recorded.place), frame);
  decisions_.each(take(recorded.decision), frame);
  maps_.each(take(recorded.map), frame);
  arrays_.each([&](const RecordedArray& row) { recorded.cells.push_back(arrayOf(row)); }, frame);
  recorded.stage_times_ns = times_[frame];
  const bool is_last = !unfinished_ && frame == end_;
  for (; next_event_ < events_.size() && (is_last || events_[next_event_].frame <= frame);
       ++next_event_, ++position_.events) {
    recorded.events.push_back(events_[next_event_]);
  }
}

/// Restores the points of a motion: the recorder stores those of a points_frame only once.
void Replay::restorePoints(Motion& motion) {
  if (motion.points.cols() > 0) {
    position_.points_frame = motion.points_frame;
    position_.points = motion.points;
  } else if (motion.points_frame >= 0 && motion.points_frame == position_.points_frame) {
    motion.points = position_.points;
  }
}

}  // namespace tolman::record
