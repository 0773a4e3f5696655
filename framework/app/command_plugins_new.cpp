// SPDX-License-Identifier: BSD-3-Clause
// tolman plugins new ROLE NAME [DIR]: creates the repository of a new plugin, which builds and
// passes its tests unchanged.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <iostream>

#include "app/options.hpp"
#include "app/plugin_template.hpp"
#include "config/text.hpp"
#include "engine/checked_system.hpp"
#include "host/catalogue.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

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

std::string nextCommands(const Request& request, const fs::path& folder,
                         const fs::path& executable) {
  const auto prefix = unusualPrefix(executable);
  const std::string program = prefix ? quoted(executable.string()) : "tolman";
  if (request.python) {
    return fmt::format("next:\n  cd {0}\n  {1} run {2}.yaml\n  {1} plugins validate {2}.py\n",
                       quoted(folder.string()), program, request.name);
  }
  const std::string sdk = prefix ? " -DCMAKE_PREFIX_PATH=" + quoted(prefix->string()) : "";
  return fmt::format(
      "next:\n"
      "  cd {}\n"
      "  cmake -S . -B build{}\n"
      "  cmake --build build\n"
      "  ctest --test-dir build\n"
      "  {} run chain.yaml --plugin-path build\n",
      quoted(folder.string()), sdk, program);
}

/// Refuses the id of a plugin that is on the search path. Two with one id cannot be distinguished:
/// the first is taken, and in another role its id is refused. A program has the name of its file.
void refuseTaken(const std::string& name, const Invocation& invocation) {
  const host::Catalogue catalogue = engine::openCatalogue(invocation.plugin_paths);
  const auto& known = catalogue.manifests();
  const auto taken = std::ranges::find(known, name, &host::Manifest::id);
  if (taken == known.end()) return;
  fail(ExitCode::Usage,
       fmt::format("'{0}' is the id of a plugin that is installed ({1}, {2}); choose another, "
                   "such as my_{0}",
                   name, enumName(taken->role), taken->file.string()));
}

void makePlugin(const Request& request, const Invocation& invocation) {
  const Role role = *config::valueNamed<Role>(request.role);
  if (const auto objection = objectionTo(request.name)) fail(ExitCode::Usage, *objection);
  if (!request.python) refuseTaken(request.name, invocation);
  std::error_code ignored;
  const fs::path executable = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path templates = valueOf(templateFolder(executable), ExitCode::Record);

  const fs::path folder = request.folder.empty() ? request.name : request.folder;
  const auto written = valueOf(
      writeNewPlugin(templates, {role, request.name, folder, request.python}), ExitCode::Record);
  if (invocation.json) {
    nlohmann::ordered_json json = {{"folder", fs::absolute(folder).string()},
                                   {"files", nlohmann::ordered_json::array()}};
    for (const fs::path& file : written) json["files"].push_back(file.string());
    std::cout << jsonText(json);
  } else if (!invocation.quiet) {
    std::cout << fmt::format("wrote {} files to {}\n", written.size(), folder.string())
              << nextCommands(request, folder, executable);
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
