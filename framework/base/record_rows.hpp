// SPDX-License-Identifier: BSD-3-Clause
// Reads rows of run.sqlite, and declares those that are not records of the SDK. A run that
// continues the map of an earlier one records its frames after those of the earlier sessions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/sqlite.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

inline constexpr std::int64_t kSchemaVersion = 6;
/// In table `run` of a run with `record.replay`: how many of the descriptions of arrays, from the
/// first, are those of the source.
inline constexpr const char* kSensorsKey = "sensors";
/// Key in table `run`, of a run that localises: the run whose map it uses.
inline constexpr const char* kLocalisedKey = "localised_in";

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

/// How far the finished map is from a link (MapGraph::residuals).
struct LinkResidual {
  static constexpr const char* kRecord = "link_residual";
  std::int64_t id = -1;
  double sigmas = -1;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(id, "", "the link");
    TOLMAN_FIELD(sigmas, "", "distance of the map from it, standard deviations; -1 for none");
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

/// All poses of a record bit for bit, in the order of its fields, those of nested lists included.
/// Only runs with `record.replay` have this table; those of the revisions after the last frame n
/// are the row `motion` of frame n + 1.
struct ExactPoses {
  static constexpr const char* kRecord = "exact_pose";
  std::int64_t frame = -1;
  std::string of;
  Eigen::Matrix<double, 3, Eigen::Dynamic> poses;  ///< four columns each: rotation, position

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame");
    TOLMAN_FIELD(of, "", "table of the record whose poses they are: frame, motion or place");
    TOLMAN_FIELD(poses, "", "rotation and position (m) of each pose, one 3x4 matrix after another");
  }
};

RecordedArrayInfo toRow(const ArrayInfo& info);
/// std::domain_error where `axes` is not the JSON that toRow() writes.
ArrayInfo fromRow(const RecordedArrayInfo& row);

/// A value of table `run`; empty where it has none.
std::string entryOf(const Database& database, const std::string& key);

/// The array of a row. Throws std::domain_error if the shape does not fit the values.
NamedArray arrayOf(const RecordedArray& row);

template <class T>
inline constexpr bool kIsRecordList = false;
template <Record R>
inline constexpr bool kIsRecordList<std::vector<R>> = true;

/// The column that holds the frame of the record that a row was nested in.
template <Record R>
inline constexpr const char* kNestedIn = requires(R r) {
  r.frame;
}
? "announced_at" : "frame";

/// SELECT of all columns of a table, in the order of rowid: that of the key if it is one integer
/// (frame, id), otherwise the order of insertion.
std::string selectSql(const std::string& table, const Columns& columns,
                      const std::string& condition);

/// Reads rows of table R that fulfil a condition, such as `WHERE "frame" = ?`, with the lists
/// nested in them.
template <Record R>
class RowsOf {
 public:
  RowsOf(const Database& database, const std::string& condition)
      : rows_(database, selectSql(R::kRecord, columnsOf<R>(), condition)) {
    if constexpr (requires(R r) { r.frame; }) {  // only records with a frame have lists
      visitFields(kNoRecord, [&]([[maybe_unused]] const Field& field, const auto& value) {
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<T, std::vector<NamedArray>>) {
          lists_.emplace_back(
              database,
              selectSql(RecordedArray::kRecord, columnsOf<RecordedArray>(),
                        "WHERE \"frame\" = ? AND \"source\" = '" + std::string(field.name) + "'"));
        } else if constexpr (kIsRecordList<T>) {
          using Item = typename T::value_type;
          const bool exists = database.tableExists(Item::kRecord);  // not in older records
          lists_.emplace_back(
              database, exists ? selectSql(Item::kRecord, columnsOf<Item>(),
                                           std::string("WHERE \"") + kNestedIn<Item> + "\" = ?")
                               : "SELECT 0 WHERE 0 * ?");
        }
      });
    }
  }

  /// Calls visit(R) for each row; `values` are those of the condition's question marks.
  template <class Visit, class... Value>
  void each(Visit&& visit, const Value&... values) {
    (rows_.bindNext(values), ...);
    while (rows_.step()) {
      R record;
      Codec<R>::read(rows_, record);
      readLists(record);
      visit(std::move(record));
    }
  }

 private:
  static inline const R kNoRecord{};

  void readLists(R& record) {
    if constexpr (requires { record.frame; }) {
      [[maybe_unused]] auto list = lists_.begin();
      visitFields(record, [&](const Field&, [[maybe_unused]] auto& value) {
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (kIsRecordList<T> || std::is_same_v<T, std::vector<NamedArray>>) {
          list->bindNext(record.frame);
          while (list->step()) readItem(*list, value);
          ++list;
        }
      });
    }
  }
  static void readItem(Statement& row, std::vector<NamedArray>& arrays) {
    RecordedArray array;
    Codec<RecordedArray>::read(row, array);
    arrays.push_back(arrayOf(array));
  }
  template <Record Item>
  static void readItem(Statement& row, std::vector<Item>& items) {
    Codec<Item>::read(row, items.emplace_back());
  }

  Statement rows_;
  std::vector<Statement> lists_;  ///< in the order of the fields
};

/// Calls visit(R) for each row that fulfils a condition.
template <Record R, class Visit>
void forEachRow(const Database& database, const std::string& condition, Visit&& visit) {
  RowsOf<R>(database, condition).each(visit);
}

/// Calls visit(pose) for each pose of a record, as ExactPoses has them.
template <class R, class Visit>
void visitPoses(R& record, Visit&& visit) {
  visitFields(record, [&](const Field&, [[maybe_unused]] auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
      visit(value);
    } else if constexpr (kIsRecordList<T>) {
      for (auto& item : value) visitPoses(item, visit);
    }
  });
}

template <Record R>
ExactPoses exactPosesOf(std::int64_t frame, const R& record) {
  ExactPoses exact{frame, R::kRecord, {}};
  visitPoses(record, [&](const Eigen::Isometry3d& T) {
    exact.poses.conservativeResize(Eigen::NoChange, exact.poses.cols() + 4);
    exact.poses.template rightCols<4>() = T.matrix().topRows<3>();
  });
  return exact;
}

/// Sets all poses of a record that was read without them.
template <Record R>
void restorePoses(const ExactPoses& exact, R& record) {
  Eigen::Index column = 0;
  visitPoses(record, [&](Eigen::Isometry3d& T) {
    if (column + 4 > exact.poses.cols()) throw std::domain_error("exact poses are missing");
    T.matrix().topRows<3>() = exact.poses.middleCols<4>(column);
    column += 4;
  });
}

}  // namespace tolman::record
