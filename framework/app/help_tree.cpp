// SPDX-License-Identifier: BSD-3-Clause
#include "app/help_tree.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/help_texts.hpp"
#include "engine/build_info.hpp"

namespace tolman::app {
namespace {

using Json = nlohmann::ordered_json;

/// The parts of `text` between `separator`, without blanks.
std::vector<std::string> splitAt(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(CLI::detail::trim_copy(part));
  }
  return parts;
}

/// "INT" of "INT:POSITIVE": the name without the suffix that a check of the value has added.
std::string nameOf(const std::string& type) { return type.substr(0, type.find(':')); }

/// The values of "se2|se3|sim3", and of a list that a check has added, "TEXT:{se2,se3}".
std::vector<std::string> choicesOf(const std::string& type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.rfind('}');
  if (open != std::string::npos && close != std::string::npos) {
    return splitAt(type.substr(open + 1, close - open - 1), ',');
  }
  const std::string name = nameOf(type);
  return name.find('|') == std::string::npos ? std::vector<std::string>() : splitAt(name, '|');
}

/// What a shell can offer for a value of this type name; empty: nothing.
std::string_view kindOf(const std::string& type) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kKinds = {
      {{"CONFIG", "configuration"},
       {"FILE", "file"},
       {"LIBRARY", "library"},
       {"PATH", "file"},
       {"FOLDER", "directory"},
       {"RUN", "directory"},
       {"PLUGIN", "plugin"},
       {"SOURCE", "plugin source"},
       {"OBSERVER", "plugin observer"},
       {"PATH=VALUE", "setting"},
       {"NAME=VALUE", "setting"},
       {"COMMAND", "command"}}};
  for (const auto& [name, kind] : kKinds) {
    if (nameOf(type) == name) return kind;
  }
  return choicesOf(type).empty() ? "" : "choice";
}

void describeValue(const CLI::Option& option, Json& json) {
  const std::string type = option.get_type_name();
  json["value"] = nameOf(type);
  json["kind"] = kindOf(type);
  if (const auto choices = choicesOf(type); !choices.empty()) json["choices"] = choices;
  if (!option.get_default_str().empty()) json["default"] = option.get_default_str();
  json["required"] = option.get_required();
}

Json optionTree(const CLI::Option& option) {
  Json names = Json::array();
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  Json json = {{"names", names}, {"text", option.get_description()}};
  if (option.get_items_expected_max() > 0) describeValue(option, json);
  return json;
}

Json positionalTree(const CLI::Option& option) {
  Json json = {{"name", option.get_single_name()}, {"text", option.get_description()}};
  describeValue(option, json);
  json["repeated"] = option.get_items_expected_max() >= CLI::detail::expected_max_vector_size;
  return json;
}

Json commandTree(const CLI::App& app, const std::string& words) {
  Json json = {{"name", app.get_name()},        {"words", words},
               {"text", app.get_description()}, {"options", Json::array()},
               {"positionals", Json::array()},  {"examples", Json::array()},
               {"commands", Json::array()}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    if (option->get_positional()) {
      json["positionals"].push_back(positionalTree(*option));
    } else {
      json["options"].push_back(optionTree(*option));
    }
  }
  for (const Example& example : examplesOf(words)) {
    json["examples"].push_back({{"command", example.command}, {"purpose", example.purpose}});
  }
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (sub->get_group().empty()) continue;
    json["commands"].push_back(commandTree(*sub, words + " " + sub->get_name()));
  }
  return json;
}

}  // namespace

nlohmann::ordered_json helpTree(const CLI::App& app) {
  Json exits = Json::array();
  for (const ExitMeaning& exit : exitMeanings()) {
    exits.push_back({{"code", static_cast<int>(exit.code)}, {"meaning", exit.meaning}});
  }
  return {{"program", app.get_name()},
          {"version", run::kVersion},
          {"exit_codes", exits},
          {"command", commandTree(app, app.get_name())}};
}

}  // namespace tolman::app
