// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset check: is a data set sound? Looks before it leaps, and lists all that is wrong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/assembly.hpp"
#include "app/program.hpp"
#include "config/check.hpp"
#include "config/overrides.hpp"

namespace tolman::app {
namespace {

struct DatasetOptions {
  std::string path;
  std::string source = "kitti";
  std::vector<std::string> overrides;
  bool decode = false;
};

using Findings = std::vector<Finding>;

void fail(Invocation& invocation, ExitCode code, const std::string& message) {
  std::cerr << message << "\n";
  invocation.exit_code = static_cast<int>(code);
}

/// Reads every frame, as a run would.
void decodeAll(plugins::SourceStage& source, Findings& findings) {
  SourceInfo info;
  Status status = source.info(info);
  std::int64_t frames = 0;
  while (status.isOk()) {
    Frame frame;
    status = source.next(frame);
    if (status.isOk()) ++frames;
  }
  if (status.code() == StatusCode::EndOfStream) {
    findings.push_back({Finding::Severity::Note, "", fmt::format("{} frames decode", frames)});
  } else {
    findings.push_back({Finding::Severity::Error, "", status.message()});
  }
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
  if (json) std::cout << list.dump(2) << "\n";
  return sound;
}

/// The same checks as in a run, for a configuration that the command line alone makes.
ParameterValues sourceParameters(const plugins::LoadedPlugin& plugin, const DatasetOptions& options,
                                 config::Problems& problems) {
  config::Node stage;
  stage.kind = config::Node::Kind::Map;
  config::applyOverrides(stage, options.overrides, config::processEnvironment(), problems);
  config::Node path;
  path.kind = config::Node::Kind::Scalar;
  path.key = "path";
  path.text = options.path;
  path.quoted = true;
  path.origin.kind = config::Origin::Kind::CommandLine;
  path.origin.file = options.path;
  path.key_origin = path.origin;
  if (stage.find("path") == nullptr) stage.children.push_back(path);
  const config::Places places{std::filesystem::current_path(), ""};
  return config::check(stage, plugin.schema, {"", "plugin " + plugin.manifest.id, {}}, places,
                       problems);
}

/// Configures the source, asks it what it sees, and says it all.
void inspect(std::unique_ptr<plugins::Instance> instance, const ParameterValues& values,
             const DatasetOptions& options, Invocation& invocation) {
  plugins::SourceStage source(std::move(instance));
  RunLog log(invocation.quiet);
  StageLogger logger(log, "source");
  StageArtefacts artefacts("source");
  const SteadyClock clock;
  const Interrupts interrupts;
  const Status configured = source.instance().configure(
      {values, logger, artefacts, interrupts, clock, {}, 1, "source", false, true});
  Findings findings;
  const Status inspected = source.inspect(findings);
  if (configured.isOk() && options.decode) decodeAll(source, findings);
  const bool sound = print(findings, invocation.json);
  if (!sound) {  // what stopped configure() is in the list
    invocation.exit_code = static_cast<int>(ExitCode::Dataset);
  } else if (!configured.isOk()) {
    fail(invocation, ExitCode::Dataset, configured.message());
  } else if (!inspected.isOk()) {
    fail(invocation, ExitCode::Dataset, inspected.message());
  }
}

void check(const DatasetOptions& options, Invocation& invocation) {
  const auto loaded =
      loadFrom(openCatalogue(invocation.plugin_paths), options.source, Role::Source);
  if (const auto* refusal = std::get_if<plugins::Refusal>(&loaded)) {
    return fail(invocation, ExitCode::Plugin, refusal->text());
  }
  const auto& plugin = std::get<plugins::LoadedPlugin>(loaded);
  config::Problems problems;
  const ParameterValues values = sourceParameters(plugin, options, problems);
  if (!problems.empty()) {
    return fail(invocation, ExitCode::Configuration, config::format(problems));
  }
  auto created = plugins::Instance::create(plugin, "source");
  if (const auto* refusal = std::get_if<plugins::Refusal>(&created)) {
    return fail(invocation, ExitCode::Plugin, refusal->text());
  }
  inspect(std::move(std::get<std::unique_ptr<plugins::Instance>>(created)), values, options,
          invocation);
}

}  // namespace

void addDatasetCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("dataset", "Check data sets, and write them");
  command->require_subcommand(1);
  command->fallthrough();
  CLI::App* check_command = command->add_subcommand("check", "Is a data set sound?");
  auto options = std::make_shared<DatasetOptions>();
  check_command->add_option("path", options->path, "Folder of the data set")->required();
  check_command->add_option("--source", options->source, "Source plugin (default: kitti)");
  check_command->add_option("--set", options->overrides, "Parameter of the source: --set a=b")
      ->allow_extra_args(false);
  check_command->add_flag("--decode", options->decode, "Read every image, too");
  check_command->callback([options, &invocation] { check(*options, invocation); });
  addRenderCommand(*command, invocation);
}

}  // namespace tolman::app
