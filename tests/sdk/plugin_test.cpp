// SPDX-License-Identifier: BSD-3-Clause
// The plugin macro: manifest at compile time, factory, extras.
#include "tolman/plugin.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace tolman;

namespace {

class Quiet : public Cells, public ArraySource {
 public:
  using Parameters = NoParameters;
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status step(const Motion&, const PlaceObservation&, Decision&) override { return Status::ok(); }
  void arrays(std::vector<NamedArray>&) const override {}
};

/// With all extras but saved state.
class Described : public Quiet, public ArrayDescriptions, public PageServer, public RawRigSource {
 public:
  Status describe(std::vector<ArrayInfo>&) const override { return Status::ok(); }
  std::string url() const override { return ""; }
  Status rawRig(RawRig&) override { return Status::ok(); }
};

}  // namespace

TOLMAN_PLUGIN(quiet, Quiet, "1.2.3", "Says \"nothing\" \\ at all.");
TOLMAN_PLUGIN(described, Described, "1.0", "");

TEST_CASE("the manifest is JSON, with quotes escaped") {
  const auto json = nlohmann::json::parse(std::string(tolman_manifest_quiet.data()));
  CHECK(json["id"] == "quiet");
  CHECK(json["role"] == "cells");
  CHECK(json["version"] == "1.2.3");
  CHECK(json["sdk"] == TOLMAN_SDK_VERSION);
  CHECK(json["fingerprint"] == TOLMAN_FINGERPRINT);
  CHECK(json["summary"] == "Says \"nothing\" \\ at all.");
}

TEST_CASE("the entry function makes and destroys the plugin, and finds its extras") {
  const PluginDescriptor* descriptor = tolman_plugin_quiet();
  CHECK(descriptor->role == Role::Cells);
  const PluginObject object = descriptor->create();
  REQUIRE(object.plugin != nullptr);
  CHECK(object.arrays != nullptr);
  CHECK(object.state == nullptr);
  CHECK(object.descriptions == nullptr);
  descriptor->destroy(object.plugin);
}

TEST_CASE("the manifest names the extras that a class implements") {
  const auto extras = [](const char* text) {
    return nlohmann::json::parse(text)["extras"].get<std::string>();
  };
  CHECK(extras(tolman_manifest_quiet.data()) == "arrays");
  CHECK(extras(tolman_manifest_described.data()) == "arrays,descriptions,page,raw_rig");
  const PluginObject object = tolman_plugin_described()->create();
  CHECK(object.descriptions != nullptr);
  CHECK(object.page != nullptr);
  CHECK(object.raw_rig != nullptr);
  tolman_plugin_described()->destroy(object.plugin);
}

TEST_CASE("a status says what it is; a result has a value or a status") {
  CHECK(Status::ok().isOk());
  CHECK(Status::endOfStream().code() == StatusCode::EndOfStream);
  const Result<int> good = 3;
  const Result<int> bad = Status::invalidInput("times.txt:3: not a number");
  CHECK(good.value() == 3);
  CHECK(good.status().isOk());
  CHECK(bad.status().message() == "times.txt:3: not a number");
  CHECK_THROWS(bad.value());
}
