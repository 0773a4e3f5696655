// SPDX-License-Identifier: BSD-3-Clause
#include "record/replay.hpp"

#include <algorithm>
#include <limits>

namespace tolman::record {
namespace {

std::int64_t lastShown(const Database& database, bool unfinished) {
  Statement row(database, "SELECT coalesce(max(\"frame\"), -1) FROM \"frame\"");
  row.step();
  return row.integer() - (unfinished ? 1 : 0);
}

Statement rowsAfter(const Database& database, const std::string& columns, const char* table,
                    std::int64_t row) {
  Statement rows(database, "SELECT rowid, " + columns + " FROM \"" + table +
                               "\" WHERE rowid > ? ORDER BY rowid");
  rows.bind(row);
  return rows;
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
Replay::Cursor<R>::Cursor(const Database& database, std::int64_t after)
    : rows(database, "SELECT " + columnList(columnsOf<R>()) + " FROM \"" + R::kRecord +
                         "\" WHERE \"frame\" > ? ORDER BY \"frame\"") {
  rows.bind(after);
  advance();
}

template <Record R>
void Replay::Cursor<R>::advance() {
  ahead.reset();
  if (rows.step()) Codec<R>::read(rows, ahead.emplace());
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
      frames_(reader.database(), position_.frame),
      motions_(reader.database(), position_.frame),
      places_(reader.database(), position_.frame),
      decisions_(reader.database(), position_.frame),
      maps_(reader.database(), position_.frame),
      times_(rowsAfter(reader.database(), "\"frame\", \"stage\", \"duration_ns\"", "timing",
                       position_.timing_row)),
      events_(rowsAfter(reader.database(), "\"frame\", \"level\", \"source\", \"message\"", "event",
                        position_.event_row)) {
  readTime();
  while (events_.step()) {
    auto& [row, event] = waiting_events_.emplace_back();
    row = events_.integer();
    Codec<RunEvent>::read(events_, event);
  }
}

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
  recorded.cells = readArrays(reader_.database(), frame, "cells");
  takeTimes(recorded);
  takeEvents(recorded);
  position_.frame = frame;
}

/// The recorder stores the points of a points_frame once.
void Replay::restorePoints(Motion& motion) {
  if (motion.points.cols() > 0) {
    position_.points_frame = motion.points_frame;
    position_.points = motion.points;
  } else if (motion.points_frame >= 0 && motion.points_frame == position_.points_frame) {
    motion.points = position_.points;
  }
}

/// Rows of timing come in the order of frames.
void Replay::takeTimes(RecordedFrame& recorded) {
  for (; time_ahead_ && time_ahead_->frame <= recorded.frame.frame; readTime()) {
    const auto role = std::ranges::find(kRoleNames, time_ahead_->stage);
    if (time_ahead_->frame == recorded.frame.frame && role != kRoleNames.end()) {
      recorded.stage_times_ns[static_cast<std::size_t>(role - kRoleNames.begin())] =
          time_ahead_->duration_ns;
    }
    position_.timing_row = time_ahead_->row;
  }
}

void Replay::readTime() {
  time_ahead_.reset();
  if (!times_.step()) return;
  TimingRow& time = time_ahead_.emplace();
  time.row = times_.integer();
  time.frame = times_.integer();
  time.stage = times_.text();
  time.duration_ns = times_.integer();
}

/// Those of later frames wait; those of none come with the next frame, and the last has the rest.
void Replay::takeEvents(RecordedFrame& recorded) {
  const bool last = !unfinished_ && !frames_.ahead;
  auto next = waiting_events_.begin();
  for (; next != waiting_events_.end(); ++next) {
    if (!last && next->second.frame > recorded.frame.frame) break;
    recorded.events.push_back(next->second);
    position_.event_row = next->first;
  }
  waiting_events_.erase(waiting_events_.begin(), next);
}

}  // namespace tolman::record
