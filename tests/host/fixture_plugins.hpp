// SPDX-License-Identifier: BSD-3-Clause
// Paths of the fixture plugins, and shortcuts for the loading steps of the host.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "host/instance.hpp"
#include "host/library.hpp"
#include "host/manifest.hpp"
#include "support/paths.hpp"

namespace tolman::test {

inline std::filesystem::path fixtureFolder(const std::string& name) {
  return std::filesystem::path(inBuild("tests/fixtures/plugins")) / name;
}

inline std::filesystem::path fixtureFile(const std::string& name) {
  return fixtureFolder(name) / ("tolman_odometry_" + name + ".so");
}

/// Reads, gates, opens and describes plugin `id` of fixture library `library`.
inline host::LoadedPlugin load(const std::string& library, const std::string& id) {
  const host::Manifest manifest = host::readManifest(fixtureFile(library), id);
  return host::loadPlugin(manifest, host::HostIdentity::ofThisBuild());
}

/// The object of plugin `id`, behind its guard.
inline std::unique_ptr<host::Instance> fixtureInstance(const std::string& library,
                                                       const std::string& id) {
  return host::Instance::create(load(library, id), id);
}

/// The refusal that `work` throws.
template <class Work>
host::Refusal refusalOf(const Work& work) {
  try {
    work();
  } catch (const host::Refusal& refusal) {
    return refusal;
  }
  FAIL("nothing was refused");
  return {};
}
#define REFUSAL_OF(...) tolman::test::refusalOf([&] { (void)(__VA_ARGS__); })

}  // namespace tolman::test
