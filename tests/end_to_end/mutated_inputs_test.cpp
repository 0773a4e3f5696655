// SPDX-License-Identifier: BSD-3-Clause
// Randomly changed input files: every command ends with an exit code of docs/errors.md for inputs
// and a message. None crashes, hangs, or reports an internal error.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "tolman/context.hpp"

using namespace tolman::test;
using tolman::RandomStream;
namespace fs = std::filesystem;

namespace {

void writeBytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// One change of a kind that copying, editing and failing disks make.
void changeOnce(std::string& bytes, RandomStream& random) {
  static const std::vector<std::string> kWild = {"nan",
                                                 "-1",
                                                 "1e999",
                                                 "99999999999999999999",
                                                 "\r\n",
                                                 "\xff\xfe",
                                                 std::string(1, '\0'),
                                                 "{",
                                                 "]",
                                                 ": ",
                                                 "\"",
                                                 "&a *a",
                                                 "../",
                                                 "\t"};
  const std::size_t at = bytes.empty() ? 0 : random.below(bytes.size());
  const std::size_t length =
      bytes.empty() ? 0 : random.below(std::min<std::size_t>(bytes.size() - at, 40) + 1);
  switch (random.below(6)) {
    case 0:
      if (!bytes.empty()) bytes[at] = static_cast<char>(random.below(256));
      break;
    case 1:
      bytes.erase(at, length);
      break;
    case 2:
      bytes.insert(at, bytes.substr(at, length));
      break;
    case 3:
      bytes.insert(at, kWild[random.below(kWild.size())]);
      break;
    case 4:
      bytes.replace(at, length, kWild[random.below(kWild.size())]);
      break;
    default:
      if (random.below(4) == 0) bytes.resize(at);
      break;
  }
}

std::string changed(std::string bytes, RandomStream& random) {
  for (std::size_t i = 1 + random.below(4); i > 0; --i) changeOnce(bytes, random);
  return bytes;
}

/// What a command may end with, and how often each of it was seen.
struct Ends {
  std::set<int> allowed;
  std::map<int, int> seen = {};

  /// Runs a command that must not take 60 s.
  void of(std::vector<std::string> words) {
    const std::vector<std::string> begin = {"timeout", "60", tolmanProgram().string()};
    words.insert(words.begin(), begin.begin(), begin.end());
    const Finished finished = run(words);
    CAPTURE(finished.exit_code, finished.out, finished.err);
    REQUIRE(allowed.contains(finished.exit_code));
    if (finished.exit_code != 0) REQUIRE_FALSE((finished.out + finished.err).empty());
    ++seen[finished.exit_code];
  }
  void hasSeen(int code, int times) { CHECK(seen[code] >= times); }
};

/// A data set of four frames and, on demand, a run on it.
struct Setting {
  TemporaryFolder folder;
  fs::path sequence = folder.path() / "sequence";
  fs::path run = folder.path() / "run";
  fs::path config;
  Setting() {
    writeTinyKitti(sequence, 4);
    config = writeTinyConfig(folder.path(), sequence);
  }
  void makeRun() const {
    const Finished finished = tolman::test::tolman(tinyRun(config, run));
    INFO(finished.err);
    REQUIRE(finished.exit_code == 0);
  }
};

}  // namespace

TEST_CASE("changed configurations are checked to the end, or refused as such") {
  const Setting setting;
  const std::string sound = readText(setting.config);
  RandomStream random(101);
  Ends ends{{0, 3, 4, 5}};
  for (int i = 0; i < 40; ++i) {
    const std::string text = changed(sound, random);
    CAPTURE(i, text);
    writeBytes(setting.config, text);
    ends.of({"check", setting.config.string(), "--plugin-path",
             inBuild("tests/fixtures/plugins/steady")});
  }
  ends.hasSeen(3, 10);
}

TEST_CASE("changed text files of a data set are damaged data, or still sound") {
  const Setting setting;
  RandomStream random(102);
  Ends ends{{0, 5}};
  for (const char* name : {"calib.txt", "times.txt", "poses.txt"}) {
    const std::string sound = readText(setting.sequence / name);
    for (int i = 0; i < 14; ++i) {
      const std::string text = changed(sound, random);
      CAPTURE(name, i, text);
      writeBytes(setting.sequence / name, text);
      ends.of({"dataset", "check", setting.sequence.string()});
    }
    writeBytes(setting.sequence / name, sound);
  }
  ends.hasSeen(5, 15);
  CHECK(tolman::test::tolman({"dataset", "check", setting.sequence.string()}).exit_code == 0);
}

TEST_CASE("changed images end a run as damaged data, or are shown as they are") {
  const Setting setting;
  RandomStream random(103);
  const fs::path image = setting.sequence / "image_0/000002.png";
  const std::string sound = readText(image);
  Ends ends{{0, 5}};
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    writeBytes(image, changed(sound, random));
    auto words = tinyRun(setting.config, setting.run);
    words.insert(words.end(), {"--force", "--quiet"});
    ends.of(words);
  }
  ends.hasSeen(5, 6);
}

TEST_CASE("changed trajectories are evaluated or refused") {
  const Setting setting;
  RandomStream random(104);
  const fs::path estimate = setting.folder.path() / "estimate.txt";
  const fs::path truth = setting.sequence / "poses.txt";
  const std::string kitti = readText(truth);
  std::string tum = "# stamp x y z qx qy qz qw\n";
  for (int k = 0; k < 6; ++k) {
    tum += std::to_string(0.1 * k) + " " + std::to_string(k) + " 0 0.5 0 0 0 1\n";
  }
  Ends ends{{0, 5}};
  for (int i = 0; i < 40; ++i) {
    const std::string text = changed(i % 2 == 0 ? kitti : tum, random);
    CAPTURE(i, text);
    writeBytes(estimate, text);
    ends.of({"eval", estimate.string(), truth.string()});
  }
  ends.hasSeen(5, 15);
}

TEST_CASE("changed motion logs are damaged data, or still sound") {
  const TemporaryFolder folder;
  RandomStream random(105);
  std::string sound;
  for (int k = 0; k < 8; ++k) {
    sound +=
        "EDGE_SE2 " + std::to_string(k) + " " + std::to_string(k + 1) + " 1.25 0 0.1 1 0 0 1 0 1\n";
  }
  Ends ends{{0, 5}};
  for (int i = 0; i < 30; ++i) {
    const std::string text = changed(sound, random);
    CAPTURE(i, text);
    writeBytes(folder.path() / "odometry.g2o", text);
    writeBytes(folder.path() / "loop_candidates.g2o", "EDGE_SE2 7 0 1 0 0 1 0 0 1 0 1\n");
    ends.of({"dataset", "check", folder.path().string(), "--source", "motion_log"});
  }
  ends.hasSeen(5, 10);
}

TEST_CASE("changed records are exported and drawn as far as they go, or refused") {
  const Setting setting;
  setting.makeRun();
  RandomStream random(106);
  const fs::path record = setting.run / "run.sqlite";
  const std::string sound = readText(record);
  Ends ends{{0, 5}};
  for (int i = 0; i < 12; ++i) {
    std::string bytes = sound;
    if (i % 4 == 3) {
      bytes = changed(sound, random);  // shifts everything after it
    } else {  // a sector of noise; in every second record within the schema
      const std::size_t reach = i % 2 == 0 ? 4096 : bytes.size() - 64;
      const std::size_t at = random.below(reach);
      for (std::size_t k = 0; k < 64; ++k) bytes[at + k] = static_cast<char>(random.below(256));
    }
    CAPTURE(i);
    writeBytes(record, bytes);
    if (i % 2 == 0) {
      ends.of({"export", setting.run.string(), "--out",
               (setting.folder.path() / ("export" + std::to_string(i))).string()});
    } else {
      ends.of({"report", setting.run.string()});
    }
  }
  ends.hasSeen(5, 2);
}

TEST_CASE("a run goes on from a changed session, or refuses it as one") {
  const Setting setting;
  setting.makeRun();
  REQUIRE(fs::is_directory(setting.run / "state"));
  RandomStream random(107);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(setting.run / "state")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 3);
  Ends ends{{0, 9}};
  for (std::size_t i = 0; i < 16; ++i) {
    const fs::path& file = files[i % files.size()];
    const std::string sound = readText(file);
    writeBytes(file, changed(sound, random));
    CAPTURE(i, file);
    auto words = tinyRun(setting.config, setting.folder.path() / "second");
    words.insert(words.end(), {"--continue", setting.run.string(), "--force", "--quiet"});
    ends.of(words);
    writeBytes(file, sound);
  }
  ends.hasSeen(9, 8);
}
