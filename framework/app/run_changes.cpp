// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "engine/program_changes.hpp"
#include "record/run_check.hpp"
#include "record/run_directory.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json part(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) ? json[key] : Json();
}

/// Whether two entries of "data" have different contents, compared by the keys that both have.
bool areOther(const Json& old, const Json& now) {
  return std::ranges::any_of(std::array{"sha256", "files", "bytes"}, [&](const char* key) {
    return old.contains(key) && now.contains(key) && old[key] != now[key];
  });
}

/// Compared by their order in the configuration, because their paths may have changed; if their
/// numbers differ, by their paths.
std::vector<std::string> changedData(const Json& before, const Json& after) {
  std::vector<std::string> changes;
  if (!before.is_array() || !after.is_array()) return changes;
  const auto path = [](const Json& data) { return data.value("path", ""); };
  const auto find = [&](const Json& list, const std::string& wanted) {
    return std::ranges::find_if(list, [&](const Json& data) { return path(data) == wanted; });
  };
  const bool by_order = before.size() == after.size();
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto old =
        by_order ? before.begin() + static_cast<std::ptrdiff_t>(i) : find(before, path(after[i]));
    if (old == before.end()) {
      changes.push_back("data: " + path(after[i]) + " is read in addition");
    } else if (areOther(*old, after[i])) {
      changes.push_back("data: " + path(after[i]) + " has other contents");
    }
  }
  for (const Json& old : before) {
    if (by_order || find(after, path(old)) != after.end()) continue;
    changes.push_back("data: " + path(old) + " is no longer read");
  }
  return changes;
}

/// Adds differences of one stage's plugin.
void addPluginChanges(const Json& old, const Json& now, std::vector<std::string>& changes) {
  if (old.value("id", "") != now.value("id", "")) {
    changes.push_back("plugins: " + now.value("id", "") + " instead of " + old.value("id", ""));
  }
  for (const std::string& file : run::changedProgramFiles(old, now)) {
    changes.push_back("plugins: " + file + " has other contents");
  }
}

/// Adds frames that a realtime run passed by, which depends on the speed of the machine.
void addDroppedFrames(const Json& before, const Json& after, std::vector<std::string>& changes) {
  for (const auto& [key, what] : {std::pair("dropped", "were dropped"),
                                  std::pair("place_left_out", "went without place recognition")}) {
    const Json old = part(part(before, "counters"), key);
    const Json now = part(part(after, "counters"), key);
    if (!old.is_number_integer() || !now.is_number_integer() || (old == 0 && now == 0)) continue;
    changes.push_back(fmt::format(
        "realtime: {} frames {}, then {}; which ones depends on the speed of the machine",
        old.get<std::int64_t>(), what, now.get<std::int64_t>()));
  }
}

/// Differences between two run.json that can change results, one line each.
std::vector<std::string> changesIn(const Json& before, const Json& after) {
  if (!before.is_object()) return {"not known: the earlier run.json is missing or damaged"};
  std::vector<std::string> changes;
  for (const char* key : {"tolman", "libraries", "machine", "seed"}) {
    const Json old = part(before, key);
    const Json now = part(after, key);
    if (!old.is_object() || !now.is_object()) {
      if (old != now) changes.push_back(fmt::format("{}: {} -> {}", key, old.dump(), now.dump()));
      continue;
    }
    for (const auto& [name, value] : now.items()) {
      if (!old.contains(name) || old[name] == value) continue;
      changes.push_back(fmt::format("{} {}: {} -> {}", key, name, old[name].dump(), value.dump()));
    }
  }
  for (const Json& now : part(after, "plugins")) {
    for (const Json& old : part(before, "plugins")) {
      if (old.value("stage", "") == now.value("stage", "")) addPluginChanges(old, now, changes);
    }
  }
  std::ranges::copy(changedData(part(before, "data"), part(after, "data")),
                    std::back_inserter(changes));
  addDroppedFrames(before, after, changes);
  return changes;
}

/// Reads both run.json for `compare`.
template <class Compare>
std::vector<std::string> changesBetween(const fs::path& before, const fs::path& after,
                                        const Compare& compare) {
  try {
    return compare(record::RunDirectory::readRunFile(before),
                   record::RunDirectory::readRunFile(after));
  } catch (const Json::exception&) {
    throw Ended{ExitCode::Dataset, (before / "run.json").string() +
                                       ": has values of other types than a run writes; it was "
                                       "changed"};
  }
}

}  // namespace

std::vector<std::string> resultChanges(const fs::path& before, const fs::path& after) {
  return changesBetween(before, after, [&](const Json& old, const Json& now) {
    std::vector<std::string> changes = changesIn(old, now);
    if (!record::checkConfig(before, old).isOk()) {
      changes.push_back("config.resolved.yaml: has changed since the run was recorded");
    }
    return changes;
  });
}

std::vector<std::string> dataChanges(const fs::path& before, const fs::path& after) {
  return changesBetween(before, after, [](const Json& old, const Json& now) {
    return changedData(part(old, "data"), part(now, "data"));
  });
}

}  // namespace tolman::app
