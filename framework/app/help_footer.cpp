// SPDX-License-Identifier: BSD-3-Clause
// Examples and exit codes at the end of a command's help.
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "app/program.hpp"

namespace tolman::app {
namespace {

struct Example {
  std::string_view command;
  std::string_view purpose;  ///< empty if the command needs no explanation
};

constexpr std::array kExamples = {
    Example{"tolman run demo --out runs/demo", "a block of the built-in town"},
    Example{"tolman run ~/recording --view", "your own recording, watched in the browser"},
    Example{"tolman run configs/kitti.yaml --set source.path=~/kitti/sequences/06", ""},
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

constexpr std::string_view kExitCodes =
    "Exit codes: 0 ok, 2 usage, 3 configuration, 4 plugin, 5 dataset, 6 tracking lost,\n"
    "  7 plugin failed while running, 8 record (disk) or output, 9 session,\n"
    "  70 internal error or out of memory, 130 interrupted\n";

}  // namespace

std::string helpFooter(std::string_view command) {
  std::string text;
  for (const Example& example : kExamples) {
    if (!example.command.starts_with(command)) continue;
    text += example.purpose.empty()
                ? fmt::format("  {}\n", example.command)
                : fmt::format("  {:<48}  {}\n", example.command, example.purpose);
  }
  if (!text.empty()) text = "Examples:\n" + text + "\n";
  return text.append(kExitCodes);
}

}  // namespace tolman::app
