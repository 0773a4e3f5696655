// SPDX-License-Identifier: BSD-3-Clause
#include "engine/provenance.hpp"

#include <fmt/chrono.h>
#include <gnu/libc-version.h>
#include <sqlite3.h>
#include <sys/utsname.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

#include "config/json_text.hpp"
#include "engine/build_info.hpp"
#include "engine/input_data.hpp"
#include "engine/loaded_libraries.hpp"
#include "engine/run.hpp"
#include "record/data_digest.hpp"
#include "record/digest.hpp"
#include "tolman/version.hpp"

namespace tolman::run {
namespace {

using Json = nlohmann::ordered_json;

/// The first entry with this name in /proc/cpuinfo.
std::string processorEntry(std::string_view name) {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with(name) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

/// Features by which libraries choose their implementations, whose results may differ.
Json processorFeatures() {
  Json features = Json::array();
  const std::string flags = " " + processorEntry("flags") + " ";
  for (const char* feature : {"sse4_2", "avx", "fma", "avx2", "avx512f", "avx512vl"}) {
    if (flags.find(std::string(" ") + feature + " ") != std::string::npos) {
      features.push_back(feature);
    }
  }
  return features;
}

/// The input data with their digests. Above kMaxDigested bytes contents are not digested, because
/// reading them would delay the run.
Json dataList(const CheckedSystem& system) {
  constexpr std::int64_t kMaxDigested = std::int64_t{1} << 30U;
  Json list = Json::array();
  for (const std::string& path : inputPaths(system)) {
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

Json machine() {
  utsname system{};
  ::uname(&system);
  return {{"host", system.nodename},
          {"system", std::string(system.sysname) + " " + system.release},
          {"processor", processorEntry("model name")},
          {"features", processorFeatures()},
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

/// A field of a raw camera; matrices row by row.
template <class T>
Json jsonOf(const T& value) {
  if constexpr (NamedEnum<T>) {
    return enumName(value);
  } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    return jsonOf(Eigen::Matrix4d(value.matrix()));
  } else if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else {
    Json list = Json::array();
    for (Eigen::Index r = 0; r < value.rows(); ++r) {
      for (Eigen::Index c = 0; c < value.cols(); ++c) list.push_back(value(r, c));
    }
    return list;
  }
}

Json sourceJson(const Assembly& assembly) {
  const SourceInfo& source = assembly.sourceInfo();
  Json json = {{"description", source.description}, {"frames", source.frames},
               {"has_truth", source.has_truth},     {"width", source.rig.width},
               {"height", source.rig.height},       {"baseline_m", source.rig.baseline}};
  const pipeline::RectifiedSource& rectified = assembly.source();
  if (!rectified.cutText().empty()) json["part_of_images"] = rectified.cutText();
  if (rectified.text().empty()) return json;
  json["rectification"] = rectified.text();
  for (const RawCamera& camera : rectified.rawRig().cameras) {
    Json& raw = json["raw_cameras"].emplace_back();
    visitFields(camera, [&](const Field& field, const auto& value) {
      raw[std::string(field.name)] = jsonOf(value);
    });
  }
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
  json["libraries"] = {{"libc", ::gnu_get_libc_version()},
                       {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                             EIGEN_MINOR_VERSION)},
                       {"sqlite", ::sqlite3_libversion()},
                       {"fmt", FMT_VERSION}};
  for (const auto& [name, file] : loadedLibraries()) json["libraries"][name] = file;
  json["machine"] = machine();
  json["source"] = sourceJson(assembly);
  json["plugins"] = pluginList(system);
  json["data"] = dataList(system);
  return json;
}

std::string newRunId(Json run_file, bool is_realtime) {
  if (is_realtime) {
    run_file["time_ns"] = std::chrono::system_clock::now().time_since_epoch().count();
  } else {
    for (const char* key : {"started", "command_line", "machine"}) run_file.erase(key);
  }
  constexpr std::size_t kDigits = 32;
  const std::string text = config::jsonText(run_file);
  return record::textDigest(text).substr(0, kDigits);
}

Json countersJson(const pipeline::RunCounters& counters) {
  Json json = Json::object();
  pipeline::RunCounters::visit(counters,
                               [&](const char* name, const auto& value) { json[name] = value; });
  return json;
}

void addOutcome(Json& json, const Outcome& outcome) {
  const pipeline::RunCounters& n = outcome.counters;
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
  const pipeline::Latency& latency = outcome.latency;
  if (latency.frames == 0) return;
  json["latency"] = {{"frames", latency.frames},
                     {"median_ms", latency.median_ms},
                     {"p99_ms", latency.p99_ms},
                     {"exposure", enumName(latency.clock)}};
}

}  // namespace tolman::run
