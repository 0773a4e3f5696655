// SPDX-License-Identifier: BSD-3-Clause
// Where the fixture plugins were built, and short ways through the host's loading steps.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "plugins/catalogue.hpp"
#include "plugins/instance.hpp"
#include "plugins/library.hpp"

namespace tolman::test {

inline std::filesystem::path fixtureFolder(const std::string& name) {
  return std::filesystem::path(TOLMAN_BINARY_DIR) / "tests/fixtures/plugins" / name;
}

inline std::filesystem::path fixtureFile(const std::string& name) {
  return fixtureFolder(name) / ("tolman_odometry_" + name + ".so");
}

/// Reads, gates, opens and describes plugin `id` of fixture library `library`.
inline plugins::OrRefusal<plugins::LoadedPlugin> load(const std::string& library,
                                                      const std::string& id) {
  auto manifests = plugins::readManifests(fixtureFile(library));
  if (auto* refusal = std::get_if<plugins::Refusal>(&manifests)) return *refusal;
  for (const auto& manifest : std::get<std::vector<plugins::Manifest>>(manifests)) {
    if (manifest.id == id) {
      return plugins::loadPlugin(manifest, plugins::HostIdentity::ofThisBuild());
    }
  }
  FAIL("no plugin " << id << " in " << library);
  return plugins::Refusal{};
}

template <class T>
const plugins::Refusal& refusalOf(const plugins::OrRefusal<T>& result) {
  REQUIRE(std::holds_alternative<plugins::Refusal>(result));
  return std::get<plugins::Refusal>(result);
}

}  // namespace tolman::test
