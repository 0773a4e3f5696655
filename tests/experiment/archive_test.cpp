// SPDX-License-Identifier: BSD-3-Clause
// The archive of a sweep can be run again with the data in another folder, and reports differences.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "experiment/motion_folder.hpp"
#include "experiment/study.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

TEST_CASE("an archive runs elsewhere, with the same results") {
  const Study study;
  study.writeAll(
      "set: {odometry.noise_distance: 0.02}\n"
      "sequences: {a: {front_end: {base: motion.yaml, source.path: a}}, b: b}\n"
      "seeds: 2\n");
  REQUIRE(study.sweep().exit_code == 0);
  const fs::path file = study.folder.path() / "study.tar.gz";
  const Finished written =
      tolman::test::tolman({"sweep", "archive", study.out().string(), "--out", file.string()});
  INFO(written.err);
  REQUIRE(written.exit_code == 0);
  const std::string first = readText(file);
  REQUIRE(tolman::test::tolman(
              {"sweep", "archive", study.out().string(), "--out", file.string(), "--force"})
              .exit_code == 0);
  CHECK(readText(file) == first);  // the same bytes each time
  const fs::path own = study.folder.path() / "own.tar.gz";
  std::ofstream(own) << "somebody's";
  const Finished refused =
      tolman::test::tolman({"sweep", "archive", study.out().string(), "--out", own.string()});
  CHECK(refused.exit_code == 8);
  CHECK(contains(refused.err, "exists; choose another --out, or replace it with --force"));
  CHECK(readText(own) == "somebody's");

  const TemporaryFolder other;
  REQUIRE(run({"tar", "-C", other.path().string(), "-xzf", file.string()}).exit_code == 0);
  for (const char* data : {"a", "b"}) {
    fs::rename(study.folder.path() / data, other.path() / data);
  }
  fs::remove_all(study.out());
  const std::string list = readText(other.path() / "out/data.txt");
  CHECK(contains(list, "DATA_1\t" + (study.folder.path() / "a").string() + "\t"));
  const Words rerun = {"env",
                       "TOLMAN=" + tolmanProgram().string(),
                       "DATA_1=" + (other.path() / "a").string(),
                       "DATA_2=" + (other.path() / "b").string(),
                       "sh",
                       (other.path() / "out/rerun.sh").string()};
  const Finished same = run(rerun);
  INFO(same.out << same.err);
  CHECK(same.exit_code == 0);
  CHECK(contains(same.out, "same     sequence=b,seed=2"));
  CHECK_FALSE(contains(same.out, "differs"));

  writeMotionFolder(other.path() / "b", 0.001);
  const Finished changed = run(rerun);
  CHECK(changed.exit_code == 1);
  CHECK(contains(changed.out, "same     sequence=a,seed=1"));
  CHECK(contains(changed.out, "differs  sequence=b,seed=1"));
  std::string said;
  for (const auto& entry : fs::directory_iterator(other.path() / "out/again")) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("sequence=b,seed=1") && name.ends_with(".txt")) {
      said = readText(entry.path());
    }
  }
  CHECK(contains(said, "has other contents"));

  // Data that are not there are no difference.
  fs::remove_all(other.path() / "b");
  const Finished without = run(rerun);
  CHECK(without.exit_code == 2);
  CHECK(contains(without.out, "not run  sequence=b,seed=1"));
  CHECK_FALSE(contains(without.out, "differs"));
  // The folder of the archive is a table.
  const Finished table = tolman::test::tolman({"compare", (other.path() / "out").string()});
  INFO(table.err);
  CHECK(table.exit_code == 0);
  CHECK(contains(table.out, "map.ate.rmse_m"));
}

TEST_CASE("paths of the data are relative to where the script is called") {
  const Study study;
  study.writeAll("sequences: {a: a}\n");
  REQUIRE(study.sweep().exit_code == 0);
  const fs::path file = study.folder.path() / "study.tar.gz";
  REQUIRE(tolman::test::tolman({"sweep", "archive", study.out().string(), "--out", file.string()})
              .exit_code == 0);
  const TemporaryFolder other;
  REQUIRE(run({"tar", "-C", other.path().string(), "-xzf", file.string()}).exit_code == 0);
  fs::rename(study.folder.path() / "a", other.path() / "a");
  const Finished again =
      run({"env", "-C", other.path().string(), "TOLMAN=" + tolmanProgram().string(), "DATA_1=a",
           "sh", "out/rerun.sh"});
  INFO(again.out << again.err);
  CHECK(again.exit_code == 0);
}
