// SPDX-License-Identifier: BSD-3-Clause
// Each reader of text says what a file in UTF-16 is, instead of blaming a line or a number.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

/// ASCII as Windows' editors save it: UTF-16, little-endian, with a byte order mark.
std::string utf16(const std::string& text) {
  std::string wide = "\xFF\xFE";
  for (const char c : text) (wide += c) += '\0';
  return wide;
}

void isNamed(const fs::path& file, int exit_code, const std::vector<std::string>& words) {
  const Finished refused = tolman::test::tolman(words);
  CAPTURE(words, refused.err);
  CHECK(refused.exit_code == exit_code);
  CHECK(contains(refused.err + refused.out, file.filename().string()));
  CHECK(contains(refused.err + refused.out, "is UTF-16; save it as UTF-8"));
}

}  // namespace

TEST_CASE("lists, calibration, times and poses in UTF-16") {
  const TemporaryFolder folder;
  for (const char* name : {"calib.txt", "times.txt", "poses.txt"}) {
    const fs::path sequence = folder.path() / name / "sequence";
    writeTinyKitti(sequence, 4);
    write(sequence / name, utf16(readText(sequence / name)));
    isNamed(sequence / name, 5, {"dataset", "check", sequence.string(), "--source", "kitti"});
  }
  const fs::path tum = folder.path() / "tum";
  write(tum / "rgb.txt", utf16("1.0 rgb/1.0.png\n1.1 rgb/1.1.png\n1.2 rgb/1.2.png"));
  write(tum / "rgb/1.0.png", "");
  isNamed(tum / "rgb.txt", 5, {"dataset", "check", tum.string(), "--source", "tum"});
  const fs::path log = folder.path() / "log";
  write(log / "odometry.g2o", utf16("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"));
  isNamed(log / "odometry.g2o", 5, {"dataset", "check", log.string(), "--source", "motion_log"});
  const fs::path bag = folder.path() / "bag";
  write(bag / "metadata.yaml", utf16("relative_file_paths:\n  - a.db3\n"));
  isNamed(bag / "metadata.yaml", 5, {"dataset", "check", bag.string(), "--source", "ros_bag"});
}

TEST_CASE("trajectories, tables, configurations and sweeps in UTF-16") {
  const TemporaryFolder folder;
  const fs::path poses = folder.path() / "poses.tum";
  write(poses, utf16("0 0 0 0 0 0 0 1\n1 0 0 1 0 0 0 1\n"));
  isNamed(poses, 5, {"eval", poses.string(), poses.string()});
  const fs::path table = folder.path() / "table.csv";
  write(table, utf16("name,alignment,truth,results,ate\nx,se3,t,r,1\n"));
  isNamed(table, 5, {"compare", table.string()});
  const fs::path yaml = folder.path() / "system.yaml";
  write(yaml, utf16("name: x\n"));
  isNamed(yaml, 3, {"check", yaml.string()});
  isNamed(yaml, 3, {"sweep", yaml.string(), "--dry-run"});
}
