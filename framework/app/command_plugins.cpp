// SPDX-License-Identifier: BSD-3-Clause
// tolman plugins: `list` (opens no plugin), `describe` (opens the plugins that it describes) and
// `doctor` (opens one file, step by step). `new` and `validate` have source files of their own.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>
#include <utility>

#include "app/options.hpp"
#include "app/parameter_text.hpp"
#include "engine/assembly.hpp"
#include "host/gate.hpp"
#include "host/remote_plugin.hpp"

namespace tolman::app {
namespace {

using host::HostIdentity;
using host::Manifest;
using host::Refusal;

void listJson(const host::Catalogue& catalogue) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Manifest& m : catalogue.manifests()) {
    const auto refusal = host::checkGate(m, HostIdentity::ofThisBuild());
    json.push_back({{"id", m.id},
                    {"role", enumName(m.role)},
                    {"version", m.version},
                    {"summary", m.summary},
                    {"file", m.file.string()},
                    {"refusal", refusal ? refusal->id : ""}});
  }
  std::cout << jsonText(json);
}

void list(Invocation& invocation) {
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  if (invocation.json) return listJson(catalogue);
  for (const std::string_view role : kRoleNames) {
    for (const Manifest& m : catalogue.manifests()) {
      if (enumName(m.role) != role) continue;
      const auto refusal = host::checkGate(m, HostIdentity::ofThisBuild());
      std::cout << fmt::format("{:<9} {:<22} {:<7} {}\n", role, m.id, m.version,
                               refusal ? "refused: " + refusal->id : m.summary);
    }
  }
  for (const Manifest& m : catalogue.interpreters()) {
    std::cout << fmt::format("{:<9} {:<22} {:<7} {}\n", "any", m.id, m.version, m.summary);
  }
  for (const auto& library : catalogue.broken()) {
    std::cout << fmt::format("{:<9} {:<22} refused: {}\n", "-", library.file.filename().string(),
                             library.refusal.id);
  }
}

/// The arguments of `describe`.
struct Description {
  std::vector<std::string> ids;
  bool markdown = false;
  bool json_schema = false;
};

/// Opens a library in a process of its own, because it may crash or block.
auto openApart(const Manifest& manifest) {
  host::LaunchOptions launch{engine::SystemOptions{}.stage_program};
  launch.deadline_s = 10;  // usually it takes milliseconds
  return host::RemotePlugin::start(manifest, launch);
}

/// Throws engine::Failed.
host::LoadedPlugin open(const host::Catalogue& catalogue, const std::string& id) {
  const auto remote = engine::require(openApart(engine::require(catalogue.find(id))));
  return {remote->manifest(), nullptr, remote->schema()};
}

/// All installed plugins that this host can use.
std::vector<host::LoadedPlugin> openUsable(const Invocation& invocation) {
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  std::set<std::string> ids;
  for (const Manifest& manifest : catalogue.manifests()) ids.insert(manifest.id);
  std::vector<host::LoadedPlugin> opened;
  for (const std::string& id : ids) {
    try {
      opened.push_back(open(catalogue, id));
    } catch (const engine::Failed& failed) {
      std::cerr << "left out: " << failed.what() << "\n";
    }
  }
  return opened;
}

void describe(const Description& asked, Invocation& invocation) {
  if (asked.ids.empty()) {
    if (!asked.json_schema) throw CLI::RequiredError("id");
    std::cout << jsonText(fileSchema(openUsable(invocation)));
    return;
  }
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  std::vector<host::LoadedPlugin> loaded;
  for (const std::string& id : asked.ids) loaded.push_back(open(catalogue, id));
  if (asked.json_schema) {
    std::cout << jsonText(stageSchema(loaded));
    return;
  }
  if (invocation.json) {  // one plugin as an object, several as a list
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const host::LoadedPlugin& plugin : loaded) json.push_back(parametersJson(plugin));
    std::cout << jsonText(loaded.size() == 1 ? json.front() : json);
    return;
  }
  std::string separator;
  for (const host::LoadedPlugin& plugin : loaded) {
    std::cout << std::exchange(separator, "\n")
              << (asked.markdown ? parametersMarkdown(plugin) : parametersText(plugin));
  }
}

/// Tests the gate, opens the library and constructs the plugin. Prints each step that succeeds;
/// returns the reason if one fails.
std::optional<Refusal> examine(const Manifest& manifest) {
  const std::string role =
      manifest.programs.empty() ? "role " + std::string(enumName(manifest.role)) : "any role";
  std::cout << fmt::format("manifest   {} {} of {}, SDK {}.{}\n           {}\n", manifest.id,
                           manifest.version, role, manifest.sdk_major, manifest.sdk_minor,
                           manifest.fingerprint);
  if (auto refusal = host::checkGate(manifest, HostIdentity::ofThisBuild())) return refusal;
  std::cout << "gate       passed\n";
  const auto opened = openApart(manifest);
  if (const auto* refusal = std::get_if<Refusal>(&opened)) return *refusal;
  host::RemotePlugin& plugin = *std::get<std::shared_ptr<host::RemotePlugin>>(opened);
  std::cout << fmt::format("open       all symbols resolved, {} parameters\n",
                           plugin.schema().size());
  if (const auto refusal = plugin.create()) return *refusal;
  const Status destroyed = plugin.destroy();
  if (!destroyed.isOk()) {
    return Refusal{"plugin/destroy-failed", destroyed.message(), "a destructor must not throw"};
  }
  std::cout << "construct  made and destroyed\n";
  return std::nullopt;
}

/// Manifests of a library, or of a program for an interpreter. Throws engine::Failed.
std::vector<Manifest> manifestsOf(const std::string& file, const Invocation& invocation) {
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  const std::string suffix = std::filesystem::path(file).extension();
  const bool is_program = std::ranges::any_of(
      catalogue.interpreters(), [&](const Manifest& m) { return m.programs == suffix; });
  if (is_program) return {engine::require(catalogue.program(file))};
  return engine::require(host::readManifests(file));
}

void doctor(const std::string& file, Invocation& invocation) {
  for (const Manifest& manifest : manifestsOf(file, invocation)) {
    const auto refusal = examine(manifest);
    if (refusal)
      invocation.exit_code = printFailure(exitCode(engine::kindOf(*refusal)), refusal->text());
  }
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
                "As a JSON Schema of one stage, or, without ids, of a whole configuration file")
      ->excludes(markdown);
  describing.callback([asked, &invocation] { describe(*asked, invocation); });

  CLI::App& examining =
      *command.add_subcommand("doctor", "Test step by step whether a plugin library can be opened");
  auto file = std::make_shared<std::string>();
  addArgument(examining, "file", *file, "FILE", "Library (*.so), or program such as *.py");
  examining.callback([file, &invocation] { doctor(*file, invocation); });

  addPluginsNewCommand(command, invocation);
  addValidateCommand(command, invocation);
}

}  // namespace tolman::app
