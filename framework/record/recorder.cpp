// SPDX-License-Identifier: BSD-3-Clause
#include "record/recorder.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <chrono>

#include "base/codec.hpp"

namespace tolman::record {
namespace {

constexpr std::chrono::milliseconds kCommitPeriod(500);
constexpr int kMergePatience = 10000;  // ms
// Merging the log less often than by default, and a cache for the newest pages of each table, save
// a third of the time of a long run.
constexpr const char* kJournal =
    "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 8000; "
    "PRAGMA cache_size = -32768";

/// Upserts the records that differ from those written before. `now(i)` is record i of `size`.
template <class Now>
void upsertChanged(StoreWriter& store, std::vector<std::uint64_t>& written, std::size_t size,
                   const Now& now) {
  const std::size_t known = std::min(written.size(), size);
  written.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto& record = now(i);
    const std::uint64_t hash = bitHash(record);
    if (i < known && written[i] == hash) continue;
    store.upsert(record);
    written[i] = hash;
  }
}

/// SQL condition for the rows that a run writes again if it resumes at frame `next`; empty: none.
/// `first` is the first frame of its session.
std::string rowsFrom(const Table& table, const std::string& next, const std::string& first) {
  const auto has = [&](const char* name) {
    return std::ranges::find(table.columns, name, &Column::name) != table.columns.end();
  };
  for (const char* whole : {CameraRig::kRecord, RecordedArrayInfo::kRecord, FinalPose::kRecord,
                            Experience::kRecord, RecordedLink::kRecord, LinkResidual::kRecord}) {
    if (table.name == whole) return "TRUE";
  }
  if (has("announced_at")) {
    return "\"announced_at\" >= " + next +
           " OR (\"announced_at\" IS NULL AND \"frame\" >= " + first + ")";
  }
  const std::string before_frames =  // configure() finds them again
      table.name == RecordedFinding::kRecord ? " OR \"frame\" < 0" : "";
  return has("frame") ? "\"frame\" >= " + next + before_frames : "";
}

void createTables(Database& database, bool exact) {
  for (const Table& table : schema()) {
    const bool wanted = (table.name == ExactPoses::kRecord) == exact;
    if (wanted && !database.tableExists(table.name)) database.exec(createSql(table));
  }
}

Database createDatabase(const std::filesystem::path& file) {
  Database database = openDatabase(file, Access::Create);
  database.exec(kJournal);
  database.exec("BEGIN");
  createTables(database, false);
  for (const SqlView& view : views()) database.exec(createSql(view));
  database.exec(
      "CREATE INDEX \"motion_revision_announced\" ON \"motion_revision\" (\"announced_at\");"
      "CREATE INDEX \"candidate_frame\" ON \"candidate\" (\"frame\");"
      "CREATE INDEX \"hypothesis_frame\" ON \"hypothesis\" (\"frame\");"
      "CREATE INDEX \"array_frame\" ON \"array\" (\"frame\");"
      "CREATE INDEX \"earlier_loop_announced\" ON \"earlier_loop\" (\"announced_at\");"
      "INSERT INTO \"run\" VALUES ('schema_version', '" +
      std::to_string(kSchemaVersion) + "')");
  database.exec("COMMIT");
  return database;
}

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::open(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "run.sqlite";
  if (std::filesystem::exists(file)) {
    return Status::failed(file.string() + ": exists; record into a fresh directory");
  }
  return answered(file.string(), [&] {
    return std::unique_ptr<Recorder>(new Recorder(file, createDatabase(file)));
  });
}

Result<std::unique_ptr<Recorder>> Recorder::reopen(const std::filesystem::path& directory,
                                                   std::int64_t next_frame) {
  const std::filesystem::path file = directory / "run.sqlite";
  return answered(file.string(), [&] {
    Database database = openDatabase(file, Access::Write);
    database.exec(kJournal);
    createTables(database, false);  // those that an older record has not
    std::unique_ptr<Recorder> recorder(new Recorder(file, std::move(database)));
    recorder->removeFrom(next_frame);
    return recorder;
  });
}

Recorder::Recorder(const std::filesystem::path& file, Database database)
    : name_(file.string()),
      database_(std::move(database)),
      store_(database_),
      meta_(database_,
            "INSERT INTO \"run\" (\"key\", \"value\") VALUES (?, ?)"
            " ON CONFLICT (\"key\") DO UPDATE SET \"value\" = excluded.\"value\""),
      remove_arrays_(database_,
                     "DELETE FROM \"array\" WHERE \"frame\" = ? AND \"source\" = 'cells'"),
      exact_(database_.tableExists(ExactPoses::kRecord)),
      committer_([this](const std::stop_token& stop) { commitRegularly(stop); }) {}

Recorder::~Recorder() { (void)close(); }

template <class Work>
Status Recorder::write(Work&& work) {
  const std::lock_guard lock(mutex_);
  if (!failure_.isOk()) return failure_;
  if (closed_) return Status::failed(name_ + ": is closed");
  failure_ = guarded(name_, [&] {
    if (!in_transaction_) database_.exec("BEGIN");
    in_transaction_ = true;
    work();
  });
  return failure_;
}

Status Recorder::recordForReplay(std::size_t sensors) {
  return write([&] {
    createTables(database_, true);
    setMeta(kSensorsKey, std::to_string(sensors));
    exact_ = true;
  });
}

Status Recorder::inherit(const RunReader& earlier, std::int64_t frames, bool arrays) {
  return write([&] {
    const Database& old = earlier.database();
    const auto insert = [&](const auto& row) { store_.insert(row); };
    const std::string before = "WHERE \"frame\" < " + std::to_string(frames);
    forEachRow<RecordedSession>(old, "", insert);
    forEachRow<Frame>(old, before, insert);
    forEachRow<Motion>(old, before, insert);
    forEachRow<MotionRevision>(
        old, before + " AND \"announced_at\" IS NULL",
        [&](const MotionRevision& row) { store_.insertAnnounced(std::nullopt, row); });
    forEachRow<PlaceObservation>(old, before, insert);
    forEachRow<Decision>(old, before, insert);
    if (arrays) forEachRow<RecordedArray>(old, before + " AND \"source\" = 'cells'", insert);
    forEachRow<MapUpdate>(old, before, insert);
  });
}

std::int64_t Recorder::largest(const std::string& column, const std::string& table) {
  Statement row(database_, "SELECT coalesce(max(\"" + column + "\"), -1) FROM \"" + table + "\"");
  row.step();
  return row.next().getInt64();
}

void Recorder::removeFrom(std::int64_t next_frame) {
  const std::lock_guard lock(mutex_);
  const std::string next = std::to_string(next_frame);
  const std::string first = std::to_string(largest("first_frame", "session"));
  database_.exec("BEGIN");
  const std::vector<Table> tables = schema();
  // Deletes rows before the rows they refer to. (clang 14 cannot compile views::reverse of this
  // library.)
  for (auto table = tables.rbegin(); table != tables.rend(); ++table) {
    if (table->name == ExactPoses::kRecord && !exact_) continue;
    const std::string rows = rowsFrom(*table, next, first);
    if (!rows.empty()) database_.exec("DELETE FROM \"" + table->name + "\" WHERE " + rows);
  }
  database_.exec("COMMIT");
  points_frame_ = largest("points_frame", "motion");
}

Status Recorder::session(const RecordedSession& session) {
  return write([&] { store_.insert(session); });
}

Status Recorder::finalPoses(const std::vector<FinalPose>& poses) {
  return write([&] {
    for (const FinalPose& pose : poses) store_.insert(pose);
  });
}

Status Recorder::begin(const RunInfo& run) {
  return write([&] {
    store_.insert(run.source.rig);
    for (const ArrayInfo& info : run.arrays) store_.insert(toRow(info));
  });
}

Status Recorder::snapshot(const Snapshot& snapshot) {
  if (snapshot.frame == nullptr) return Status::failed(name_ + ": a snapshot without a frame");
  return write([&] {
    const std::int64_t frame = snapshot.frame->frame;
    const auto insert = [&](const auto* answer) {
      if (answer != nullptr) store_.insert(*answer);
    };
    const auto insertExact = [&](const auto* answer) {
      if (exact_ && answer != nullptr) store_.insert(exactPosesOf(frame, *answer));
    };
    insert(snapshot.frame);
    if (snapshot.motion != nullptr) writeMotion(*snapshot.motion);
    insert(snapshot.place);
    insertExact(snapshot.frame);
    insertExact(snapshot.motion);
    insertExact(snapshot.place);
    insert(snapshot.decision);
    if (snapshot.graph != nullptr) writeGraph(*snapshot.graph);
    insert(snapshot.map);
    if (snapshot.cells != nullptr) writeArrays(frame, *snapshot.cells);
    for (std::size_t role = 0; role < snapshot.stage_times_ns.size(); ++role) {
      const std::int64_t ns = snapshot.stage_times_ns[role];
      if (ns > 0) store_.insert(RecordedTiming{frame, std::string(kRoleNames[role]), ns});
    }
  });
}

void Recorder::writeMotion(const Motion& motion) {
  if (motion.points_frame != points_frame_ || motion.points.cols() == 0) {
    store_.insert(motion);
    points_frame_ = motion.points.cols() > 0 ? motion.points_frame : points_frame_;
    return;
  }
  Motion without_points = motion;
  without_points.points.resize(Eigen::NoChange, 0);
  store_.insert(without_points);
}

/// When the step has doubled at frame `begin`, the frames before it have twice as many arrays as
/// they should. Each further frame removes those of one of them, so that none takes long.
void Recorder::writeArrays(std::int64_t frame, const std::vector<NamedArray>& arrays) {
  const bool automatic = arrays_every_ == kAutomatic;
  const std::int64_t step = automatic ? arrayStep(frame) : arrays_every_;
  if (step == 0 || frame % step != 0) return;
  store_.insertArrays(frame, "cells", arrays);
  if (!automatic || step == 1) return;
  const std::int64_t begin = kMostArrayFrames * step / 2;
  remove_arrays_.bindNext(frame - begin + step / 2);
  remove_arrays_.run();
}

/// Those that writeArrays() has not yet removed.
void Recorder::removeArraysBetween() {
  if (arrays_every_ != kAutomatic) return;
  const std::int64_t step = arrayStep(largest("frame", "frame"));
  if (step == 1) return;
  database_.exec("DELETE FROM \"array\" WHERE \"source\" = 'cells' AND \"frame\" % " +
                 std::to_string(step) + " <> 0");
}

void Recorder::writeGraph(const MapGraph& graph) {
  const std::size_t links = graph.links.size();
  if (links < written_links_.size()) {  // a map may remove links
    database_.exec("DELETE FROM \"link\" WHERE \"id\" >= " + std::to_string(links));
  }
  upsertChanged(store_, written_experiences_, graph.experiences.size(),
                [&](std::size_t i) -> const Experience& { return graph.experiences[i]; });
  upsertChanged(store_, written_links_, links, [&](std::size_t i) {
    return RecordedLink{graph.links[i], graph.isRejected(graph.links[i])};
  });
}

Status Recorder::revisions(const std::vector<MotionRevision>& revisions) {
  return write([&] {
    for (const MotionRevision& revision : revisions) {
      store_.insertAnnounced(std::nullopt, revision);
    }
    if (!exact_) return;
    Motion after_the_last;
    after_the_last.revisions = revisions;
    store_.insert(exactPosesOf(largest("frame", "frame") + 1, after_the_last));
  });
}

Status Recorder::graph(const MapGraph& graph) {
  return write([&] {
    writeGraph(graph);
    for (std::size_t i = 0; i < graph.residuals.size(); ++i) {
      store_.upsert(LinkResidual{static_cast<std::int64_t>(i), graph.residuals[i]});
    }
  });
}

Status Recorder::timing(std::int64_t frame, std::string_view stage, std::int64_t duration_ns) {
  return write([&] { store_.insert(RecordedTiming{frame, std::string(stage), duration_ns}); });
}

Status Recorder::event(std::int64_t frame, LogLevel level, std::string_view source,
                       std::string_view message) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return write([&] {
    store_.insert(RecordedEvent{{frame, level, std::string(source), std::string(message)},
                                std::chrono::nanoseconds(now).count()});
  });
}

Status Recorder::findings(const std::vector<RecordedFinding>& findings) {
  return write([&] {
    for (const RecordedFinding& finding : findings) store_.insert(finding);
  });
}

void Recorder::setMeta(const std::string& key, const std::string& value) {
  meta_.bindNext(key);
  meta_.bindNext(value);
  meta_.run();
}

Status Recorder::meta(std::string_view key, std::string_view value) {
  return write([&] { setMeta(std::string(key), std::string(value)); });
}

/// The caller must hold the mutex.
void Recorder::commitNow() {
  if (!in_transaction_ || !failure_.isOk()) return;
  failure_ = guarded(name_, [&] { database_.exec("COMMIT"); });
  in_transaction_ = false;
}

Status Recorder::commit() {
  const std::lock_guard lock(mutex_);
  commitNow();
  return failure_;
}

Status Recorder::sync() {
  const std::lock_guard lock(mutex_);
  commitNow();
  if (failure_.isOk()) {  // a checkpoint of the log writes it to the disk first
    failure_ = guarded(name_, [&] { database_.exec("PRAGMA wal_checkpoint(PASSIVE)"); });
  }
  return failure_;
}

void Recorder::commitRegularly(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wake_.wait_for(lock, stop, kCommitPeriod, [] { return false; });
    commitNow();
  }
}

/// Merges the log into the file, which can then be opened on read-only media. While a reader is
/// connected, the log remains, but is empty unless the reader is in the middle of a transaction for
/// longer than kMergePatience.
void Recorder::mergeLog() {
  try {
    database_.exec("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE");
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode();
    if (code != SQLITE_BUSY && code != SQLITE_LOCKED) throw;
    database_.setBusyTimeout(kMergePatience);
    Statement(database_, "PRAGMA wal_checkpoint(TRUNCATE)").step();
  }
}

Status Recorder::close() {
  committer_.request_stop();
  if (committer_.joinable()) committer_.join();
  const std::lock_guard lock(mutex_);
  if (closed_) return failure_;
  closed_ = true;
  commitNow();
  if (failure_.isOk()) {
    failure_ = guarded(name_, [&] {
      removeArraysBetween();
      mergeLog();
    });
  }
  return failure_;
}

}  // namespace tolman::record
