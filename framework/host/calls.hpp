// SPDX-License-Identifier: BSD-3-Clause
// The calls from the host to the process of a plugin, and its replies.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>

#include "host/manifest.hpp"
#include "tolman/context.hpp"

namespace tolman::host {

/// Messages from the host. Each call gets one reply.
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
  Cancel,  ///< at any time, without a reply
};

/// Messages from the process.
enum class ReplyKind : std::uint32_t {
  Reply = 1,  ///< to a call: status and results
  Log,        ///< one log line; at any time
  Finding,    ///< one finding; at any time
};

// The values of a context that are sent to the process of a plugin, whose services (log, findings,
// artefacts, cancellation) are created in that process.

struct ContextMessage {
  ParameterValues parameters;
  CameraRig rig;
  std::uint64_t seed = 0;
  std::string instance;

  static ContextMessage of(const Context& context) {
    return {context.parameters, context.rig, context.seed, context.instance};
  }
};

/// Which plugin a process opens, and its limits.
struct LoadMessage {
  std::string file;
  std::string id;
  std::string program;           ///< program of an interpreter; empty for other plugins
  std::uint64_t memory_mib = 0;  ///< 0 for no limit
  std::int64_t threads = 0;      ///< 0 for one per processor
};

template <class T>
requires std::same_as<std::remove_const_t<T>, Refusal>
auto parts(T& refusal) { return std::tie(refusal.id, refusal.message, refusal.remedy); }
template <class T>
requires std::same_as<std::remove_const_t<T>, ContextMessage>
auto parts(T& m) { return std::tie(m.parameters, m.rig, m.seed, m.instance); }
template <class T>
requires std::same_as<std::remove_const_t<T>, LoadMessage>
auto parts(T& m) { return std::tie(m.file, m.id, m.program, m.memory_mib, m.threads); }

}  // namespace tolman::host
