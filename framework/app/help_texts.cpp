// SPDX-License-Identifier: BSD-3-Clause
#include "app/help_texts.hpp"

#include <fmt/format.h>

#include <array>

namespace tolman::app {
namespace {

constexpr std::array kExamples = {
    Example{"tolman run demo --out runs/demo", "a block of the built-in town"},
    Example{"tolman run configs/kitti.yaml --set source.path=~/kitti/sequences/06", ""},
    Example{"tolman run configs/demo.yaml --view", "watch it in the browser"},
    Example{"tolman run configs/kitti.yaml --set odometry.plugin=my_odometry --plugin-path "
            "~/mine/build",
            ""},
    Example{"tolman run configs/kitti.yaml --continue runs/monday --out runs/tuesday",
            "continue a saved map"},
    Example{"tolman help run", "the options of a command"},
    Example{"tolman check configs/kitti.yaml --explain", "every value and where it comes from"},
    Example{"tolman init ~/recording --out mine.yaml", "a configuration for your own recording"},
    Example{"tolman plugins list", "what is installed"},
    Example{"tolman plugins describe bayesian_attractor", "parameters of a plugin"},
    Example{"tolman plugins doctor build/mine.so", "why is a library not loaded?"},
    Example{"tolman plugins new place my_places", "a repository with a plugin that works"},
    Example{"tolman plugins new cells mine --python", "one file in Python that works"},
    Example{"tolman plugins validate build/mine.so", "does a plugin satisfy the contract?"},
    Example{"tolman dataset check ~/kitti/sequences/06", "is the data set sound?"},
    Example{"tolman dataset render town.yaml --out town",
            "the frames of any source as a KITTI folder"},
    Example{"tolman bench configs/kitti.yaml --frames 200",
            "how fast is the source, and every stage?"},
    Example{"tolman report runs/demo", "figures and a page about a run, or several"},
    Example{"tolman report runs/demo --grid-unit 12,30", "the firing rate of another grid unit"},
    Example{"tolman view runs/demo", "the same run in the browser; also while it is running"},
    Example{"tolman plan runs/demo --from 0 --to 40,-120", "the fastest way through a map"},
    Example{"tolman sweep study.yaml --dry-run", "are all points right, and how many are to do?"},
    Example{"tolman sweep study.yaml --jobs 4", "run what is not done yet"},
    Example{"tolman sweep status sweeps/study", "what became of the runs?"},
    Example{"tolman compare sweeps/study --by cells.period --figure period.svg",
            "a table with intervals, and a figure"},
    Example{"tolman rerun runs/demo --verify", "does it still give the same bytes?"},
    Example{"tolman export runs/demo", "trajectories and map of a run that was killed"},
    Example{"tolman eval truth.txt estimate.txt --align se3",
            "errors of any TUM or KITTI trajectory"},
};

constexpr std::array kExitMeanings = {
    ExitMeaning{ExitCode::Ok, "ok"},
    ExitMeaning{ExitCode::Usage, "usage"},
    ExitMeaning{ExitCode::Configuration, "configuration"},
    ExitMeaning{ExitCode::Plugin, "plugin"},
    ExitMeaning{ExitCode::Dataset, "dataset"},
    ExitMeaning{ExitCode::TrackingLost, "tracking lost"},
    ExitMeaning{ExitCode::PluginFailed, "plugin failed while running"},
    ExitMeaning{ExitCode::Record, "record (disk) or output"},
    ExitMeaning{ExitCode::Session, "session"},
    ExitMeaning{ExitCode::Internal, "internal error or out of memory"},
    ExitMeaning{ExitCode::Interrupted, "interrupted"},
};

/// "Exit codes: 0 ok, 2 usage, ...", in lines of at most 90 characters.
std::string exitCodesText() {
  constexpr std::size_t kWidth = 90;
  std::string text;
  std::string line = "Exit codes:";
  for (const ExitMeaning& exit : kExitMeanings) {
    const bool last = exit.code == kExitMeanings.back().code;
    const std::string item =
        fmt::format(" {} {}{}", static_cast<int>(exit.code), exit.meaning, last ? "" : ",");
    if (line.size() + item.size() > kWidth) {
      text += line + "\n";
      line = " ";
    }
    line += item;
  }
  return text + line + "\n";
}

}  // namespace

std::vector<Example> examplesOf(std::string_view command) {
  std::vector<Example> examples;
  for (const Example& example : kExamples) {
    if (example.command.starts_with(command)) examples.push_back(example);
  }
  return examples;
}

std::span<const ExitMeaning> exitMeanings() { return kExitMeanings; }

std::string helpFooter(std::string_view command) {
  std::string text;
  for (const Example& example : examplesOf(command)) {
    text += example.purpose.empty()
                ? fmt::format("  {}\n", example.command)
                : fmt::format("  {:<48}  {}\n", example.command, example.purpose);
  }
  if (!text.empty()) text = "Examples:\n" + text + "\n";
  return text + exitCodesText();
}

}  // namespace tolman::app
