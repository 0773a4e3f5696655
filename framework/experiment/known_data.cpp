// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/known_data.hpp"

#include <nlohmann/json.hpp>

#include "base/bounded_json.hpp"
#include "config/json_text.hpp"
#include "record/atomic_file.hpp"
#include "record/regular_file.hpp"

namespace tolman::experiment {

using nlohmann::ordered_json;

std::map<std::string, record::DataDigest> readKnownData(const std::filesystem::path& sweep) {
  std::map<std::string, record::DataDigest> known;
  std::ifstream stream = record::openRegular(sweep / "data.json");
  const auto json = bounded_json::parse<ordered_json>(stream);
  if (!json.is_object()) return known;
  for (const auto& [path, data] : json.items()) {
    if (!data.is_object()) continue;
    known[path] = {path, data.value("files", std::int64_t{0}), data.value("bytes", std::int64_t{0}),
                   data.value("stamp", ""), data.value("sha256", "")};
  }
  return known;
}

Status writeKnownData(const std::filesystem::path& sweep,
                      const std::map<std::string, record::DataDigest>& data) {
  auto json = ordered_json::object();
  for (const auto& [path, one] : data) {
    json[path] = {
        {"files", one.files}, {"bytes", one.bytes}, {"stamp", one.stamp}, {"sha256", one.sha256}};
  }
  return record::writeAtomically(sweep / "data.json", config::jsonText(json, 1) + "\n");
}

}  // namespace tolman::experiment
