// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset check: checks a data set and lists all problems.
#include <fmt/format.h>

#include <array>
#include <iostream>

#include "app/options.hpp"
#include "app/recording.hpp"
#include "config/values.hpp"
#include "engine/assembly.hpp"
#include "engine/pair_survey.hpp"
#include "engine/rectified_source.hpp"
#include "host/stage_artefacts.hpp"

namespace tolman::app {
namespace {

using Findings = std::vector<Finding>;
using Severity = Finding::Severity;

struct CheckCommand {
  std::string source;               ///< id; empty: by the layout of the recording
  std::string path;                 ///< empty for a source that reads no files, such as a camera
  std::vector<std::string> values;  ///< "first=3", "images.scale=0.5"
  bool decode = false;
};

/// Whether a value of --set is a key of the host for the images, not a parameter of the source.
bool isOfHost(const std::string& override) {
  constexpr std::array kSections = {"images", "rectification"};
  return std::ranges::any_of(kSections, [&](const std::string key) {
    return override.starts_with(key + ".") || override.starts_with(key + "=");
  });
}

std::string sourceOf(const CheckCommand& command) {
  if (!command.source.empty()) return command.source;
  const std::string& path = command.path;
  if (path.empty()) fail(ExitCode::Usage, "name the folder of the data set, or --source");
  if (!std::filesystem::exists(path)) {
    fail(ExitCode::Dataset, path + ": " + config::absence(path, "no such file or folder"));
  }
  const std::vector<std::string> sources = sourcesFor(std::filesystem::canonical(path));
  if (!sources.empty()) return sources.front();
  fail(ExitCode::Dataset, path +
                              ": its layout is not known; name its source with --source "
                              "(`tolman plugins list`)");
}

/// The source stage alone.
run::SystemOptions systemOf(const CheckCommand& command, const Invocation& invocation) {
  refuseTwoValues(command.values);
  run::SystemOptions options{"", {}, invocation.plugin_paths};
  options.overrides = {"source.plugin=" + config::writeText(sourceOf(command))};
  if (!command.path.empty()) {
    options.overrides.push_back("source.path=" + config::writeText(command.path));
  }
  for (const std::string& value : command.values) {
    options.overrides.push_back((isOfHost(value) ? "" : "source.") + value);
  }
  return options;
}

/// Reads every frame, as a run would.
void decodeAll(pipeline::RectifiedSource& source, Findings& findings) {
  SourceInfo info;
  Status status = source.info(info);
  std::int64_t frames = 0;
  std::int64_t defects = 0;
  std::string first_defect;
  while (status.isOk()) {
    Frame frame;
    status = source.next(frame);
    if (!status.isOk()) break;
    if (!frame.defect.empty() && defects++ == 0) {
      first_defect = fmt::format("frame {}: {}", frame.frame, frame.defect);
    }
    ++frames;
  }
  if (defects > 0) {
    findings.push_back({Severity::Warning, "",
                        fmt::format("{} of {} frames have no sound image, which a run passes by; "
                                    "the first is {}",
                                    defects, frames, first_defect)});
  }
  const bool at_end = status.code() == StatusCode::EndOfStream;
  findings.push_back(
      {at_end ? Severity::Note : Severity::Error, "",
       at_end ? fmt::format("{} frames decode", frames - defects) : status.message()});
}

/// Rectifies some pairs as a run would, and reports how well their rows agree.
void surveyPairs(pipeline::RectifiedSource& source, Findings& findings) {
  constexpr int kPairs = 10;
  SourceInfo info;
  if (const Status status = source.info(info); !status.isOk()) {
    findings.push_back({Severity::Error, "", status.message()});
    return;
  }
  if (!source.text().empty()) findings.push_back({Severity::Note, "cameras", source.text()});
  if (!source.cutText().empty()) findings.push_back({Severity::Note, "images", source.cutText()});
  for (const std::string& doubt : source.doubts()) {
    findings.push_back({Severity::Warning, "cameras", doubt});
  }
  if (!info.rig.isStereo()) return;
  imaging::PairSurvey survey;
  Frame frame;
  while (survey.pairs() < kPairs && source.next(frame).isOk()) survey.add(frame);
  for (Finding& finding : survey.findings()) findings.push_back(std::move(finding));
  (void)source.instance().reset();  // the next call reports a failure
  source.resetChecks();
}

bool print(const Findings& findings, bool json) {
  constexpr std::array<std::string_view, 3> kNames = {"note", "warning", "error"};
  bool sound = true;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    const std::string_view severity = kNames.at(static_cast<std::size_t>(finding.severity));
    sound = sound && finding.severity != Severity::Error;
    list.push_back(
        {{"severity", severity}, {"where", finding.where}, {"message", finding.message}});
    if (json) continue;
    std::cout << fmt::format("{:<8} {}{}{}\n", severity, finding.where,
                             finding.where.empty() ? "" : ": ", finding.message);
  }
  if (json) std::cout << jsonText(list);
  return sound;
}

/// Configures the source, lets it inspect its data, and prints the findings.
ExitCode check(const CheckCommand& command, const Invocation& invocation) {
  const auto checked =
      run::require(run::checkSystem(systemOf(command, invocation), run::Scope::Source));
  pipeline::RectifiedSource source(
      run::require(host::Instance::create(checked.plugins.front(), "source")),
      checked.config.rectification, checked.config.images);
  run::RunLog log(invocation.quiet);
  run::StageLogger logger(log, "source");
  host::StageArtefacts artefacts;
  const run::SteadyClock clock;
  const run::Interrupts interrupts;
  const Status configured = source.instance().configure(
      {checked.values.at("source"), logger, artefacts, interrupts, clock, {}, 1, "source"});
  if (interrupts.requested()) return ExitCode::Interrupted;
  Findings findings;
  const Status inspected = source.inspect(findings);
  if (configured.isOk()) surveyPairs(source, findings);
  if (configured.isOk() && command.decode) decodeAll(source, findings);
  const bool sound = print(findings, invocation.json);
  if (!sound) return ExitCode::Dataset;  // the findings say why configure() failed
  run::require(configured, run::FailureKind::Dataset);
  run::require(inspected, run::FailureKind::Dataset);
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
  checking.add_flag("--decode", asked->decode, "Also decode every image");
  checking.callback([asked, &invocation] { invocation.exit_code = check(*asked, invocation); });
  addRenderCommand(command, invocation);
}

}  // namespace tolman::app
