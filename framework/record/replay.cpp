// SPDX-License-Identifier: BSD-3-Clause
#include "record/replay.hpp"

#include "base/named_value.hpp"

namespace tolman::record {
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
