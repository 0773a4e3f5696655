// SPDX-License-Identifier: BSD-3-Clause
// tolman eval: errors of a trajectory file against the truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/named_value.hpp"
#include "app/path_kind.hpp"
#include "app/program.hpp"
#include "app/summary.hpp"
#include "app/terminal_output.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/trajectory_files.hpp"

namespace tolman::app {
namespace {

struct EvalOptions {
  std::string truth;
  std::string estimate;
  evaluation::Alignment alignment = evaluation::Alignment::Se3;
  double max_difference = -1;
};

void requireStamps(const std::string& file, const evaluation::Trajectory& trajectory) {
  if (evaluation::hasStamps(trajectory) || trajectory.size() < 2) return;  // one may be at 0 s
  throw Ended{ExitCode::Usage,
              file +
                  ": has no times, as all KITTI files; leave out --max-difference, and poses "
                  "are matched by frame"};
}

/// Refuses matching by frame where stamps show that equal frames are of different times.
void checkOrder(const EvalOptions& options, const evaluation::Trajectory& truth,
                const evaluation::Trajectory& estimate, const Invocation& invocation) {
  using evaluation::StampAgreement;
  const evaluation::StampComparison found = evaluation::compareStamps(truth, estimate);
  const double apart_s = 1e-9 * static_cast<double>(found.apart_ns);
  if (found.agreement == StampAgreement::Contradicts) {
    throw Ended{
        ExitCode::Dataset,
        fmt::format("{}: poses of one number are up to {:.3f} s from those of {}; match them by "
                    "time with --max-difference {:.3g}, half the time between true poses",
                    options.estimate, apart_s, options.truth,
                    0.5e-9 * static_cast<double>(found.period_ns))};
  }
  if (found.agreement == StampAgreement::OtherClock && !invocation.quiet) {
    std::cerr << fmt::format(
        "warning: {}: all stamps are {:.3f} s from those of {}; the poses are matched by their "
        "order, whatever the stamps say\n",
        options.estimate, apart_s, options.truth);
  }
}

/// Refuses matching by frame where one file has times, the other none, and their numbers of poses
/// differ: which poses belong together cannot be told, and at another rate all errors are wrong.
void refuseUnmatched(const EvalOptions& options, const evaluation::Trajectory& truth,
                     const evaluation::Trajectory& estimate) {
  const bool one_has_stamps = evaluation::hasStamps(truth) != evaluation::hasStamps(estimate);
  if (!one_has_stamps || truth.size() == estimate.size()) return;
  if (truth.size() < 2 || estimate.size() < 2) return;  // one pose may be at 0 s
  throw Ended{ExitCode::Dataset,
              fmt::format("{} has {} poses and {} has {}, and only one of them has times: which "
                          "belong together is not known; give both with times (TUM) and "
                          "--max-difference, or both as KITTI files that begin at the same frame",
                          options.estimate, estimate.size(), options.truth, truth.size())};
}

void evaluate(const EvalOptions& options, const Invocation& invocation) {
  for (const std::string& file : {options.truth, options.estimate}) {
    requireKind(file, {PathKind::Trajectory}, "a trajectory", ExitCode::Dataset);
  }
  const auto truth = valueOrEnd(evaluation::readTrajectory(options.truth), ExitCode::Dataset);
  const auto estimate = valueOrEnd(evaluation::readTrajectory(options.estimate), ExitCode::Dataset);
  if (options.max_difference >= 0) {
    requireStamps(options.truth, truth);
    requireStamps(options.estimate, estimate);
  } else {
    checkOrder(options, truth, estimate, invocation);
  }
  refuseUnmatched(options, truth, estimate);
  const auto difference_ns = static_cast<std::int64_t>(options.max_difference * 1e9);
  const auto metrics =
      evaluation::scoreTrajectory(truth, estimate, options.alignment, std::nullopt, difference_ns);
  if (!metrics.scores) throw Ended{ExitCode::Dataset, metrics.reason};
  const bool has_both_stamps = evaluation::hasStamps(truth) && evaluation::hasStamps(estimate);
  if (options.max_difference < 0 && !has_both_stamps && truth.size() != estimate.size() &&
      !invocation.quiet) {
    std::cerr << fmt::format(
        "warning: {} has {} poses and {} has {}: pose N of one is compared with pose N of the "
        "other, so both must begin at the same frame and leave none out; truth with times (TUM) "
        "and --max-difference match by time\n",
        options.estimate, estimate.size(), options.truth, truth.size());
  }
  const std::size_t fewer = std::min(truth.size(), estimate.size());
  if (metrics.matched * 20 < fewer && !invocation.quiet) {
    std::cerr << fmt::format(
        "warning: {}: only {} of {} poses have a true pose at their time; are both stamps in "
        "seconds, and of one clock?\n",
        options.estimate, metrics.matched, estimate.size());
  }
  if (invocation.json) {
    std::cout << jsonText(evaluation::toJson(metrics));
  } else {
    std::cout << fmt::format("{:<10}{}\n", "alignment", enumName(options.alignment))
              << trajectoryText("estimate", metrics);
  }
}

}  // namespace

void addEvalCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("eval", "Score a trajectory (TUM or KITTI file) against the truth");
  auto options = std::make_shared<EvalOptions>();
  const std::vector<std::pair<std::string, evaluation::Alignment>> names = {
      {"none", evaluation::Alignment::None},
      {"se2", evaluation::Alignment::Se2},
      {"se3", evaluation::Alignment::Se3},
      {"sim3", evaluation::Alignment::Sim3}};
  command->add_option("truth", options->truth, "True trajectory")->type_name("FILE")->required();
  command->add_option("estimate", options->estimate, "Estimated trajectory")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--align", options->alignment, "Alignment before the comparison (default: se3)")
      ->type_name("none|se2|se3|sim3")
      ->transform(CLI::Validator(namedValue(names), ""));
  command
      ->add_option("--max-difference", options->max_difference,
                   "Match by time, at most this many seconds apart (default: by frame)")
      ->check(notNegative)
      ->check(CLI::Range(0.0, 1e6));
  command->callback([options, &invocation] { evaluate(*options, invocation); });
}

}  // namespace tolman::app
