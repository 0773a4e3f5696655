// SPDX-License-Identifier: BSD-3-Clause
#include "record/digest.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "base/sqlite.hpp"
#include "record/atomic_file.hpp"
#include "record/export.hpp"
#include "record/run_directory.hpp"

namespace tolman::record {

namespace {

namespace fs = std::filesystem;

void check(int success) {
  if (success != 1) throw std::runtime_error("libcrypto cannot compute SHA-256");
}

/// Without a handler of exit(): when a plugin calls it, other threads still compute digests.
evp_md_ctx_st* newContext() {
  check(OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr));
  return EVP_MD_CTX_new();
}

constexpr const char* kRecordName = "run.sqlite";
using Digests = std::map<std::string, std::string>;

/// Those that run.json has.
Digests ownDigests(const fs::path& run_directory) {
  const auto json = RunDirectory::readRunFile(run_directory);
  Digests digests;
  for (const auto& [file, key] :
       {std::pair("config.resolved.yaml", kConfigDigest), std::pair(kRecordName, kRecordDigest)}) {
    const auto digest = json.find(key);  // end() also if it is no object
    if (digest != json.end() && digest->is_string()) digests[file] = digest->get<std::string>();
  }
  return digests;
}

/// A log that a run leaves when it ends is empty: another one is of an earlier state, and SQLite
/// would read it.
bool hasLog(const fs::path& run_directory) {
  std::error_code error;
  const auto size = fs::file_size(run_directory / "run.sqlite-wal", error);
  return !error && size > 0;
}

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* context) const { EVP_MD_CTX_free(context); }

Sha256::Sha256() : context_(newContext()) {
  check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Sha256::add(std::span<const std::byte> bytes) {
  check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::digest() {
  std::array<unsigned char, 32> bytes{};
  check(EVP_DigestFinal_ex(context_.get(), bytes.data(), nullptr));
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

std::string textDigest(std::string_view text) {
  Sha256 sha;
  sha.add(text);
  return sha.digest();
}

Result<std::string> fileDigest(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Sha256 sha;
  std::array<char, 65536> buffer{};
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    sha.add(std::string_view(buffer.data(), static_cast<std::size_t>(stream.gcount())));
  }
  if (!stream.eof()) return Status::invalidInput(file.string() + ": cannot be read");
  return sha.digest();
}

Status writeResultsDigest(const fs::path& run_directory) {
  std::string text;
  for (const std::string_view file : kExportedFiles) {
    if (!fs::exists(run_directory / file)) continue;
    const Result<std::string> digest = fileDigest(run_directory / file);
    if (!digest.isOk()) return digest.status();
    text += digest.value() + "  " + std::string(file) + "\n";
  }
  return writeAtomically(run_directory / "results.sha256", text);
}

std::map<std::string, std::string> resultsDigests(const fs::path& run_directory) {
  std::map<std::string, std::string> digests;
  std::ifstream stream(run_directory / "results.sha256");
  for (std::string digest, file; stream >> digest >> file;) digests[file] = digest;
  return digests;
}

Result<std::string> recordDigest(const fs::path& run_directory) {
  if (hasLog(run_directory)) return std::string();
  return fileDigest(run_directory / kRecordName);
}

Status verify(const fs::path& run_directory) {
  if (RunDirectory::isBeingWritten(run_directory)) return Status::ok();
  const Digests digests = ownDigests(run_directory);
  std::string changed;
  for (const auto& [file, digest] : digests) {
    std::error_code ignored;  // an archive has the digests without the files
    if (!fs::exists(run_directory / file, ignored)) continue;
    const Result<std::string> found = fileDigest(run_directory / file);
    if (!found.isOk() || found.value() != digest) changed = file;
  }
  if (digests.contains(kRecordName) && hasLog(run_directory)) changed = "run.sqlite-wal";
  if (!changed.empty()) {
    return Status::invalidInput((run_directory / changed).string() +
                                ": is not what the run wrote: changed, damaged or of another run "
                                "since; put the file back, or run it again");
  }
  const fs::path file = run_directory / kRecordName;
  if (!RunDirectory::wasKilled(run_directory) || !fs::exists(file)) return Status::ok();
  return guarded(file.string(), [&] {
    const Database database = openDatabase(file, Access::ReadOnly);
    Statement row(database, "PRAGMA quick_check(1)");
    if (row.step() && row.next().getString() != "ok")
      throw std::domain_error("is damaged; run it again");
  });
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 1'000'000;

struct DataFile {
  std::string name;  ///< relative to the path that was given; empty for a single file
  fs::path path;
  struct stat status {};

  /// Name, device, inode, size and time of modification, as one line.
  std::string stamp() const {
    return fmt::format("{}\n{} {} {} {} {}\n", name, status.st_dev, status.st_ino, status.st_size,
                       status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
  }
};

void add(std::vector<DataFile>& files, const fs::path& path, const fs::path& root) {
  DataFile file{path == root ? "" : path.lexically_relative(root).string(), path, {}};
  if (::stat(path.c_str(), &file.status) != 0 || !S_ISREG(file.status.st_mode)) return;
  files.push_back(std::move(file));
  if (files.size() > kMaxFiles) {
    throw fs::filesystem_error("walk", root, std::make_error_code(std::errc::file_too_large));
  }
}

bool isRun(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "run.json", ignored);
}

/// By name. Throws fs::filesystem_error.
std::vector<DataFile> dataFiles(const fs::path& root) {
  std::vector<DataFile> files;
  if (!fs::is_directory(root)) {
    add(files, root, root);
    return files;
  }
  const bool is_run = isRun(root);
  for (fs::recursive_directory_iterator at(root, fs::directory_options::follow_directory_symlink);
       at != fs::recursive_directory_iterator(); ++at) {
    const fs::path& path = at->path();
    std::error_code ignored;
    const bool leads_back = at->is_symlink(ignored) && isInside(path.parent_path(), path);
    if (at->is_directory(ignored) && (isRun(path) || leads_back)) at.disable_recursion_pending();
    const std::string name = path.lexically_relative(root).string();
    if (is_run && name != "run.sqlite" && !name.starts_with("state/")) continue;
    add(files, path, root);
  }
  std::ranges::sort(files, {}, &DataFile::name);
  return files;
}

}  // namespace

Result<DataDigest> digestData(const fs::path& path, const DataDigest& known, std::int64_t most) {
  std::vector<DataFile> files;
  try {
    files = dataFiles(path);
  } catch (const fs::filesystem_error& error) {
    if (error.code() == std::errc::file_too_large) {
      return Status::invalidInput(fmt::format(
          "{}: more than {} files; name the folder of one recording", path.string(), kMaxFiles));
    }
    return Status::invalidInput(error.path1().string() + ": " + error.code().message());
  }
  DataDigest digest;
  digest.path = path.string();
  digest.files = static_cast<std::int64_t>(files.size());
  Sha256 stamp;
  for (const DataFile& file : files) {
    digest.bytes += file.status.st_size;
    stamp.add(file.stamp());
  }
  digest.stamp = stamp.digest();
  if (known.path == digest.path && known.stamp == digest.stamp) return known;
  if (digest.bytes > most) return digest;
  Sha256 contents;
  for (const DataFile& file : files) {
    const auto one = fileDigest(file.path);
    if (!one.isOk()) return one.status();
    contents.add(one.value() + "  " + file.name + "\n");
  }
  digest.sha256 = contents.digest();
  return digest;
}

}  // namespace tolman::record
