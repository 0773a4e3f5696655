// SPDX-License-Identifier: BSD-3-Clause
// The installed tree runs and finds its plugins; a plugin built in a folder outside this tree,
// against the installed package, is loaded by the installed host.
#include <catch2/catch.hpp>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

TEST_CASE("install, build a stranger's plugin against the package, run it") {
  const TemporaryFolder folder;
  const auto prefix = (folder.path() / "prefix").string();
  const Finished installed = run({TOLMAN_CMAKE, "--install", inBuild(""), "--prefix", prefix});
  INFO(installed.err);
  REQUIRE(installed.exit_code == 0);
  const std::string program = prefix + "/bin/tolman";
  const Finished list = run({program, "plugins", "list"});
  REQUIRE(list.exit_code == 0);
  CHECK(contains(list.out, "view_templates"));
  CHECK(contains(list.out, "view_sequences"));
  CHECK(fs::exists(prefix + "/share/tolman/configs/kitti.yaml"));
  CHECK(run({"sh", "-c", "cd / && '" + program + "' check demo"}).exit_code == 0);

  const std::string source = (folder.path() / "stranger").string();
  const std::string build = (folder.path() / "stranger-build").string();
  fs::copy(inSource("tests/end_to_end/external_plugin"), source);
  const Finished configured =
      run({TOLMAN_CMAKE, "-S", source, "-B", build, "-DCMAKE_PREFIX_PATH=" + prefix});
  INFO(configured.out << configured.err);
  REQUIRE(configured.exit_code == 0);
  const Finished built = run({TOLMAN_CMAKE, "--build", build});
  INFO(built.out << built.err);
  REQUIRE(built.exit_code == 0);

  writeTinyKitti(folder.path() / "sequence", 11);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const Finished ran =
      run({program, "run", config.string(), "--plugin-path", build, "--set",
           "odometry={plugin: half_speed}", "--out", (folder.path() / "run").string()});
  INFO(ran.err);
  REQUIRE(ran.exit_code == 0);
  const auto metrics = readJson(folder.path() / "run/metrics.json");
  CHECK(metrics["odometry"]["path_length_m"].get<double>() == Approx(5.0));
}
