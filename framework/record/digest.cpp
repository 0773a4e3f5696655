// SPDX-License-Identifier: BSD-3-Clause
#include "record/digest.hpp"

#include <array>

#include "record/atomic_file.hpp"
#include "record/export.hpp"
#include "record/regular_file.hpp"
#include "record/sha256.hpp"

namespace tolman::record {

std::string textDigest(std::string_view text) {
  Sha256 sha;
  sha.add(text);
  return sha.digest();
}

Result<std::string> fileDigest(const std::filesystem::path& file) {
  std::ifstream stream = openRegular(file);
  if (!stream.is_open()) return Status::invalidInput(file.string() + ": cannot be read");
  Sha256 sha;
  std::array<char, 65536> buffer{};
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    sha.add(std::string_view(buffer.data(), static_cast<std::size_t>(stream.gcount())));
  }
  if (!stream.eof()) return Status::invalidInput(file.string() + ": cannot be read");
  return sha.digest();
}

Status writeResultsDigest(const std::filesystem::path& run_directory) {
  std::string text;
  for (const std::string_view file : kExportedFiles) {
    if (!std::filesystem::exists(run_directory / file)) continue;
    const Result<std::string> digest = fileDigest(run_directory / file);
    if (!digest.isOk()) return digest.status();
    text += digest.value() + "  " + std::string(file) + "\n";
  }
  return writeAtomically(run_directory / "results.sha256", text);
}

std::map<std::string, std::string> resultsDigests(const std::filesystem::path& run_directory) {
  std::map<std::string, std::string> digests;
  std::ifstream stream = openRegular(run_directory / "results.sha256");
  for (std::string digest, file; stream >> digest >> file;) digests[file] = digest;
  return digests;
}

std::set<std::string> changedResults(const std::filesystem::path& run_directory) {
  std::set<std::string> changed;
  for (const auto& [file, digest] : resultsDigests(run_directory)) {
    std::error_code ignored;
    if (!std::filesystem::exists(run_directory / file, ignored)) continue;
    const Result<std::string> found = fileDigest(run_directory / file);
    if (!found.isOk() || found.value() != digest) changed.insert(file);
  }
  return changed;
}

}  // namespace tolman::record
