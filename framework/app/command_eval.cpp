// SPDX-License-Identifier: BSD-3-Clause
// tolman eval: errors of a trajectory file against the truth.
#include <fmt/format.h>

#include <iostream>

#include "app/options.hpp"
#include "app/summary.hpp"
#include "config/text.hpp"
#include "evaluation/plausibility.hpp"
#include "evaluation/score.hpp"
#include "evaluation/trajectory_files.hpp"

namespace tolman::app {
namespace {

struct EvalOptions {
  std::string truth;
  std::string estimate;
  std::string alignment = "se3";
  double max_difference = -1;
};

void warn(const std::string& text, const Invocation& invocation) {
  if (!invocation.quiet) std::cerr << "warning: " + text + "\n";
}

/// Poses are matched by their order: refuses where the numbers of poses show that those of equal
/// number are of different times, warns where that may be so.
void checkOrder(const EvalOptions& options, const evaluation::Trajectory& truth,
                const evaluation::Trajectory& estimate, const Invocation& invocation) {
  const int with_stamps = evaluation::hasStamps(truth) + evaluation::hasStamps(estimate);
  if (with_stamps == 2) {
    warn(fmt::format("{}: its stamps and those of {} have no moment in common; the poses are "
                     "matched by their order",
                     options.estimate, options.truth),
         invocation);
  }
  if (truth.size() == estimate.size() || truth.size() < 2 || estimate.size() < 2) return;
  const std::string counts = fmt::format("{} has {} poses and {} has {}", options.estimate,
                                         estimate.size(), options.truth, truth.size());
  if (with_stamps == 1) {  // at another rate all errors would be wrong
    fail(ExitCode::Dataset,
         counts +
             ", and only one of them has times: which belong together is not known; give both "
             "with times (TUM) and --max-difference, or both as KITTI files that begin at the "
             "same frame");
  }
  warn(counts +
           ": pose N of one is compared with pose N of the other, so both must begin at the "
           "same frame and leave none out; truth with times (TUM) and --max-difference match by "
           "time",
       invocation);
}

void requireStamps(const std::string& file, const evaluation::Trajectory& trajectory) {
  if (evaluation::hasStamps(trajectory) || trajectory.size() < 2) return;  // one may be at 0 s
  fail(ExitCode::Usage,
       file +
           ": has no times, as all KITTI files; leave out --max-difference, and poses are "
           "matched by frame");
}

void evaluate(const EvalOptions& options, const Invocation& invocation) {
  const auto truth = valueOf(evaluation::readTrajectory(options.truth), ExitCode::Dataset);
  const auto estimate = valueOf(evaluation::readTrajectory(options.estimate), ExitCode::Dataset);
  std::int64_t difference_ns = evaluation::usualDifference(truth, estimate);
  if (options.max_difference >= 0) {
    requireStamps(options.truth, truth);
    requireStamps(options.estimate, estimate);
    difference_ns = static_cast<std::int64_t>(options.max_difference * 1e9);
  } else if (difference_ns < 0) {
    checkOrder(options, truth, estimate, invocation);
  }
  const auto alignment = *config::valueNamed<evaluation::Alignment>(options.alignment);
  auto metrics = evaluation::score(truth, estimate, alignment, std::nullopt, difference_ns);
  if (!metrics.scores) fail(ExitCode::Dataset, metrics.reason);
  metrics.warning =
      evaluation::doubtText(evaluation::doubts(truth, estimate, alignment, difference_ns));
  if (metrics.matched * 20 < std::min(truth.size(), estimate.size())) {
    warn(fmt::format("{}: only {} of {} poses have a true pose at their time; are both stamps in "
                     "seconds, and of one clock?",
                     options.estimate, metrics.matched, estimate.size()),
         invocation);
  }
  if (invocation.json) {
    std::cout << jsonText(evaluation::toJson(metrics));
  } else {
    std::cout << row("alignment", options.alignment) << trajectoryText("estimate", metrics);
  }
}

}  // namespace

void addEvalCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("eval", "Score a trajectory (TUM or KITTI file) against the truth");
  auto options = std::make_shared<EvalOptions>();
  addArgument(command, "truth", options->truth, "FILE", "True trajectory");
  addArgument(command, "estimate", options->estimate, "FILE", "Estimated trajectory");
  addChoice(command, "--align", options->alignment, {"none", "se2", "se3", "sim3"},
            "Alignment before the comparison (default: se3)");
  addOption(command, "--max-difference", options->max_difference, "SECONDS",
            "Match by time, at most this many seconds apart (default: half a frame, at least "
            "0.02; files without times by their order)")
      ->check(notNegative)
      ->check(CLI::Range(0.0, 1e6));
  command.callback([options, &invocation] { evaluate(*options, invocation); });
}

}  // namespace tolman::app
