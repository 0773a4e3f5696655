// SPDX-License-Identifier: BSD-3-Clause
// tolman bench: the text that it must print. Times are not checked.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

struct Track {
  TemporaryFolder folder;
  fs::path config;

  Track() {
    writeTinyKitti(folder.path() / "sequence", 12);
    config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  }
  Finished bench(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"bench"};
    words.push_back(config.string());
    for (const char* plugin : {"steady", "painted"}) {
      words.emplace_back("--plugin-path");
      words.push_back(inBuild("tests/fixtures/plugins/") + plugin);
    }
    words.insert(words.end(), more.begin(), more.end());
    return tolman::test::tolman(words);
  }
  nlohmann::json json(std::vector<std::string> more) const {
    more.emplace_back("--json");
    const Finished finished = bench(more);
    INFO(finished.err);
    REQUIRE(finished.exit_code == 0);
    return nlohmann::json::parse(finished.out);
  }
};

}  // namespace

TEST_CASE("bench measures every stage, against the source") {
  const Track track;
  const auto json = track.json({});
  CHECK(json["name"] == "tiny");
  CHECK(contains(json["source"], "12 stereo pairs"));
  CHECK(json["frames"] == 12);
  CHECK(json["seconds"].get<double>() > 0);
  CHECK(json["interrupted"] == false);
  REQUIRE(json["rows"].size() == 5);
  const double source_ms = json["rows"][0]["mean_ms"].get<double>();
  std::size_t i = 0;
  for (const char* stage : {"source", "odometry", "place", "cells", "map"}) {
    const auto& row = json["rows"][i++];
    CHECK(row["stage"] == stage);
    CHECK(row["median_ms"].get<double>() <= row["p95_ms"].get<double>());
    CHECK(row["of_source"].get<double>() == Approx(row["mean_ms"].get<double>() / source_ms));
  }
}

TEST_CASE("bench refuses counts and lengths that are none, in a short sentence") {
  const auto refusal = [](const std::vector<std::string>& words) {
    const Finished finished = tolman::test::tolman(words);
    CHECK(finished.exit_code == 2);
    CHECK(finished.err.size() < 250);
    return finished.err;
  };
  for (const char* wrong : {"0", "-3", "nan", "inf", "1e999", "many"}) {
    CAPTURE(wrong);
    CHECK(contains(refusal({"bench", "demo", "--frames", wrong}),
                   "--frames: must be a number above 0"));
    CHECK(contains(refusal({"bench", "places", "places", "--metres-per-image", wrong}),
                   "--metres-per-image: must be a number above 0"));
  }
  for (const char* wrong : {"-1", "nan", "inf"}) {
    CHECK(contains(refusal({"bench", "places", "places", "--near", wrong}),
                   "--near: must be a number of at least 0"));
  }
}

TEST_CASE("bench --frames counts exactly so many, and prints a small table") {
  const Track track;
  const Finished finished = track.bench({"--frames", "5"});
  REQUIRE(finished.exit_code == 0);
  INFO(finished.out);
  CHECK(finished.out.starts_with("tiny: KITTI odometry, 12 stereo pairs"));
  CHECK(contains(finished.out, "; 5 frames in "));
  CHECK(contains(finished.out, "\nstage     mean ms  median ms  95 % ms  of source\n"));
  CHECK(contains(finished.out, "\nodometry "));
  CHECK(contains(finished.err, "frame 5 of 5 (100 %)"));
}

TEST_CASE("bench of a configuration that is wrong ends as a run would") {
  const Track track;
  const Finished wrong = track.bench({"--set", "map.plugin=atlas"});
  CHECK(wrong.exit_code == 4);
  CHECK(contains(wrong.err, "[plugin/not-found]"));
  const Finished half = track.bench({"--set", "place.treshold=1"});
  CHECK(half.exit_code == 3);
  CHECK(contains(half.err, "did you mean 'threshold'?"));
  fs::remove(track.folder.path() / "sequence/image_0/000003.png");
  CHECK(track.bench({}).exit_code == 5);
}
