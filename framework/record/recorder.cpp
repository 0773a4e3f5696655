// SPDX-License-Identifier: BSD-3-Clause
#include "record/recorder.hpp"

#include <array>
#include <chrono>

namespace tolman::record {
namespace {

constexpr std::chrono::milliseconds kCommitPeriod(500);
constexpr std::array<std::string_view, 4> kLevelNames = {"debug", "info", "warning", "error"};

template <class T>
bool sameValue(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    return a.matrix() == b.matrix();
  } else {
    return a == b;
  }
}

template <Record R>
bool sameRecord(const R& a, const R& b) {
  std::vector<const void*> others;
  visitFields(b, [&](const Field&, const auto& other) { others.push_back(&other); });
  bool same = true;
  auto next = others.begin();
  visitFields(a, [&](const Field&, const auto& value) {
    same = sameValue(value, *static_cast<decltype(&value)>(*next++)) && same;
  });
  return same;
}

/// Upserts the records that differ from those written before.
template <Record R>
void upsertChanged(StoreWriter& store, std::vector<R>& written, const std::vector<R>& now) {
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (i < written.size() && sameRecord(written[i], now[i])) continue;
    store.upsert(now[i]);
  }
  written = now;
}

Database createDatabase(const std::filesystem::path& file) {
  Database database(file, Database::Mode::Create);
  database.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; BEGIN");
  for (const Table& table : schema()) database.execute(createSql(table));
  database.execute(
      "CREATE INDEX \"motion_revision_announced\" ON \"motion_revision\" (\"announced_at\");"
      "INSERT INTO \"run\" VALUES ('schema_version', '" +
      std::to_string(kSchemaVersion) + "'); COMMIT");
  return database;
}

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::open(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "run.sqlite";
  if (std::filesystem::exists(file)) {
    return Status::failed(file.string() + ": exists; record into a fresh directory");
  }
  std::unique_ptr<Recorder> recorder;
  const Status status = guarded(file.string(), [&] { recorder.reset(new Recorder(file)); });
  if (!status.isOk()) return status;
  return recorder;
}

Recorder::Recorder(const std::filesystem::path& file)
    : name_(file.string()),
      database_(createDatabase(file)),
      store_(database_),
      meta_(database_,
            "INSERT INTO \"run\" (\"key\", \"value\") VALUES (?, ?)"
            " ON CONFLICT (\"key\") DO UPDATE SET \"value\" = excluded.\"value\""),
      committer_([this](const std::stop_token& stop) { commitRegularly(stop); }) {}

Recorder::~Recorder() { (void)close(); }

template <class Work>
Status Recorder::write(Work&& work) {
  const std::lock_guard lock(mutex_);
  if (!failure_.isOk()) return failure_;
  if (closed_) return Status::failed(name_ + ": is closed");
  bool broke_rule = false;
  Status status = guarded(name_, [&] {
    if (!in_transaction_) database_.execute("BEGIN");
    in_transaction_ = true;
    database_.execute("SAVEPOINT one_call");
    try {
      work();
    } catch (const SqliteError& error) {
      broke_rule = error.isConstraint();
      if (broke_rule) rollBackCall();
      throw;
    }
    database_.execute("RELEASE one_call");
  });
  if (!status.isOk() && !broke_rule) failure_ = status;
  return status;
}

/// Forgets what the call has noted as written, so that it is written again.
void Recorder::rollBackCall() {
  database_.execute("ROLLBACK TO one_call; RELEASE one_call");
  written_ = {};
  points_frame_ = -1;
}

Status Recorder::inherit(const RunReader& earlier) {
  return write([&] {
    const Database& old = earlier.database();
    forEachRow<Session>(old, "", [&](const Session& row) { store_.insert(row); });
    forEachRow<Frame>(old, "", [&](const Frame& row) { store_.insert(row); });
    forEachRow<Motion>(old, "", [&](const Motion& row) { store_.insert(row); });
    forEachRow<MotionRevision>(old, "WHERE \"announced_at\" IS NULL",
                               [&](const auto& row) { store_.insertAnnounced(std::nullopt, row); });
    forEachRow<PlaceObservation>(old, "", [&](const auto& row) { store_.insert(row); });
    forEachRow<Decision>(old, "", [&](const Decision& row) {
      store_.insert(row);
      store_.insertArrays(row.frame, "cells", readArrays(old, row.frame, "cells"));
    });
    forEachRow<MapUpdate>(old, "", [&](const MapUpdate& row) { store_.insert(row); });
  });
}

Status Recorder::session(const Session& session) {
  return write([&] { store_.insert(session); });
}

Status Recorder::finalPoses(const std::vector<FinalPose>& poses) {
  return write([&] {
    for (const FinalPose& pose : poses) store_.insert(pose);
  });
}

Status Recorder::camera(const CameraRig& rig) {
  return write([&] { store_.insert(rig); });
}

Status Recorder::snapshot(const Snapshot& snapshot) {
  if (snapshot.frame == nullptr) return Status::failed(name_ + ": a snapshot without a frame");
  return write([&] {
    store_.insert(*snapshot.frame);
    if (snapshot.motion != nullptr) writeMotion(*snapshot.motion);
    if (snapshot.place != nullptr) store_.insert(*snapshot.place);
    if (snapshot.decision != nullptr) store_.insert(*snapshot.decision);
    if (snapshot.graph != nullptr) writeGraph(*snapshot.graph);
    if (snapshot.map != nullptr) store_.insert(*snapshot.map);
    if (snapshot.cells != nullptr) {
      store_.insertArrays(snapshot.frame->frame, "cells", *snapshot.cells);
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

void Recorder::writeGraph(const MapGraph& graph) {
  if (graph.links.size() < written_.links.size()) {  // a map may take loops back
    database_.execute("DELETE FROM \"link\" WHERE \"id\" >= " + std::to_string(graph.links.size()));
  }
  upsertChanged(store_, written_.experiences, graph.experiences);
  upsertChanged(store_, written_.links, graph.links);
}

Status Recorder::revisions(const std::vector<MotionRevision>& revisions) {
  return write([&] {
    for (const MotionRevision& revision : revisions) {
      store_.insertAnnounced(std::nullopt, revision);
    }
  });
}

Status Recorder::graph(const MapGraph& graph) {
  return write([&] { writeGraph(graph); });
}

Status Recorder::timing(std::int64_t frame, std::string_view stage, std::int64_t duration_ns) {
  return write([&] {
    Statement& row = store_.insertion("timing");
    row.bind(frame);
    row.bind(stage);
    row.bind(duration_ns);
    row.run();
  });
}

Status Recorder::event(std::int64_t frame, LogLevel level, std::string_view source,
                       std::string_view message) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return write([&] {
    Statement& row = store_.insertion("event");
    row.bind(frame);
    row.bind(kLevelNames.at(static_cast<std::size_t>(level)));
    row.bind(source);
    row.bind(message);
    row.bind(std::int64_t{std::chrono::nanoseconds(now).count()});
    row.run();
  });
}

Status Recorder::meta(std::string_view key, std::string_view value) {
  return write([&] {
    meta_.bind(key);
    meta_.bind(value);
    meta_.run();
  });
}

/// With the mutex held.
void Recorder::commitNow() {
  if (!in_transaction_ || !failure_.isOk()) return;
  failure_ = guarded(name_, [&] { database_.execute("COMMIT"); });
  in_transaction_ = false;
}

Status Recorder::commit() {
  const std::lock_guard lock(mutex_);
  commitNow();
  return failure_;
}

void Recorder::commitRegularly(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wake_.wait_for(lock, stop, kCommitPeriod, [] { return false; });
    commitNow();
  }
}

Status Recorder::close() {
  committer_.request_stop();
  if (committer_.joinable()) committer_.join();
  const std::lock_guard lock(mutex_);
  if (closed_) return failure_;
  closed_ = true;
  commitNow();
  // Back to one plain file, which also opens on read-only media; a reader may hinder it.
  if (failure_.isOk()) {
    (void)guarded(
        name_, [&] { database_.execute("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE"); });
  }
  return failure_;
}

}  // namespace tolman::record
