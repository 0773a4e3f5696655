// SPDX-License-Identifier: BSD-3-Clause
// Artefacts of one stage, in the host and in the process of an isolated stage.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "tolman/context.hpp"

namespace tolman::host {

/// The run directory is made after configure(), when all checks have passed; before that, writing
/// fails.
class StageArtefacts : public ArtefactWriter {
 public:
  std::unique_ptr<ArtefactWriter> folder;

  Status write(std::string_view name, std::span<const std::byte> bytes) override {
    if (folder) return folder->write(name, bytes);
    return Status::failed("there is no run directory yet; write artefacts after configure()");
  }
};

}  // namespace tolman::host
