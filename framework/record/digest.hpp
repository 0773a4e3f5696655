// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 digests, as sha256sum prints them; computed by OpenSSL's libcrypto. And whether the files
// of a run are those that it wrote: run.json, its last file, has the digests of run.sqlite and
// config.resolved.yaml, and results.sha256 those of the results, to compare runs byte by byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "tolman/status.hpp"

struct evp_md_ctx_st;  // EVP_MD_CTX of <openssl/evp.h>

namespace tolman::record {

class Sha256 {
 public:
  Sha256();
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text.data(), text.size()))); }
  /// 64 hexadecimal digits of all bytes added; nothing may be added afterwards.
  std::string digest();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_;
};

/// SHA-256 of a text or of the bytes of a file.
std::string textDigest(std::string_view text);
Result<std::string> fileDigest(const std::filesystem::path& file);

/// Keys of run.json.
inline constexpr const char* kConfigDigest = "config_sha256";
inline constexpr const char* kRecordDigest = "record_sha256";

/// Writes results.sha256: digests of the exported files that exist, in the format of `sha256sum
/// -c`.
Status writeResultsDigest(const std::filesystem::path& run_directory);

/// Digests that results.sha256 lists, by file; empty where there is none.
std::map<std::string, std::string> resultsDigests(const std::filesystem::path& run_directory);

/// The digest of run.sqlite of a run that ends; empty if a reader has kept rows in its log.
Result<std::string> recordDigest(const std::filesystem::path& run_directory);

/// InvalidInput where run.sqlite or config.resolved.yaml is not what the run wrote. A run that was
/// killed has no digest of run.sqlite: then SQLite checks it. Ok while the run goes on.
Status verify(const std::filesystem::path& run_directory);

// The files that a run reads, their digests, and whether they are still the same.

struct DataDigest {
  std::string path;
  std::int64_t files = 0;
  std::int64_t bytes = 0;
  std::string stamp;   ///< SHA-256 of names, inodes, sizes and modification times of all files
  std::string sha256;  ///< SHA-256 of names and contents of all files; empty above the limit
};

/// The digest of a file, or of all regular files below a folder. Of a run directory only the files
/// that a later run reads: run.sqlite and the state; run directories further below are left out,
/// because they are results, and not part of the data beside them. Links are followed, but not to a
/// folder that contains them. Contents are not read if `known` has the same path and stamp (then
/// `known` is returned), or if there are more than `most` bytes. InvalidInput if something cannot
/// be read, or for more than a million files.
Result<DataDigest> digestData(const std::filesystem::path& path, const DataDigest& known = {},
                              std::int64_t most = std::int64_t{64} << 30U);

}  // namespace tolman::record
