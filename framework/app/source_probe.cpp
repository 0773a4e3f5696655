// SPDX-License-Identifier: BSD-3-Clause
// Also the internal command `tolman probe-source`, which runs in that process.
#include "app/source_probe.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/rendering.hpp"
#include "app/terminal_output.hpp"
#include "base/bounded_json.hpp"
#include "config/json_text.hpp"
#include "engine/assembly.hpp"
#include "host/child_process.hpp"
#include "host/guard.hpp"
#include "host/library.hpp"
#include "host/plugin_process.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

constexpr std::chrono::seconds kShortest{20};
constexpr std::uintmax_t kBytesPerSecond = 20'000'000;  // of a bag with compressed chunks
constexpr int kProbedFrames = 10;

/// Reads the first frames as a run would, and prints one line of JSON.
void probeSource(const std::string& config, const Invocation& invocation) {
  run::RunLog log(true);
  const run::SteadyClock clock;
  const run::Interrupts interrupts;
  run::SystemOptions options;
  options.config = config;
  options.plugin_paths = invocation.plugin_paths;
  run::Assembly assembly(run::require(run::checkSystem(options, run::Scope::Source)), log, clock,
                         interrupts);
  std::int64_t first_ns = 0;
  std::int64_t last_ns = 0;
  int frames = 0;
  for (; frames < kProbedFrames; ++frames) {
    Frame frame;
    const Status status = assembly.source().next(frame);
    if (status.code() == StatusCode::EndOfStream) break;
    run::require(status, run::FailureKind::Dataset);
    if (frames == 0) first_ns = frame.stamp_ns;
    last_ns = frame.stamp_ns;
  }
  if (frames == 0) throw run::Failed({run::FailureKind::Dataset, "there is no frame"});
  std::vector<ArrayInfo> arrays;
  (void)assembly.source().instance().describe(arrays);  // it has given frames
  const SourceInfo& info = assembly.sourceInfo();
  const double seconds = static_cast<double>(last_ns - first_ns) * 1e-9;
  std::vector<std::string> warnings = log.keptWarnings();
  for (const std::string& doubt : assembly.source().doubts())
    warnings.push_back("source: " + doubt);
  const nlohmann::ordered_json json = {{"description", info.description},
                                       {"width", info.rig.width},
                                       {"height", info.rig.height},
                                       {"calibrated", info.rig.calibrated},
                                       {"baseline", info.rig.baseline},
                                       {"depth", !dataset::depthArray(arrays).empty()},
                                       {"has_truth", info.has_truth},
                                       {"rate", seconds > 0 ? (frames - 1) / seconds : 0},
                                       {"warnings", warnings}};
  std::cout << "\n" << config::jsonText(json) << "\n" << std::flush;
}

std::string contentOf(int descriptor) {
  std::string text(static_cast<std::size_t>(std::max<off_t>(::lseek(descriptor, 0, SEEK_END), 0)),
                   '\0');
  const ssize_t read = ::pread(descriptor, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(read, 0)));
  return text;
}

std::string lastLine(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);  // npos + 1 is 0
}

/// The last line; libraries may have printed others before.
std::optional<Probe> readProbe(const std::string& output) {
  const std::size_t begin = output.rfind("\n{");
  if (begin == std::string::npos) return std::nullopt;
  const auto json = bounded_json::parse<nlohmann::json>(output.substr(begin + 1));
  if (!json.is_object()) return std::nullopt;
  Probe probe;
  probe.description = json.value("description", "");
  probe.width = json.value("width", 0);
  probe.height = json.value("height", 0);
  probe.calibrated = json.value("calibrated", false);
  probe.baseline = json.value("baseline", 0.0);
  probe.depth = json.value("depth", false);
  probe.has_truth = json.value("has_truth", false);
  probe.rate = json.value("rate", 0.0);
  probe.warnings = json.value("warnings", std::vector<std::string>());
  return probe;
}

}  // namespace

std::string sourceSection(const std::string& plugin, const SourceValues& values) {
  std::string text = "source:\n  plugin: " + plugin + "\n";
  for (const auto& [name, value] : values) text += fmt::format("  {}: {}\n", name, value);
  return text;
}

std::chrono::seconds probeDeadline(const std::filesystem::path& recording) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::uintmax_t bytes = 0;
  if (fs::is_regular_file(recording, error)) bytes = fs::file_size(recording, error);
  for (fs::directory_iterator at(recording, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored)) bytes += at->file_size(ignored);
  }
  return kShortest + std::chrono::seconds(static_cast<std::int64_t>(bytes / kBytesPerSecond));
}

Result<Probe> probe(const std::string& plugin, const SourceValues& values,
                    std::chrono::seconds deadline, const Invocation& invocation) {
  const record::FileDescriptor config(::memfd_create("probe.yaml", 0));
  const record::FileDescriptor output(::memfd_create("probe.out", MFD_CLOEXEC));
  const std::string yaml = sourceSection(plugin, values);
  if (::write(config.number(), yaml.data(), yaml.size()) != static_cast<ssize_t>(yaml.size())) {
    throw Ended{ExitCode::Record, "no memory for the configuration of a source"};
  }
  std::vector<std::string> command = {"/proc/self/exe"};
  for (const std::string& path : invocation.plugin_paths) {
    command.insert(command.end(), {"--plugin-path", path});
  }
  command.insert(command.end(),
                 {"probe-source", "/proc/self/fd/" + std::to_string(config.number())});
  isolation::ChildProcess child(command, {config.number()}, output.number());
  const auto begin = std::chrono::steady_clock::now();
  const isolation::ProcessEnd end = child.end(deadline);
  if (end.signal == SIGKILL && std::chrono::steady_clock::now() - begin >= deadline) {
    return Status::invalidInput("did not read the first frames within " +
                                std::to_string(deadline.count()) +
                                " s; if it should read them, name it in a file of your own");
  }
  if (end.exit_code == isolation::kNoThreadsExit) {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  }
  const std::string printed = contentOf(output.number());
  const std::string said = lastLine(printed);
  const bool is_out_of_memory = end.exit_code == static_cast<int>(ExitCode::Internal) &&
                                host::isOutOfMemory(Status::failed(said));
  if (is_out_of_memory || said.find(host::kLimitsTooLow) != std::string::npos) {
    throw std::bad_alloc();
  }
  // Messages of the source itself begin with "source (ID), configure: "; others are of the host.
  const std::string prefix = "source (" + plugin + "), ";
  if (end.signal == 0 && end.exit_code != 0 && said.starts_with(prefix)) {
    return Status::invalidInput(said.substr(prefix.size()));
  }
  auto found = end.signal == 0 && end.exit_code == 0 ? readProbe(printed) : std::nullopt;
  if (!found) return Status::unsupported(end.text());
  found->plugin = plugin;
  found->values = values;
  return std::move(*found);
}

void addProbeCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("probe-source", "Reads the first frames of a source (internal)")
          ->group("");
  auto config = std::make_shared<std::string>();
  command->add_option("config", *config)->required();
  command->callback([config, &invocation] { probeSource(*config, invocation); });
}

}  // namespace tolman::app
