// SPDX-License-Identifier: BSD-3-Clause
#include "record/replay.hpp"

#include "base/named_value.hpp"

namespace tolman::record {
namespace {

std::int64_t lastShown(const Database& database, bool unfinished) {
  Statement row(database, "SELECT coalesce(max(\"frame\"), -1) FROM \"frame\"");
  row.step();
  return row.next().getInt64() - (unfinished ? 1 : 0);
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

template <Record R>
Replay::Cursor<R>::Cursor(const Database& database, const std::string& key_column,
                          std::int64_t after)
    : rows(database, "SELECT " + key_column + ", " + columnList(columnsOf<R>()) + " FROM \"" +
                         R::kRecord + "\" WHERE " + key_column + " > ? ORDER BY " + key_column) {
  rows.bindNext(after);
  advance();
}

template <Record R>
void Replay::Cursor<R>::advance() {
  ahead.reset();
  if (!rows.step()) return;
  key = rows.next().getInt64();
  Codec<R>::read(rows, ahead.emplace());
}

template <Record R>
std::optional<R> Replay::Cursor<R>::take(std::int64_t frame) {
  while (ahead && ahead->frame < frame) advance();
  if (!ahead || ahead->frame != frame) return std::nullopt;
  std::optional<R> taken = std::move(ahead);
  advance();
  return taken;
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
    : reader_(reader),
      position_(std::move(position)),
      unfinished_(unfinished),
      end_(lastShown(reader.database(), unfinished)),
      frames_(reader.database(), "frame", position_.frame),
      motions_(reader.database(), "frame", position_.frame),
      places_(reader.database(), "frame", position_.frame),
      decisions_(reader.database(), "frame", position_.frame),
      maps_(reader.database(), "frame", position_.frame),
      times_(reader.database(), "rowid", position_.timing_row),
      events_(reader.database(), "rowid", position_.event_row),
      arrays_(reader.database(), "WHERE \"frame\" = ? AND \"source\" = 'cells'") {}

Result<bool> Replay::next(RecordedFrame& recorded) {
  if (!frames_.ahead || frames_.ahead->frame > end_) return false;
  recorded = RecordedFrame();
  const Status status =
      guarded((reader_.directory() / "run.sqlite").string(), [&] { fill(recorded); });
  if (!status.isOk()) return status;
  return true;
}

void Replay::fill(RecordedFrame& recorded) {
  const std::int64_t frame = frames_.ahead->frame;
  recorded.frame = *frames_.take(frame);
  recorded.motion = motions_.take(frame);
  if (recorded.motion) restorePoints(*recorded.motion);
  recorded.place = places_.take(frame);
  recorded.decision = decisions_.take(frame);
  recorded.map = maps_.take(frame);
  arrays_.each([&](const RecordedArray& row) { recorded.cells.push_back(arrayOf(row)); }, frame);
  takeTimes(recorded);
  takeEvents(recorded);
  position_.frame = frame;
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

/// Takes the timing rows of the frame; rows are in the order of frames.
void Replay::takeTimes(RecordedFrame& recorded) {
  for (; times_.ahead && times_.ahead->frame <= recorded.frame.frame; times_.advance()) {
    const auto role = valueNamed<Role>(times_.ahead->stage);
    if (role && times_.ahead->frame == recorded.frame.frame) {
      recorded.stage_times_ns[static_cast<std::size_t>(*role)] = times_.ahead->duration_ns;
    }
    position_.timing_row = times_.key;
  }
}

/// Takes the events of the frame, events without a frame (-1) before it, and at the last frame all
/// remaining events.
void Replay::takeEvents(RecordedFrame& recorded) {
  const bool last = !unfinished_ && !frames_.ahead;
  for (; events_.ahead && (last || events_.ahead->frame <= recorded.frame.frame);
       events_.advance()) {
    recorded.events.push_back(*events_.ahead);
    position_.event_row = events_.key;
  }
}

}  // namespace tolman::record
