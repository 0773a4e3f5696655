// SPDX-License-Identifier: BSD-3-Clause
// Sessions: real motion in two parts, the second one on the map of the first.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "end_to_end/process.hpp"
#include "end_to_end/record_rows.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Settings = std::vector<std::string>;

/// Frames first ... last of a sequence; `settings` follow --set.
Finished drive(const fs::path& data, const fs::path& out, int first, int last,
               const Settings& settings = {}, const std::string& earlier = "") {
  Settings arguments = {"run", inSource("configs/motion.yaml"), "--quiet", "--out", out.string()};
  Settings all = {"source.path=" + data.string(), "source.first=" + std::to_string(first),
                  "source.last=" + std::to_string(last)};
  const std::string origin = "source.truth_origin=";
  if (std::ranges::none_of(settings, [&](const auto& s) { return s.starts_with(origin); })) {
    all.push_back(origin + "data");
  }
  all.insert(all.end(), settings.begin(), settings.end());
  for (const std::string& setting : all) {
    arguments.insert(arguments.end(), {"--set", setting});
  }
  if (!earlier.empty()) arguments.insert(arguments.end(), {"--continue", earlier});
  return tolman::test::tolman(arguments);
}

std::size_t linesOf(const fs::path& file) {
  const std::string text = readText(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void replaceIn(const fs::path& file, const std::string& what, const std::string& by) {
  std::string text = readText(file);
  REQUIRE(contains(text, what));
  text.replace(text.find(what), what.size(), by);
  std::ofstream(file, std::ios::binary) << text;
}

/// Loop links of all sessions, and those between places more than 10 m apart in truth.
struct Loops {
  int all = 0;
  int false_ones = 0;
};

Loops loopCounts(const fs::path& run) {
  const auto rows =
      recordRows(run,
                 "SELECT fa.T_world_camera_truth_x - fb.T_world_camera_truth_x, "
                 "fa.T_world_camera_truth_z - fb.T_world_camera_truth_z FROM link "
                 "JOIN experience a ON a.id = link.\"from\" JOIN frame fa ON fa.frame = a.frame "
                 "JOIN experience b ON b.id = link.\"to\" JOIN frame fb ON fb.frame = b.frame "
                 "WHERE kind = 'loop' AND NOT rejected");
  Loops loops;
  for (const auto& apart : rows) {
    ++loops.all;
    loops.false_ones += std::hypot(apart[0], apart[1]) > 10 ? 1 : 0;
  }
  return loops;
}

struct Cut {
  const char* sequence;
  int first;   ///< of the second session
  int middle;  ///< end of the first session
  int last;
  double bar;  ///< m, joint RMSE
};

}  // namespace

TEST_CASE("a second session joins the map of the first, as good as in one go", "[data]") {
  // 00 and 05 cut in two; then second sessions that wake up amid the first one's way.
  const Cut cut = GENERATE(Cut{"00", 2271, 2270, 4540, 2.6}, Cut{"05", 1381, 1380, 2760, 2.8},
                           Cut{"05", 700, 1500, 2760, 2.8}, Cut{"00", 1600, 3000, 4540, 2.9},
                           Cut{"06", 400, 800, 1100, 4});
  const auto data = dataOrSkip(std::string("kitti_motion/") + cut.sequence);
  if (!data) return;
  const TemporaryFolder out;
  const fs::path first = out.path() / "first";
  const fs::path second = out.path() / "second";
  const Finished one = drive(*data, first, 0, cut.middle);
  INFO(one.err);
  REQUIRE(one.exit_code == 0);
  const Finished two =
      drive(*data, second, cut.first, cut.last, {"evaluation.sessions=joint"}, first.string());
  INFO(two.err);
  REQUIRE(two.exit_code == 0);

  const auto metrics = readJson(second / "metrics.json");
  CHECK(metrics["parts"] == 1);
  CHECK(readJson(second / "run.json")["counters"]["templates"] == metrics["templates"]);
  REQUIRE(metrics["sessions"].size() == 2);
  CHECK(metrics["sessions"][1]["first_frame"] == cut.middle + 1);
  CHECK(metrics["map"]["matched"] == cut.middle + 1 + cut.last - cut.first + 1);
  const double joint = metrics["map"]["ate"]["rmse_m"].get<double>();
  CHECK(joint <= cut.bar);
  CHECK(metrics["map"]["warning"].is_null());
  // How the robot came from one session to the next is in no figure.
  CHECK(metrics["map"]["rpe"]["frame"]["translation"]["max_m"] < 2);
  CHECK(metrics["map"]["rpe"]["frame"]["pairs"] == cut.middle + cut.last - cut.first);
  CHECK(metrics["map"]["kitti"]["segments_in_gaps"] > 0);
  CHECK(metrics["odometry"]["coverage"] > 0.99);
  WARN("KITTI " << cut.sequence << ", second session from frame " << cut.first << ": joint RMSE "
                << joint << " m");
  const Loops loops = loopCounts(second);
  CHECK(loops.all > 0);
  CHECK(loops.false_ones == 0);
  // The record is complete in itself, and the exported trajectories are of one session each.
  fs::remove_all(first);
  CHECK(linesOf(second / "trajectory.tum") == static_cast<std::size_t>(cut.last - cut.first + 1));
  REQUIRE(tolman::test::tolman({"export", second.string(), "--session", "0"}).exit_code == 0);
  CHECK(linesOf(second / "session-0/trajectory.tum") == static_cast<std::size_t>(cut.middle + 1));
  const auto last = std::to_string(metrics["experiences"].get<int>() - 1);
  const Finished way = tolman::test::tolman({"plan", second.string(), "--from", "0", "--to", last});
  INFO(way.err);
  CHECK(way.exit_code == 0);
}

TEST_CASE("truth that each session counts from its own first frame is told", "[data]") {
  const auto data = dataOrSkip("kitti_motion/05");
  if (!data) return;
  const TemporaryFolder out;
  const std::string first = (out.path() / "first").string();
  const std::string second = (out.path() / "second").string();
  REQUIRE(drive(*data, first, 0, 1380).exit_code == 0);
  const Finished two = drive(*data, second, 1381, 2760,
                             {"evaluation.sessions=joint", "source.truth_origin=first"}, first);
  REQUIRE(two.exit_code == 0);
  const auto map = readJson(fs::path(second) / "metrics.json")["map"];
  CHECK(map["ate"]["rmse_m"].get<double>() > 50);
  REQUIRE(map["warning"].is_string());
  CHECK(contains(map["warning"].get<std::string>(), "truth_origin: data"));
}

TEST_CASE("a run does not go on in its own directory", "[data]") {
  const auto data = dataOrSkip("kitti_motion/07");
  if (!data) return;
  const TemporaryFolder out;
  const std::string run = (out.path() / "run").string();
  REQUIRE(drive(*data, run, 0, 30).exit_code == 0);
  const Finished again = drive(*data, run, 31, 60, {}, run);
  CHECK(again.exit_code == 9);
  CHECK(contains(again.err,
                 "a run cannot continue in its own directory; give another one with --out"));
  CHECK(linesOf(fs::path(run) / "trajectory.tum") == 31);
}

TEST_CASE("what nothing joins is said to be apart", "[data]") {
  const auto data = dataOrSkip("kitti_motion/07");
  if (!data) return;
  const TemporaryFolder out;
  const std::string first = (out.path() / "first").string();
  const std::string second = (out.path() / "second").string();
  REQUIRE(drive(*data, first, 0, 300).exit_code == 0);
  REQUIRE(drive(*data, second, 400, 600, {"evaluation.sessions=joint"}, first).exit_code == 0);
  const auto metrics = readJson(fs::path(second) / "metrics.json");
  CHECK(metrics["parts"] == 2);
  CHECK(metrics["map"]["ate"]["rmse_m"].is_null());
  CHECK(contains(metrics["map"]["reason"].get<std::string>(), "session 1 in part 1"));
  CHECK(contains(readText(fs::path(second) / "report.html"), "poses of different parts"));
  CHECK(contains(readText(fs::path(second) / "map.g2o"), "# 2 parts"));
  const auto last = metrics["experiences"].get<int>() - 1;
  const Finished way =
      tolman::test::tolman({"plan", second, "--from", "0", "--to", std::to_string(last)});
  CHECK(way.exit_code == 5);
  CHECK(contains(way.err, "different connected parts"));
}

TEST_CASE("the recorded candidates of another drive find nothing in this one's map", "[data]") {
  const auto earlier = dataOrSkip("kitti_motion/00");
  const auto later = dataOrSkip("kitti_motion/06");
  if (!earlier || !later) return;
  const TemporaryFolder out;
  const std::string first = (out.path() / "first").string();
  const std::string second = (out.path() / "second").string();
  REQUIRE(drive(*earlier, first, 0, 4540).exit_code == 0);
  const Finished two = drive(*later, second, 0, 1100, {}, first);
  REQUIRE(two.exit_code == 0);
  CHECK(contains(readText(fs::path(second) / "log.txt"), "another drive"));
  const auto metrics = readJson(fs::path(second) / "metrics.json");
  CHECK(metrics["parts"] == 2);
  CHECK(metrics["map"]["ate"]["rmse_m"].get<double>() < 2.5);  // as without the first session
}

TEST_CASE("a state that does not fit is refused in one sentence, with exit code 9", "[data]") {
  const auto data = dataOrSkip("kitti_motion/07");
  if (!data) return;
  const TemporaryFolder out;
  const fs::path first = out.path() / "first";
  REQUIRE(drive(*data, first, 0, 200).exit_code == 0);
  const auto refusal = [&](const Settings& settings = {}) {
    const Finished finished =
        drive(*data, out.path() / "second", 300, 400, settings, first.string());
    CHECK(finished.exit_code == 9);
    CHECK_FALSE(fs::exists(out.path() / "second"));
    CHECK(std::count(finished.err.begin(), finished.err.end(), '\n') == 1);
    return finished.err;
  };
  const fs::path contents = first / "state/session.json";
  const fs::path map = first / "state/map.bin";
  CHECK(contains(refusal({"cells.period=12"}),
                 "cells.period is 12.0, and was 0.0 in the earlier session"));
  CHECK(contains(refusal({"map.plugin=relaxation"}),
                 "map.plugin is relaxation, and was experience_map"));
  SECTION("damaged bytes") {
    replaceIn(map, "TLMEXMAP", "tlmexmap");
    CHECK(contains(refusal(), "state/map.bin: "));
  }
  SECTION("cut short, and nothing left") {
    fs::resize_file(map, 100);
    CHECK(contains(refusal(), "state/map.bin: "));
    fs::remove(map);
    CHECK(contains(refusal(), "cannot be read"));
    fs::remove(contents);
    CHECK(contains(refusal(), "saved no map that could be continued"));
    fs::remove_all(first);
    CHECK(contains(refusal(), "is no run directory"));
  }
  SECTION("a newer version of a plugin") {
    replaceIn(contents, "\"version\": \"0.1.0\"", "\"version\": \"9.0.0\"");
    CHECK(contains(refusal(), "and was 9.0.0"));
  }
  SECTION("a damaged run.json") {
    std::ofstream(first / "run.json").close();
    CHECK(contains(refusal(), "run.json: is missing or damaged"));
  }
  SECTION("no JSON") {
    std::ofstream(contents) << "{\"frames\": ";
    CHECK(contains(refusal(), "is damaged"));
    std::ofstream(contents) << "{\"frames\": 1, \"stages\": 3}";
    CHECK(contains(refusal(), "is damaged"));
  }
}

TEST_CASE("carried away within a session: the same as two sessions", "[data]") {
  const auto data = dataOrSkip("kitti_motion/05");
  if (!data) return;
  const TemporaryFolder out;
  const Finished finished = drive(*data, out.path() / "run", 0, 2760, {"odometry.carried_at=1380"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto metrics = readJson(out.path() / "run/metrics.json");
  CHECK(metrics["parts"] == 1);
  CHECK(metrics["map"]["ate"]["rmse_m"].get<double>() <= 2.8);
}
