// SPDX-License-Identifier: BSD-3-Clause
#include "app/exit_code.hpp"

#include "engine/run.hpp"

namespace tolman::app {

ExitCode exitCode(run::FailureKind kind) {
  constexpr std::array kCodes = {ExitCode::Configuration, ExitCode::Plugin,     ExitCode::Dataset,
                                 ExitCode::PluginFailed,  ExitCode::Record,     ExitCode::Session,
                                 ExitCode::Internal,      ExitCode::Interrupted};
  static_assert(kCodes.size() == run::kFailureKindNames.size());
  return kCodes.at(static_cast<std::size_t>(kind));
}

ExitCode exitCode(const run::Outcome& outcome) {
  if (outcome.failure) return exitCode(outcome.failure->kind);
  if (outcome.interrupted) return ExitCode::Interrupted;
  const pipeline::RunCounters& n = outcome.counters;
  return n.lost_at_end || n.neverTracked() ? ExitCode::TrackingLost : ExitCode::Ok;
}

}  // namespace tolman::app
