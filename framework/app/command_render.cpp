// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset render: the frames of any source or recording as a KITTI folder, for any other
// program.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <iostream>

#include "app/options.hpp"
#include "app/progress_line.hpp"
#include "app/rendering.hpp"
#include "engine/assembly.hpp"
#include "engine/drive.hpp"
#include "record/data_digest.hpp"

namespace tolman::app {
namespace {

struct RenderCommand {
  Output out;
  RenderOptions render;
  bool depth = false;
};

/// Whether the source reads from `out`. Such a folder must not be replaced.
bool readsFrom(const engine::CheckedSystem& system, const std::filesystem::path& out) {
  const ParameterValues& values = system.values.at(system.config.stages.front().instance);
  return std::ranges::any_of(system.plugins.front().schema, [&](const ParameterInfo& info) {
    if (info.type != ParameterType::Path) return false;
    const std::string text = std::get<std::string>(values.at(info.name));
    return !text.empty() && (record::isInside(text, out) || record::isInside(out, text));
  });
}

void print(const RenderOutcome& outcome, const std::string& out, bool calibrated, double seconds,
           const Invocation& invocation) {
  const auto& revisits = outcome.revisits;
  const auto same =
      std::ranges::count(revisits, evaluation::Heading::Same, &evaluation::Revisit::heading);
  const auto opposite = std::ssize(revisits) - same;
  if (invocation.json) {
    const nlohmann::ordered_json json = {{"folder", out},
                                         {"frames", outcome.written},
                                         {"left_out", outcome.left_out},
                                         {"calibrated", calibrated},
                                         {"revisits_same", same},
                                         {"revisits_opposite", opposite},
                                         {"interrupted", outcome.interrupted},
                                         {"seconds", seconds}};
    std::cout << jsonText(json);
    return;
  }
  if (invocation.quiet) return;
  const double rate = seconds > 0 ? static_cast<double>(outcome.written) / seconds : 0;
  std::cout << fmt::format("{:<10}{}\n{:<10}{} written, {} left out\n", "folder", out, "frames",
                           outcome.written, outcome.left_out)
            << fmt::format("{:<10}{} frames in the same direction, {} in the opposite one\n",
                           "revisits", same, opposite)
            << fmt::format("{:<10}{}, {:.1f} frames/s\n", "time", durationText(seconds), rate);
  if (calibrated) return;
  std::cout << fmt::format(
      "{:<10}none: read it by {{plugin: images, path: {}, left: image_0, stamps: times.txt}}\n",
      "calib.txt", out);
}

ExitCode execute(RenderCommand command, engine::SystemOptions system,
                 const Invocation& invocation) {
  const std::string& out = command.out.path;
  const engine::Interrupts interrupts;  // before anything that starts threads
  if (command.depth) system.overrides.emplace_back("source.depth=true");
  auto checked = engine::require(engine::checkSystem(system, engine::Scope::Source));
  if (readsFrom(checked, out)) {
    fail(ExitCode::Record, out + ": the source reads from there; choose another --out");
  }
  engine::RunLog log(invocation.quiet);
  const engine::SteadyClock clock;
  engine::Assembly assembly(std::move(checked), log, clock, interrupts);
  const SourceInfo& info = assembly.sourceInfo();
  if (info.rig.width == 0) {
    fail(ExitCode::Dataset, "the source gives no images; a KITTI folder is made of them");
  }
  if (command.depth) {
    std::vector<ArrayInfo> arrays;
    engine::require(assembly.source().instance().describe(arrays), engine::FailureKind::Dataset);
    command.render.depth = depthArray(arrays);
    if (command.render.depth.empty()) {
      fail(ExitCode::Dataset, "the source gives no depth maps; leave out --depth");
    }
  }
  const auto folder =
      engine::require(KittiFolder::create(out, command.out.replace), engine::FailureKind::Record);
  const int threads = engine::concurrency(assembly.system().config.general.threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  engine::StageLogger logger(log, "render");
  const std::int64_t begin_ns = clock.steadyNs();
  auto progress = std::make_unique<ProgressLine>(std::cerr, clock, terminalOf(invocation),
                                                 framesToCome(command.render.frames, info.frames));
  const RenderSource source{[&](Frame& frame) { return assembly.source().next(frame); }, info,
                            [&] { progress->step(); }};
  const auto outcome = render(source, folder, command.render, logger, interrupts);
  progress.reset();
  const double seconds = static_cast<double>(clock.steadyNs() - begin_ns) * 1e-9;
  for (const Status& status : assembly.teardown()) logger.warning(status.message());
  engine::require(outcome.folder, engine::FailureKind::Record);
  print(outcome, out, info.rig.calibrated, seconds, invocation);
  engine::require(outcome.source, engine::FailureKind::Dataset);
  if (outcome.interrupted) return ExitCode::Interrupted;
  if (outcome.written > 0) return ExitCode::Ok;
  fail(ExitCode::Dataset, "the source gave no frame with a sound image");
}

}  // namespace

void addRenderCommand(CLI::App& dataset, Invocation& invocation) {
  CLI::App& command = *dataset.add_subcommand(
      "render", "Write the frames of a source or recording, rectified, as a KITTI folder");
  auto reader = std::make_shared<SystemOptionsReader>(command);
  auto render = std::make_shared<RenderCommand>();
  render->out
      .add(command, "FOLDER", "Folder to write", "Replace an earlier rendering in the folder")
      ->required();
  addOption(command, "--frames", render->render.frames, "N", "Take at most this many frames")
      ->check(positive);
  command.add_flag("--depth", render->depth, "Write depth maps too (16 bits, m * 256)");
  command.callback([reader, render, &invocation] {
    invocation.exit_code = execute(*render, reader->read(invocation, Use::Copy), invocation);
  });
}

}  // namespace tolman::app
