// SPDX-License-Identifier: BSD-3-Clause
#include "record/schema.hpp"

#include "record/session.hpp"

namespace tolman::record {
namespace {

const char* const kFrameKey = ", PRIMARY KEY (\"frame\")";
const char* const kFrameForeignKey =
    ", PRIMARY KEY (\"frame\"), FOREIGN KEY (\"frame\") REFERENCES \"frame\" (\"frame\")";

template <Record R>
Table table(std::string doc, std::string constraints) {
  return {R::kRecord, std::move(doc), columnsOf<R>(), std::move(constraints)};
}

Table motionRevisionTable() {
  Table result = table<MotionRevision>(
      "better values for earlier motions, in the order of announcement (rowid); of several for one "
      "frame the last counts",
      ", FOREIGN KEY (\"frame\") REFERENCES \"frame\" (\"frame\")"
      ", FOREIGN KEY (\"announced_at\") REFERENCES \"frame\" (\"frame\")");
  result.columns.insert(result.columns.begin(), announcedAt());
  return result;
}

Table linkTable() {
  return table<Link>("links of the experience map as last known",
                     ", PRIMARY KEY (\"id\")"
                     ", FOREIGN KEY (\"from\") REFERENCES \"experience\" (\"id\")"
                     ", FOREIGN KEY (\"to\") REFERENCES \"experience\" (\"id\")"
                     ", FOREIGN KEY (\"frame\") REFERENCES \"frame\" (\"frame\")");
}

Table experienceTable() {
  return table<Experience>("nodes of the experience map as last known",
                           ", PRIMARY KEY (\"id\")"
                           ", FOREIGN KEY (\"frame\") REFERENCES \"frame\" (\"frame\")");
}

Table finalPoseTable() {
  return table<FinalPose>("where each frame was, by all that the map knew after the last one",
                          kFrameForeignKey);
}

Table sessionTable() {
  return table<Session>("the runs whose frames are recorded here, this one the last",
                        ", PRIMARY KEY (\"id\")");
}

Table arrayTable() {
  return {"array",
          "named arrays of a frame: its sensors, and the state of the cells",
          {{"frame", "INTEGER", "", "the frame"},
           {"source", "TEXT", "", "field of the frame record (sensors), or cells"},
           {"name", "TEXT", "", "name of the array"},
           {"shape", "TEXT", "", "sizes, slowest first, e.g. 10x36"},
           {"values", "BLOB", "", "float32, row-major"}},
          ", PRIMARY KEY (\"frame\", \"source\", \"name\")"
          ", FOREIGN KEY (\"frame\") REFERENCES \"frame\" (\"frame\")"};
}

Table timingTable() {
  return {"timing",
          "how long stages took; never the same twice",
          {{"frame", "INTEGER", "", "the frame"},
           {"stage", "TEXT", "", "name of the stage"},
           {"duration_ns", "INTEGER", "ns", "time of the machine"}},
          "",
          false};
}

Table eventTable() {
  return {"event",
          "warnings, errors and notes",
          {{"frame", "INTEGER", "", "the frame, -1 for none"},
           {"level", "TEXT", "", "debug, info, warning or error"},
           {"source", "TEXT", "", "who says it"},
           {"message", "TEXT", "", "what"},
           {"time_ns", "INTEGER", "ns", "time of the machine since 1970"}},
          "",
          false};
}

Table runTable() {
  return {"run",
          "facts about the run, among them schema_version",
          {{"key", "TEXT", "", "name"}, {"value", "TEXT", "", "value"}},
          ", PRIMARY KEY (\"key\")",
          false};
}

}  // namespace

Column announcedAt() {
  return {"announced_at", "INTEGER NULL", "",
          "the frame with which it came; NULL after the last frame"};
}

std::vector<Table> schema() {
  return {
      runTable(),
      sessionTable(),
      table<CameraRig>("the cameras; one row", ""),
      table<Frame>("exposures, without the images", kFrameKey),
      table<Motion>("what odometry said; points only where points_frame is new", kFrameForeignKey),
      motionRevisionTable(),
      table<PlaceObservation>("what place recognition said", kFrameForeignKey),
      table<Decision>("what the spatial cells decided", kFrameForeignKey),
      table<MapUpdate>("what the map said", kFrameForeignKey),
      finalPoseTable(),
      experienceTable(),
      linkTable(),
      arrayTable(),
      timingTable(),
      eventTable(),
  };
}

std::string columnList(const Columns& columns) {
  std::string sql;
  for (const Column& column : columns) sql += (sql.empty() ? "\"" : ", \"") + column.name + "\"";
  return sql;
}

std::string createSql(const Table& table) {
  std::string sql;
  for (const Column& column : table.columns) {
    sql += (sql.empty() ? "\"" : ", \"") + column.name + "\" " + column.type;
    if (!column.type.ends_with(" NULL")) sql += " NOT NULL";
  }
  return "CREATE TABLE \"" + table.name + "\" (" + sql + table.constraints + ") STRICT";
}

std::string insertSql(const std::string& table, const Columns& columns) {
  std::string marks;
  for (std::size_t i = 0; i < columns.size(); ++i) marks += i == 0 ? "?" : ", ?";
  return "INSERT INTO \"" + table + "\" (" + columnList(columns) + ") VALUES (" + marks + ")";
}

}  // namespace tolman::record
