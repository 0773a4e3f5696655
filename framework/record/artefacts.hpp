// SPDX-License-Identifier: BSD-3-Clause
// The artefacts folder of one plugin instance.
#pragma once

#include <filesystem>
#include <string>

#include "tolman/context.hpp"

namespace tolman::record {

/// Writes below <run>/artefacts/<instance>/ only: names with "..", absolute names and
/// symbolic links on the way are refused.
class ArtefactFolder : public ArtefactWriter {
 public:
  ArtefactFolder(std::filesystem::path run_directory, std::string instance);
  Status write(std::string_view name, std::span<const std::byte> bytes) override;

 private:
  std::filesystem::path run_directory_;
  std::string instance_;
};

}  // namespace tolman::record
