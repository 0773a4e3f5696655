// SPDX-License-Identifier: BSD-3-Clause
// Why a plugin was not opened.
#pragma once

#include <string>
#include <variant>

namespace tolman::host {

/// Id of a refusal for want of processes or threads, which says nothing about the plugin.
inline constexpr const char* kNoProcess = "plugin/no-process";

/// The ids are listed with their remedies in docs/errors.md.
struct Refusal {
  std::string id;       ///< e.g. "plugin/fingerprint"
  std::string message;  ///< what was expected, where, and what was found
  std::string remedy;   ///< what to do

  std::string text() const { return "[" + id + "] " + message + "\n  remedy: " + remedy; }
};

/// A value or a refusal.
template <class T>
using OrRefusal = std::variant<T, Refusal>;

}  // namespace tolman::host
