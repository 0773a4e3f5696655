// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_directory.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <system_error>

#include "config/json_text.hpp"
#include "config/paths.hpp"
#include "record/export.hpp"
#include "record/regular_file.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOther = "choose another --out";

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
fs::path makeNamed(const RunDirectoryOptions& options) {
  fs::create_directories(options.root);
  const std::string name = folderName(options);
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

}  // namespace

Result<RunDirectory> RunDirectory::create(const RunDirectoryOptions& options) {
  try {
    if (options.out) {
      fs::create_directories(*options.out);
      Result<RunDirectory> directory = lock(fs::canonical(*options.out), kOther);
      if (!directory.isOk()) return directory;
      const Status cleared = directory.value().clear(options.replace);
      if (!cleared.isOk()) return cleared;
      return directory;
    }
    const fs::path path = fs::canonical(makeNamed(options));
    pointLatestAt(path);
    return lock(path, kOther);
  } catch (const fs::filesystem_error& error) {
    return Status::failed(error.path1().string() + ": cannot be made a run directory (" +
                          error.code().message() + "); choose another with --out");
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
    return Status::failed(path.string() + ": another run is writing here; " + remedy);
  }
  return RunDirectory(path, std::move(descriptor));
}

Status RunDirectory::mayTakeFilesOf(const fs::path& run, const fs::path& folder) {
  std::error_code ignored;
  const bool holds_run =
      fs::exists(folder / "run.sqlite", ignored) || fs::exists(folder / "run.json", ignored);
  if (!holds_run || fs::equivalent(run, folder, ignored)) return Status::ok();
  return Status::failed(folder.string() + ": holds another run; " + kOther);
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
  std::ifstream file = openRegular(path / "run.json");
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

/// Removes the files of an earlier run by their names; other files are kept.
Status RunDirectory::clear(bool replace) const {
  if (fs::is_empty(path_)) return Status::ok();
  if (!fs::exists(path_ / "run.sqlite") && !fs::exists(path_ / "run.json")) {
    return Status::failed(path_.string() +
                          ": is not empty and holds no run; choose an empty or new directory");
  }
  if (!replace) {
    return Status::failed(path_.string() +
                          ": holds a run; choose another --out, or give --force to replace it");
  }
  for (const char* file : {"run.sqlite", "run.sqlite-wal", "run.sqlite-shm", "run.sqlite-journal",
                           "run.json", "config.resolved.yaml", "log.txt", "answers.bin"}) {
    fs::remove(path_ / file);
  }
  for (const char* folder : {"artefacts", "state"}) fs::remove_all(path_ / folder);
  return removeDerived();
}

Status RunDirectory::removeDerived() const {
  std::vector<fs::path> derived(kExportedFiles.begin(), kExportedFiles.end());
  for (const char* name : {"metrics.json", "report.html", "results.sha256", "map.svg", "run.npz",
                           "run.nwb", "figures"}) {
    derived.emplace_back(name);
  }
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path_, error)) {
    const fs::path name = entry.path().filename();
    if (name.string().starts_with("session-") && entry.is_directory(error)) derived.push_back(name);
  }
  for (const fs::path& name : derived) {
    if (!error) fs::remove_all(path_ / name, error);
  }
  return error ? Status::failed(path_.string() + ": " + error.message()) : Status::ok();
}

Status RunDirectory::writeRunFile(nlohmann::ordered_json provenance, RunState state) const {
  provenance["status"] = enumName(state);
  const std::string text = config::jsonText(provenance, 2);
  const fs::path held = "/proc/self/fd/" + std::to_string(lock_.number());
  return writeAtomically((stillInPlace().isOk() ? path_ : held) / "run.json", text + "\n");
}

}  // namespace tolman::record
