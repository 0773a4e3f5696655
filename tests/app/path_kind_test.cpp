// SPDX-License-Identifier: BSD-3-Clause
// A path of another kind than a command takes gets one sentence: what it is, and what takes it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// One path of each kind, by the words that messages call it.
struct Kinds {
  TemporaryFolder folder;
  std::map<std::string, fs::path> paths;

  Kinds() {
    const fs::path& in = folder.path();
    writeTinyKitti(in / "kitti", 3);
    put(in / "run/run.sqlite", "");
    put(in / "run/run.json", R"({"status": "finished"})");
    put(in / "run/figures/map.png", "");
    put(in / "sweep/points.txt", "");
    put(in / "point/point.json", "{}");
    fs::copy(in / "kitti/image_0", in / "images");
    fs::create_directories(in / "empty");
    put(in / "bag/metadata.yaml", "rosbag2_bagfile_information:\n");
    put(in / "bag/a.db3", "SQLite format 3");
    put(in / "base.yaml", "name: x\nsource: {plugin: town}\n");
    put(in / "study.yaml", "base: base.yaml\nseeds: 2\n");
    put(in / "poses.tum", "# time x y z qx qy qz qw\n0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
    put(in / "results.csv", "name,seed,alignment,truth_sha256,results_sha256,x\na,1,se2,,,3\n");
    put(in / "run.npz", std::string("PK\3\4\0", 5));
    put(in / "a.so",
        "\x7f"
        "ELF");
    paths = {{"a run directory", in / "run"},
             {"the folder of a sweep", in / "sweep"},
             {"the folder of one run of a sweep", in / "point"},
             {"a folder of images", in / "images"},
             {"an empty folder", in / "empty"},
             {"a bag of ROS", in / "bag"},
             {"a configuration", in / "base.yaml"},
             {"the file of a sweep", in / "study.yaml"},
             {"a trajectory", in / "poses.tum"},
             {"a table of `tolman sweep collect`", in / "results.csv"},
             {"a file of arrays", in / "run.npz"},
             {"a shared library", in / "a.so"},
             {"the record of a run", in / "run/run.sqlite"},
             {"the folder of a recording", in / "kitti"}};
    put(in / "run/run.sqlite", "SQLite format 3");
  }
};

struct Command {
  std::vector<std::string> before;
  std::vector<std::string> after;
  std::vector<std::string> takes;  ///< kinds for which the test does not ask
  int exit_code = 5;
};

}  // namespace

TEST_CASE("each command says what a path of another kind is, and what takes it") {
  const Kinds kinds;
  const std::string poses = kinds.paths.at("a trajectory").string();
  const std::string out = (kinds.folder.path() / "out").string();
  const std::vector<std::string> recordings = {"a folder of images", "a bag of ROS",
                                               "the folder of a recording"};
  const std::vector<Command> commands = {
      {{"run"}, {"--out", out}, {"a configuration"}, 3},
      {{"run", "demo", "--continue"}, {"--out", out}, {"a run directory"}, 9},
      {{"run", "--resume"}, {}, {"a run directory"}, 9},
      {{"check"}, {}, {"a configuration"}, 3},
      {{"bench"}, {}, {"a configuration"}, 3},
      {{"bench", "places"}, {}, {"a configuration"}, 3},
      {{"dataset", "render"}, {"--out", out}, {"a configuration"}, 3},
      {{"dataset", "check"}, {}, {"the folder of a recording"}},
      {{"dataset", "import"}, {"--source", "kitti", "--out", out}, {"the folder of a recording"}},
      {{"init"}, {}, recordings},
      {{"eval"}, {poses}, {"a trajectory"}},
      {{"eval", poses}, {}, {"a trajectory"}},
      {{"export"}, {"--out", out}, {"a run directory"}},
      {{"report"}, {"--out", out}, {"a run directory"}},
      {{"view"}, {"--port", "0"}, {"a run directory"}},
      {{"plan"}, {"--from", "0", "--to", "here"}, {"a run directory"}},
      {{"rerun"}, {"--out", out}, {"a run directory", "the folder of one run of a sweep"}},
      {{"compare"},
       {},
       {"a run directory", "the folder of a sweep", "a table of `tolman sweep collect`"}},
      {{"sweep"}, {"--out", out}, {"the file of a sweep"}, 3},
      {{"sweep", "status"}, {}, {"the folder of a sweep"}, 2},
      {{"sweep", "collect"},
       {"--out", out},
       {"a run directory", "the folder of a sweep", "a table of `tolman sweep collect`"}},
      {{"sweep", "archive"}, {"--out", out}, {"the folder of a sweep"}},
      {{"sweep", "point"}, {}, {"the folder of one run of a sweep"}, 3},
      {{"plugins", "doctor"}, {}, {"a shared library"}, 4},
      {{"plugins", "validate"}, {}, {"a shared library"}, 4},
  };
  std::size_t asked = 0;  // each command meets run directories, and every third of the others
  for (const Command& command : commands) {
    for (const auto& [kind, path] : kinds.paths) {
      if (++asked % 3 != 0 && kind != "a run directory") continue;
      if (std::ranges::find(command.takes, kind) != command.takes.end()) continue;
      std::vector<std::string> words = command.before;
      words.push_back(path.string());
      words.insert(words.end(), command.after.begin(), command.after.end());
      const Finished refused = tolman::test::tolman(words);
      INFO(command.before[0] + " " + kind + ": " + refused.err);
      CHECK(refused.exit_code == command.exit_code);
      CHECK(refused.err.starts_with(path.string() + ": is " + kind + ", not "));
      CHECK(std::ranges::count(refused.err, '\n') == 1);
      CHECK(refused.out.empty());
      CHECK_FALSE(fs::exists(out));
    }
  }
}

TEST_CASE("the figures of a run are no recording") {
  const Kinds kinds;
  const fs::path figures = kinds.folder.path() / "run/figures";
  const Finished refused = tolman::test::tolman({"init", figures.string()});
  CHECK(refused.exit_code == 5);
  CHECK(contains(refused.err, figures.string() + ": belongs to the run "));
}

TEST_CASE("a folder without runs is no archive of a sweep") {
  const TemporaryFolder folder;
  put(folder.path() / "some/notes.txt", "notes");
  const std::string out = (folder.path() / "a.tar.gz").string();
  const Finished refused =
      tolman::test::tolman({"sweep", "archive", (folder.path() / "some").string(), "--out", out});
  CHECK(refused.exit_code == 5);
  CHECK(contains(refused.err, "some: holds no runs of a sweep"));
  CHECK_FALSE(fs::exists(out));
  const Finished again = tolman::test::tolman({"rerun", (folder.path() / "some").string()});
  CHECK(again.exit_code == 3);
  CHECK(
      again.err.ends_with("/some: is no run directory, it holds no config.resolved.yaml; give "
                          "the folder that a run has written\n"));
}
