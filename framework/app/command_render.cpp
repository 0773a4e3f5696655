// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset render: the frames of any source as a KITTI folder, for any other program.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/progress_line.hpp"
#include "app/rendering.hpp"
#include "app/system_options.hpp"
#include "pipeline/run.hpp"

namespace tolman::app {
namespace {

struct RenderCommand {
  std::string out;
  RenderOptions render;
  bool replace = false;
};

Failure noDepth(const std::string& plugin) {
  return {ExitCode::Configuration,
          "source plugin '" + plugin +
              "' has no parameter 'depth', so it gives no depth maps; leave out --depth, or choose "
              "a source that has it ('tolman plugins describe ID' lists parameters)"};
}

/// The source stage alone; with `depth` its parameter of that name is switched on.
std::variant<CheckedSystem, Failure> checkSource(SystemOptions options, bool depth) {
  auto checked = checkSystem(options, Scope::Source);
  if (!depth || std::holds_alternative<Failure>(checked)) return checked;
  const plugins::LoadedPlugin& plugin = std::get<CheckedSystem>(checked).plugins.front();
  const bool declared = std::any_of(
      plugin.schema.begin(), plugin.schema.end(),
      [](const ParameterInfo& p) { return p.name == "depth" && p.type == ParameterType::Bool; });
  if (!declared) return noDepth(plugin.manifest.id);
  options.overrides.emplace_back("source.depth=true");
  return checkSystem(options, Scope::Source);
}

/// What the layout needs of a source.
Status checkRig(const SourceInfo& info) {
  if (info.rig.width == 0) {
    return Status::unsupported("the source gives no images; a KITTI folder is made of them");
  }
  if (!info.rig.calibrated) {
    return Status::unsupported(
        "the cameras of the source are not calibrated, and calib.txt needs fx, fy, cx and cy; give "
        "the source its calibration");
  }
  return Status::ok();
}

/// Replacing must never delete what the source reads.
bool readsFrom(const CheckedSystem& system, const std::filesystem::path& out) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(fs::absolute(out), ignored) / "";
  const std::string& instance = system.config.stages.front().instance;
  const ParameterValues& values = system.values.find(instance)->second;
  const Schema& schema = system.plugins.front().schema;
  return std::any_of(schema.begin(), schema.end(), [&](const ParameterInfo& info) {
    const auto value = values.find(info.name);
    if (info.type != ParameterType::Path || value == values.end()) return false;
    const std::string text = std::get<std::string>(value->second);
    const fs::path read = fs::weakly_canonical(text, ignored) / "";
    return !text.empty() && read.string().starts_with(folder.string());
  });
}

class RenderRun {
 public:
  RenderRun(Invocation& invocation, const RenderCommand& command)
      : invocation_(invocation), command_(command), log_(invocation.quiet) {}

  ExitCode execute(const SystemOptions& options) {
    auto checked = checkSource(options, command_.render.depth);
    if (auto* failure = std::get_if<Failure>(&checked)) return tell(*failure);
    if (readsFrom(std::get<CheckedSystem>(checked), command_.out)) {
      return tell({ExitCode::Record, command_.out + ": the source reads from there; choose "
                                                    "another --out"});
    }
    auto assembled =
        Assembly::create(std::move(std::get<CheckedSystem>(checked)), log_, clock_, interrupts_,
                         {false, true});  // the command itself shows progress
    if (auto* failure = std::get_if<Failure>(&assembled)) return tell(*failure);
    assembly_ = std::move(std::get<std::unique_ptr<Assembly>>(assembled));
    Status status = assembly_->source().info(info_);
    if (!status.isOk()) return tell({ExitCode::Dataset, status.message()});
    status = checkRig(info_);
    if (!status.isOk()) return tell({ExitCode::Dataset, status.message()});
    const auto folder = KittiFolder::create(command_.out, command_.replace);
    if (!folder.isOk()) return tell({ExitCode::Record, folder.status().message()});
    return render(folder.value());
  }

 private:
  ExitCode render(const KittiFolder& folder) {
    const int threads = pipeline::concurrency(assembly_->system().config.general.threads);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    const std::int64_t begin_ns = clock_.steadyNs();
    StageLogger logger(log_, "render");
    RenderOutcome outcome;
    {
      const Audience audience{isatty(STDERR_FILENO) == 1 && !invocation_.quiet, invocation_.quiet};
      ProgressLine progress(std::cerr, clock_, audience,
                            framesToCome(command_.render.frames, info_.frames));
      Rendering rendering(assembly_->source(), info_, folder, command_.render, logger,
                          [&] { progress.step(); });
      outcome = rendering.run(interrupts_);
    }
    const double seconds = static_cast<double>(clock_.steadyNs() - begin_ns) * 1e-9;
    for (const Status& status : assembly_->teardown()) logger.warning(status.message());
    if (outcome.folder.isOk()) show(outcome, seconds);
    return conclude(outcome);
  }

  static ExitCode conclude(const RenderOutcome& outcome) {
    if (!outcome.folder.isOk()) return tell({ExitCode::Record, outcome.folder.message()});
    if (!outcome.source.isOk()) return tell({ExitCode::Dataset, outcome.source.message()});
    if (outcome.interrupted) return ExitCode::Interrupted;
    if (outcome.written > 0) return ExitCode::Ok;
    return tell({ExitCode::Dataset, "the source gave no frame with a sound image"});
  }

  void show(const RenderOutcome& outcome, double seconds) const {
    const auto& revisits = outcome.revisits;
    const auto same = std::count_if(revisits.begin(), revisits.end(), [](const auto& r) {
      return r.heading == evaluation::Heading::Same;
    });
    const auto opposite = static_cast<std::ptrdiff_t>(revisits.size()) - same;
    if (invocation_.json) {
      const nlohmann::ordered_json json = {{"folder", command_.out},
                                           {"frames", outcome.written},
                                           {"left_out", outcome.left_out},
                                           {"revisits_same", same},
                                           {"revisits_opposite", opposite},
                                           {"interrupted", outcome.interrupted},
                                           {"seconds", seconds}};
      std::cout << json.dump(2) << "\n";
    } else if (!invocation_.quiet) {
      const double rate = seconds > 0 ? static_cast<double>(outcome.written) / seconds : 0;
      std::cout << fmt::format("{:<10}{}\n{:<10}{} written, {} left out\n", "folder", command_.out,
                               "frames", outcome.written, outcome.left_out)
                << fmt::format("{:<10}{} frames in the same direction, {} in the opposite one\n",
                               "revisits", same, opposite)
                << fmt::format("{:<10}{:.1f} s, {:.1f} frames/s\n", "time", seconds, rate);
    }
  }

  Invocation& invocation_;
  const RenderCommand& command_;
  Interrupts interrupts_;  // before anything that starts threads
  RunLog log_;
  SteadyClock clock_;
  std::unique_ptr<Assembly> assembly_;
  SourceInfo info_;
};

}  // namespace

void addRenderCommand(CLI::App& dataset, Invocation& invocation) {
  CLI::App* command =
      dataset.add_subcommand("render", "Write the frames of a source as a KITTI folder");
  auto options = std::make_shared<SystemOptionsReader>(*command);
  auto render = std::make_shared<RenderCommand>();
  command->add_option("--out", render->out, "Folder to write")->required();
  command->add_option("--frames", render->render.frames, "Take so many frames at most")
      ->check(CLI::PositiveNumber);
  command->add_flag("--depth", render->render.depth, "Write depth maps too (16 bits, m * 256)");
  command->add_flag("--force", render->replace, "Replace an earlier rendering in the folder");
  command->callback([options, render, &invocation] {
    RenderRun run(invocation, *render);
    invocation.exit_code = static_cast<int>(run.execute(options->read(invocation)));
  });
}

}  // namespace tolman::app
