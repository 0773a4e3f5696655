// SPDX-License-Identifier: BSD-3-Clause
#include "record/schema.hpp"

#include "record/rows.hpp"

namespace tolman::record {
namespace {

std::string primaryKey(const std::string& column) { return ", PRIMARY KEY (\"" + column + "\")"; }

/// `column` refers to the key of table `parent`.
std::string reference(const std::string& column, const std::string& parent,
                      const std::string& key) {
  return ", FOREIGN KEY (\"" + column + "\") REFERENCES \"" + parent + "\" (\"" + key + "\")";
}

std::string frameReference() { return reference("frame", "frame", "frame"); }

template <Record R>
Table table(std::string doc, std::string constraints) {
  return {R::kRecord, std::move(doc), columnsOf<R>(), std::move(constraints)};
}

/// A table with one row per frame.
template <Record R>
Table frameTable(std::string doc) {
  return table<R>(std::move(doc), primaryKey("frame") + frameReference());
}

/// A table of records that belong to an earlier frame and were announced at a later one.
template <Record R>
Table announcedTable(std::string doc) {
  Table announced =
      table<R>(std::move(doc), frameReference() + reference("announced_at", "frame", "frame"));
  announced.columns.insert(announced.columns.begin(), announcedAt());
  return announced;
}

}  // namespace

Column announcedAt() {
  return {"announced_at", "INTEGER NULL", "",
          "the frame whose record brought it; NULL after the last frame"};
}

std::vector<Table> schema() {
  return {
      {"run",
       "properties of the run: schema_version, name, the id that run.json has too, sums over the "
       "rows at the last commit (row_sums), and, when it has ended, how many rows the tables have",
       {{"key", "TEXT", "", "name"}, {"value", "TEXT", "", "value"}},
       primaryKey("key")},
      table<RecordedSession>("the runs whose frames are recorded here, this one the last",
                             primaryKey("id")),
      table<CameraRig>("the cameras; one row", ""),
      table<Frame>("exposures, without the images", primaryKey("frame")),
      frameTable<Motion>("answers of odometry; points only where points_frame is new"),
      announcedTable<MotionRevision>(
          "improved motions of earlier frames, in the order of arrival (rowid); the last one of a "
          "frame is valid"),
      frameTable<PlaceObservation>("answers of place recognition"),
      frameTable<Decision>("decisions of the spatial cells"),
      announcedTable<EarlierLoop>("loops of earlier frames that a decision accepts"),
      frameTable<MapUpdate>("answers of the map"),
      frameTable<FinalPose>("pose of each frame in the finished map"),
      table<Experience>("nodes of the experience map, latest values",
                        primaryKey("id") + frameReference()),
      table<RecordedLink>("links of the experience map, latest values",
                          primaryKey("id") + reference("from", "experience", "id") +
                              reference("to", "experience", "id") + frameReference()),
      table<RecordedArrayInfo>("descriptions of the named arrays, constant over a run", ""),
      table<RecordedArray>("named arrays of a frame: its sensors, and the state of the cells",
                           ", PRIMARY KEY (\"frame\", \"source\", \"name\")" + frameReference()),
      table<RecordedTiming>("computing time of each stage and frame", ""),
      table<RecordedEvent>("warnings, errors and notes", ""),
      table<RecordedFinding>("what the stages found in their data", ""),
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
