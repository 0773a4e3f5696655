// SPDX-License-Identifier: BSD-3-Clause
// tolman plugins new ROLE NAME [DIR]: creates the repository of a new plugin from the templates
// that come with the SDK. It builds and passes its tests unchanged.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <iostream>
#include <map>

#include "app/options.hpp"
#include "base/text_file.hpp"
#include "config/text.hpp"
#include "engine/checked_system.hpp"
#include "host/manifest.hpp"
#include "record/atomic_file.hpp"
#include "tolman/version.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using Values = std::map<std::string, std::string>;

constexpr std::size_t kLongestName = 40;

struct Request {
  std::string role;
  std::string name;
  std::string folder;
  bool python = false;
};

/// A word of a shell command, quoted if necessary.
std::string quoted(const std::string& word) {
  if (word.find_first_of(" \t'\"\\$&;()<>|*?[]#~`!") == std::string::npos) return word;
  return "'" + boost::replace_all_copy(word, "'", "'\\''") + "'";
}

/// The name must be an identifier in every language, and two plugins with one id cannot be
/// distinguished: the first is taken, and in another role its id is refused. A program has the name
/// of its file.
void refuseName(const Request& request, const Invocation& invocation) {
  const std::string& name = request.name;
  const auto isLegal = [](char c) {
    return (c >= 'a' && c <= 'z') || config::isDigit(c) || c == '_';
  };
  const bool legal = std::ranges::all_of(name, isLegal) && !name.empty() && name.front() >= 'a' &&
                     name.back() != '_' && name.find("__") == std::string::npos &&
                     name.size() <= kLongestName;
  if (!legal) {
    fail(ExitCode::Usage,
         fmt::format(
             "'{}' cannot be the name of a plugin: it takes small letters, digits and single "
             "underscores, begins with a letter and has {} of them at most, as my_places",
             name, kLongestName));
  }
  // Other files of a repository, and Python's None, True and False.
  constexpr std::array kTaken = {"plugin", "test_context", "none", "true", "false"};
  if (std::ranges::find(kTaken, name) != kTaken.end()) {
    fail(ExitCode::Usage,
         "'" + name + "' has another meaning in the repository; try 'my_" + name + "'");
  }
  if (request.python) return;
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  const auto& known = catalogue.manifests();
  const auto taken = std::ranges::find(known, name, &host::Manifest::id);
  if (taken == known.end()) return;
  fail(ExitCode::Usage,
       fmt::format("'{0}' is the id of a plugin that is installed ({1}, {2}); choose another, "
                   "such as my_{0}",
                   name, enumName(taken->role), taken->file.string()));
}

/// The templates that belong to a program in PREFIX/bin or in a build tree.
fs::path templateFolder() {
  const fs::path folder = thisProgram().parent_path().parent_path() / "share/tolman/template";
  std::error_code error;
  if (fs::is_directory(folder / "shared", error)) return folder;
  fail(ExitCode::Record, folder.string() +
                             ": the templates are not there; install the SDK (Debian: "
                             "libtolman-sdk-dev) beside this program");
}

/// "my_places" to "MyPlaces".
std::string className(const std::string& id) {
  std::string name;
  bool begins_word = true;
  for (const char c : id) {
    if (c != '_') name += begins_word ? static_cast<char>(std::toupper(c)) : c;
    begins_word = c == '_';
  }
  return name;
}

/// The placeholders' values. `about`: a summary line, an empty line, and the description.
Values valuesOf(const Request& request, const std::string& about) {
  const std::size_t line = std::min(about.find('\n'), about.size());
  const std::size_t rest = std::min(about.find_first_not_of('\n', line), about.size());
  const std::size_t end = std::max(about.find_last_not_of('\n') + 1, rest);
  return {{"NAME", request.name},
          {"CLASS", className(request.name)},
          {"ROLE", request.role},
          {"SDK_VERSION", TOLMAN_SDK_VERSION},
          {"SUMMARY", about.substr(0, line)},
          {"ABOUT", about.substr(rest, end - rest)}};
}

/// Replaces each @NAME@ by its value.
std::string fillIn(std::string text, const Values& values) {
  for (const auto& [name, value] : values) boost::replace_all(text, "@" + name + "@", value);
  return text;
}

/// Copies the templates, filled in; returns the files, relative to the folder.
std::vector<fs::path> copyFilled(const fs::path& from, const fs::path& to, const Values& values) {
  std::vector<fs::path> written;
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".in") continue;
    const std::string text = valueOf(text_encoding::readText(entry.path()), ExitCode::Record);
    written.emplace_back(
        fillIn(fs::relative(entry.path(), from).replace_extension().string(), values));
    std::error_code ignored;  // the write below fails with a better message
    fs::create_directories((to / written.back()).parent_path(), ignored);
    failUnless(
        record::writeAtomically(to / written.back(), fillIn(text, values), record::Sync::No));
  }
  return written;
}

/// Makes the folder, or takes an empty one.
void makeFolder(const fs::path& folder) {
  std::error_code error;
  const bool is_there = fs::exists(folder, error);
  if (is_there && !(fs::is_directory(folder, error) && fs::is_empty(folder, error))) {
    fail(ExitCode::Record, folder.string() +
                               ": is there already and not an empty folder; name another one, or "
                               "remove it");
  }
  fs::create_directories(folder, error);
  if (!error) return;
  fail(ExitCode::Record, folder.string() + ": the plugin's folder cannot be written (" +
                             error.message() +
                             "); name another one: tolman plugins new ROLE NAME FOLDER");
}

std::string nextCommands(const Request& request, const fs::path& folder) {
  const fs::path prefix = thisProgram().parent_path().parent_path();
  const bool is_usual = prefix == "/usr" || prefix == "/usr/local";  // CMake searches them
  const std::string program = is_usual ? "tolman" : quoted(thisProgram().string());
  if (request.python) {
    return fmt::format("next:\n  cd {0}\n  {1} run {2}.yaml\n  {1} plugins validate {2}.py\n",
                       quoted(folder.string()), program, request.name);
  }
  return fmt::format(
      "next:\n"
      "  cd {}\n"
      "  cmake -S . -B build{}\n"
      "  cmake --build build\n"
      "  ctest --test-dir build\n"
      "  {} run chain.yaml --plugin-path build\n",
      quoted(folder.string()), is_usual ? "" : " -DCMAKE_PREFIX_PATH=" + quoted(prefix.string()),
      program);
}

void makePlugin(const Request& request, const Invocation& invocation) {
  refuseName(request, invocation);
  const fs::path templates = templateFolder();
  const fs::path folder = request.folder.empty() ? request.name : request.folder;
  const fs::path of_role = templates / request.role;
  const Values values =
      valuesOf(request, valueOf(text_encoding::readText(of_role / "about.md"), ExitCode::Record));
  makeFolder(folder);
  std::vector<fs::path> written =
      copyFilled(request.python ? templates / "python" / request.role : of_role, folder, values);
  if (!request.python) {
    const auto shared = copyFilled(templates / "shared", folder, values);
    written.insert(written.end(), shared.begin(), shared.end());
  }
  std::ranges::sort(written);
  if (invocation.json) {
    nlohmann::ordered_json json = {{"folder", fs::absolute(folder).string()},
                                   {"files", nlohmann::ordered_json::array()}};
    for (const fs::path& file : written) json["files"].push_back(file.string());
    std::cout << jsonText(json);
  } else if (!invocation.quiet) {
    std::cout << fmt::format("wrote {} files to {}\n", written.size(), folder.string())
              << nextCommands(request, folder);
  }
}

}  // namespace

void addPluginsNewCommand(CLI::App& plugins, Invocation& invocation) {
  CLI::App& command =
      *plugins.add_subcommand("new", "A repository of your own, with a plugin that works");
  auto request = std::make_shared<Request>();
  addChoice(command, "role", request->role, {kRoleNames.begin(), kRoleNames.end()},
            "Role of the plugin")
      ->required();
  addArgument(command, "name", request->name, "ID", "Id of the plugin, such as my_places");
  addOption(command, "dir", request->folder, "FOLDER", "Folder to write; default: NAME");
  command.add_flag("--python", request->python, "One file in Python instead of C++");
  command.callback([request, &invocation] { makePlugin(*request, invocation); });
}

}  // namespace tolman::app
