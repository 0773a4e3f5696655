// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_directory.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <fstream>
#include <system_error>
#include <vector>

#include "config/json_text.hpp"
#include "config/values.hpp"
#include "record/export.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOther = "choose another --out";
constexpr const char* kBusy = ": another run is writing here; ";

constexpr std::array kRecordFiles = {
    "figures",        "artefacts",          "state",    "run.sqlite", "run.sqlite-wal",
    "run.sqlite-shm", "run.sqlite-journal", "run.json", "log.txt",    "config.resolved.yaml"};
constexpr std::array kDerivedFiles = {"metrics.json", "report.html", "results.sha256", "map.svg",
                                      "run.npz",      "run.nwb",     "figures"};

/// The name without the affixes of writeAtomically(): a killed program leaves its temporary files.
std::string finalName(const std::string& name) {
  const std::size_t partial = name.rfind(".partial");
  const bool is_temporary = name.starts_with('.') && partial != std::string::npos && partial > 0;
  return is_temporary ? name.substr(1, partial - 1) : name;
}

/// Removes files, and folders with all that is in them; keeps the first failure.
template <class Names>
void removeAll(const fs::path& directory, const Names& names, Status& status) {
  for (const auto& name : names) {
    std::error_code error;
    if (status.isOk()) fs::remove_all(directory / name, error);
    if (error) status = Status::failed((directory / name).string() + ": " + error.message());
  }
}

/// Temporary files of a killed program in this folder, and the folders of earlier sessions.
std::vector<fs::path> remainsIn(const fs::path& directory) {
  std::vector<fs::path> remains;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (finalName(name) != name) remains.push_back(entry.path());
    if (name.starts_with("session-") && entry.is_directory(error)) remains.push_back(entry.path());
  }
  return remains;
}

Status removeDerivedFiles(const fs::path& directory) {
  Status status;
  removeAll(directory, kExportedFiles, status);
  removeAll(directory, kDerivedFiles, status);
  for (const fs::path& remains : remainsIn(directory)) {
    std::error_code kept;  // a folder in which the user has files
    if (fs::is_directory(remains)) removeAll(remains, kExportedFiles, status);
    if (status.isOk()) fs::remove(remains, kept);
  }
  return status;
}

/// The same for all files of a run, including record, log, states and artefacts.
Status removeRunFiles(const fs::path& directory) {
  Status status = removeDerivedFiles(directory);
  removeAll(directory, kRecordFiles, status);
  return status;
}

/// The folder name for a run: without separators, not hidden.
std::string folderName(const RunDirectoryOptions& options) {
  std::string name;
  for (const char c : options.name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += plain || c == '-' || c == '_' || (c == '.' && !name.empty()) ? c : '_';
  }
  if (name.empty()) name = "run";
  return fmt::format("{}-{:%Y%m%dT%H%M%SZ}", name, fmt::gmtime(std::time_t{options.utc_seconds}));
}

/// Creates a new folder; two runs in the same second get different ones.
fs::path makeNamed(const RunDirectoryOptions& options, const std::string& name) {
  fs::create_directories(options.root);
  fs::path path = options.root / name;
  for (int i = 2; !fs::create_directory(path); ++i) {
    path = options.root / (name + "-" + std::to_string(i));
  }
  return path;
}

/// Replaces the link `latest` atomically. A file or folder of this name is kept.
void pointLatestAt(const fs::path& path) {
  const fs::path link = path.parent_path() / "latest";
  const fs::path temporary = path.parent_path() / (".latest-" + path.filename().string());
  std::error_code ignored;  // the link is a convenience: a run does not fail without it
  if (fs::exists(fs::symlink_status(link, ignored)) && !fs::is_symlink(link, ignored)) return;
  fs::remove(temporary, ignored);
  fs::create_directory_symlink(path.filename(), temporary, ignored);
  fs::rename(temporary, link, ignored);
}

Status cannotBeMade(const fs::path& path, const std::error_code& why) {
  return Status::failed(path.string() + ": cannot be made a run directory (" + why.message() +
                        "); choose another with --out");
}

/// Failed if the path lies in the directory of a run, at any depth.
Status refuseInsideRun(const fs::path& path) {
  for (fs::path outer = truePath(path).parent_path(); outer.has_relative_path();
       outer = outer.parent_path()) {
    if (!holdsRun(outer)) continue;
    return Status::failed(path.string() + ": lies in the directory of the run " + outer.string() +
                          ", whose files belong to that run alone; choose another --out");
  }
  return Status::ok();
}

/// Ok for an empty folder, and with `replace` for that of an earlier run.
Status mayReplace(const fs::path& path, bool replace) {
  std::error_code error;
  if (fs::is_empty(path, error)) return Status::ok();
  if (!holdsRun(path)) {
    return Status::failed(path.string() +
                          ": is not empty and holds no run; choose an empty or new directory");
  }
  if (!replace) {
    return Status::failed(path.string() +
                          ": holds a run; choose another --out, or give --force to replace it");
  }
  return Status::ok();
}

}  // namespace

Result<RunDirectory> RunDirectory::create(const RunDirectoryOptions& options) {
  try {
    if (options.out) {
      if (Status own = refuseInsideRun(*options.out); !own.isOk()) return own;
      fs::create_directories(*options.out);
      const fs::path out = fs::canonical(*options.out);
      Result<RunDirectory> directory = lock(out, kOther);
      if (!directory.isOk()) return directory;
      Status status = mayReplace(out, options.replace);
      if (status.isOk()) status = removeRunFiles(out);
      if (!status.isOk()) return status;
      return directory;
    }
    const std::string name = folderName(options);
    const fs::path named = options.root / name;
    if (Status own = refuseInsideRun(named); !own.isOk()) return own;
    const fs::path path = fs::canonical(makeNamed(options, name));
    pointLatestAt(path);
    return lock(path, kOther);
  } catch (const fs::filesystem_error& error) {
    return cannotBeMade(error.path1(), error.code());
  }
}

Result<RunDirectory> RunDirectory::reopen(const fs::path& path) {
  std::error_code error;
  const fs::path directory = fs::canonical(path, error);
  if (error) return Status::failed(path.string() + ": " + error.message());
  Result<RunDirectory> locked = lock(directory, "wait until it has ended");
  if (!locked.isOk()) return locked;
  for (const fs::path& written : {directory, directory / "run.sqlite", directory / "log.txt"}) {
    if (::access(written.c_str(), W_OK) == 0 || errno == ENOENT) continue;
    return Status::failed(
        written.string() + ": is read-only for this user (" +
        std::generic_category().message(errno) +
        "), and a run goes on in its own directory; make it writable, or resume a "
        "copy: cp -r " +
        path.string() + " COPY; tolman run --resume COPY");
  }
  return locked;
}

Result<RunDirectory> RunDirectory::lock(const fs::path& path, const std::string& remedy) {
  FileDescriptor descriptor = lockFolder(path);
  if (!descriptor.isOpen() && ::access(path.c_str(), R_OK | W_OK | X_OK) != 0) {
    return Status::failed(path.string() + ": " + std::generic_category().message(errno) +
                          "; look at its permissions and at the umask");
  }
  if (!descriptor.isOpen()) {
    return Status::failed(path.string() + kBusy + remedy);
  }
  return RunDirectory(path, std::move(descriptor));
}

Status RunDirectory::stillInPlace() const {
  struct stat held {};
  struct stat named {};
  if (::fstat(lock_.number(), &held) == 0 && ::stat(path_.c_str(), &named) == 0 &&
      held.st_dev == named.st_dev && held.st_ino == named.st_ino) {
    return Status::ok();
  }
  return Status::failed(path_.string() +
                        ": this run directory was moved, removed or replaced while the run was "
                        "going; where it is now it has the frames until then, for `tolman export`");
}

bool RunDirectory::isBeingWritten(const std::filesystem::path& path) {
  const FileDescriptor descriptor(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return descriptor.isOpen() && ::flock(descriptor.number(), LOCK_SH | LOCK_NB) != 0;
}

nlohmann::ordered_json RunDirectory::readRunFile(const std::filesystem::path& path) {
  std::ifstream file(path / "run.json");
  auto json = nlohmann::ordered_json::parse(file, nullptr, false);
  return json.is_discarded() ? nullptr : json;
}

Status RunDirectory::checkRunFile(const std::filesystem::path& path) {
  const auto json = readRunFile(path);
  if (json.is_object() && json.contains("status")) return Status::ok();
  const std::string why = config::absence(path / "run.json", "is missing or damaged");
  return Status::invalidInput((path / "run.json").string() + ": " + why +
                              ", so how the run ended, its health and its plugins are not known");
}

bool RunDirectory::wasKilled(const std::filesystem::path& path) {
  const auto json = readRunFile(path);
  const auto status = json.find("status");  // end() also if it is not an object
  const bool running = status != json.end() && *status == enumName(RunState::Running);
  return running && !isBeingWritten(path);
}

bool RunDirectory::hasEnded(const std::filesystem::path& path) {
  const auto json = readRunFile(path);
  const auto status = json.find("status");
  if (status == json.end() || isBeingWritten(path)) return false;
  return *status == enumName(RunState::Finished) || *status == enumName(RunState::Interrupted);
}

Status RunDirectory::mayTake(const fs::path& path, bool replace) {
  if (Status own = refuseInsideRun(path); !own.isOk()) return own;
  std::error_code error;
  if (!fs::exists(path, error)) return Status::ok();
  if (!fs::is_directory(path, error)) {
    return cannotBeMade(path, std::make_error_code(std::errc::not_a_directory));
  }
  if (isBeingWritten(path)) return Status::failed(path.string() + kBusy + kOther);
  return mayReplace(path, replace);
}

Status RunDirectory::removeDerived() const { return removeDerivedFiles(path_); }

std::string RunDirectory::runFileText(nlohmann::ordered_json provenance, RunState state) {
  provenance["status"] = enumName(state);
  return config::jsonText(provenance, 2) + "\n";
}

Status RunDirectory::writeRunFile(const nlohmann::ordered_json& provenance, RunState state) const {
  const std::string folder = "/proc/self/fd/" + std::to_string(lock_.number());
  const Status status = writeAtomically(folder + "/run.json", runFileText(provenance, state));
  if (status.isOk()) return status;
  return Status::failed(path_.string() + status.message().substr(folder.size()));
}

bool holdsRun(const fs::path& directory) {
  std::error_code ignored;
  return fs::exists(directory / "run.sqlite", ignored) ||
         RunDirectory::checkRunFile(directory).isOk() ||
         (fs::exists(directory / "run.json", ignored) &&
          fs::exists(directory / "config.resolved.yaml", ignored));
}

}  // namespace tolman::record
