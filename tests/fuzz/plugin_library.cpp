// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: a plugin library as a file, up to its manifests. Nothing in it is executed.
#include "host/manifest.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  try {
    fuzz::require(!host::readManifests(file.path()).empty(), "a library without manifests");
  } catch (const host::Refusal& refusal) {
    fuzz::require(!refusal.id.empty() && !refusal.remedy.empty(), "a refusal that says nothing");
  }
  return 0;
}
