// SPDX-License-Identifier: BSD-3-Clause
// tolman eval: errors of a trajectory file against the truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/program.hpp"
#include "app/summary.hpp"
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

void evaluate(const EvalOptions& options, const Invocation& invocation) {
  const auto truth = valueOrEnd(evaluation::readTrajectory(options.truth), ExitCode::Dataset);
  const auto estimate = valueOrEnd(evaluation::readTrajectory(options.estimate), ExitCode::Dataset);
  const auto difference_ns = static_cast<std::int64_t>(options.max_difference * 1e9);
  const auto metrics =
      evaluation::scoreTrajectory(truth, estimate, options.alignment, std::nullopt, difference_ns);
  if (!metrics.scores) throw Ended{ExitCode::Dataset, metrics.reason};
  if (invocation.json) {
    std::cout << evaluation::toJson(metrics).dump(2) << "\n";
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
  const std::map<std::string, evaluation::Alignment> names = {
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
      ->transform(CLI::CheckedTransformer(names, CLI::ignore_case).description(""));
  command
      ->add_option("--max-difference", options->max_difference,
                   "Match by time, at most this many seconds apart (default: by frame)")
      ->check(CLI::Range(0.0, 1e6));
  command->callback([options, &invocation] { evaluate(*options, invocation); });
}

}  // namespace tolman::app
