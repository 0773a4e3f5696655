// SPDX-License-Identifier: BSD-3-Clause
// A failure of a run as data: its kind, its stage, and the message for a person. The command line
// derives its exit codes from the kind (docs/errors.md).
#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/guard.hpp"
#include "host/manifest.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

enum class FailureKind : std::uint8_t {
  Configuration,  ///< a file, an override or a parameter is wrong
  Plugin,         ///< a plugin cannot be loaded, created or configured
  Dataset,        ///< the data of the source are missing, damaged or inconsistent
  Stage,          ///< a plugin failed during the run
  Record,         ///< the run directory, the record in it or a temporary file cannot be written
  Continuation,   ///< the map of an earlier run cannot be continued
  Machine,        ///< no process or thread can be started, or memory is short
  Interrupted,    ///< cancelled while the plugins were configured
};
inline constexpr std::array<std::string_view, 8> kFailureKindNames = {
    "configuration", "plugin",       "dataset", "stage",
    "record",        "continuation", "machine", "interrupted"};
constexpr std::span<const std::string_view> enumNames(FailureKind) { return kFailureKindNames; }

/// It is thrown up to the boundary of the program, Run::execute() or the end of a command, and kept
/// in the outcome of a run.
struct Failure : std::exception {
  Failure(FailureKind k, std::string text, std::string where = {})  // NOLINT: implicit
      : kind(k), message(std::move(text)), stage(std::move(where)) {}
  const char* what() const noexcept override { return message.c_str(); }

  FailureKind kind;
  std::string message;
  std::string stage;  ///< its name in the configuration; empty when no stage is concerned
};

inline FailureKind kindOf(const host::Refusal& refusal) {
  const bool is_short = host::isOutOfMemory(Status::failed(refusal.message));
  return refusal.id == host::kNoProcess || is_short ? FailureKind::Machine : FailureKind::Plugin;
}

/// The kind of a plugin's failed call: `usual`, unless memory or a folder for temporary files was
/// lacking. Messages on that folder name TMPDIR, the variable that chooses it.
inline FailureKind kindOf(const Status& status, FailureKind usual) {
  if (host::isOutOfMemory(status)) return FailureKind::Machine;
  const bool no_folder = status.message().find("TMPDIR") != std::string::npos;
  return no_folder ? FailureKind::Record : usual;
}

[[noreturn]] inline void refuseToContinue(const std::string& message) {
  throw Failure(FailureKind::Continuation, message);
}

// Each returns the value, or throws Failure where there is none.
inline void require(const Status& status, FailureKind kind, const std::string& stage = {}) {
  if (!status.isOk()) throw Failure(kindOf(status, kind), status.message(), stage);
}
template <class T>
T require(Result<T> result, FailureKind kind) {
  require(result.status(), kind);
  return std::move(result).value();
}
/// Calls `work`, which opens plugins; the refusal of one becomes a failure of `stage`.
template <class Work>
auto opening(const Work& work, const std::string& stage = {}) {
  try {
    return work();
  } catch (const host::Refusal& refusal) {
    throw Failure(kindOf(refusal), refusal.text(), stage);
  }
}

}  // namespace tolman::engine
