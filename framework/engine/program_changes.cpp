// SPDX-License-Identifier: BSD-3-Clause
#include "engine/program_changes.hpp"

#include <algorithm>
#include <iterator>

namespace tolman::run {
namespace {

using Json = nlohmann::ordered_json;

/// Null if there is no such key, or `json` is no object.
Json valueAt(const Json& json, const std::string& key) {
  return json.is_object() && json.contains(key) ? json[key] : Json();
}

Json objectAt(const Json& json, const std::string& key) {
  Json value = valueAt(json, key);
  return value.is_object() ? value : Json::object();
}

/// Adds the names of those of `files` (digests by path) that `others` does not have. A file may
/// have another path there, as a package that is installed elsewhere.
void addFilesNotIn(const Json& others, const Json& files, std::vector<std::string>& names) {
  for (const auto& [file, digest] : files.items()) {
    const Json known = valueAt(others, file);
    const bool is_same =
        known.is_null() ? std::ranges::find(others, digest) != others.end() : known == digest;
    if (!is_same) names.push_back(file);
  }
}

/// The entry of "plugins" for this role; null if there is none.
Json pluginOf(const Json& run_file, Role role) {
  for (const Json& plugin : valueAt(run_file, "plugins")) {
    if (valueAt(plugin, "role") == enumName(role)) return plugin;
  }
  return {};
}

}  // namespace

std::vector<std::string> changedProgramFiles(const Json& before, const Json& now) {
  std::vector<std::string> changed;
  const Json library = valueAt(now, "file");
  if (library.is_string() && valueAt(before, "sha256") != valueAt(now, "sha256")) {
    changed.push_back(library.get<std::string>());
  }
  const Json program = valueAt(now, "program");
  if (program.is_string() && valueAt(before, "program_sha256") != valueAt(now, "program_sha256")) {
    changed.push_back(program.get<std::string>());
  }
  const Json old_files = objectAt(before, "program_files");
  const Json new_files = objectAt(now, "program_files");
  addFilesNotIn(old_files, new_files, changed);
  for (const auto& [file, digest] : old_files.items()) {
    if (valueAt(new_files, file).is_null())
      addFilesNotIn(new_files, Json::object({{file, digest}}), changed);
  }
  return changed;
}

std::vector<std::string> changedProgramFiles(const Json& before, const Json& now,
                                             std::initializer_list<Role> roles) {
  std::vector<std::string> changed;
  for (const Role role : roles) {
    const Json old = pluginOf(before, role);
    if (!old.is_null()) {
      std::ranges::copy(changedProgramFiles(old, pluginOf(now, role)), std::back_inserter(changed));
    }
  }
  return changed;
}

}  // namespace tolman::run
