// SPDX-License-Identifier: BSD-3-Clause
// Real laps of a toy car with one uncalibrated camera: configs/ratslam.yaml against the gyroscope.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <span>
#include <sstream>
#include <tolman/geometry.hpp>

#include "end_to_end/process.hpp"
#include "end_to_end/record_rows.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// Heading of each image, rad: the yaw rate in the table, integrated; gaps above a second are
/// pauses.
std::vector<double> gyroscope(const fs::path& table) {
  std::vector<double> headings;
  std::ifstream stream(table);
  std::string line;
  std::getline(stream, line);
  double last_time = 0;
  double last_rate = 0;
  while (std::getline(stream, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    std::string file;
    double time = 0;
    double rate = 0;
    fields >> file >> time >> rate;
    const double dt = time - last_time;
    const double turned = dt < 1 ? 0.5 * (rate + last_rate) / kDegrees * dt : 0;
    headings.push_back(headings.empty() ? 0 : headings.back() + turned);
    last_time = time;
    last_rate = rate;
  }
  return headings;
}

std::vector<double> headingsOf(const fs::path& trajectory) {
  std::vector<double> headings;
  std::ifstream stream(trajectory);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream fields(line);
    double t = 0, x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 0;
    if (!(fields >> t >> x >> y >> z >> qx >> qy >> qz >> qw)) continue;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::Quaterniond(qw, qx, qy, qz).toRotationMatrix();
    headings.push_back(tolman::toPlanar(T).theta);
  }
  return headings;
}

using Headings = std::span<const double>;

/// Turn that brings `headings` closest to `truth`, rad.
double commonTurn(Headings headings, Headings truth) {
  double sine = 0;
  double cosine = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    sine += std::sin(headings[i] - truth[i]);
    cosine += std::cos(headings[i] - truth[i]);
  }
  return std::atan2(sine, cosine);
}

/// Absolute differences after the best common turn, degrees, ascending.
std::vector<double> sortedErrors(Headings headings, Headings truth) {
  const double turn = commonTurn(headings, truth);
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    errors.push_back(std::abs(tolman::wrapAngle(headings[i] - truth[i] - turn)) * kDegrees);
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

double median(const std::vector<double>& sorted) { return sorted[sorted.size() / 2]; }

/// Cells of the page's table: median and 90 % of the whole run, of the laps to the left and of
/// those to the right. The car turns about where the gyroscope's heading is largest.
std::string tableCells(Headings headings, Headings truth) {
  const auto left = static_cast<std::size_t>(std::ranges::max_element(truth) - truth.begin());
  std::string cells;
  for (const auto& [from, count] :
       {std::pair{std::size_t{0}, truth.size()}, std::pair{std::size_t{0}, left},
        std::pair{left, truth.size() - left}}) {
    const auto errors = sortedErrors(headings.subspan(from, count), truth.subspan(from, count));
    cells += fmt::format("| {:.1f} ({:.1f}) ", median(errors), errors[errors.size() * 9 / 10]);
  }
  return cells + "|";
}

/// For each view recognised from more than 60 images ago: what the gyroscope says that it is
/// turned against then, degrees.
std::vector<double> turnsAtRecognition(const fs::path& run, const std::vector<double>& gyro) {
  std::map<std::int64_t, std::size_t> made_at;
  std::vector<double> turns;
  for (const auto& row : recordRows(run, "SELECT frame, template_id FROM place ORDER BY frame")) {
    const auto frame = static_cast<std::size_t>(row[0]);
    const std::size_t first =
        made_at.try_emplace(static_cast<std::int64_t>(row[1]), frame).first->second;
    if (frame - first <= 60) continue;
    turns.push_back(std::abs(tolman::wrapAngle(gyro[frame] - gyro[first])) * kDegrees);
  }
  return turns;
}

}  // namespace

TEST_CASE("laps: the map keeps the gyroscope's heading better than odometry, with either cells",
          "[data]") {
  const auto folder = dataOrSkip("laps_office");
  if (!folder) return;
  const std::string cells = GENERATE("pose_cells", "bayesian_attractor");
  const TemporaryFolder out;
  const fs::path run = out.path() / "run";
  const Finished finished = tolman::test::tolman(
      {"run", inSource("configs/ratslam.yaml"), "--set", "source.path=" + folder->string(), "--set",
       "cells.plugin=" + cells, "--out", run.string(), "--quiet"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const std::vector<double> gyro = gyroscope(*folder / "frames.csv");
  const std::vector<double> map = headingsOf(run / "trajectory.tum");
  const std::vector<double> odometry = headingsOf(run / "odometry.tum");
  REQUIRE(map.size() == gyro.size());
  REQUIRE(odometry.size() == gyro.size());
  const double map_error = median(sortedErrors(map, gyro));
  CHECK(map_error < 30);
  CHECK(map_error < 0.6 * median(sortedErrors(odometry, gyro)));

  const std::string page = readText(inSource("docs/results.md"));
  const std::string name = cells == "pose_cells" ? "pose cells" : "attractor";
  CHECK_THAT(page, Catch::Contains("| `scanline` alone " + tableCells(odometry, gyro)));
  CHECK_THAT(page, Catch::Contains("| " + name + ", relaxation " + tableCells(map, gyro)));

  const std::vector<double> turns = turnsAtRecognition(run, gyro);
  CHECK(turns.size() > 500);
  CHECK(*std::max_element(turns.begin(), turns.end()) < 60);
}
