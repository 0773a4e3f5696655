// SPDX-License-Identifier: BSD-3-Clause
// tolman eval: which poses are compared, and which inputs are refused.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"

using namespace tolman::test;

namespace {

/// Pose k of a curved drive, with its stamp in front (TUM) or without (KITTI).
std::string line(int k, double stamp_s, bool tum) {
  const double x = 0.002 * k * k;
  if (tum) return fmt::format("{:.3f} {} 0 {} 0 0 0 1\n", stamp_s, x, k);
  return fmt::format("1 0 0 {} 0 1 0 0 0 0 1 {}\n", x, k);
}

struct Files {
  TemporaryFolder folder;

  /// Poses 0, step, ... of a drive with 10 frames a second.
  std::string write(const std::string& name, bool tum, double start_s = 0, int step = 1,
                    int end = 60) const {
    const std::filesystem::path path = folder.path() / name;
    std::ofstream file(path);
    for (int k = 0; k < end; k += step) file << line(k, start_s + 0.1 * k, tum);
    return path.string();
  }
};

Finished eval(const std::string& truth, const std::string& estimate,
              const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"eval", truth, estimate};
  words.insert(words.end(), more.begin(), more.end());
  return tolman::test::tolman(words);
}

}  // namespace

TEST_CASE("eval by time refuses files without times") {
  const Files files;
  const std::string tum = files.write("a.tum", true);
  const std::string kitti = files.write("a.kitti", false);
  const std::string refusal =
      kitti + ": has no times, as all KITTI files; its poses can only be matched by their order\n";
  for (const auto& [truth, estimate] :
       {std::pair(kitti, kitti), std::pair(tum, kitti), std::pair(kitti, tum)}) {
    const Finished finished = eval(truth, estimate, {"--max-difference", "0.02"});
    CHECK(finished.exit_code == 2);
    CHECK(finished.err == refusal);
    CHECK(finished.out.empty());
    CHECK(eval(truth, estimate).exit_code == 0);
  }
  CHECK(eval(tum, tum, {"--max-difference", "0.02"}).exit_code == 0);
}

TEST_CASE("eval matches by time where both files have times") {
  const Files files;
  const std::string truth = files.write("truth.tum", true);
  const Finished third = eval(truth, files.write("third.tum", true, 0, 3));
  CHECK(third.exit_code == 0);
  CHECK(contains(third.out, "20 with truth; coverage 100.0 %"));
  CHECK(contains(third.out, "ATE rmse 0.000 m"));
  CHECK(third.err.empty());
  CHECK(eval(truth, files.write("early.tum", true, 0, 1, 40)).err.empty());  // ends early
}

TEST_CASE("eval warns of stamps by another clock") {
  const Files files;
  const std::string truth = files.write("truth.tum", true);
  const std::string moved = files.write("moved.tum", true, 10000);
  const Finished finished = eval(truth, moved, {"--json"});
  CHECK(finished.exit_code == 0);
  CHECK(finished.err == "warning: " + moved + ": its stamps and those of " + truth +
                            " have no moment in common; the poses are matched by their order\n");
  CHECK(nlohmann::json::parse(finished.out)["matched"] == 60);
  CHECK(eval(truth, moved, {"--quiet"}).err.empty());
}

TEST_CASE("eval of a single pose tells no error of zero") {
  const Files files;
  const std::string truth = files.write("truth.tum", true);
  const std::string one = files.write("one.tum", true, 0, 1, 1);
  const Finished finished = eval(truth, one);
  CHECK(finished.exit_code == 5);
  CHECK(contains(finished.err, "only one pose matches"));
  CHECK(eval(truth, one, {"--align", "none"}).exit_code == 0);
  const auto at_zero = files.folder.path() / "zero.tum";  // a time, though it is 0
  std::ofstream(at_zero) << "0.000000 0 0 0 0 0 0 1\n";
  const Finished by_time = eval(truth, at_zero.string(), {"--max-difference", "0.04"});
  CHECK(by_time.exit_code == 5);
  CHECK_FALSE(contains(by_time.err, "KITTI"));
}

TEST_CASE("eval of two poses under a free scale tells no error of zero, of few poses warns") {
  const Files files;
  const std::string truth = files.write("truth.tum", true);
  const std::string two = files.write("two.tum", true, 0, 1, 2);
  const std::vector<std::string> free_scale = {"--align", "sim3", "--max-difference", "0.01"};
  const Finished finished = eval(truth, two, free_scale);
  CHECK(finished.exit_code == 5);
  CHECK(contains(finished.err, "only two poses match"));
  // Stamps in other units: only the first pose has a true one near.
  std::ofstream apart(files.folder.path() / "ms.tum");
  for (int k = 0; k < 60; ++k) apart << line(k, k < 2 ? 0.1 * k : 100.0 * k, true);
  apart.close();
  const Finished few =
      eval(truth, (files.folder.path() / "ms.tum").string(), {"--max-difference", "0.01"});
  CHECK(few.exit_code == 0);
  CHECK(contains(few.err, "only 2 of 60 poses have a true pose at their time"));
}

TEST_CASE("eval refuses to guess which poses belong together") {
  const Files files;
  const std::string truth = files.write("truth.kitti", false);
  const std::string half = files.write("half.tum", true, 0, 2);
  const Finished finished = eval(truth, half);
  CHECK(finished.exit_code == 5);
  CHECK(finished.err ==
        half + " has 30 poses and " + truth +
            " has 60, and only one of them has times: which belong together is not known; give "
            "both with times (TUM), or both as KITTI files that begin at the same frame\n");
  CHECK(eval(truth, files.write("all.tum", true)).exit_code == 0);
}

TEST_CASE("eval of several estimates gives a table, a figure, and JSON by name") {
  const Files files;
  const std::string truth = files.write("truth.tum", true);
  const std::string third = files.write("third.tum", true, 0, 3);
  const std::string figure = (files.folder.path() / "errors.svg").string();
  const std::vector<std::string> words = {"eval", truth, truth, third, "--figure", figure};
  const Finished table = tolman::test::tolman(words);
  CHECK(table.exit_code == 0);
  CHECK(contains(table.out, "estimate"));
  CHECK(contains(table.out, third + "     0.000"));
  CHECK(std::filesystem::file_size(figure) > 1000);
  CHECK(tolman::test::tolman(words).exit_code == 8);  // the figure exists
  const auto json = nlohmann::json::parse(
      tolman::test::tolman({"eval", truth, truth, third, "--rpe", "10m", "--path", "--json"}).out);
  CHECK(json[third]["matched"] == 20);
  CHECK(json[third]["steps"][0]["pairs"] > 5);
  CHECK(json[truth]["path"]["hausdorff_m"].get<double>() < 1e-12);  // after an alignment
}

TEST_CASE("eval shifts the clock and takes the body of the truth as it is asked to") {
  const Files files;
  const std::string truth = files.write("truth.tum", true);
  const std::string late = files.write("late.tum", true, 5);
  CHECK(contains(eval(truth, late, {"--offset=-5"}).out, "ATE rmse 0.000 m"));
  CHECK(contains(eval(truth, truth, {"--body", "0,0,1", "--align", "none"}).out,
                 "the truth is measured at (0, 0, 1) m in the camera"));
  CHECK(
      contains(eval(truth, truth, {"--body", "0,0,1", "--align", "none"}).out, "ATE rmse 1.000 m"));
  CHECK(eval(truth, truth, {"--body", "0,0"}).exit_code == 2);
  CHECK(eval(truth, truth, {"--rpe", "10 parsec"}).exit_code == 2);
  CHECK(contains(eval(truth, truth, {"--match", "interpolate"}).out, "60 with truth"));
}

TEST_CASE("eval warns of a truth that stands still") {
  const Files files;
  const std::string still = (files.folder.path() / "still.tum").string();
  std::ofstream file(still);
  for (int k = 0; k < 60; ++k) file << fmt::format("{:.3f} 1 2 3 0 0 0 1\n", 0.1 * k);
  file.close();
  const std::string drive = files.write("drive.tum", true);
  CHECK(
      contains(eval(still, drive).out, "WARNING the truth stands still: the figures say nothing"));
  CHECK_FALSE(contains(eval(drive, still).out, "stands still"));
}
