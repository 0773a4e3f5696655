// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the JSON of a plugin's manifest, and the gate that it is compared with.
#include "host/manifest.hpp"

#include "host/library.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  host::Manifest manifest;
  try {
    manifest = host::parseManifest(std::string(fuzz::asText({data, size})), "plugin.so");
  } catch (const host::Refusal& refusal) {
    fuzz::require(!refusal.id.empty() && !refusal.message.empty() && !refusal.remedy.empty(),
                  "a refusal that says nothing");
    return 0;
  }
  fuzz::require(!manifest.id.empty(), "a plugin without an id");
  for (const std::string& text : {manifest.version, manifest.fingerprint, manifest.summary}) {
    for (const char c : text) fuzz::require(c < 0 || c >= ' ', "a control character");
  }
  (void)host::checkGate(manifest, host::HostIdentity::ofThisBuild());
  return 0;
}
