// SPDX-License-Identifier: BSD-3-Clause
// What of a plugin's context crosses to its process: the values; the services are made there.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>

#include "isolation/codec.hpp"
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

/// What a process is to open, and within which bounds.
struct LoadMessage {
  std::string file;
  std::string id;
  std::uint64_t memory_mib = 0;  ///< 0 for no limit
  std::int64_t threads = 0;      ///< 0 for all
};

/// Why not; without an id, nothing is the matter.
struct RefusalMessage {
  std::string id;
  std::string message;
  std::string remedy;
};

template <class T>
requires std::same_as<std::remove_const_t<T>, ContextMessage>
auto parts(T& m) {
  return std::tie(m.parameters, m.rig, m.seed, m.instance, m.interactive, m.quiet);
}
template <class T>
requires std::same_as<std::remove_const_t<T>, LoadMessage>
auto parts(T& m) { return std::tie(m.file, m.id, m.memory_mib, m.threads); }
template <class T>
requires std::same_as<std::remove_const_t<T>, RefusalMessage>
auto parts(T& m) { return std::tie(m.id, m.message, m.remedy); }

}  // namespace tolman::isolation
