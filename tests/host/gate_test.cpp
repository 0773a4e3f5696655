// SPDX-License-Identifier: BSD-3-Clause
#include "host/fixture_plugins.hpp"
#include "host/library.hpp"

using namespace tolman;
using namespace tolman::host;
using tolman::test::load;

namespace {

const HostIdentity kHost = {1, 4, "gcc align16 sanitizer-none", "4.6.0"};

Manifest fitting() {
  Manifest manifest;
  manifest.file = "p.so";
  manifest.id = "p";
  manifest.sdk_major = 1;
  manifest.sdk_minor = 4;
  manifest.fingerprint = kHost.fingerprint;
  return manifest;
}

}  // namespace

TEST_CASE("the gate lets through what fits, and older minors") {
  Manifest manifest = fitting();
  CHECK_FALSE(checkGate(manifest, kHost));
  manifest.sdk_minor = 0;
  manifest.opencv = "4.6.0";
  CHECK_FALSE(checkGate(manifest, kHost));
}

TEST_CASE("minors of an unreleased SDK do not fit each other") {
  Manifest manifest = fitting();
  HostIdentity host = kHost;
  manifest.sdk_major = host.sdk_major = 0;
  CHECK_FALSE(checkGate(manifest, host));
  manifest.sdk_minor = 3;
  CHECK(checkGate(manifest, host)->id == "plugin/sdk-minor");
}

TEST_CASE("the gate's refusals are golden") {
  Manifest manifest = fitting();
  SECTION("another major") {
    manifest.sdk_major = 2;
    CHECK(checkGate(manifest, kHost)->text() ==
          "[plugin/sdk-major] plugin 'p' (p.so) was built for SDK 2.4; this host has SDK 1.4\n"
          "  remedy: rebuild the plugin against this SDK; docs/stability.md lists what changed");
  }
  SECTION("a newer minor") {
    manifest.sdk_minor = 5;
    CHECK(checkGate(manifest, kHost)->text() ==
          "[plugin/sdk-minor] plugin 'p' (p.so) was built for SDK 1.5; this host has SDK 1.4\n"
          "  remedy: rebuild the plugin against this SDK, or use the Tolman that it was built for");
  }
  SECTION("other flags") {
    manifest.fingerprint = "gcc align32 sanitizer-none";
    CHECK(checkGate(manifest, kHost)->text() ==
          "[plugin/fingerprint] plugin 'p' (p.so) has another build fingerprint:\n"
          "    plugin: gcc align32 sanitizer-none\n"
          "    host:   gcc align16 sanitizer-none\n"
          "  remedy: rebuild the plugin without -march, -mavx or -mavx2 (Eigen's alignment follows "
          "them), or rebuild Tolman with -DTOLMAN_MARCH_V3=ON");
  }
  SECTION("another OpenCV") {
    manifest.opencv = "4.10.0";
    CHECK(checkGate(manifest, kHost)->id == "plugin/opencv");
  }
}

TEST_CASE("real libraries are stopped at the gate before any of their code runs") {
  CHECK(REFUSAL_OF(load("wrong_major", "wrong_major")).id == "plugin/sdk-major");
  CHECK(REFUSAL_OF(load("newer_minor", "newer_minor")).id == "plugin/sdk-minor");
}

TEST_CASE("the same source built with -mavx2 is refused by its fingerprint") {
  if (HostIdentity::ofThisBuild().fingerprint.find("align16") == std::string::npos) {
    WARN("SKIPPED: this host is itself built for AVX");
    return;
  }
  CHECK(REFUSAL_OF(load("avx2", "steady")).id == "plugin/fingerprint");
}
