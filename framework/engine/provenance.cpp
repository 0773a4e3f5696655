// SPDX-License-Identifier: BSD-3-Clause
#include "engine/provenance.hpp"

#include <fmt/chrono.h>
#include <sqlite3.h>
#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <thread>

#include "config/json_text.hpp"
#include "engine/build_info.hpp"
#include "engine/checked_system.hpp"
#include "engine/run.hpp"
#include "record/digest.hpp"
#include "tolman/version.hpp"

namespace tolman::engine {
namespace {

using Json = nlohmann::ordered_json;

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

/// The input data with their digests. Above kMaxDigested bytes contents are not digested, because
/// reading them would delay the run.
Json dataList(const CheckedSystem& system) {
  constexpr std::int64_t kMaxDigested = std::int64_t{1} << 30U;
  Json list = Json::array();
  for (const std::string& path : inputPaths(system).present) {
    const auto digest = record::digestData(path, {}, kMaxDigested);
    if (!digest.isOk()) {
      list.push_back({{"path", path}, {"reason", digest.status().message()}});
      continue;
    }
    const record::DataDigest& data = digest.value();
    list.push_back({{"path", path}, {"files", data.files}, {"bytes", data.bytes}});
    if (!data.sha256.empty()) list.back()["sha256"] = data.sha256;
  }
  return list;
}

/// The digests of the files of the plugin with this role, by file.
std::map<std::string, std::string> filesOf(const Json& run_file, Role role) {
  std::map<std::string, std::string> files;
  const auto add = [&](const Json& file, const Json& digest) {
    if (file.is_string() && digest.is_string()) files[file] = digest;
  };
  try {
    for (const Json& plugin : run_file.at("plugins")) {
      if (plugin.at("role") != enumName(role)) continue;
      add(plugin.at("file"), plugin.at("sha256"));
      add(plugin.value("program", Json()), plugin.value("program_sha256", Json()));
      const Json brought = plugin.value("program_files", Json::object());
      for (const auto& [file, digest] : brought.items()) {
        add(file, digest);
      }
    }
  } catch (const Json::exception&) {  // a foreign file
  }
  return files;
}

Json machine() {
  utsname system{};
  ::uname(&system);
  return {{"host", system.nodename},
          {"system", std::string(system.sysname) + " " + system.release},
          {"processor", processor()},
          {"cores", std::thread::hardware_concurrency()}};
}

std::string digestOf(const std::filesystem::path& file) {
  const auto digest = record::fileDigest(file);
  return digest.isOk() ? digest.value() : "unreadable";
}

Json pluginList(const CheckedSystem& system) {
  Json list = Json::array();
  for (std::size_t i = 0; i < system.plugins.size(); ++i) {
    const host::Manifest& manifest = system.plugins[i].manifest;
    Json entry = {{"stage", system.config.stages[i].instance},
                  {"id", manifest.id},
                  {"role", enumName(manifest.role)},
                  {"version", manifest.version},
                  {"file", manifest.file.string()},
                  {"sha256", digestOf(manifest.file)}};
    if (!manifest.program.empty()) {
      entry["program"] = manifest.program.string();
      entry["program_sha256"] = digestOf(manifest.program);
    }
    for (const std::string& file : manifest.program_files) {
      entry["program_files"][file] = digestOf(file);
    }
    list.push_back(std::move(entry));
  }
  return list;
}

Json sourceJson(const Assembly& assembly) {
  const SourceInfo& source = assembly.sourceInfo();
  Json json = {{"description", source.description}, {"frames", source.frames},
               {"has_truth", source.has_truth},     {"width", source.rig.width},
               {"height", source.rig.height},       {"baseline_m", source.rig.baseline}};
  const RectifiedSource& rectified = assembly.source();
  if (!rectified.cutText().empty()) json["part_of_images"] = rectified.cutText();
  if (!rectified.text().empty()) json["rectification"] = rectified.text();
  return json;
}

}  // namespace

std::int64_t utcSeconds() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::seconds>(now).count();
}

std::string utcText(std::int64_t seconds) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time_t{seconds}));
}

Json provenance(const Assembly& assembly, const std::vector<std::string>& command_line) {
  const CheckedSystem& system = assembly.system();
  Json json;
  json["name"] = system.config.general.name;
  json["started"] = utcText(utcSeconds());
  json["command_line"] = command_line;
  json["seed"] = system.config.general.seed;
  json["threads"] = system.config.general.threads;
  json["tolman"] = {{"version", kVersion},
                    {"revision", kRevision},
                    {"compiler", kCompiler},
                    {"build_type", kBuildType},
                    {"sdk", TOLMAN_SDK_VERSION},
                    {"fingerprint", TOLMAN_FINGERPRINT},
                    {"sha256", digestOf("/proc/self/exe")}};
  json["libraries"] = {{"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                             EIGEN_MINOR_VERSION)},
                       {"opencv", host::HostIdentity::ofThisBuild().opencv},
                       {"sqlite", ::sqlite3_libversion()}};
  json["machine"] = machine();
  json["source"] = sourceJson(assembly);
  json["plugins"] = pluginList(system);
  json["data"] = dataList(system);
  return json;
}

std::vector<std::string> changedProgramFiles(const Json& before, const Json& now,
                                             std::initializer_list<Role> roles) {
  std::set<std::string> changed;
  using Files = std::map<std::string, std::string>;
  const auto addOthers = [&](const Files& files, const Files& others) {
    std::set<std::string> known;
    for (const auto& [file, digest] : others) known.insert(digest);
    for (const auto& [file, digest] : files) {
      if (!known.contains(digest)) changed.insert(file);
    }
  };
  for (const Role role : roles) {
    const Files then = filesOf(before, role);
    const Files files = filesOf(now, role);
    if (then.empty()) continue;
    addOthers(files, then);
    addOthers(then, files);
  }
  return {changed.begin(), changed.end()};
}

std::vector<std::string> changedInputs(const Json& before, const Json& now) {
  std::vector<std::string> changed = changedProgramFiles(
      before, now, {Role::Source, Role::Odometry, Role::Place, Role::Cells, Role::Map});
  const auto contents = [](const Json& data) {
    return std::pair(data.value("bytes", 0LL), data.value("sha256", std::string()));
  };
  const Json then = before.value("data", Json());  // null: of a version without digests
  for (const Json& data : then.is_null() ? Json::array() : now.at("data")) {
    if (std::ranges::none_of(then,
                             [&](const Json& old) { return contents(old) == contents(data); })) {
      changed.push_back(data.at("path").get<std::string>());
    }
  }
  return changed;
}

Json countersJson(const RunCounters& counters) {
  Json json = Json::object();
  RunCounters::visit(counters, [&](const char* name, const auto& value) { json[name] = value; });
  return json;
}

void addOutcome(Json& json, const Outcome& outcome) {
  const RunCounters& n = outcome.counters;
  json["ended"] = utcText(utcSeconds());
  json["message"] = outcome.failure ? outcome.failure->message : std::string(n.endText());
  if (outcome.failure) {
    json["failure"] = {{"kind", enumName(outcome.failure->kind)},
                       {"stage", outcome.failure->stage}};
  }
  json["counters"] = countersJson(n);
  Json finish = Json::object();
  for (std::size_t role = 0; role < outcome.finish_times_ns.size(); ++role) {
    const std::int64_t ns = outcome.finish_times_ns[role];
    if (ns > 0) finish[std::string(kRoleNames[role])] = 1e-9 * static_cast<double>(ns);
  }
  json["finish_s"] = finish;
  const Latency& latency = outcome.latency;
  if (latency.frames == 0) return;
  json["latency"] = {
      {"frames", latency.frames}, {"median_ms", latency.median_ms}, {"p99_ms", latency.p99_ms}};
}

}  // namespace tolman::engine
