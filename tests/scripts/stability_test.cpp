// SPDX-License-Identifier: BSD-3-Clause
// scripts/check-stability on small repositories that released a small SDK and then changed it.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* kVersion = "#define TOLMAN_SDK_MAJOR 0\n#define TOLMAN_SDK_MINOR 1\n";
constexpr const char* kRoles = R"(#pragma once
#include <string>
#include <vector>
namespace tolman {
enum class Colour : unsigned char { Red, Green };
struct Item {
  int size = 0;
};
struct Frame {
  int index = -1;
  std::vector<Item> items;
};
class Plugin {
 public:
  virtual ~Plugin() {}
  virtual bool observe(const Frame& frame) = 0;
};
inline int twice(int value) { return 2 * value; }
}  // namespace tolman
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  INFO(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

class Repository {
 public:
  explicit Repository(bool with_tag = true) {
    write("sdk/include/tolman/version.hpp", kVersion);
    write("sdk/include/tolman/roles.hpp", kRoles);
    write("docs/changelog.md", "# Changelog\n\n### Migrations\n\nNothing yet.\n");
    shell("git init -q . && git add . && git -c user.name=a -c user.email=a@b commit -qm first");
    if (with_tag) shell("git tag v0.1.0");
  }
  void write(const std::string& name, const std::string& text) const {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  void roles(const std::string& from, const std::string& to) const {
    write("sdk/include/tolman/roles.hpp", replaced(kRoles, from, to));
  }
  void version(int major, int minor) const {
    write("sdk/include/tolman/version.hpp", "#define TOLMAN_SDK_MAJOR " + std::to_string(major) +
                                                "\n#define TOLMAN_SDK_MINOR " +
                                                std::to_string(minor) + "\n");
  }
  Finished check() const {
    return run(
        {inSource("scripts/check-stability"), "--repository", folder_.path().string(), "--list"});
  }

 private:
  void shell(const std::string& script) const {
    const Finished finished = run({"env", "-C", folder_.path().string(), "bash", "-euc", script});
    INFO(finished.out << finished.err);
    REQUIRE(finished.exit_code == 0);
  }
  TemporaryFolder folder_;
};

/// The script needs Python and Doxygen; abidiff it can do without.
bool toolsAreHere() {
  const bool here = run({"bash", "-c", "command -v python3 && command -v doxygen"}).exit_code == 0;
  if (!here) WARN("SKIPPED: no python3 and doxygen (scripts/install-dependencies --check)");
  return here;
}

void checkFails(const Repository& repository, const std::string& finding,
                const std::string& remedy) {
  const Finished finished = repository.check();
  INFO(finished.out << finished.err);
  CHECK(finished.exit_code == 1);
  CHECK(contains(finished.out, finding));
  CHECK(contains(finished.out, remedy));
}

void checkPasses(const Repository& repository, const std::string& summary) {
  const Finished finished = repository.check();
  INFO(finished.out << finished.err);
  CHECK(finished.exit_code == 0);
  CHECK(contains(finished.out, summary));
}

constexpr const char* kRaiseMajor = "raise TOLMAN_SDK_MAJOR: it is 0 as it was";

}  // namespace

TEST_CASE("headers that did not change pass") {
  if (!toolsAreHere()) return;
  checkPasses(Repository(), "the SDK's headers are those of v0.1.0");
}

TEST_CASE("what no author can notice asks for nothing") {
  if (!toolsAreHere()) return;
  const Repository repository;
  repository.roles("inline int twice(int value) { return 2 * value; }",
                   "/// A comment.\ninline int twice(int x) { return x + x; }");
  checkPasses(repository, "0 broken, 0 added");
}

TEST_CASE("additions ask for a minor") {
  if (!toolsAreHere()) return;
  const Repository repository;
  SECTION("an extra") {
    repository.roles("inline int twice",
                     "class Extra {\n public:\n  virtual ~Extra() {}\n};\n"
                     "inline int twice");
    checkFails(repository, "tolman::Extra: new", "raise TOLMAN_SDK_MINOR: it is 0.1 as it was");
  }
  SECTION("a field at the end of a record of the host") {
    repository.roles("std::vector<Item> items;", "std::vector<Item> items;\n  double gain = 1;");
    checkFails(repository, "tolman::Frame: data at the end: double gain", "TOLMAN_SDK_MINOR");
  }
  SECTION("an enumerator at the end, and a helper") {
    repository.write("sdk/include/tolman/roles.hpp",
                     replaced(replaced(kRoles, "Green", "Green, Blue"), "inline int twice",
                              "inline int thrice(int x) { return 3 * x; }\ninline int twice"));
    checkFails(repository, "tolman::Colour: Blue", "TOLMAN_SDK_MINOR");
  }
}

TEST_CASE("with the minor raised an addition passes") {
  if (!toolsAreHere()) return;
  const Repository repository;
  repository.roles("inline int twice", "struct Extra {};\ninline int twice");
  repository.version(0, 2);
  checkPasses(repository, "SDK 0.2 against 0.1 of v0.1.0: 0 broken, 1 added");
}

TEST_CASE("breaks ask for a major") {
  if (!toolsAreHere()) return;
  const Repository repository;
  SECTION("a virtual function with other arguments") {
    repository.roles("observe(const Frame& frame) = 0", "observe(const Frame& frame, int n) = 0");
    checkFails(repository, "tolman::Plugin: virtual functions were", kRaiseMajor);
  }
  SECTION("a new virtual function, even with a body") {
    repository.roles("frame) = 0;", "frame) = 0;\n  virtual void pause() {}");
    checkFails(repository, "tolman::Plugin: virtual functions were", kRaiseMajor);
  }
  SECTION("a field in the middle") {
    repository.roles("int index = -1;", "int index = -1;\n  int stamp = 0;");
    checkFails(repository, "tolman::Frame: data members were", kRaiseMajor);
  }
  SECTION("a longer item of a list") {
    repository.roles("int size = 0;", "int size = 0;\n  int depth = 0;");
    checkFails(repository, "tolman::Item: data members were", kRaiseMajor);
  }
  SECTION("a function that is gone, and a value that is another") {
    repository.write("sdk/include/tolman/roles.hpp",
                     replaced(replaced(kRoles, "Red, Green", "Green, Red"), "twice", "double_of"));
    checkFails(repository, "gone or changed: int twice(int)", kRaiseMajor);
    checkFails(repository, "tolman::Colour: was", kRaiseMajor);
  }
}

TEST_CASE("with the major raised and a migration a break passes") {
  if (!toolsAreHere()) return;
  const Repository repository;
  repository.roles("observe(const Frame& frame) = 0", "observe(const Frame& frame, int n) = 0");
  repository.version(0, 2);
  checkFails(repository, "taken away or changed", kRaiseMajor);
  repository.version(1, 0);
  checkFails(repository, "taken away or changed", "Migrations in docs/changelog.md, for SDK 1.0");
  repository.write("docs/changelog.md", "# Changelog\n\n### Migrations\n\n- SDK 1.0: rebuild.\n");
  checkPasses(repository, "SDK 1.0 against 0.1 of v0.1.0");
}

TEST_CASE("without a tag the headers that the tests keep are the baseline") {
  if (!toolsAreHere()) return;
  const Repository repository(false);
  const Finished skipped = repository.check();
  CHECK(skipped.exit_code == 0);
  CHECK(contains(skipped.out, "SKIPPED: no tag"));
  repository.write("tests/fixtures/sdk-0.1/include/tolman/version.hpp", kVersion);
  repository.write("tests/fixtures/sdk-0.1/include/tolman/roles.hpp", kRoles);
  repository.roles("int index = -1;", "");
  checkFails(repository, "compared with tests/fixtures/sdk-0.1/include", kRaiseMajor);
}

TEST_CASE("a version does not go back") {
  if (!toolsAreHere()) return;
  const Repository repository;
  repository.version(0, 0);
  checkFails(repository, "not as promised", "the version went back from 0.1 to 0.0");
}
