// SPDX-License-Identifier: BSD-3-Clause
// The calls from the host to the process of a plugin, and its replies.
#pragma once

#include <cstdint>

namespace tolman::isolation {

/// Calls from the host. Each call gets one reply.
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
  Describe,
  Url,
  RawRig,
};

/// Messages from the process.
enum class ReplyKind : std::uint32_t {
  Reply = 1,  ///< to a call: status and results in the shared buffer
  Log,        ///< one log line; at any time
  Finding,    ///< one finding; at any time
};

}  // namespace tolman::isolation
