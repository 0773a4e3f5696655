// SPDX-License-Identifier: BSD-3-Clause
// tolman bench: time of every stage. tolman bench places: precision and recall
// of place recognition.
#include <iostream>

#include "app/options.hpp"
#include "app/program.hpp"
#include "experiment/bench.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

/// The second pass may differ from the first only in parameters of place recognition.
std::string isOfPlace(const std::string& override) {
  const bool is_parameter = override.starts_with("place.") && !override.starts_with("place.plugin");
  return is_parameter ? "" : "'" + override + "' is no parameter of place (place.NAME=VALUE)";
}

/// Measures by `run`, then prints the table.
template <class Run, class Options>
ExitCode bench(const Run& run, Options options, const Invocation& invocation) {
  const engine::Interrupts interrupts;  // before anything that starts threads
  engine::RunLog log(invocation.quiet);
  const engine::SteadyClock clock;
  options.progress = [&, most = options.frames](std::int64_t frames) {
    const auto line = std::make_shared<ProgressLine>(std::cerr, clock, terminalOf(invocation),
                                                     framesToCome(most, frames));
    return [line] { line->step(); };
  };
  const auto [table, interrupted] = run(options, log, interrupts);
  std::cout << (invocation.json ? experiment::jsonOf(table) : experiment::textOf(table));
  return interrupted ? ExitCode::Interrupted : ExitCode::Ok;
}

void addPlacesOptions(CLI::App& command, experiment::PlacesOptions& options) {
  addOption(command, "--second", options.second, "FOLDER",
            "Folder of a second pass along the same path: image N of both shows the same "
            "place; the source's parameter `path` is set to it");
  addList(command, "--query-set", options.query_overrides, "PATH=VALUE",
          "Override a parameter of place for the second pass only (repeatable)")
      ->check(isOfPlace);
  addOption(command, "--tolerance", options.tolerance, "N",
            "Two passes: images that a right claim may be away (default: 5)")
      ->check(notNegative);
  addOption(command, "--pairs", options.pairs, "FILE",
            "One drive: CSV file of the true pairs, query,match; without it the true "
            "poses of the source decide")
      ->excludes("--second");
  addOption(command, "--near", options.near, "N",
            "One drive: claims over at most so many images do not count (default: 20)")
      ->check(notNegative);
  addOption(command, "--metres-per-image", options.metres_per_image, "N",
            "Motion between images where there are no true poses (default: 1)")
      ->check(positive);
  addOption(command, "--frames", options.frames, "N", "Use at most this many images of each pass")
      ->check(positive);
}

/// A figure of the curve that was measured, and of earlier ones.
struct PlaceFigure {
  std::string file;                 ///< empty: no figure
  std::vector<std::string> beside;  ///< files with the output of earlier calls with --json
  bool replace = false;

  void addOptions(CLI::App& command) {
    CLI::Option* figure = addOption(command, "--figure", file, "FILE",
                                    "Write precision over recall as a figure (SVG); its "
                                    "curve has the name of the configuration")
                              ->check(notEmpty);
    addList(command, "--beside", beside, "FILE",
            "Draw an earlier measurement in the same figure, what --json printed "
            "(repeatable)")
        ->needs(figure);
    command.add_flag("--force", replace, "Replace the file of --figure");
  }
  /// Call it before the measurement, so that a wrong file is reported before the long work.
  std::vector<experiment::PlaceCurve> read() const {
    if (!file.empty()) refuseExisting({file}, replace, "--figure");
    std::vector<experiment::PlaceCurve> curves;
    for (const std::string& name : beside) {
      curves.push_back(
          engine::require(experiment::placeCurveOf(name), engine::FailureKind::Dataset));
    }
    return curves;
  }
  void write(const std::vector<experiment::PlaceCurve>& curves) const {
    if (file.empty()) return;
    engine::require(record::writeOutput(file, experiment::placeCurvesFigure(curves)),
                    engine::FailureKind::Record);
  }
};

void addPlacesCommand(CLI::App& bench_command, Invocation& invocation) {
  CLI::App* command = bench_command.add_subcommand(
      "places", "Precision and recall of place recognition, over one drive or two passes");
  auto reader = std::make_shared<SystemOptionsReader>(*command);
  auto options = std::make_shared<experiment::PlacesOptions>();
  addPlacesOptions(*command, *options);
  auto figure = std::make_shared<PlaceFigure>();
  figure->addOptions(*command);
  command->callback([reader, options, figure, &invocation] {
    std::vector<experiment::PlaceCurve> curves = figure->read();
    const auto run = [&](auto&&... arguments) {
      const auto measured = experiment::runPlacesBench(reader->read(invocation), arguments...);
      curves.insert(curves.begin(), {measured.name, measured.curve});
      return experiment::BenchTable{experiment::tableOf(measured), measured.interrupted};
    };
    invocation.exit_code = bench(run, *options, invocation);
    figure->write(curves);
  });
}

}  // namespace

void addBenchCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("bench", "Measure the time of every stage");
  auto reader = std::make_shared<SystemOptionsReader>(*command);
  auto options = std::make_shared<experiment::BenchOptions>();
  addOption(*command, "--frames", options->frames, "N", "Measure at most this many frames")
      ->check(positive);
  addPlacesCommand(*command, invocation);
  CLI::Option* config = command->get_option("config")->required(false);
  command->callback([command, config, reader, options, &invocation] {
    if (!command->get_subcommands().empty()) return;  // the subcommand has run already
    if (config->empty()) throw CLI::RequiredError("config");
    const auto run = [&](auto&&... arguments) {
      return experiment::runBench(reader->read(invocation), arguments...);
    };
    invocation.exit_code = bench(run, *options, invocation);
  });
}

}  // namespace tolman::app
