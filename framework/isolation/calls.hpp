// SPDX-License-Identifier: BSD-3-Clause
// What the host and the process of a stage say to each other.
#pragma once

#include <cstdint>

namespace tolman::isolation {

/// From the host; each gets one reply.
enum class Call : std::uint32_t {
  Load = 1,
  Create,
  Configure,
  OpenArtefacts,
  Reset,
  Destroy,
  Arrays,
  Save,
  Restore,
  Info,
  Next,
  Inspect,
  Track,
  FinishOdometry,
  Input,
  Observe,
  FinishPlace,
  Step,
  FinishCells,
  Update,
  PoseOf,
  Graph,
  FinishMap,
  Begin,
  Watch,
  FinishObserver,
};

/// To the host.
enum class Word : std::uint32_t {
  Reply = 1,  ///< a status and the answers, in the buffer
  Log,        ///< a line; any number, at any time
};

}  // namespace tolman::isolation
