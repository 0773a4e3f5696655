// SPDX-License-Identifier: BSD-3-Clause
// Artefacts of one stage, in the host and in the process of an isolated stage.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "tolman/context.hpp"

namespace tolman::host {

/// Writing fails until the run directory exists. It is created after configure(), when all checks
/// have passed.
class StageArtefacts : public ArtefactWriter {
 public:
  std::unique_ptr<ArtefactWriter> folder;

  Status write(std::string_view name, std::span<const std::byte> bytes) override {
    if (folder) return folder->write(name, bytes);
    return Status::failed("there is no run directory yet; write artefacts after configure()");
  }
};

}  // namespace tolman::host
