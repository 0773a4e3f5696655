// SPDX-License-Identifier: BSD-3-Clause
#include "edited_record.hpp"

#include <sqlite3.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

#include "input.hpp"
#include "record/export.hpp"
#include "record/graph_parts.hpp"
#include "record/recorder.hpp"
#include "record/replay.hpp"
#include "record/sample_run.hpp"

namespace tolman::fuzz {
namespace {

namespace fs = std::filesystem;

using Handle = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;

Handle open(const fs::path& file) {
  sqlite3* handle = nullptr;
  require(sqlite3_open(file.c_str(), &handle) == SQLITE_OK, "no database");
  return {handle, &sqlite3_close};
}

bool execute(const Handle& database, const std::string& sql) {
  return sqlite3_exec(database.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
}

RunInfo cameras() {
  RunInfo run;
  run.source.rig = {16, 8, true, {10, 10, 8, 4}, 0.5};
  ArrayInfo ring;
  ring.name = "hd.activity";
  ring.kind = ArrayKind::Activity;
  ring.axes = {{"heading", "rad", 0, 2.0943951, 6.2831853, {}}};
  ArrayInfo sheet;
  sheet.name = "grid.activity";
  sheet.kind = ArrayKind::Activity;
  sheet.axes = {{"x", "m", 0, 1, 3, {}}, {"y", "m", 0, 1, 3, {}}};
  run.arrays = {ring, sheet};
  return run;
}

/// A drive to and fro, which closes a loop at its end.
void recordFrame(record::Recorder& recorder, std::int64_t i, std::int64_t frames) {
  Frame frame = test::frameAt(i);
  frame.has_truth = true;
  frame.T_world_camera_truth.translation() << 0, 0, static_cast<double>(i);
  Motion motion = test::motionAt(i);
  motion.covariance.diagonal().setConstant(0.01);
  if (i % 3 == 0) motion.points_frame = i;
  if (i % 3 == 0) motion.points = Eigen::Matrix<float, 4, 2>::Constant(1.5F);
  if (i == 4) motion.revisions = {{3, Eigen::Isometry3d::Identity(), Matrix6d::Zero()}};
  PlaceObservation place;
  place.frame = i;
  place.recognition = i < 4 ? Recognition::Novel : Recognition::Familiar;
  place.template_id = i % 4;
  Decision decision;
  decision.frame = i;
  decision.action = i + 1 == frames ? Action::CloseLoop : Action::Stay;
  decision.experience = 0;
  if (i + 1 == frames) decision.earlier.resize(1);
  if (i + 1 == frames) decision.earlier[0].frame = i - 1;
  MapUpdate update;
  update.frame = i;
  update.experience = 0;
  update.T_experience_camera.translation().z() = static_cast<double>(i);
  MapGraph graph{1, {test::experienceAt(0, 0, 0), test::experienceAt(1, 1, 1)}, {}, {}};
  graph.links = {test::linkBetween(0, 0, 1, 1)};
  const auto wave = static_cast<float>(i % 3);
  const std::vector<NamedArray> cells = {{"hd.activity", {3}, {1, 2, wave}},
                                         {"grid.activity", {3, 3}, {1, 2, 3, wave, 0, 0, 1, 1, 1}},
                                         {"other", {2}, {1, wave}}};
  const std::vector<RunEvent> events = {{i, LogLevel::Info, "place", "new view"}};
  Snapshot snapshot{&frame, &motion, &place, &decision, &update, &cells, i == 1 ? &graph : nullptr,
                    {},     &events};
  require(recorder.snapshot(snapshot).isOk(), "the sample cannot be recorded");
  (void)recorder.timing(i, "odometry", 1'000'000 + i);
}

void recordRun(const fs::path& folder) {
  constexpr std::int64_t kFrames = 6;
  auto recorder = record::Recorder::open(folder).value();
  require(recorder->session({0, 0, "first", "made"}).isOk(), "no session");
  require(recorder->meta("name", "sample").isOk(), "no name");
  require(recorder->begin(cameras()).isOk(), "no cameras");
  for (std::int64_t i = 0; i < kFrames; ++i) recordFrame(*recorder, i, kFrames);
  require(recorder->finalPoses({{0, Eigen::Isometry3d::Identity()}}).isOk(), "no poses");
  require(recorder->event(-1, LogLevel::Warning, "host", "a note").isOk(), "no event");
  require(recorder->close().isOk(), "the sample cannot be closed");
}

/// Copies all tables to a database whose columns take any value.
std::string withoutConditions(const fs::path& file) {
  const fs::path loose = file.string() + "-loose";
  {
    const Handle database = open(loose);
    bool good = execute(database, "PRAGMA page_size = 1024; PRAGMA journal_mode = OFF; ATTACH '" +
                                      file.string() + "' AS strict");
    for (const record::Table& table : record::schema()) {
      std::string columns;
      for (const record::Column& column : table.columns) {
        columns += (columns.empty() ? "\"" : ", \"") + column.name + "\"";
      }
      const std::string name = "\"" + table.name + "\"";
      good = good &&
             execute(database, "CREATE TABLE main." + name + " (" + columns +
                                   "); INSERT INTO main." + name + " SELECT * FROM strict." + name);
    }
    // With the numbers and sums of rows every edit would be noticed at once.
    good = good && execute(database, "DELETE FROM main.run WHERE \"key\" IN ('rows', 'row_sums')");
    require(good, "the sample cannot be copied");
  }
  std::ifstream stream(loose, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string makeSample() {
  const ScratchFolder folder;
  recordRun(folder.path());
  return withoutConditions(folder.path() / "run.sqlite");
}

std::string bytesOf(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    int value = 0;
    (void)std::from_chars(digits.data() + i, digits.data() + i + 2, value, 16);
    bytes += static_cast<char>(value);
  }
  return bytes;
}

void bindValue(sqlite3_stmt* statement, const std::string& kind, const std::string& value) {
  if (kind == "i") {
    std::int64_t number = 0;
    (void)std::from_chars(value.data(), value.data() + value.size(), number);
    sqlite3_bind_int64(statement, 1, number);
  } else if (kind == "r") {
    double number = 0;
    (void)std::from_chars(value.data(), value.data() + value.size(), number);
    sqlite3_bind_double(statement, 1, number);
  } else if (kind == "b") {
    const std::string bytes = bytesOf(value);
    sqlite3_bind_blob(statement, 1, bytes.data(), static_cast<int>(bytes.size()),
                      SQLITE_TRANSIENT);  // NOLINT
  } else if (kind == "t") {
    sqlite3_bind_text(statement, 1, value.data(), static_cast<int>(value.size()),
                      SQLITE_TRANSIENT);  // NOLINT
  }
}

/// "WHERE rowid = 3", or nothing for all; a number only, since it becomes SQL.
std::string rowCondition(const std::string& row) {
  if (row == "*") return "";
  int number = 0;
  (void)std::from_chars(row.data(), row.data() + row.size(), number);
  return " WHERE rowid = " + std::to_string(number);
}

const record::Table* tableNamed(const std::string& name) {
  static const std::vector<record::Table> kTables = record::schema();
  for (const record::Table& table : kTables) {
    if (table.name == name) return &table;
  }
  return nullptr;
}

void setValue(const Handle& database, const std::string& target, std::istringstream& words) {
  const std::size_t dot = target.find('.');
  const record::Table* table = tableNamed(target.substr(0, dot));
  if (table == nullptr || dot == std::string::npos) return;
  std::string row;
  std::string kind;
  words >> row >> kind;
  std::string value;
  std::getline(words >> std::ws, value);
  for (const record::Column& column : table->columns) {
    if (column.name != target.substr(dot + 1)) continue;
    const std::string sql =
        "UPDATE \"" + table->name + "\" SET \"" + column.name + "\" = ?" + rowCondition(row);
    sqlite3_stmt* statement = nullptr;
    require(sqlite3_prepare_v2(database.get(), sql.c_str(), -1, &statement, nullptr) == SQLITE_OK,
            "a wrong statement");
    bindValue(statement, kind, value);
    (void)sqlite3_step(statement);
    sqlite3_finalize(statement);
  }
}

void edit(const Handle& database, const std::string& line) {
  std::istringstream words(line);
  std::string what;
  words >> what;
  if (what != "-" && what != "+") return setValue(database, what, words);
  std::string name;
  std::string row;
  words >> name >> row;
  if (tableNamed(name) == nullptr) return;
  const std::string quoted = "\"" + name + "\"" + rowCondition(row);
  (void)execute(database, what == "-" ? "DELETE FROM " + quoted
                                      : "INSERT INTO \"" + name + "\" SELECT * FROM " + quoted);
}

template <Record R>
void readAll(const record::RunReader& reader) {
  (void)reader.records<R>();
}

void replay(const record::RunReader& reader) {
  (void)record::Replay::open(reader, {}, true);
  const auto opened = record::Replay::open(reader, {}, false);
  if (!opened.isOk()) return;
  record::RecordedFrame frame;
  for (int i = 0; i < 1000; ++i) {
    const auto more = opened.value()->next(frame);
    if (!more.isOk() || !more.value()) break;
    (void)frame.snapshot();
  }
}

/// As a run that goes on from this one.
void inherit(const record::RunReader& reader) {
  if (!record::Recorder::inheritable(reader).isOk()) return;
  const ScratchFolder folder;
  auto recorder = record::Recorder::open(folder.path());
  require(recorder.isOk(), "no record");
  const auto frames = reader.nextFrame();
  if (frames.isOk()) (void)recorder.value()->inherit(reader, frames.value());
}

}  // namespace

void writeEditedRecord(const fs::path& folder, std::string_view edits) {
  static const std::string kSample = makeSample();
  constexpr int kMaxEdits = 32;
  {
    std::ofstream stream(folder / "run.sqlite", std::ios::binary);
    stream.write(kSample.data(), static_cast<std::streamsize>(kSample.size()));
    require(stream.good(), "the record cannot be written");
  }
  const Handle database = open(folder / "run.sqlite");
  require(execute(database, "PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY; BEGIN"),
          "no transaction");
  std::istringstream stream{std::string(edits)};
  std::string line;
  for (int i = 0; i < kMaxEdits && std::getline(stream, line); ++i) edit(database, line);
  require(execute(database, "COMMIT"), "no commit");
}

void readEverything(const fs::path& folder) {
  const auto opened = record::RunReader::open(folder);
  if (!opened.isOk()) {
    require(!opened.status().message().empty(), "refused without a message");
    return;
  }
  const record::RunReader& reader = *opened.value();
  readAll<record::RecordedSession>(reader);
  readAll<CameraRig>(reader);
  readAll<Frame>(reader);
  readAll<Motion>(reader);
  readAll<PlaceObservation>(reader);
  readAll<Decision>(reader);
  readAll<MapUpdate>(reader);
  readAll<record::RecordedEvent>(reader);
  (void)reader.visitCellArrays([](std::int64_t, const NamedArray& array) {
    std::size_t size = 1;
    for (const int side : array.shape) size *= static_cast<std::size_t>(side);
    require(size == array.values.size(), "an array of another size than its shape");
  });
  (void)reader.arrayInfos();
  (void)reader.meta();
  (void)reader.timing();
  (void)reader.totals();
  (void)reader.truth();
  (void)reader.scaleKnown();
  if (reader.graph().isOk()) (void)record::partsOf(reader.graph().value());
  replay(reader);
  inherit(reader);
  (void)record::exportRun(reader, folder);
}

}  // namespace tolman::fuzz
