// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/study.hpp"

#include <fstream>

#include "experiment/motion_folder.hpp"

namespace tolman::test {

namespace fs = std::filesystem;

Study::Study() {
  writeMotionFolder(folder.path() / "a");
  writeMotionFolder(folder.path() / "b", -0.003);
  writeMotionConfig(folder.path(), folder.path() / "a");
  write("seeds: 3\n");
}

void Study::write(const std::string& more) const {
  writeAll(
      "set: {odometry.noise_distance: 0.02, odometry.noise_heading: 0.002}\n"
      "grid: {cells.period: [100, 150]}\n"
      "sequences: {a: a, b: b}\n" +
      more);
}

void Study::writeAll(const std::string& text) const {
  std::ofstream(file()) << "base: motion.yaml\n" << text;
}

Words Study::words(const Words& options, const std::string& name) const {
  Words words = {"sweep", file(), "--out", out(name).string()};
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

Finished Study::sweep(const Words& options, const std::string& name) const {
  return tolman(words(options, name));
}

std::string Study::status(const std::string& name) const {
  return tolman({"sweep", "status", out(name).string()}).out;
}

fs::path Study::point(const std::string& run, const std::string& name) const {
  for (const auto& entry : fs::directory_iterator(out(name))) {
    const fs::path file = entry.path() / "point.json";
    if (fs::exists(file) && readJson(file)["name"] == run) return entry.path();
  }
  return out(name) / "none";
}

std::map<std::string, std::string> Study::results(const std::string& name) const {
  std::map<std::string, std::string> digests;
  for (const auto& entry : fs::directory_iterator(out(name))) {
    if (!fs::exists(entry.path() / "run/results.sha256")) continue;
    digests[readJson(entry.path() / "point.json")["name"]] =
        readText(entry.path() / "run/results.sha256");
  }
  return digests;
}

}  // namespace tolman::test
