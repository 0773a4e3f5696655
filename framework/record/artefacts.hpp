// SPDX-License-Identifier: BSD-3-Clause
// The artefacts folder of one plugin instance.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "tolman/context.hpp"

namespace tolman::record {

/// Writes below <run>/artefacts/<instance>/ only: names with "..", absolute names and
/// symbolic links on the way are refused. Each name is added to kArtefactList first, so that
/// `run --force` can tell artefacts from other files.
class ArtefactFolder : public ArtefactWriter {
 public:
  ArtefactFolder(std::filesystem::path run_directory, std::string instance);
  Status write(std::string_view name, std::span<const std::byte> bytes) override;

 private:
  std::filesystem::path run_directory_;
  std::string instance_;
  std::set<std::string> listed_;  ///< names that are in the list already
};

}  // namespace tolman::record
