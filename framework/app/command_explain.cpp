// SPDX-License-Identifier: BSD-3-Clause
// tolman explain: why a loop was closed, rejected or missed, from the record of a run.
#include <fmt/format.h>

#include <iostream>

#include "app/options.hpp"
#include "engine/replay_server.hpp"
#include "engine/results.hpp"
#include "engine/services.hpp"
#include "experiment/tables.hpp"
#include "record/atomic_file.hpp"
#include "report/run_data.hpp"
#include "report/svg.hpp"

namespace tolman::app {
namespace {

using report::LoopStory;

struct ExplainCommand {
  std::string run;
  std::int64_t frame = -1;
  std::size_t loop = 0;  ///< counted from 1; 0: not given
  bool no_images = false;
};

std::string listText(const std::vector<LoopStory>& stories) {
  if (stories.empty()) return "no loop was closed, and none was near\n";
  experiment::Table table{report::storyHeadings(), {}};
  table.heading.insert(table.heading.begin(), "loop");
  for (const LoopStory& story : stories) {
    auto& row = table.rows.emplace_back(story.cells());
    row.insert(row.begin(), std::to_string(table.rows.size()));
  }
  return experiment::textOf(table);
}

/// Writes both views side by side to figures/loop-FRAME.png; what is said about it.
std::string picture(const LoopStory& story, const ExplainCommand& command,
                    const record::RunReader& reader, const Invocation& invocation) {
  if (command.no_images || story.earlier < 0) return "";
  const engine::Interrupts interrupts;
  const engine::SteadyClock clock;
  engine::RecordedImages images(command.run, invocation.plugin_paths, clock, interrupts);
  auto views = images.views(reader, {story.earlier, story.frame});
  if (!images.problem().empty()) return "without pictures: " + images.problem();
  const std::string figure = report::pairFigure(story, views[story.earlier], views[story.frame]);
  if (figure.empty()) return "without pictures: the source has no images of these frames";
  const std::filesystem::path file =
      reader.directory() / "figures" / fmt::format("loop-{}.png", story.frame);
  std::error_code ignored;  // writing fails with a better message
  std::filesystem::create_directories(file.parent_path(), ignored);
  failUnless(record::writeAtomically(file, valueOf(report::pngOf(figure, 1))));
  return file.string();
}

void explain(const ExplainCommand& command, const Invocation& invocation) {
  const auto reader = valueOf(record::RunReader::open(command.run));
  const report::LoopRecord record =
      valueOf(report::readLoops(*reader, engine::configOf(command.run).evaluation));
  std::optional<LoopStory> story;
  if (command.frame >= 0) {
    story = report::storyOf(record, command.frame);
    if (!story) fail(ExitCode::Usage, fmt::format("the run has no frame {}", command.frame));
  } else {
    const std::vector<LoopStory> stories = report::storiesOf(record);
    if (command.loop == 0) {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const LoopStory& each : stories) list.push_back(each.json());
      std::cout << (invocation.json ? jsonText({{"loops", list}}) : listText(stories));
      return;
    }
    if (command.loop > stories.size()) {
      fail(ExitCode::Usage, fmt::format("the run has {} loops and near misses; `tolman explain {}` "
                                        "lists them",
                                        stories.size(), command.run));
    }
    story = stories[command.loop - 1];
  }
  const std::string written = picture(*story, command, *reader, invocation);
  if (invocation.json) {
    nlohmann::ordered_json json = story->json();
    json["picture"] = written;
    std::cout << jsonText(json);
  } else {
    std::cout << story->text() << "\n" << (written.empty() ? "" : written + "\n");
  }
}

}  // namespace

void addExplainCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand(
      "explain", "Why loops of a run were closed, rejected or missed: a list, or one of them");
  auto options = std::make_shared<ExplainCommand>();
  addArgument(command, "run", options->run, "RUN", "Run directory");
  CLI::Option* frame =
      addOption(command, "--frame", options->frame, "N",
                "Explain what happened at this frame, with both views in figures/loop-N.png")
          ->check(notNegative);
  addOption(command, "--loop", options->loop, "K", "Explain the K-th loop of the list")
      ->check(positive)
      ->excludes(frame);
  command.add_flag("--no-images", options->no_images,
                   "Do not read the images of the run's source again");
  command.callback([options, &invocation] { explain(*options, invocation); });
}

}  // namespace tolman::app
