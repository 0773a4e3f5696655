// SPDX-License-Identifier: BSD-3-Clause
#include "record/schema.hpp"

#include <fmt/format.h>

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
  announced.columns.insert(announced.columns.begin(), nestedIn<R>());
  return announced;
}

/// A table of records without a frame of their own that belong to a frame.
template <Record R>
Table nestedTable(std::string doc) {
  Table nested = table<R>(std::move(doc), frameReference());
  nested.columns.insert(nested.columns.begin(), nestedIn<R>());
  return nested;
}

/// SQL for columns x, y (m) and heading (rad) of the pose `pose`, as in toPlanar().
std::string planar(const std::string& pose) {
  return fmt::format(
      R"("{0}_z" AS x, -"{0}_x" AS y, atan2(-2 * ("{0}_qx" * "{0}_qz" + "{0}_qw" * "{0}_qy"), )"
      R"(1 - 2 * ("{0}_qx" * "{0}_qx" + "{0}_qy" * "{0}_qy")) AS heading)",
      pose);
}

const char* const kIntroduction =
    "# Tables of run.sqlite\n\n"
    "Generated from the field lists of the records; do not edit. Schema version ";

const char* const kConventions =
    ".\n\n"
    "Poses are seven columns, position `_x _y _z` and unit quaternion `_qx _qy _qz _qw` with\n"
    "`_qw >= 0`; `T_a_b` takes points of b to a. Matrices and arrays are little-endian, row-major\n"
    "blobs. Booleans are 0 or 1. Records of one frame are joined by `frame`.\n\n"
    "Names of columns that are words of SQL must be quoted: `SELECT \"from\", \"to\" FROM link`.\n"
    "Views for queries by hand need no quotes; records of earlier versions do not have them, and\n"
    "headings need an SQLite with mathematical functions:\n\n";

std::string tableMarkdown(const Table& table) {
  std::string text = "\n## " + table.name + "\n\n" + table.doc + "\n\n";
  text += "| column | type | unit | meaning |\n|---|---|---|---|\n";
  for (const Column& column : table.columns) {
    text += "| `" + column.name + "` | " + column.type + " | " + column.unit + " | " + column.doc +
            " |\n";
  }
  return text;
}

}  // namespace

std::vector<Table> schema() {
  return {
      {"run",
       "properties of the run: schema_version, name; with "
       "`record.replay` also how many of array_info, from the first, are the source's (sensors)",
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
      nestedTable<Candidate>("places that were considered for a frame, best first (rowid)"),
      frameTable<Decision>("decisions of the spatial cells"),
      nestedTable<PlaceHypothesis>("hypotheses of the spatial cells that a frame changed"),
      announcedTable<EarlierLoop>("loops of earlier frames that a decision accepts"),
      frameTable<MapUpdate>("answers of the map"),
      frameTable<FinalPose>("pose of each frame in the finished map"),
      table<Experience>("nodes of the experience map, latest values",
                        primaryKey("id") + frameReference()),
      table<RecordedLink>("links of the experience map, latest values",
                          primaryKey("id") + reference("from", "experience", "id") +
                              reference("to", "experience", "id") + frameReference()),
      table<LinkResidual>("how far the finished map is from its links", primaryKey("id")),
      table<RecordedArrayInfo>("descriptions of the named arrays, constant over a run", ""),
      table<RecordedArray>("named arrays of a frame: its sensors, and the state of the cells",
                           frameReference()),
      table<ExactPoses>(
          "poses bit for bit, which the quaternions are not; the table exists only with "
          "`record.replay`",
          ", PRIMARY KEY (\"frame\", \"of\")"),
      table<RecordedTiming>("computing time of each stage and frame", ""),
      table<RecordedEvent>("warnings, errors and notes", ""),
      table<RecordedFinding>("what the stages found in their data", ""),
  };
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

std::string upsertSql(const std::string& table, const Columns& columns) {
  std::string sql = insertSql(table, columns) + " ON CONFLICT (\"id\") DO UPDATE SET ";
  const char* separator = "";
  for (const Column& column : columns) {
    // Setting the key, even to the same value, makes SQLite look for child rows, which scans all
    // links for each row.
    if (column.name == "id") continue;
    const std::string quoted = "\"" + column.name + "\"";
    sql.append(separator).append(quoted).append(" = excluded.").append(quoted);
    separator = ", ";
  }
  return sql;
}

std::vector<SqlView> views() {
  return {
      {"path",
       "`frame`, `stamp_ns`, `x` (forward, m), `y` (left, m), `heading` (rad) of the finished map",
       "SELECT frame, stamp_ns, " + planar("T_world_camera") +
           " FROM final_pose JOIN frame USING (frame)"},
      {"true_path", "the same of the true poses",
       "SELECT frame, stamp_ns, " + planar("T_world_camera_truth") + " FROM frame WHERE has_truth"},
      {"map_link",
       "`id`, `from_experience`, `to_experience`, `kind`, `frame`, `x`, `y`, `heading`, "
       "`duration`, "
       "`weight`, `rejected`",
       R"(SELECT id, "from" AS from_experience, "to" AS to_experience, kind, frame, )" +
           planar("T_from_to") + ", duration, weight, rejected FROM link"},
      {"localisation",
       "of a run that localises: `frame`, `status` (found, unknown_place or lost), `experience`, "
       "`x`, `y`, `heading` in the map, `covariance` of the pose relative to the experience",
       "SELECT frame, CASE WHEN motion.state = 'lost' THEN 'lost' WHEN map_update.experience < 0 "
       "THEN 'unknown_place' ELSE 'found' END AS status, map_update.experience, " +
           planar("T_world_camera") +
           ", decision.covariance FROM map_update JOIN motion USING (frame) JOIN decision USING "
           "(frame) WHERE frame >= (SELECT max(first_frame) FROM session) AND EXISTS (SELECT 1 "
           "FROM run WHERE key = '" +
           kLocalisedKey + "')"},
      {"array_data", "`frame`, `source`, `name`, `shape`, `data` (`values` of `array`)",
       R"(SELECT frame, source, name, shape, "values" AS data FROM "array")"},
  };
}

std::string createSql(const SqlView& view) {
  return "CREATE VIEW " + view.name + " AS " + view.select;
}

std::string recordsMarkdown() {
  std::string text = kIntroduction + std::to_string(kSchemaVersion) + kConventions;
  for (const SqlView& view : views()) text += "- `" + view.name + "`: " + view.doc + "\n";
  for (const Table& table : schema()) text += tableMarkdown(table);
  return text;
}

}  // namespace tolman::record
