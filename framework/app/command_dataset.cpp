// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset check: checks a data set and lists all problems.
#include <fmt/format.h>

#include <iostream>

#include "app/options.hpp"
#include "config/values.hpp"
#include "engine/camera_check.hpp"
#include "engine/checked_system.hpp"
#include "engine/rectified_source.hpp"
#include "engine/services.hpp"
#include "host/instance.hpp"

namespace tolman::app {
namespace {

using Severity = Finding::Severity;

struct CheckCommand {
  std::string source;               ///< id; empty: by the layout of the recording
  std::string path;                 ///< empty for a source that reads no files, such as a camera
  std::vector<std::string> values;  ///< "first=3", "images.scale=0.5"
  std::int64_t frames = 0;          ///< at most; 0: all
};

std::string sourceOf(const CheckCommand& command) {
  if (!command.source.empty()) return command.source;
  const std::string& path = command.path;
  if (path.empty()) fail(ExitCode::Usage, "name the folder of the data set, or --source");
  if (!std::filesystem::exists(path)) {
    fail(ExitCode::Dataset, path + ": " + config::absence(path, "no such file or folder"));
  }
  const std::string source = sourceFor(std::filesystem::canonical(path));
  if (!source.empty()) return source;
  fail(ExitCode::Dataset, path +
                              ": its layout is not known; name its source with --source "
                              "(`tolman plugins list`)");
}

/// The source stage alone. Keys of the host for the images are no parameters of the source.
engine::SystemOptions systemOf(const CheckCommand& command, const Invocation& invocation) {
  engine::SystemOptions options{"", {}, invocation.plugin_paths};
  options.overrides = {"source.plugin=" + config::writeText(sourceOf(command))};
  if (!command.path.empty()) {
    options.overrides.push_back("source.path=" + config::writeText(command.path));
  }
  for (const std::string& value : command.values) {
    const std::string section = value.substr(0, value.find_first_of(".="));
    const bool is_of_host = section == "images" || section == "rectification";
    options.overrides.push_back((is_of_host ? "" : "source.") + value);
  }
  return options;
}

/// Reads the cameras and the frames as a run would, and reports what it would of them.
Status readAll(engine::RectifiedSource& source, std::int64_t most, FindingCollector& findings) {
  SourceInfo info;
  Status status = source.info(info);
  if (!status.isOk()) return status;
  findings.add({Severity::Note, "", info.description});
  for (const std::string& doubt : source.doubts()) {
    findings.add({Severity::Warning, "cameras", doubt});
  }
  constexpr std::int64_t kOfEndless = 10;
  if (most == 0) most = source.isEndless() ? kOfEndless : INT64_MAX;
  engine::FrameCheck images;
  engine::Alternation alternation;
  std::int64_t frames = 0;
  std::int64_t defects = 0;
  for (; frames < most; ++frames) {
    Frame frame;
    status = source.next(frame);
    if (!status.isOk()) break;
    if (!frame.defect.empty()) ++defects;
    if (auto finding = alternation.add(frame.left)) findings.add(*std::move(finding));
    if (const auto fault = images.check(frame)) {
      findings.add({Severity::Warning, "images", *fault, "", Finding::Kind::Contradiction});
    }
  }
  if (defects > 0) {
    findings.add({Severity::Warning, "",
                  fmt::format("{} of {} frames have no sound images", defects, frames)});
  }
  const bool failed = !status.isOk() && status.code() != StatusCode::EndOfStream;
  findings.add({failed ? Severity::Error : Severity::Note, "",
                failed ? status.message() : fmt::format("{} frames decode", frames - defects)});
  return Status::ok();
}

/// Prints each kind of findings once, with their number. Whether there is no error.
bool print(engine::Findings& findings, bool json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings.take()) {
    list.push_back({{"severity", enumName(finding.severity)},
                    {"kind", enumName(finding.kind)},
                    {"where", finding.where},
                    {"message", finding.message},
                    {"remedy", finding.remedy}});
  }
  if (json) std::cout << jsonText(list);
  bool sound = true;
  for (const engine::Findings::Kind& kind : findings.takeNewKinds()) {
    sound = sound && kind.first.severity != Severity::Error;
    if (!json) std::cout << fmt::format("{:<8} {}\n", enumName(kind.first.severity), kind.text());
  }
  return sound;
}

/// Reads the data as a run would, and prints the findings.
ExitCode check(const CheckCommand& command, const Invocation& invocation) {
  const auto checked = engine::checkSystem(systemOf(command, invocation), engine::Scope::Source);
  engine::RectifiedSource source(engine::instantiate(checked, 0), checked.config.rectification,
                                 checked.config.images);
  engine::RunLog log(invocation.quiet);
  engine::StageLogger logger(log, "source");
  engine::Findings all;
  engine::StageFindings findings(all, "source");
  host::StageArtefacts artefacts;
  const engine::SteadyClock clock;
  const engine::Interrupts interrupts;
  Status status = source.instance().configure({checked.values.at("source"),
                                               logger,
                                               findings,
                                               artefacts,
                                               interrupts,
                                               clock,
                                               {},
                                               1,
                                               "source"});
  if (interrupts.requested()) return ExitCode::Interrupted;
  if (status.isOk()) status = readAll(source, command.frames, findings);
  if (!print(all, invocation.json)) return ExitCode::Dataset;  // they say why configure() failed
  engine::require(status, engine::FailureKind::Dataset);
  return ExitCode::Ok;
}

}  // namespace

void addDatasetCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand("dataset", "Check data sets, and write them");
  command.require_subcommand(1);
  command.fallthrough();
  CLI::App& checking = *command.add_subcommand("check", "Check a data set");
  auto asked = std::make_shared<CheckCommand>();
  addOption(checking, "path", asked->path, "PATH", "Folder or file of the recording");
  addOption(checking, "--source", asked->source, "SOURCE",
            "Source plugin that reads it (default: by its layout)");
  addList(checking, "--set", asked->values, "NAME=VALUE",
          "Parameter of the source, or key of the host: --set a=b, --set images.scale=0.5");
  addOption(checking, "--frames", asked->frames, "N",
            "Read at most N frames (default: all; 10 of a source without an end)");
  checking.callback([asked, &invocation] { invocation.exit_code = check(*asked, invocation); });
  addRenderCommand(command, invocation);
  addBagCommand(command, invocation);
}

}  // namespace tolman::app
