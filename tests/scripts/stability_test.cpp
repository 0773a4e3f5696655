// SPDX-License-Identifier: BSD-3-Clause
// scripts/check-stability on a small repository that released a small SDK and then changed it.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

TEST_CASE("the version of the SDK rises when its code changes") {
  const TemporaryFolder folder;
  const fs::path headers = folder.path() / "sdk/include/tolman";
  fs::create_directories(headers);
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(headers / name) << text;
  };
  const auto shell = [&](const std::string& script) {
    const Finished finished = run({"env", "-C", folder.path().string(), "bash", "-euc", script});
    INFO(finished.out << finished.err);
    REQUIRE(finished.exit_code == 0);
  };
  const auto check = [&] {
    return run({inSource("scripts/check-stability"), "--repository", folder.path().string()});
  };
  write("version.hpp", "#define TOLMAN_SDK_MAJOR 0\n#define TOLMAN_SDK_MINOR 1\n");
  write("roles.hpp", "struct Item {\n  int size = 0;\n};\n");
  shell("git init -q . && git add . && git -c user.name=a -c user.email=a@b commit -qm first");
  CHECK(contains(check().out, "nothing was released yet"));
  shell("git tag v0.1.0");
  CHECK(contains(check().out, "0 headers changed"));
  write("roles.hpp", "struct Item { int size = 0; };  // a comment\n");
  CHECK(contains(check().out, "0 headers changed"));
  write("roles.hpp", "struct Item {\n  int size = 0;\n  int depth = 0;\n};\n");
  const Finished unchanged = check();
  CHECK(unchanged.exit_code == 1);
  CHECK(contains(unchanged.out, "sdk/include/tolman/roles.hpp changed; raise TOLMAN_SDK_MINOR"));
  write("version.hpp", "#define TOLMAN_SDK_MAJOR 0\n#define TOLMAN_SDK_MINOR 2\n");
  const Finished raised = check();
  CHECK(raised.exit_code == 0);
  CHECK(contains(raised.out, "SDK 0.2, that of v0.1.0 is 0.1"));
}
