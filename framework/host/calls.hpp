// SPDX-License-Identifier: BSD-3-Clause
// The calls from the host to the process of a plugin, and its replies.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>

#include "base/codec.hpp"
#include "host/channel.hpp"
#include "host/manifest.hpp"
#include "tolman/context.hpp"

namespace tolman::host {

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

// The values of a context that are sent to the process of a plugin, whose services (log, findings,
// artefacts, cancellation) are created in that process; and findings that it sends back.

struct ContextMessage {
  ParameterValues parameters;
  CameraRig rig;
  std::uint64_t seed = 0;
  std::string instance;

  static ContextMessage of(const Context& context) {
    return {context.parameters, context.rig, context.seed, context.instance};
  }
};

/// A finding as the text of a message, and back; std::nullopt for another text.
inline std::string textOf(const Finding& finding) {
  std::string text{static_cast<char>(finding.severity), static_cast<char>(finding.kind)};
  for (const std::string* part : {&finding.where, &finding.message, &finding.remedy}) {
    text += part->substr(0, kMaxText / 4) + '\0';
  }
  return text;
}
inline std::optional<Finding> findingOf(const std::string& text) {
  Finding finding;
  if (text.size() < 2) return std::nullopt;
  finding.severity = static_cast<Finding::Severity>(text[0]);
  finding.kind = static_cast<Finding::Kind>(text[1]);
  if (finding.severity > Finding::Severity::Error || finding.kind > Finding::Kind::Contradiction) {
    return std::nullopt;
  }
  std::size_t begin = 2;
  for (std::string* part : {&finding.where, &finding.message, &finding.remedy}) {
    const std::size_t end = text.find('\0', begin);
    if (end == std::string::npos) return std::nullopt;
    *part = text.substr(begin, end - begin);
    begin = end + 1;
  }
  return finding;
}

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
