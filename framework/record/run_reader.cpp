// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_reader.hpp"

#include "config/values.hpp"
#include "record/row_sums.hpp"
#include "record/run_directory.hpp"
#include "record/run_id.hpp"
#include "record/schema_check.hpp"

namespace tolman::record {
namespace {

/// The counts of rows are the last that a run records, and only then its run.json says that it has
/// ended. So without them the end of the record is missing.
Status endIsThere(const std::filesystem::path& file, bool has_counts) {
  if (has_counts || !RunDirectory::hasEnded(file.parent_path())) return Status::ok();
  return Status::invalidInput(
      file.string() +
      ": lacks the end of the run, which has ended by run.json; if run.sqlite-wal was not copied "
      "with it, put it beside it, or run it again");
}

}  // namespace

Result<std::unique_ptr<RunReader>> RunReader::open(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "run.sqlite";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return Status::invalidInput(
        directory.string() + ": " +
        config::absence(file,
                        "is no run directory, it holds no run.sqlite; give the folder that a run "
                        "has written"));
  }
  Result<std::unique_ptr<RunReader>> reader = openAs(directory, file, Access::ReadOnly);
  if (reader.isOk() || !hasForeignLog(directory, file)) return reader;
  return Status::invalidInput(
      file.string() +
      ": is whole, but the run.sqlite-wal beside it is of another state of it, such as a copy that "
      "was made during the run; remove run.sqlite-wal and run.sqlite-shm");
}

Result<std::unique_ptr<RunReader>> RunReader::openAs(const std::filesystem::path& directory,
                                                     const std::filesystem::path& file,
                                                     Access access) {
  std::unique_ptr<RunReader> reader;
  std::string id;
  const Status status = guarded(file.string(), [&] {
    reader.reset(new RunReader(directory, file, access));
    id = reader->entry(kRunIdKey);
  });
  if (!status.isOk()) return Status::invalidInput(status.message());
  Status of_run = isOfRun(file, id, runIdOf(directory));
  if (of_run.isOk()) of_run = endIsThere(file, reader->hasEnd());
  if (!of_run.isOk()) return of_run;
  return reader;
}

bool RunReader::hasForeignLog(const std::filesystem::path& directory,
                              const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file.string() + "-wal", ignored)) return false;
  if (!RunDirectory::hasEnded(directory)) return false;
  const auto alone = openAs(directory, file, Access::WithoutLog);
  return alone.isOk() && alone.value()->hasEnd();
}

RunReader::RunReader(std::filesystem::path directory, const std::filesystem::path& file,
                     Access access)
    : directory_(std::move(directory)),
      name_(file.string()),
      database_(openDatabase(file, access)) {
  database_.exec("BEGIN");  // all reads see one state
  checkVersion();
  requireOwnTables(database_);
  const std::string counts = entry(kRowCountsKey);
  if (!counts.empty() && counts != rowCounts(database_)) {
    throw BadRow("has other numbers of rows than when the run ended: rows were removed or added");
  }
  requireRowsOfFrames(database_);
  if (!counts.empty()) return;  // digests of its files tell of a run that ended
  requireRowSums(database_);
  rows_were_compared_ = true;
}

void RunReader::checkVersion() const {
  if (!database_.tableExists("run")) throw BadRow("is no run database; it has no table `run`");
  const std::string version = entry("schema_version");
  if (version == std::to_string(kSchemaVersion)) return;
  throw BadRow("has schema version " + (version.empty() ? "none" : version) +
               ", this program reads " + std::to_string(kSchemaVersion) +
               "; run again to record it anew");
}

std::string RunReader::entry(const std::string& key) const {
  Statement row(database_, "SELECT \"value\" FROM \"run\" WHERE \"key\" = ?");
  row.bindNext(key);
  return row.step() ? row.next().getString() : "";
}

Result<std::vector<ArrayInfo>> RunReader::arrayInfos() const {
  return answered(name_, [&] {
    std::vector<ArrayInfo> infos;
    forEachRow<RecordedArrayInfo>(
        database_, "", [&](const RecordedArrayInfo& row) { infos.push_back(fromRow(row)); });
    return infos;
  });
}

Result<std::map<std::string, std::string>> RunReader::meta() const {
  return answered(name_, [&] {
    std::map<std::string, std::string> facts;
    Statement rows(database_, "SELECT \"key\", \"value\" FROM \"run\"");
    while (rows.step()) {
      const std::string key = rows.next().getString();
      facts[key] = rows.next().getString();
    }
    return facts;
  });
}

Result<std::map<std::string, std::vector<std::int64_t>>> RunReader::timing() const {
  return answered(name_, [&] {
    std::map<std::string, std::vector<std::int64_t>> durations;
    forEachRow<RecordedTiming>(database_, "", [&](const RecordedTiming& row) {
      durations[row.stage].push_back(row.duration_ns);
    });
    return durations;
  });
}

}  // namespace tolman::record
