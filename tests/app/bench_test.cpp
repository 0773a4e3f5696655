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

TEST_CASE("bench measures the source alone and the chain, each repeat in its own pass") {
  const Track track;
  const auto json = track.json({"--repeat", "2"});
  CHECK(json["name"] == "tiny");
  CHECK(contains(json["source"], "12 stereo pairs"));
  CHECK(json["interrupted"] == false);
  REQUIRE(json["rows"].size() == 4);
  CHECK(json["rows"][0]["ratio"] == 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& pass = json["rows"][i];
    CHECK(pass["pass"] == (i < 2 ? "source" : "chain"));
    CHECK(pass["repeat"] == i % 2 + 1);
    CHECK(pass["frames"] == 12);
    CHECK(pass["seconds"].get<double>() > 0);
    CHECK(pass["frames_per_second"].get<double>() == Approx(12 / pass["seconds"].get<double>()));
    CHECK(pass["peak_mib"].get<double>() > 1);
    CHECK(pass["stages"]["source"]["frames"] == 12);
  }
  for (const char* stage : {"source", "odometry", "place", "cells", "map"}) {
    const auto& timing = json["rows"][3]["stages"][stage];
    INFO(stage);
    CHECK(timing["frames"] == 12);
    CHECK(timing["median_ms"].get<double>() <= timing["p90_ms"].get<double>());
    CHECK(timing["p90_ms"].get<double>() <= timing["max_ms"].get<double>());
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

TEST_CASE("bench --frames counts exactly so many") {
  const Track track;
  const auto json = track.json({"--repeat", "1", "--frames", "5"});
  CHECK(json["rows"][0]["frames"] == 5);
  CHECK(json["rows"][1]["frames"] == 5);
  CHECK(json["rows"][1]["stages"]["map"]["frames"] == 5);
}

TEST_CASE("bench leaves the chain out when told so, or when there is none") {
  Track track;
  CHECK(track.json({"--repeat", "1", "--source-only"})["rows"].size() == 1);
  track.config = track.folder.path() / "source.yaml";
  std::ofstream(track.config) << "source: {plugin: kitti, path: sequence}\n";
  const auto json = track.json({"--repeat", "1"});
  REQUIRE(json["rows"].size() == 1);
  CHECK(json["rows"][0]["pass"] == "source");
}

TEST_CASE("bench prints a small table") {
  const Track track;
  const Finished finished = track.bench({"--repeat", "2"});
  REQUIRE(finished.exit_code == 0);
  INFO(finished.out);
  CHECK(finished.out.starts_with("tiny: KITTI odometry, 12 stereo pairs"));
  CHECK(contains(finished.out, "\npass    repeat  frames  frames/s  ratio  peak MiB "));
  CHECK(contains(finished.out, "\nsource       1      12"));
  CHECK(contains(finished.out, "\nchain        2      12"));
  CHECK(contains(finished.out, " odometry ms"));
  CHECK(contains(finished.err, "frame 12 of 12 (100 %)"));  // the progress of each pass
}

TEST_CASE("bench of a configuration that is wrong ends as a run would") {
  const Track track;
  const Finished wrong = track.bench({"--set", "map.plugin=atlas"});
  CHECK(wrong.exit_code == 4);
  CHECK(contains(wrong.err, "[plugin/not-found]"));
  const Finished half = track.bench({"--set", "place.treshold=1"});
  CHECK(half.exit_code == 3);
  CHECK(contains(half.err, "did you mean 'threshold'?"));
  CHECK(track.bench({"--repeat", "0"}).exit_code == 2);
  fs::remove(track.folder.path() / "sequence/image_0/000003.png");
  CHECK(track.bench({}).exit_code == 5);
}
