// SPDX-License-Identifier: BSD-3-Clause
// The values of a context that are sent to the process of a plugin. Its services (log, artefacts,
// cancellation) are created in that process.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>

#include "host/codec.hpp"
#include "tolman/context.hpp"

namespace tolman::isolation {

struct ContextMessage {
  ParameterValues parameters;
  CameraRig rig;
  std::uint64_t seed = 0;
  std::string instance;
  bool interactive = false;
  bool quiet = false;

  static ContextMessage of(const Context& context) {
    return {context.parameters, context.rig,         context.seed,
            context.instance,   context.interactive, context.quiet};
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
requires std::same_as<std::remove_const_t<T>, ContextMessage>
auto parts(T& m) {
  return std::tie(m.parameters, m.rig, m.seed, m.instance, m.interactive, m.quiet);
}
template <class T>
requires std::same_as<std::remove_const_t<T>, LoadMessage>
auto parts(T& m) { return std::tie(m.file, m.id, m.program, m.memory_mib, m.threads); }

}  // namespace tolman::isolation
