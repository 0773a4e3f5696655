// SPDX-License-Identifier: BSD-3-Clause
#include "host/catalogue.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "config/text.hpp"

namespace tolman::host {
namespace fs = std::filesystem;

namespace {

/// The plugin folders of the tree that the executable lies in: <prefix>/bin/tolman.
std::vector<fs::path> treeOf(const fs::path& executable) {
  const fs::path prefix = executable.parent_path().parent_path();
  if (fs::exists(prefix / "CMakeCache.txt")) return {prefix / "plugins"};
  std::vector<fs::path> folders;
  for (const char* library_folder : {"lib", "lib/x86_64-linux-gnu", "lib64"}) {
    const fs::path folder = prefix / library_folder / "tolman/plugins";
    if (fs::is_directory(folder)) folders.push_back(folder);
  }
  return folders;
}

std::vector<fs::path> librariesIn(const fs::path& place) {
  std::error_code error;
  if (fs::is_regular_file(place, error)) return {place};
  std::vector<fs::path> files;
  for (fs::directory_iterator it(place, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".so") files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> searchPath(const std::vector<std::string>& command_line,
                                 const char* environment, const fs::path& executable) {
  std::vector<fs::path> path(command_line.begin(), command_line.end());
  std::istringstream list(environment != nullptr ? environment : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) path.emplace_back(folder);
  }
  const auto tree = treeOf(executable);
  path.insert(path.end(), tree.begin(), tree.end());
  return path;
}

Catalogue::Catalogue(std::vector<fs::path> search_path) : search_path_(std::move(search_path)) {
  std::set<fs::path>
      seen;  // the search path may contain a folder twice, also as two different paths
  for (const fs::path& place : search_path_) {
    for (const fs::path& file : librariesIn(place)) {
      std::error_code error;
      const fs::path real = fs::weakly_canonical(file, error);
      if (seen.insert(error ? file : real).second) addLibrary(file);
    }
  }
}

void Catalogue::addLibrary(const fs::path& file) {
  try {
    for (Manifest& manifest : readManifests(file)) {
      (manifest.programs.empty() ? manifests_ : interpreters_).push_back(std::move(manifest));
    }
  } catch (const Refusal& refusal) {
    broken_.push_back({file, refusal});
  }
}

Manifest Catalogue::find(const std::string& id, Role role) const {
  if (fs::path(id).has_extension()) throw notFound(id, role);  // the file of a program, not an id
  Manifest manifest = findLibrary(id, role);
  if (manifest.role == role) return manifest;
  throw Refusal{"plugin/wrong-role",
                "plugin '" + id + "' (" + manifest.file.string() + ") has the role " +
                    std::string(enumName(manifest.role)) + ", not " + std::string(enumName(role)),
                "`tolman plugins list` shows the plugins of each role"};
}

const Manifest* Catalogue::interpreter(const std::string& id) const {
  const auto found = std::ranges::find(interpreters_, id, &Manifest::id);
  return found == interpreters_.end() ? nullptr : &*found;
}

Manifest Catalogue::program(const fs::path& file) const {
  const std::string suffix = file.extension().string();
  const auto found = std::ranges::find(interpreters_, suffix, &Manifest::programs);
  if (found == interpreters_.end()) {
    throw Refusal{"plugin/not-found",
                  file.string() + ": no plugin on the search path runs '" + suffix + "' files",
                  "`tolman plugins list` shows what is there; the plugin may be in a package of "
                  "its own, or have been left out of the build for want of a library"};
  }
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw Refusal{"plugin/not-found", file.string() + ": there is no such file",
                  "correct the path; it is relative to the configuration that says it"};
  }
  Manifest manifest = *found;
  manifest.program = fs::absolute(file);
  return manifest;
}

Manifest Catalogue::find(const std::string& id) const {
  if (const fs::path file = id; file.has_extension()) return program(file);
  return findLibrary(id, std::nullopt);
}

/// `role` is for the message where there is none.
Manifest Catalogue::findLibrary(const std::string& id, std::optional<Role> role) const {
  const auto is_wanted = [&](const Manifest& manifest) { return manifest.id == id; };
  const auto first = std::find_if(manifests_.begin(), manifests_.end(), is_wanted);
  if (first == manifests_.end()) throw notFound(id, role);
  const auto second = std::find_if(first + 1, manifests_.end(), is_wanted);
  if (second != manifests_.end() && second->file.parent_path() == first->file.parent_path()) {
    throw Refusal{"plugin/ambiguous",
                  "plugin '" + id + "' is in both " + first->file.string() + " and " +
                      second->file.filename().string(),
                  "remove one of the two files, or give the wanted one with --plugin-path FILE"};
  }
  return *first;
}

Refusal Catalogue::notFound(const std::string& id, std::optional<Role> role) const {
  std::string kind = role ? std::string(enumName(*role)) + " plugin" : "plugin";
  std::string message = "no " + kind + " '" + id + "' in";
  for (const fs::path& place : search_path_) message += " " + place.string();
  if (search_path_.empty()) message += " any folder: the search path is empty";
  for (const BrokenLibrary& library : broken_) {
    if (library.file.stem().string().find(id) == std::string::npos) continue;
    message += "\n    " + library.file.string() +
               " may be it, but cannot be used: " + library.refusal.text();
  }
  std::vector<std::string> known;
  for (const Manifest& manifest : manifests_) {
    if (!role || manifest.role == *role) known.push_back(manifest.id);
  }
  for (const Manifest& manifest : interpreters_) {
    if (manifest.id == id) {
      return {"plugin/not-found", "'" + id + "' is no plugin itself, it runs one that a file holds",
              "give the file of the plugin in place of '" + id +
                  "', or use it in a configuration with the parameter 'file'"};
    }
    known.push_back(manifest.id);
  }
  const std::optional<std::string> nearest = config::nearestName(id, known);
  return {"plugin/not-found", message,
          (nearest ? "did you mean '" + *nearest + "'? " : std::string()) +
              "`tolman plugins list` shows the plugins found; --plugin-path adds a folder"};
}

}  // namespace tolman::host
