// SPDX-License-Identifier: BSD-3-Clause
// tolman plugins: `list` (opens no plugin), `describe` (opens the plugins that it describes),
// `validate` (runs the checks of the conformance kit) and `doctor` (the checks of the opening
// alone).
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <utility>

#include "app/options.hpp"
#include "app/parameter_text.hpp"
#include "conformance/kit.hpp"
#include "engine/checked_system.hpp"
#include "host/child_process.hpp"
#include "host/library.hpp"
#include "host/remote_plugin.hpp"

namespace tolman::app {
namespace {

using conformance::CheckResult;
using conformance::CheckSeverity;
using conformance::ConformanceReport;
using conformance::KitOptions;
using host::Manifest;
using host::Refusal;
using Json = nlohmann::ordered_json;

void list(Invocation& invocation) {
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  Json json = Json::array();
  std::string text;
  const auto add = [&](std::string_view role, const Manifest& m) {
    const auto refusal = host::checkGate(m, host::HostIdentity::ofThisBuild());
    text += fmt::format("{:<9} {:<22} {:<7} {}\n", role, m.id, m.version,
                        refusal ? "refused: " + refusal->id : m.summary);
    if (!m.programs.empty()) return;
    json.push_back({{"id", m.id},
                    {"role", role},
                    {"version", m.version},
                    {"summary", m.summary},
                    {"file", m.file.string()},
                    {"refusal", refusal ? refusal->id : ""}});
  };
  for (const std::string_view role : kRoleNames) {
    for (const Manifest& m : catalogue.manifests()) {
      if (enumName(m.role) == role) add(role, m);
    }
  }
  for (const Manifest& m : catalogue.interpreters()) add("any", m);
  for (const auto& library : catalogue.broken()) {
    text += fmt::format("{:<9} {:<22} refused: {}\n", "-", library.file.filename().string(),
                        library.refusal.id);
  }
  std::cout << (invocation.json ? jsonText(json) : text);
}

/// The arguments of `describe`.
struct Description {
  std::vector<std::string> ids;
  bool markdown = false;
  bool json_schema = false;
};

/// Opens a plugin in a process of its own, because it may crash or block.
auto openApart(const Manifest& manifest, double deadline_s = 10) {
  host::LaunchOptions launch{engine::SystemOptions{}.stage_program};
  launch.deadline_s = deadline_s;
  return host::RemotePlugin::start(manifest, launch);
}

/// Throws engine::Failure.
host::LoadedPlugin open(const host::Catalogue& catalogue, const std::string& id) {
  const auto remote = engine::opening([&] { return openApart(catalogue.find(id)); });
  return {remote->manifest(), nullptr, remote->schema()};
}

/// All installed plugins that this host can use.
std::vector<host::LoadedPlugin> openUsable(const host::Catalogue& catalogue) {
  std::set<std::string> ids;
  for (const Manifest& manifest : catalogue.manifests()) ids.insert(manifest.id);
  std::vector<host::LoadedPlugin> opened;
  for (const std::string& id : ids) {
    try {
      opened.push_back(open(catalogue, id));
    } catch (const engine::Failure& failed) {
      std::cerr << "left out: " << failed.what() << "\n";
    }
  }
  return opened;
}

void describe(const Description& asked, Invocation& invocation) {
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  if (asked.ids.empty() && !asked.json_schema) throw CLI::RequiredError("id");
  std::vector<host::LoadedPlugin> loaded;
  if (asked.ids.empty()) loaded = openUsable(catalogue);
  for (const std::string& id : asked.ids) loaded.push_back(open(catalogue, id));
  if (asked.json_schema) {
    std::cout << jsonText(fileSchema(loaded));
  } else if (invocation.json) {  // one plugin as an object, several as a list
    Json json = Json::array();
    for (const host::LoadedPlugin& plugin : loaded) json.push_back(parametersJson(plugin));
    std::cout << jsonText(loaded.size() == 1 ? json.front() : json);
  } else {
    std::string separator;
    for (const host::LoadedPlugin& plugin : loaded) {
      std::cout << std::exchange(separator, "\n")
                << (asked.markdown ? parametersMarkdown(plugin) : parametersText(plugin));
    }
  }
}

/// The plugins of the file that are asked for: all of a library, or the one of --id. A program is
/// opened in a process of its own: only then is its role known. Throws Refusal.
std::vector<Manifest> pluginsIn(const KitOptions& options, const Invocation& invocation) {
  const std::string suffix = std::filesystem::path(options.file).extension();
  if (!suffix.empty() && suffix != ".so") {
    const Manifest found = engine::openCatalogue(invocation.plugin_paths).program(options.file);
    return {openApart(found, options.timeout)->manifest()};
  }
  const std::vector<Manifest> manifests = host::readManifests(options.file);
  if (options.id.empty()) return manifests;
  std::string known;
  for (const Manifest& manifest : manifests) {
    if (manifest.id == options.id) return {manifest};
    known += (known.empty() ? "" : ", ") + manifest.id;
  }
  throw Refusal{"plugin/not-found", options.file + " has no plugin '" + options.id + "'",
                "it has: " + known};
}

/// The report of a file without a readable manifest.
ConformanceReport refused(const KitOptions& options, const Refusal& refusal) {
  const CheckResult manifest{
      "manifest",
      1,
      "a manifest that can be read without opening the library",
      0,
      {{Finding::Severity::Error, {}, "[" + refusal.id + "] " + refusal.message, refusal.remedy}}};
  return {options.file, options.id, "", options.level, options.seed, {manifest}};
}

ExitCode codeOf(const ConformanceReport& report) {
  if (report.conforms()) return ExitCode::Ok;
  const CheckResult& last = report.checks.back();
  const bool settings = last.check == "settings" && last.severity() == CheckSeverity::Error;
  return settings ? ExitCode::Configuration : ExitCode::Plugin;
}

/// Runs checks on the plugins of a file and prints each result at once, with `summaries` behind
/// those of each plugin.
void validate(KitOptions options, bool summaries, Invocation& invocation) {
  options.program = {thisProgram().string(), "plugins", "run-check"};
  if (host::ScratchFolder("tolman-validate").path().empty()) {
    throw engine::Failure(engine::FailureKind::Record, host::kNoScratchFolder);
  }
  const auto print = [&](const CheckResult& result) {
    const bool fault = result.severity() >= CheckSeverity::Warning;
    if (!invocation.json && (fault || !invocation.quiet)) {
      std::cout << conformance::text(result) << std::flush;
    }
  };
  std::vector<ConformanceReport> reports;
  try {
    for (const Manifest& manifest : pluginsIn(options, invocation)) {
      options.file = manifest.file;
      options.id = manifest.id;
      options.program_file = manifest.program;
      reports.push_back(conformance::validate(options, manifest.role, print));
      if (summaries && !invocation.json) {
        std::cout << conformance::summary(reports.back()) << std::flush;
      }
    }
  } catch (const Refusal& refusal) {
    if (refusal.id == host::kNoProcess) {
      throw engine::Failure(engine::FailureKind::Machine, refusal.text());
    }
    reports.push_back(refused(options, refusal));
    print(reports.back().checks.back());
  }
  Json all = Json::array();
  for (const ConformanceReport& report : reports) {
    all.push_back(conformance::json(report));
    if (invocation.exit_code == ExitCode::Ok) invocation.exit_code = codeOf(report);
  }
  if (invocation.json) std::cout << jsonText(all);
}

void addValidateCommand(CLI::App& plugins, Invocation& invocation) {
  CLI::App& command =
      *plugins.add_subcommand("validate", "Check whether a plugin keeps the contract");
  auto options = std::make_shared<KitOptions>();
  addArgument(command, "file", options->file, "FILE", "Library, *.so, or a program such as *.py");
  addOption(command, "--id", options->id, "ID", "One plugin of the library; else all");
  addOption(command, "--level", options->level, "1|2|3",
            "1 contract, 2 reproducible results, 3 all checks")
      ->check(CLI::Range(1, 3))
      ->capture_default_str();
  addOption(command, "--seed", options->seed, "N", "Seed of the images and random parameters")
      ->capture_default_str();
  addList(command, "--set", options->set, "NAME=VALUE", "A parameter, key=value (repeatable)");
  addList(command, "--check", options->only, "NAME", "Only this check (repeatable)")
      ->check(CLI::IsMember(conformance::checkIds()));
  addOption(command, "--timeout", options->timeout, "S", "Seconds for each check")
      ->check(positive)
      ->capture_default_str();
  addOption(command, "--memory", options->memory_mib, "MIB", "MiB for each check; 0 for no limit")
      ->capture_default_str();
  command.callback([options, &invocation] { validate(*options, true, invocation); });

  CLI::App& inside = *plugins.add_subcommand("run-check", "Run one check (internal)")->group("");
  auto task = std::make_shared<std::string>();
  addArgument(inside, "task", *task, "TASK", "");
  inside.callback([task] { conformance::runCheck(*task); });
}

}  // namespace

void addPluginsCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand("plugins", "List, describe and examine plugins");
  command.require_subcommand(1);
  command.fallthrough();
  command.add_subcommand("list", "Plugins on the search path; opens none of them")
      ->callback([&invocation] { list(invocation); });

  CLI::App& describing = *command.add_subcommand("describe", "Parameters of plugins");
  auto asked = std::make_shared<Description>();
  addOption(describing, "id", asked->ids, "PLUGIN", "Plugin ids, or programs such as my_cells.py");
  auto* markdown = describing.add_flag("--markdown", asked->markdown, "As a reference page");
  describing
      .add_flag("--json-schema", asked->json_schema,
                "As a JSON Schema of a configuration file with these plugins, without ids with all")
      ->excludes(markdown);
  describing.callback([asked, &invocation] { describe(*asked, invocation); });

  CLI::App& examining =
      *command.add_subcommand("doctor", "Test step by step whether a plugin library can be opened");
  auto opening = std::make_shared<KitOptions>();
  opening->only = {"manifest", "load", "life-unused"};
  opening->timeout = 10;  // usually it takes milliseconds
  addArgument(examining, "file", opening->file, "FILE", "Library (*.so), or program such as *.py");
  examining.callback([opening, &invocation] { validate(*opening, false, invocation); });

  addPluginsNewCommand(command, invocation);
  addValidateCommand(command, invocation);
}

}  // namespace tolman::app
