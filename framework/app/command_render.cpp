// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset render and import: the frames of any source as a KITTI folder, for any other
// program.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/duration_text.hpp"
#include "app/output_files.hpp"
#include "app/path_kind.hpp"
#include "app/progress_line.hpp"
#include "app/rendering.hpp"
#include "app/source_overrides.hpp"
#include "app/system_options.hpp"
#include "app/terminal_output.hpp"
#include "config/scalars.hpp"
#include "engine/assembly.hpp"
#include "engine/drive.hpp"
#include "engine/input_data.hpp"
#include "record/atomic_file.hpp"
#include "record/data_files.hpp"

namespace tolman::app {
namespace {

struct RenderCommand {
  std::string out;
  dataset::RenderOptions render;
  bool depth = false;
  bool replace = false;
  bool needs_calibration = true;  ///< else a folder without calib.txt, which `images` reads
};

[[noreturn]] void refuseDepth(const std::string& plugin) {
  throw run::Failed(
      {run::FailureKind::Configuration,
       "source plugin '" + plugin +
           "' has no parameter 'depth', so it gives no depth maps; leave out --depth, or choose "
           "a source that has it ('tolman plugins describe ID' lists parameters)"});
}

/// The source stage alone; `depth` sets its parameter of that name.
run::CheckedSystem checkSource(run::SystemOptions options, bool depth) {
  auto checked = run::require(run::checkSystem(options, run::Scope::Source));
  if (!depth) return checked;
  const host::LoadedPlugin& plugin = checked.plugins.front();
  const bool declared = std::any_of(
      plugin.schema.begin(), plugin.schema.end(),
      [](const ParameterInfo& p) { return p.name == "depth" && p.type == ParameterType::Bool; });
  if (!declared) refuseDepth(plugin.manifest.id);
  options.overrides.emplace_back("source.depth=true");
  return run::require(run::checkSystem(options, run::Scope::Source));
}

/// Unsupported if the source has no images, or no calibration although it is needed.
Status checkRig(const SourceInfo& info, bool needs_calibration) {
  if (info.rig.width == 0) {
    return Status::unsupported("the source gives no images; a KITTI folder is made of them");
  }
  if (needs_calibration && !info.rig.calibrated) {
    return Status::unsupported(
        "the cameras of the source are not calibrated, and calib.txt needs fx, fy, cx and cy; give "
        "the source its calibration");
  }
  return Status::ok();
}

/// Whether the source reads from `out`. Such a folder must not be replaced.
bool readsFrom(const run::CheckedSystem& system, const std::filesystem::path& out) {
  const std::string& instance = system.config.stages.front().instance;
  const ParameterValues& values = system.values.find(instance)->second;
  const Schema& schema = system.plugins.front().schema;
  return std::any_of(schema.begin(), schema.end(), [&](const ParameterInfo& info) {
    const auto value = values.find(info.name);
    if (info.type != ParameterType::Path || value == values.end()) return false;
    const std::string text = std::get<std::string>(value->second);
    return !text.empty() && (record::isInside(text, out) || record::isInside(out, text));
  });
}

class RenderRun {
 public:
  RenderRun(Invocation& invocation, const RenderCommand& command)
      : invocation_(invocation),
        command_(command),
        render_(command.render),
        log_(invocation.quiet) {}

  ExitCode execute(const run::SystemOptions& options) {
    run::CheckedSystem checked = checkSource(options, command_.depth);
    if (readsFrom(checked, command_.out)) {
      return printFailure(ExitCode::Record,
                          command_.out + ": the source reads from there; choose another --out");
    }
    inputs_ = run::inputFiles(run::inputPaths(checked));
    assembly_ = std::make_unique<run::Assembly>(std::move(checked), log_, clock_, interrupts_);
    run::require(checkRig(assembly_->sourceInfo(), command_.needs_calibration),
                 run::FailureKind::Dataset);
    if (command_.depth && !findDepth()) {
      refuseDepth(assembly_->system().plugins.front().manifest.id);
    }
    return render(run::require(dataset::KittiFolder::create(command_.out, command_.replace),
                               run::FailureKind::Record));
  }

 private:
  /// The array that the source describes as a depth image.
  bool findDepth() {
    std::vector<ArrayInfo> arrays;
    if (!assembly_->source().instance().describe(arrays).isOk()) return false;
    render_.depth = dataset::depthArray(arrays);
    return !render_.depth.empty();
  }

  ExitCode render(const dataset::KittiFolder& folder) {
    const int threads = pipeline::concurrency(assembly_->system().config.general.threads);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    const SourceInfo& info = assembly_->sourceInfo();
    const std::int64_t begin_ns = clock_.steadyNs();
    run::StageLogger logger(log_, "render");
    dataset::RenderOutcome outcome;
    {
      ProgressLine progress(std::cerr, clock_, terminalOf(invocation_),
                            framesToCome(command_.render.frames, info.frames));
      const auto next = [this](Frame& frame) { return assembly_->source().next(frame); };
      dataset::Rendering rendering(next, info, folder, render_, logger, [&] { progress.step(); });
      outcome = rendering.run(interrupts_);
    }
    const double seconds = static_cast<double>(clock_.steadyNs() - begin_ns) * 1e-9;
    for (const Status& status : assembly_->teardown()) logger.warning(status.message());
    if (outcome.folder.isOk()) show(outcome, seconds);
    return conclude(outcome);
  }

  ExitCode conclude(const dataset::RenderOutcome& outcome) const {
    using run::FailureKind;
    for (const auto& [status, kind] : {std::pair(outcome.folder, FailureKind::Record),
                                       std::pair(outcome.source, FailureKind::Dataset)}) {
      if (!status.isOk())
        return printFailure(exitCode(run::kindOf(status, kind)), status.message());
    }
    if (outcome.interrupted) return ExitCode::Interrupted;
    if (outcome.written == 0) {
      return printFailure(ExitCode::Dataset, "the source gave no frame with a sound image");
    }
    const std::filesystem::path changed = record::firstChanged(inputs_);
    if (changed.empty()) return ExitCode::Ok;
    return printFailure(ExitCode::Dataset,
                        changed.string() + ": was changed or removed meanwhile, so the images in " +
                            command_.out + " may be of two data sets; do it again with --force");
  }

  void show(const dataset::RenderOutcome& outcome, double seconds) const {
    const auto& revisits = outcome.revisits;
    const auto same = std::count_if(revisits.begin(), revisits.end(), [](const auto& r) {
      return r.heading == dataset::Heading::Same;
    });
    const auto opposite = static_cast<std::ptrdiff_t>(revisits.size()) - same;
    if (invocation_.json) {
      const nlohmann::ordered_json json = {{"folder", command_.out},
                                           {"frames", outcome.written},
                                           {"left_out", outcome.left_out},
                                           {"calibrated", assembly_->sourceInfo().rig.calibrated},
                                           {"revisits_same", same},
                                           {"revisits_opposite", opposite},
                                           {"interrupted", outcome.interrupted},
                                           {"seconds", seconds}};
      std::cout << jsonText(json);
    } else if (!invocation_.quiet) {
      const double rate = seconds > 0 ? static_cast<double>(outcome.written) / seconds : 0;
      std::cout << fmt::format("{:<10}{}\n{:<10}{} written, {} left out\n", "folder", command_.out,
                               "frames", outcome.written, outcome.left_out)
                << fmt::format("{:<10}{} frames in the same direction, {} in the opposite one\n",
                               "revisits", same, opposite)
                << fmt::format("{:<10}{}, {:.1f} frames/s\n", "time", durationText(seconds), rate);
      if (!assembly_->sourceInfo().rig.calibrated) {
        std::cout << fmt::format(
            "{:<10}none: read it by {{plugin: images, path: {}, left: image_0, stamps: "
            "times.txt}}\n",
            "calib.txt", command_.out);
      }
    }
  }

  Invocation& invocation_;
  const RenderCommand& command_;
  dataset::RenderOptions render_;
  run::Interrupts interrupts_;  // before anything that starts threads
  run::RunLog log_;
  run::SteadyClock clock_;
  std::vector<record::DataFile> inputs_;  ///< as they were at the begin
  std::unique_ptr<run::Assembly> assembly_;
};

struct ImportCommand {
  std::string path;
  std::string source;
  std::vector<std::string> overrides;
};

/// Writes a configuration of a source alone into the file `memory`, and returns its options. The
/// plugin is an override, too, so that messages name it instead of that file.
run::SystemOptions systemOf(const ImportCommand& import, const record::FileDescriptor& memory,
                            const Invocation& invocation) {
  const std::string yaml = "source: {plugin: none}\n";
  if (::write(memory.number(), yaml.data(), yaml.size()) != static_cast<ssize_t>(yaml.size())) {
    throw run::Failed({run::FailureKind::Record, "no memory for the configuration"});
  }
  run::SystemOptions options;
  options.config = "/proc/self/fd/" + std::to_string(memory.number());
  options.plugin_paths = invocation.plugin_paths;
  options.overrides = {"source.plugin=" + config::writeText(import.source),
                       "source.path=" + config::writeText(import.path)};
  const SourceOverrides split = splitOverrides(import.overrides);
  for (const std::string& value : split.source) options.overrides.push_back("source." + value);
  options.overrides.insert(options.overrides.end(), split.host.begin(), split.host.end());
  return options;
}

void addOutput(CLI::App& command, RenderCommand& render) {
  command.add_option("--out", render.out, "Folder to write")
      ->type_name("FOLDER")
      ->required()
      ->check(notEmpty);
  command.add_option("--frames", render.render.frames, "Take at most this many frames")
      ->check(positive);
  command.add_flag("--depth", render.depth, "Write depth maps too (16 bits, m * 256)");
  addForce(command, render.replace, "Replace an earlier rendering in the folder");
}

}  // namespace

void addRenderCommand(CLI::App& dataset, Invocation& invocation) {
  CLI::App* command =
      dataset.add_subcommand("render", "Write the frames of a source as a KITTI folder");
  auto options = std::make_shared<SystemOptionsReader>(*command);
  auto render = std::make_shared<RenderCommand>();
  addOutput(*command, *render);
  command->callback([options, render, &invocation] {
    RenderRun run(invocation, *render);
    invocation.exit_code = run.execute(options->read(invocation));
  });
}

void addImportCommand(CLI::App& dataset, Invocation& invocation) {
  CLI::App* command = dataset.add_subcommand(
      "import", "Write a recording, rectified, as a KITTI folder (render without a configuration)");
  auto import = std::make_shared<ImportCommand>();
  auto render = std::make_shared<RenderCommand>();
  render->needs_calibration = false;
  command->add_option("path", import->path, "Folder or file of the recording")
      ->type_name("PATH")
      ->required();
  command->add_option("--source", import->source, "Source plugin that reads it")
      ->type_name("SOURCE")
      ->required();
  command
      ->add_option("--set", import->overrides,
                   "Parameter of the source, or key of the host: --set a=b, --set images.scale=0.5")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  addOutput(*command, *render);
  command->callback([import, render, &invocation] {
    requireRecording(import->path, import->source);
    const record::FileDescriptor memory(::memfd_create("import.yaml", MFD_CLOEXEC));
    RenderRun run(invocation, *render);
    invocation.exit_code = run.execute(systemOf(*import, memory, invocation));
  });
}

}  // namespace tolman::app
