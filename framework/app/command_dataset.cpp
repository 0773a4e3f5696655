// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset check: checks a data set and lists all problems.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/path_kind.hpp"
#include "app/program.hpp"
#include "app/source_overrides.hpp"
#include "app/terminal_output.hpp"
#include "config/check.hpp"
#include "config/overrides.hpp"
#include "engine/assembly.hpp"
#include "engine/pair_survey.hpp"
#include "engine/rectified_source.hpp"
#include "host/guard.hpp"
#include "host/stage_artefacts.hpp"

namespace tolman::app {
namespace {

struct DatasetOptions {
  std::string path;
  std::string source = "kitti";
  std::vector<std::string> overrides;
  bool decode = false;
};

using Findings = std::vector<Finding>;

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
    findings.push_back({Finding::Severity::Warning, "",
                        fmt::format("{} of {} frames have no sound image, which a run passes by; "
                                    "the first is {}",
                                    defects, frames, first_defect)});
  }
  if (status.code() == StatusCode::EndOfStream) {
    findings.push_back(
        {Finding::Severity::Note, "", fmt::format("{} frames decode", frames - defects)});
  } else {
    findings.push_back({Finding::Severity::Error, "", status.message()});
  }
}

/// Rectifies some pairs as a run would, and reports how well their rows agree.
void surveyPairs(pipeline::RectifiedSource& source, Findings& findings) {
  constexpr int kPairs = 10;
  SourceInfo info;
  if (const Status status = source.info(info); !status.isOk()) {
    findings.push_back({Finding::Severity::Error, "", status.message()});
    return;
  }
  if (!source.text().empty()) {
    findings.push_back({Finding::Severity::Note, "cameras", source.text()});
  }
  if (!source.cutText().empty()) {
    findings.push_back({Finding::Severity::Note, "images", source.cutText()});
  }
  for (const std::string& doubt : source.doubts()) {
    findings.push_back({Finding::Severity::Warning, "cameras", doubt});
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
    sound = sound && finding.severity != Finding::Severity::Error;
    list.push_back(
        {{"severity", severity}, {"where", finding.where}, {"message", finding.message}});
    if (json) continue;
    std::cout << fmt::format("{:<8} {}{}{}\n", severity, finding.where,
                             finding.where.empty() ? "" : ": ", finding.message);
  }
  if (json) std::cout << jsonText(list);
  return sound;
}

/// The source's parameters from the command line, checked as those of a configuration file are.
ParameterValues sourceParameters(const host::LoadedPlugin& plugin, const std::string& path,
                                 const std::vector<std::string>& overrides,
                                 config::Problems& problems) {
  using config::Node;
  Node stage{Node::Kind::Map};
  config::applyOverrides(stage, overrides, config::processEnvironment(), problems);
  // Of a source that reads no files, such as a camera, all parameters are given by --set.
  if (!path.empty() && stage.find("path") == nullptr) {
    const config::Origin origin{config::Origin::Kind::CommandLine, path, 0, 0, {}};
    stage.children.push_back({Node::Kind::Scalar, "path", origin, origin, path, true});
  }
  const config::BaseFolders folders{std::filesystem::current_path(), ""};
  return config::check(stage, plugin.schema, {"", "plugin " + plugin.manifest.id, {}}, folders,
                       problems);
}

/// Configures the source, lets it inspect its data, and prints the findings.
ExitCode inspect(pipeline::RectifiedSource source, const ParameterValues& values, bool decode,
                 const Invocation& invocation) {
  run::RunLog log(invocation.quiet);
  run::StageLogger logger(log, "source");
  host::StageArtefacts artefacts;
  const run::SteadyClock clock;
  const run::Interrupts interrupts;
  const Status configured =
      source.instance().configure({values, logger, artefacts, interrupts, clock, {}, 1, "source"});
  if (interrupts.requested()) return ExitCode::Interrupted;
  Findings findings;
  const Status inspected = source.inspect(findings);
  if (configured.isOk()) surveyPairs(source, findings);
  if (configured.isOk() && decode) decodeAll(source, findings);
  for (const Status& status : {configured, inspected}) {
    if (host::isOutOfMemory(status)) return printFailure(ExitCode::Internal, status.message());
  }
  const bool sound = print(findings, invocation.json);
  if (!sound) return ExitCode::Dataset;  // the findings say why configure() failed
  for (const Status& status : {configured, inspected}) {
    if (!status.isOk()) return printFailure(ExitCode::Dataset, status.message());
  }
  return ExitCode::Ok;
}

/// Refuses a missing path, and one that the source does not have.
void requirePath(const host::LoadedPlugin& plugin, const DatasetOptions& options) {
  const bool has_path =
      std::ranges::find(plugin.schema, "path", &ParameterInfo::name) != plugin.schema.end();
  if (has_path && options.path.empty() && options.overrides.empty()) {
    throw Ended{ExitCode::Usage, "name the folder of the data set"};
  }
  if (has_path || options.path.empty()) return;
  throw Ended{ExitCode::Usage, "source '" + options.source +
                                   "' reads no folder; leave it out, and give its parameters by "
                                   "--set NAME=VALUE"};
}

ExitCode check(const DatasetOptions& options, const Invocation& invocation) {
  requireRecording(options.path, options.source);
  const host::Catalogue catalogue = run::openCatalogue(invocation.plugin_paths);
  const auto plugin = run::loadFrom(catalogue, options.source, Role::Source);
  requirePath(plugin, options);
  config::Problems problems;
  const SourceOverrides split = splitOverrides(options.overrides);
  const ParameterValues values = sourceParameters(plugin, options.path, split.source, problems);
  const ImageHandling handling = imageHandling(split.host, problems);
  if (!problems.empty()) return printFailure(ExitCode::Configuration, config::format(problems));
  auto instance = run::require(host::Instance::create(plugin, "source"));
  return inspect(
      pipeline::RectifiedSource(std::move(instance), handling.rectification, handling.images),
      values, options.decode, invocation);
}

}  // namespace

void addDatasetCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("dataset", "Check data sets, and write them");
  command->require_subcommand(1);
  command->fallthrough();
  CLI::App* check_command = command->add_subcommand("check", "Check a data set");
  auto options = std::make_shared<DatasetOptions>();
  check_command
      ->add_option("path", options->path, "Folder of the data set; none for a source without one")
      ->type_name("FOLDER");
  check_command->add_option("--source", options->source, "Source plugin (default: kitti)")
      ->type_name("SOURCE");
  check_command
      ->add_option("--set", options->overrides,
                   "Parameter of the source, or key of the host: --set a=b, --set images.scale=0.5")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  check_command->add_flag("--decode", options->decode, "Also decode every image");
  check_command->callback(
      [options, &invocation] { invocation.exit_code = check(*options, invocation); });
  addRenderCommand(*command, invocation);
  addImportCommand(*command, invocation);
}

}  // namespace tolman::app
