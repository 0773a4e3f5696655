// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: a plugin library as a file, up to its manifests. Nothing in it is executed.
#include "host/manifest.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  const auto read = host::readManifests(file.path());
  if (const auto* refusal = std::get_if<host::Refusal>(&read)) {
    fuzz::require(!refusal->id.empty() && !refusal->remedy.empty(), "a refusal that says nothing");
  } else {
    fuzz::require(!std::get<0>(read).empty(), "a library without manifests");
  }
  return 0;
}
