// SPDX-License-Identifier: BSD-3-Clause
// tolman plugins: list (opens none), describe (opens what it describes), doctor (one file, step by
// step), and validate, which has a file of its own.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "app/assembly.hpp"
#include "app/json_schema.hpp"
#include "app/parameter_text.hpp"
#include "app/program.hpp"
#include "plugins/gate.hpp"
#include "plugins/instance.hpp"

namespace tolman::app {
namespace {

using plugins::HostIdentity;
using plugins::Manifest;
using plugins::Refusal;

void fail(Invocation& invocation, const Refusal& refusal) {
  std::cerr << refusal.text() << "\n";
  invocation.exit_code = static_cast<int>(ExitCode::Plugin);
}

void listJson(const plugins::Catalogue& catalogue) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Manifest& m : catalogue.manifests()) {
    const auto refusal = plugins::checkGate(m, HostIdentity::ofThisBuild());
    json.push_back({{"id", m.id},
                    {"role", enumName(m.role)},
                    {"version", m.version},
                    {"summary", m.summary},
                    {"file", m.file.string()},
                    {"refusal", refusal ? refusal->id : ""}});
  }
  std::cout << json.dump(2) << "\n";
}

void list(Invocation& invocation) {
  const plugins::Catalogue catalogue = openCatalogue(invocation.plugin_paths);
  if (invocation.json) return listJson(catalogue);
  for (const std::string_view role : kRoleNames) {
    for (const Manifest& m : catalogue.manifests()) {
      if (enumName(m.role) != role) continue;
      const auto refusal = plugins::checkGate(m, HostIdentity::ofThisBuild());
      std::cout << fmt::format("{:<9} {:<22} {:<7} {}\n", role, m.id, m.version,
                               refusal ? "refused: " + refusal->id : m.summary);
    }
  }
  for (const auto& library : catalogue.broken()) {
    std::cout << fmt::format("{:<9} {:<22} refused: {}\n", "-", library.file.filename().string(),
                             library.refusal.id);
  }
}

/// What `describe` was asked for.
struct Description {
  std::vector<std::string> ids;
  bool markdown = false;
  bool json_schema = false;
};

plugins::OrRefusal<plugins::LoadedPlugin> open(const plugins::Catalogue& catalogue,
                                               const std::string& id) {
  auto found = catalogue.find(id);
  if (auto* refusal = std::get_if<Refusal>(&found)) return std::move(*refusal);
  return plugins::loadPlugin(std::get<Manifest>(found), HostIdentity::ofThisBuild());
}

/// All plugins of these ids, or the reason why one of them cannot be opened.
plugins::OrRefusal<std::vector<plugins::LoadedPlugin>> openAll(const std::vector<std::string>& ids,
                                                               const Invocation& invocation) {
  const plugins::Catalogue catalogue = openCatalogue(invocation.plugin_paths);
  std::vector<plugins::LoadedPlugin> opened;
  for (const std::string& id : ids) {
    auto plugin = open(catalogue, id);
    if (auto* refusal = std::get_if<Refusal>(&plugin)) return std::move(*refusal);
    opened.push_back(std::get<plugins::LoadedPlugin>(std::move(plugin)));
  }
  return opened;
}

/// All that this host can use of what is installed.
std::vector<plugins::LoadedPlugin> openUsable(const Invocation& invocation) {
  const plugins::Catalogue catalogue = openCatalogue(invocation.plugin_paths);
  std::set<std::string> ids;
  for (const Manifest& manifest : catalogue.manifests()) ids.insert(manifest.id);
  std::vector<plugins::LoadedPlugin> opened;
  for (const std::string& id : ids) {
    auto plugin = open(catalogue, id);
    if (const auto* refusal = std::get_if<Refusal>(&plugin)) {
      std::cerr << "left out: " << refusal->text() << "\n";
    } else {
      opened.push_back(std::get<plugins::LoadedPlugin>(std::move(plugin)));
    }
  }
  return opened;
}

/// One plugin as an object, several as a list.
void describeJson(const std::vector<plugins::LoadedPlugin>& loaded) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const plugins::LoadedPlugin& plugin : loaded) json.push_back(parametersJson(plugin));
  std::cout << (loaded.size() == 1 ? json.front() : json).dump(2) << "\n";
}

void describe(const Description& asked, Invocation& invocation) {
  if (asked.ids.empty()) {
    if (!asked.json_schema) throw CLI::RequiredError("id");
    std::cout << fileSchema(openUsable(invocation)).dump(2) << "\n";
    return;
  }
  const auto opened = openAll(asked.ids, invocation);
  if (const auto* refusal = std::get_if<Refusal>(&opened)) return fail(invocation, *refusal);
  const auto& loaded = std::get<std::vector<plugins::LoadedPlugin>>(opened);
  if (asked.json_schema) {
    std::cout << stageSchema(loaded).dump(2) << "\n";
    return;
  }
  if (invocation.json) return describeJson(loaded);
  std::string separator;
  for (const plugins::LoadedPlugin& plugin : loaded) {
    std::cout << std::exchange(separator, "\n")
              << (asked.markdown ? parametersMarkdown(plugin) : parametersText(plugin));
  }
}

/// Gate, open, construct: says each step that worked, then what did not.
std::optional<Refusal> examine(const Manifest& manifest) {
  std::cout << fmt::format("manifest   {} {} of role {}, SDK {}.{}\n           {}\n", manifest.id,
                           manifest.version, enumName(manifest.role), manifest.sdk_major,
                           manifest.sdk_minor, manifest.fingerprint);
  if (auto refusal = plugins::checkGate(manifest, HostIdentity::ofThisBuild())) return refusal;
  std::cout << "gate       passed\n";
  const auto loaded = plugins::loadPlugin(manifest, HostIdentity::ofThisBuild());
  if (const auto* refusal = std::get_if<Refusal>(&loaded)) return *refusal;
  const auto& plugin = std::get<plugins::LoadedPlugin>(loaded);
  std::cout << fmt::format("open       all symbols resolved, {} parameters\n",
                           plugin.schema.size());
  auto created = plugins::Instance::create(plugin, manifest.id);
  if (const auto* refusal = std::get_if<Refusal>(&created)) return *refusal;
  const Status destroyed = std::get<std::unique_ptr<plugins::Instance>>(created)->destroy();
  if (!destroyed.isOk()) {
    return Refusal{"plugin/destroy-failed", destroyed.message(), "a destructor must not throw"};
  }
  std::cout << "construct  made and destroyed\n";
  return std::nullopt;
}

void doctor(const std::string& file, Invocation& invocation) {
  const auto read = plugins::readManifests(file);
  if (const auto* refusal = std::get_if<Refusal>(&read)) return fail(invocation, *refusal);
  for (const Manifest& manifest : std::get<std::vector<Manifest>>(read)) {
    if (const auto refusal = examine(manifest)) fail(invocation, *refusal);
  }
}

}  // namespace

void addPluginsCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("plugins", "List, describe and examine plugins");
  command->require_subcommand(1);
  command->fallthrough();
  command->add_subcommand("list", "Plugins on the search path; opens none of them")
      ->callback([&invocation] { list(invocation); });

  CLI::App* one = command->add_subcommand("describe", "Parameters of plugins");
  auto asked = std::make_shared<Description>();
  one->add_option("id", asked->ids, "Plugin ids");
  auto* markdown = one->add_flag("--markdown", asked->markdown, "As a reference page");
  one->add_flag("--json-schema", asked->json_schema,
                "As JSON Schema of a stage; without ids of a whole configuration file")
      ->excludes(markdown);
  one->callback([asked, &invocation] { describe(*asked, invocation); });

  CLI::App* doctor_command =
      command->add_subcommand("doctor", "Why does a plugin library (not) load?");
  auto file = std::make_shared<std::string>();
  doctor_command->add_option("file", *file, "Library, *.so")->required();
  doctor_command->callback([file, &invocation] { doctor(*file, invocation); });

  addPluginsNewCommand(*command, invocation);
  addValidateCommand(*command, invocation);
}

}  // namespace tolman::app
