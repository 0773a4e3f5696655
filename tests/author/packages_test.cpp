// SPDX-License-Identifier: BSD-3-Clause
// The Debian packages: their contents, their dependencies, and that they work where dpkg installs
// them. Reported as skipped without dpkg-deb.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <iostream>

#include "author/workshop.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// Packages of plugins that need ROS, by the library of Debian that these need; only those built.
std::vector<std::pair<std::string, std::string>> rosPackages() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [ros, library] : {std::pair("ros1", "libroscpp"), {"ros2", "libddsc"}}) {
    const std::string node = std::string(ros) + "_node";
    if (!fs::exists(inBuild("plugins/support/" + node + "/libtolman_" + node + ".a"))) continue;
    all.emplace_back(ros, library);
  }
  return all;
}

bool hasDpkg() {
  if (run({"dpkg-deb", "--version"}).exit_code == 0) return true;
  std::cout << "SKIPPED: dpkg-deb is not there\n";
  return false;
}

/// Builds the packages into `folder`/packages as tolman.deb and libtolman-sdk-dev.deb.
void makePackages(const Workshop& workshop) {
  const Finished made =
      workshop.shell("cpack --config " + inBuild("CPackConfig.cmake") +
                     " -G DEB -B packages\n"
                     "mv packages/tolman_*.deb packages/tolman.deb\n"
                     "mv packages/libtolman-sdk-dev_*.deb packages/libtolman-sdk-dev.deb\n");
  INFO(made.out << made.err);
  REQUIRE(made.exit_code == 0);
}

std::string field(const Workshop& workshop, const std::string& package, const std::string& name) {
  return workshop.shell("dpkg-deb -f packages/" + package + ".deb " + name).out;
}

/// A plugin made, built and described with nothing but what lies in `root`/usr.
void checkUse(const Workshop& workshop, const std::string& root) {
  const Finished used =
      workshop.shell("tolman plugins new place my_places of_" + root + " && cd of_" + root +
                         " && cmake -S . -B build -DBUILD_TESTING=OFF && cmake --build build"
                         " && tolman plugins doctor build/tolman_place_my_places.so"
                         " && tolman run chain.yaml --plugin-path build --set source.last=2"
                         " --set source.scale=0.15 --out run",
                     workshop.folder() / root / "usr");
  INFO(used.out << used.err);
  REQUIRE(used.exit_code == 0);
  CHECK(contains(readText(workshop.folder() / ("of_" + root) / "build/CMakeCache.txt"),
                 "tolman-sdk_DIR:PATH=" + (workshop.folder() / root / "usr/lib").string()));
}

}  // namespace

TEST_CASE("the packages say what they need and hold what they should") {
  if (!hasDpkg()) return;
  const Workshop workshop;
  makePackages(workshop);

  const std::string needs = field(workshop, "tolman", "Depends");
  for (const char* library :
       {"libc6", "libembree", "libopencv-core", "libsqlite3-0", "libtbb", "libyaml-cpp"}) {
    INFO(needs);
    CHECK(contains(needs, library));
  }
  const std::string sdk_needs = field(workshop, "libtolman-sdk-dev", "Depends");
  CHECK(contains(sdk_needs, "libeigen3-dev (>= 3.4)"));
  CHECK_FALSE(contains(sdk_needs, "libopencv"));  // only a plugin that wants it
  CHECK(field(workshop, "libtolman-sdk-dev", "Architecture") == "all\n");
  CHECK(contains(field(workshop, "libtolman-sdk-dev", "Description"), "'tolman plugins new'"));

  const std::string program = workshop.shell("dpkg-deb -c packages/tolman.deb").out;
  const std::string sdk = workshop.shell("dpkg-deb -c packages/libtolman-sdk-dev.deb").out;
  for (const char* file :
       {"./usr/bin/tolman\n", "/tolman/plugins/tolman_source_town.so\n",
        "./usr/share/tolman/configs/demo.yaml\n", "./usr/share/doc/tolman/copyright\n",
        "./usr/share/doc/tolman/changelog.gz\n", "./usr/share/bash-completion/completions/tolman\n",
        "./usr/share/doc/tolman/docs/write-a-plugin.md\n"}) {
    INFO(file);
    CHECK(contains(program, file));
    CHECK_FALSE(contains(sdk, file));
  }
  for (const char* file :
       {"./usr/include/tolman/roles.hpp\n", "/cmake/tolman-sdk/tolman-sdk-config.cmake\n",
        "./usr/share/tolman/template/shared/CMakeLists.txt.in\n",
        "./usr/share/tolman/examples/hog_places.cpp\n",
        "./usr/share/doc/libtolman-sdk-dev/copyright\n",
        "./usr/share/doc/libtolman-sdk-dev/changelog.gz\n"}) {
    INFO(file);
    CHECK(contains(sdk, file));
    CHECK_FALSE(contains(program, file));
  }
}

TEST_CASE("what needs ROS is in a package of its own, the rest the same with and without it") {
  if (!hasDpkg()) return;
  const Workshop workshop;
  makePackages(workshop);
  CHECK_FALSE(contains(field(workshop, "tolman", "Depends"), "ros"));
  const std::string plain = workshop.shell("dpkg-deb -c packages/tolman.deb").out;
  CHECK_FALSE(contains(plain, "_ros1"));
  CHECK_FALSE(contains(plain, "_ros2"));
  for (const auto& [ros, library] : rosPackages()) {
    const std::string package = "tolman-" + ros;
    const Finished packed =
        workshop.shell("mv packages/" + package + "_*.deb packages/" + package + ".deb");
    REQUIRE(packed.exit_code == 0);
    const std::string needs = field(workshop, package, "Depends");
    INFO(needs);
    CHECK(contains(needs, library));
    CHECK(contains(needs, "tolman (= "));
    const std::string held = workshop.shell("dpkg-deb -c packages/" + package + ".deb").out;
    CHECK(contains(held, "/tolman/plugins/tolman_source_" + ros + ".so\n"));
    CHECK(contains(held, "/tolman/plugins/tolman_observer_" + ros + "_publisher.so\n"));
    CHECK(contains(held, "./usr/share/doc/" + package + "/copyright\n"));
  }
}

TEST_CASE("packages of the same sources are the same bytes at any hour") {
  if (!hasDpkg()) return;
  const Workshop workshop;
  const Finished made =
      workshop.shell("cpack --config " + inBuild("CPackConfig.cmake") +
                     " -G DEB -B first\n"
                     "export TZ=Asia/Tokyo SOURCE_DATE_EPOCH=1\nsleep 1\n"
                     "cpack --config " +
                     inBuild("CPackConfig.cmake") +
                     " -G DEB -B second\n"
                     "for package in first/*.deb; do cmp $package second/${package#first/}; done");
  INFO(made.out << made.err);
  CHECK(made.exit_code == 0);
}

TEST_CASE("unpacked packages work from their folder") {
  if (!hasDpkg()) return;
  const Workshop workshop;
  makePackages(workshop);
  const Finished unpacked = workshop.shell(
      "dpkg-deb -x packages/tolman.deb unpacked && "
      "dpkg-deb -x packages/libtolman-sdk-dev.deb unpacked");
  REQUIRE(unpacked.exit_code == 0);
  checkUse(workshop, "unpacked");

  if (::geteuid() != 0) {
    std::cout << "SKIPPED: dpkg -i into a root of its own needs root\n";
    return;
  }
  // Dependencies are not in that root's database; the test above looks at them.
  const Finished installed = workshop.shell(
      "mkdir -p installed/var/lib/dpkg/{info,updates} && touch installed/var/lib/dpkg/status\n"
      "dpkg --root=\"$PWD/installed\" --force-depends -i packages/*.deb\n"
      "dpkg --root=\"$PWD/installed\" -l tolman libtolman-sdk-dev | grep -c ^ii");
  INFO(installed.out << installed.err);
  REQUIRE(installed.exit_code == 0);
  CHECK(installed.out.ends_with("2\n"));
  checkUse(workshop, "installed");
  std::string others;
  for (const auto& [ros, library] : rosPackages()) others += " tolman-" + ros;
  const Finished removed = workshop.shell(
      "dpkg --root=\"$PWD/installed\" --force-depends -P python3-tolman tolman libtolman-sdk-dev" +
      others +
      "\n"
      "find installed -path '*/usr/*' -type f");
  INFO(removed.out << removed.err);
  CHECK(removed.exit_code == 0);
  CHECK_FALSE(contains(removed.out, "/usr/"));
}
