// SPDX-License-Identifier: BSD-3-Clause
// All data of the run that clients can get, and the file that holds past frames.
//
// A file without a name; the system deletes it when the process ends.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "event_log.hpp"
#include "frame_encoder.hpp"
#include "handover.hpp"
#include "wire_records.hpp"

namespace tolman::web_viewer {

/// All functions throw std::system_error on failure.
class TemporaryFile {
 public:
  /// Creates the file in the folder for temporary files ($TMPDIR).
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::uint64_t offset, std::span<const char> bytes);
  void read(std::uint64_t offset, std::span<char> bytes) const;
  /// Frees the blocks; false if the file system does not support this.
  bool release(std::uint64_t offset, std::uint64_t size);

 private:
  int descriptor_ = -1;
};

// Encoded messages by number, in a temporary file of limited size. When it is full, every second
// message is dropped.

class Spool {
 public:
  /// `capacity` in bytes on the disk.
  explicit Spool(std::uint64_t capacity) : capacity_(capacity) {}

  /// Stores `message` under `number`, replacing an older one. A full spool first drops every second
  /// message, so that old messages become sparse. False when there is no room at all.
  bool store(std::int64_t number, const std::string& message);

  std::optional<std::string> at(std::int64_t number) const;
  /// The number of the newest message up to `number`.
  std::optional<std::int64_t> atOrBefore(std::int64_t number) const;

  std::size_t messages() const { return extents_.size(); }
  std::uint64_t bytes() const { return used_; }

 private:
  struct Extent {
    std::uint64_t offset;
    std::uint64_t size;  ///< of the message in bytes; it occupies whole blocks
  };
  using Extents = std::map<std::int64_t, Extent>;
  Extents::iterator drop(Extents::iterator extent);
  void thin();

  TemporaryFile file_;
  std::uint64_t capacity_;
  std::uint64_t used_ = 0;
  std::uint64_t end_ = 0;
  bool full_ = false;  ///< the file system cannot free blocks
  Extents extents_;
};

// All history rows of a run, in a temporary file: no row is dropped, and memory is constant.

class RowStore {
 public:
  /// `values`: whole rows, one after the other.
  void append(const std::vector<double>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    file_.write(size_ * rowBytes(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    size_ += values.size() / rowColumns().size();
  }
  std::size_t size() const { return size_; }

  /// At most `count` rows from `first` on, as the array "rows"; fewer at the end, none beyond it.
  PackedArray read(std::size_t first, std::size_t count) const {
    first = std::min(first, size_);
    count = std::min(count, size_ - first);
    std::string bytes(count * rowBytes(), '\0');
    file_.read(first * rowBytes(), bytes);
    return {"rows",
            ElementType::F64,
            {count, rowColumns().size()},
            std::make_shared<const std::string>(std::move(bytes))};
  }

 private:
  static std::size_t rowBytes() { return rowColumns().size() * sizeof(double); }

  TemporaryFile file_;
  std::size_t size_ = 0;
};

// All data of the run that clients can get: description, rows, stored frames, template images,
// graph and events. Belongs to the viewer's thread.

class RunStore {
 public:
  RunStore(const JpegOptions& jpeg_options, std::uint64_t spool_bytes);

  /// `recorded`: the run had ended before it was shown.
  void begin(const RunInfo& run, bool recorded) {
    hello_.run = run;
    hello_.recorded = recorded;
  }
  /// Encodes and stores new data.
  void add(const PendingData& pending);
  /// `state`: finished or interrupted.
  void end(std::string_view state);

  /// The object of /api/run.
  HelloHeader hello() const;
  bool hasEnded() const { return !hello_.live; }
  std::string endMessage() const;
  const std::string& endState() const { return end_state_; }
  const RowStore& rows() const { return rows_; }
  const Spool& frames() const { return frames_; }
  const Spool& templateImages() const { return template_images_; }
  const EventLog& events() const { return events_; }
  const MessageLog& messages() const { return messages_; }
  const LatestPose& pose() const { return pose_; }
  const FlatGraph& flatGraph() const { return flat_graph_; }
  /// The newest frame, null before the first; shared, because it may still be being sent to a
  /// client.
  const std::shared_ptr<const EncodedFrame>& newest() const { return newest_; }
  /// The encoded graph; null before the first.
  const std::shared_ptr<const std::string>& graph() const { return graph_; }

 private:
  JpegOptions jpeg_options_;
  HelloHeader hello_;
  std::string end_state_;
  RowStore rows_;
  Spool frames_;
  Spool template_images_;
  EventLog events_;
  MessageLog messages_;
  LatestPose pose_;
  FlatGraph flat_graph_;
  std::shared_ptr<const EncodedFrame> newest_;
  std::shared_ptr<const std::string> graph_;
};

}  // namespace tolman::web_viewer
