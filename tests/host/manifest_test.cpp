// SPDX-License-Identifier: BSD-3-Clause
#include "host/manifest.hpp"

#include "fixtures/plugins/steady.hpp"
#include "host/fixture_plugins.hpp"

using namespace tolman;
using namespace tolman::host;

namespace {

const std::string kGood =
    R"({"id":"x","role":"map","version":"1.2","sdk":"0.1","fingerprint":"f","opencv":"",)"
    R"("schema":"00000000000000ff","summary":"s"})";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kGood;
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a manifest tells all that the gate needs") {
  const Manifest manifest = parseManifest(kGood, "file.so");
  CHECK(manifest.id == "x");
  CHECK(manifest.role == Role::Map);
  CHECK(manifest.sdk_major == 0);
  CHECK(manifest.sdk_minor == 1);
  CHECK(manifest.schema_hash == 255);
}

TEST_CASE("extras are listed since SDK 0.2") {
  CHECK(parseManifest(kGood, "file.so").extras.empty());
  const Manifest manifest =
      parseManifest(with("\"summary\":\"s\"", R"("summary":"s","extras":"arrays,page")"), "f.so");
  CHECK(manifest.extras == std::vector<std::string>{"arrays", "page"});
  CHECK(manifest.hasExtra("page"));
  CHECK_FALSE(manifest.hasExtra("state"));
  CHECK(readManifests(test::fixtureFile("snapshot_log")).at(0).hasExtra("descriptions"));
}

TEST_CASE("one library may hold several plugins") {
  CHECK(readManifests(test::fixtureFile("misbehaving")).size() == 11);
}

TEST_CASE("the schema hash of the manifest is that of the declaration") {
  const auto manifests = readManifests(test::fixtureFile("steady"));
  CHECK(manifests.at(0).schema_hash == schemaHash<fixture::Steady::Parameters>());
}

TEST_CASE("an illegal manifest is refused with the cause") {
  CHECK(REFUSAL_OF(readManifests(test::fixtureFile("bad_json"))).id == "plugin/bad-manifest");
  const auto message = [](const std::string& text) {
    return REFUSAL_OF(parseManifest(text, "file.so")).message;
  };
  CHECK(message(with("\"map\"", "\"chef\"")) ==
        "file.so: the manifest is not valid: 'chef' is not a role");
  CHECK(message(with("\"0.1\"", "\"0.x\"")) ==
        "file.so: the manifest is not valid: 'x' is not a number");
  CHECK(message(with("\"x\"", "\"../x\"")) ==
        "file.so: the manifest is not valid: '../x' is not an identifier");
  CHECK(message(with("\"id\"", "\"jd\"")).find("'id' not found") != std::string::npos);
  const std::string escape = message(with("\"x\"", "\"\\u001b[2J\""));
  CHECK(escape == "file.so: the manifest is not valid: '?[2J' is not an identifier");
  CHECK(message("[]").find("is not valid") != std::string::npos);
  CHECK(message(std::string(100000, '[')).find("is not valid") != std::string::npos);
}
