// SPDX-License-Identifier: BSD-3-Clause
// Rows of run.sqlite that are not records of the SDK. A run that continues the map of an earlier
// one records its frames after those of the earlier sessions.
#pragma once

#include <cstdint>
#include <string>

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

/// The frames of one run.
struct RecordedSession {
  static constexpr const char* kRecord = "session";
  std::int64_t id = 0;           ///< consecutive from 0; the last one is that of this run
  std::int64_t first_frame = 0;  ///< frames before it are of earlier sessions
  std::string name;              ///< of the run
  std::string source;            ///< the source's description of its data

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(id, "", "0, 1, 2 ...; the last one is this run's own");
    TOLMAN_FIELD(first_frame, "", "its first frame; those before are of earlier sessions");
    TOLMAN_FIELD(name, "", "name of the run");
    TOLMAN_FIELD(source, "", "the source's description of its data");
  }
};

/// The pose of one frame in the finished map.
struct FinalPose {
  static constexpr const char* kRecord = "final_pose";
  std::int64_t frame = -1;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame");
    TOLMAN_FIELD(T_world_camera, "m", "pose in the world");
  }
};

/// A link, and whether the map has rejected it (MapGraph::rejected).
struct RecordedLink : Link {
  bool rejected = false;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    Link::fields(self, visit);
    TOLMAN_FIELD(rejected, "", "whether the map has rejected it as a false loop");
  }
};

/// A named array of a frame.
struct RecordedArray {
  static constexpr const char* kRecord = "array";
  std::int64_t frame = -1;
  std::string source;
  std::string name;
  std::string shape;
  Eigen::RowVectorXf values;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame");
    TOLMAN_FIELD(source, "", "field of the frame record (sensors), or cells");
    TOLMAN_FIELD(name, "", "name of the array");
    TOLMAN_FIELD(shape, "", "sizes, slowest first, e.g. 10x36");
    TOLMAN_FIELD(values, "", "all values");
  }
};

/// The description of an array, its axes as JSON.
struct RecordedArrayInfo {
  static constexpr const char* kRecord = "array_info";
  std::string name;
  ArrayKind kind = ArrayKind::Values;
  std::string unit;
  std::string doc;
  std::string population;
  std::string axes;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(name, "", "name of the array that is described");
    TOLMAN_FIELD(kind, "", "values, activity, bump or depth_image");
    TOLMAN_FIELD(unit, "", "unit of the values");
    TOLMAN_FIELD(doc, "", "what the numbers are");
    TOLMAN_FIELD(population, "", "of a bump: the activity array whose axes its mean refers to");
    TOLMAN_FIELD(axes, "", "JSON list with name, unit, first, step, period, labels of each axis");
  }
};

/// Computing time of a stage at one frame.
struct RecordedTiming {
  static constexpr const char* kRecord = "timing";
  std::int64_t frame = -1;
  std::string stage;
  std::int64_t duration_ns = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame");
    TOLMAN_FIELD(stage, "", "name of the stage");
    TOLMAN_FIELD(duration_ns, "ns", "wall-clock duration");
  }
};

/// An event, and when it happened.
struct RecordedEvent : RunEvent {
  static constexpr const char* kRecord = "event";
  std::int64_t time_ns = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame, -1 for none");
    TOLMAN_FIELD(level, "", "debug, info, warning or error");
    TOLMAN_FIELD(source, "", "stage or part of the program");
    TOLMAN_FIELD(message, "", "text");
    TOLMAN_FIELD(time_ns, "ns", "wall-clock time since 1970");
  }
};

/// A finding of a stage, and the frame at which it was made.
struct RecordedFinding : Finding {
  static constexpr const char* kRecord = "finding";
  std::int64_t frame = -1;
  std::string stage;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame, -1 for findings before the first");
    TOLMAN_FIELD(stage, "", "name of the stage");
    Finding::fields(self, visit);
  }
};

RecordedArrayInfo toRow(const ArrayInfo& info);
/// BadRow where `axes` is not the JSON that toRow() writes.
ArrayInfo fromRow(const RecordedArrayInfo& row);

}  // namespace tolman::record
