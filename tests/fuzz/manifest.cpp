// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the JSON of a plugin's manifest, and the gate that it is compared with.
#include "host/manifest.hpp"

#include "host/library.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const auto parsed = host::parseManifest(std::string(fuzz::asText({data, size})), "plugin.so");
  if (const auto* refusal = std::get_if<host::Refusal>(&parsed)) {
    fuzz::require(!refusal->id.empty() && !refusal->message.empty() && !refusal->remedy.empty(),
                  "a refusal that says nothing");
    return 0;
  }
  const auto& manifest = std::get<host::Manifest>(parsed);
  fuzz::require(!manifest.id.empty(), "a plugin without an id");
  for (const std::string& text : {manifest.version, manifest.fingerprint, manifest.summary}) {
    for (const char c : text) fuzz::require(c < 0 || c >= ' ', "a control character");
  }
  (void)host::checkGate(manifest, host::HostIdentity::ofThisBuild());
  return 0;
}
