// SPDX-License-Identifier: BSD-3-Clause
// tolman eval: errors of a trajectory file against the truth.
#include <fmt/format.h>

#include <iostream>

#include "app/options.hpp"
#include "app/summary.hpp"
#include "config/text.hpp"
#include "evaluation/metrics.hpp"
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

/// How many poses a file has, for messages.
std::string countText(const std::string& file, const evaluation::Trajectory& trajectory) {
  return fmt::format("{} has {} poses", file, trajectory.size());
}

/// Refuses to match by frame where the stamps or the numbers of poses show that equal frames are of
/// different times; warns where that may be so.
void checkFrames(const EvalOptions& options, const evaluation::Trajectory& truth,
                 const evaluation::Trajectory& estimate, const Invocation& invocation) {
  using evaluation::StampAgreement;
  const evaluation::StampComparison found = evaluation::compareStamps(truth, estimate);
  const double apart_s = 1e-9 * static_cast<double>(found.apart_ns);
  if (found.agreement == StampAgreement::Contradicts) {
    fail(ExitCode::Dataset,
         fmt::format("{}: poses of one number are up to {:.3f} s from those of {}; match them by "
                     "time with --max-difference {:.3g}, half the time between true poses",
                     options.estimate, apart_s, options.truth,
                     0.5e-9 * static_cast<double>(found.period_ns)));
  }
  if (found.agreement == StampAgreement::OtherClock) {
    warn(fmt::format("{}: all stamps are {:.3f} s from those of {}; the poses are matched by their "
                     "order",
                     options.estimate, apart_s, options.truth),
         invocation);
  }
  if (truth.size() == estimate.size() || truth.size() < 2 || estimate.size() < 2) return;
  const int with_stamps = evaluation::hasStamps(truth) + evaluation::hasStamps(estimate);
  const std::string counts =
      countText(options.estimate, estimate) + " and " + countText(options.truth, truth);
  if (with_stamps == 1) {  // at another rate all errors would be wrong
    fail(ExitCode::Dataset,
         counts +
             ", and only one of them has times: which belong together is not known; give both "
             "with times (TUM) and --max-difference, or both as KITTI files that begin at the "
             "same frame");
  }
  if (with_stamps > 0) return;
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
  if (options.max_difference >= 0) {
    requireStamps(options.truth, truth);
    requireStamps(options.estimate, estimate);
  } else {
    checkFrames(options, truth, estimate, invocation);
  }
  const auto difference_ns = static_cast<std::int64_t>(options.max_difference * 1e9);
  const auto alignment = *config::valueNamed<evaluation::Alignment>(options.alignment);
  const auto metrics =
      evaluation::scoreTrajectory(truth, estimate, alignment, std::nullopt, difference_ns);
  if (!metrics.scores) fail(ExitCode::Dataset, metrics.reason);
  if (metrics.matched * 20 < std::min(truth.size(), estimate.size())) {
    warn(fmt::format("{}: only {} of {} poses have a true pose at their time; are both stamps in "
                     "seconds, and of one clock?",
                     options.estimate, metrics.matched, estimate.size()),
         invocation);
  }
  if (invocation.json) {
    std::cout << jsonText(evaluation::toJson(metrics));
  } else {
    std::cout << fmt::format("{:<10}{}\n", "alignment", options.alignment)
              << trajectoryText("estimate", metrics);
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
            "Match by time, at most this many seconds apart (default: by frame)")
      ->check(notNegative)
      ->check(CLI::Range(0.0, 1e6));
  command.callback([options, &invocation] { evaluate(*options, invocation); });
}

}  // namespace tolman::app
