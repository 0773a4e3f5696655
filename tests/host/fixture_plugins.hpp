// SPDX-License-Identifier: BSD-3-Clause
// Paths of the fixture plugins, and shortcuts for the loading steps of the host.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "host/catalogue.hpp"
#include "host/instance.hpp"
#include "host/library.hpp"
#include "support/paths.hpp"

namespace tolman::test {

inline std::filesystem::path fixtureFolder(const std::string& name) {
  return std::filesystem::path(inBuild("tests/fixtures/plugins")) / name;
}

inline std::filesystem::path fixtureFile(const std::string& name) {
  return fixtureFolder(name) / ("tolman_odometry_" + name + ".so");
}

/// Reads, gates, opens and describes plugin `id` of fixture library `library`.
inline host::OrRefusal<host::LoadedPlugin> load(const std::string& library, const std::string& id) {
  auto manifests = host::readManifests(fixtureFile(library));
  if (auto* refusal = std::get_if<host::Refusal>(&manifests)) return *refusal;
  for (const auto& manifest : std::get<std::vector<host::Manifest>>(manifests)) {
    if (manifest.id == id) {
      return host::loadPlugin(manifest, host::HostIdentity::ofThisBuild());
    }
  }
  FAIL("no plugin " << id << " in " << library);
  return host::Refusal{};
}

/// The object of plugin `id`, behind its guard.
inline std::unique_ptr<host::Instance> fixtureInstance(const std::string& library,
                                                       const std::string& id) {
  const auto loaded = load(library, id);
  if (const auto* refusal = std::get_if<host::Refusal>(&loaded)) FAIL(refusal->text());
  auto created = host::Instance::create(std::get<host::LoadedPlugin>(loaded), id);
  REQUIRE(std::holds_alternative<std::unique_ptr<host::Instance>>(created));
  return std::get<std::unique_ptr<host::Instance>>(std::move(created));
}

template <class T>
const host::Refusal& refusalOf(const host::OrRefusal<T>& result) {
  REQUIRE(std::holds_alternative<host::Refusal>(result));
  return std::get<host::Refusal>(result);
}

}  // namespace tolman::test
