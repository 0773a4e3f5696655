// SPDX-License-Identifier: BSD-3-Clause
// tolman bench places on the command line: two passes, one drive with pairs, one with true poses.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/gray_images.hpp"
#include "support/paths.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// Blocks of grey, others at every place, with the noise of another exposure.
tolman::Image place(int number, std::uint64_t exposure) {
  tolman::RandomStream noise(1000 + exposure);
  return gray(208, 128, [&](int x, int y) {
    tolman::RandomStream random(static_cast<std::uint64_t>((number * 307 + x / 20) * 211 + y / 24));
    return std::lround(std::clamp(40 + 170 * random.uniform() + 8 * noise.normal(), 0.0, 255.0));
  });
}

constexpr int kPlaces = 60;

/// Folders `day` and `night` of 60 images each, and `lap` of both, one after the other.
struct Walks {
  TemporaryFolder folder;

  Walks() {
    for (const char* name : {"day", "night", "lap"}) fs::create_directory(folder.path() / name);
    for (int i = 0; i < kPlaces; ++i) {
      write("day", i, place(i, std::uint64_t(i)));
      write("night", i, place(i, 500 + std::uint64_t(i)));
      write("lap", i, place(i, std::uint64_t(i)));
      write("lap", kPlaces + i, place(i, 500 + std::uint64_t(i)));
    }
    std::ofstream pairs(folder.path() / "pairs.csv");
    pairs << "query,match\n";
    for (int i = 0; i < kPlaces; ++i) {
      for (int away : {-1, 0, 1}) pairs << kPlaces + i << "," << std::max(0, i + away) << "\n";
    }
  }
  void write(const std::string& pass, int number, const tolman::Image& image) const {
    char name[16];
    std::snprintf(name, sizeof name, "%04d.png", number);
    cv::imwrite((folder.path() / pass / name).string(), tolman::asMat(image));
  }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }

  Finished bench(const std::string& pass, const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"bench",
                                      "places",
                                      inSource("configs/places.yaml"),
                                      "--set",
                                      "source.path=" + path(pass),
                                      "--set",
                                      "place.probability=0.6"};
    words.insert(words.end(), more.begin(), more.end());
    return tolman::test::tolman(words);
  }
  nlohmann::json json(const std::string& pass, std::vector<std::string> more) const {
    more.emplace_back("--json");
    const Finished finished = bench(pass, more);
    INFO(finished.err);
    REQUIRE(finished.exit_code == 0);
    return nlohmann::json::parse(finished.out);
  }
};

/// What the summary says must follow from the claims.
void checkCurve(const nlohmann::json& json) {
  const auto& claims = json["claims"];
  std::int64_t right = 0;
  double last = -1;
  for (const auto& point : json["rows"]) {
    CHECK(point["score"].get<double>() > last);
    last = point["score"];
    std::int64_t made = 0;
    right = 0;
    for (const auto& claim : claims) {
      if (claim["score"].get<double>() > last) continue;
      ++made;
      right += claim["right"].get<bool>() ? 1 : 0;
    }
    CHECK(point["claims"] == made);
    CHECK(point["precision"].get<double>() == Approx(double(right) / double(made)));
    CHECK(point["recall"].get<double>() == Approx(double(right) / json["findable"].get<double>()));
  }
  CHECK(json["rows"].back()["claims"] == claims.size());
}

}  // namespace

TEST_CASE("bench places: two passes, where image N of both shows the same place") {
  const Walks walks;
  const auto json = walks.json("day", {"--second", walks.path("night")});
  CHECK(json["name"] == "places");
  CHECK(json["plugin"] == "view_sequences");
  CHECK(json["images"] == 2 * kPlaces);
  CHECK(json["findable"] == kPlaces);
  CHECK(json["templates"] >= kPlaces);
  CHECK(json["interrupted"] == false);
  CHECK(json["claims"].size() >= 40);
  CHECK(json["recall_at_100"].get<double>() >= 0.6);
  CHECK(json["recall_at_90"] >= json["recall_at_99"]);
  CHECK(json["recall_at_99"] >= json["recall_at_100"]);
  CHECK(json["median_ms"].get<double>() > 0);
  CHECK(json["p99_ms"] >= json["median_ms"]);
  CHECK(json["state_bytes"].get<std::int64_t>() > kPlaces * 312);
  for (const auto& claim : json["claims"]) {
    const int away = claim["query"].get<int>() - claim["place"].get<int>();
    CHECK(claim["right"] == (std::abs(away) <= 5));
  }
  checkCurve(json);
}

TEST_CASE("bench places: passes of unlike lengths are told") {
  const Walks walks;
  const std::string unlike = "the second pass has 57 images, and the first has 60";
  CHECK_FALSE(contains(walks.bench("day", {"--second", walks.path("night")}).err, unlike));
  for (int i = 0; i < 3; ++i)
    fs::remove(walks.folder.path() / "night" / ("000" + std::to_string(i) + ".png"));
  const Finished finished = walks.bench("day", {"--second", walks.path("night")});
  CHECK(finished.exit_code == 0);
  CHECK(contains(finished.err, unlike));
}

TEST_CASE("bench places: the tolerance decides what is right, --query-set what is claimed") {
  const Walks walks;
  const std::vector<std::string> second = {"--second", walks.path("night")};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = second;
    words.insert(words.end(), more.begin(), more.end());
    return walks.json("day", words);
  };
  for (const auto& claim : with({"--tolerance", "0"})["claims"]) {
    CHECK(claim["right"] == (claim["query"] == claim["place"]));
  }
  const auto all = with({"--query-set", "place.probability=0.01"});
  CHECK(all["claims"].size() > with({})["claims"].size());
  checkCurve(all);
  const auto few = with({"--frames", "30"});
  CHECK(few["images"] == 60);
  CHECK(few["findable"] == 30);
  const auto slow = with({"--metres-per-image", "0.5"});  // every second image is looked at
  CHECK(slow["templates"].get<int>() <= 60);
  CHECK(slow["claims"].size() <= 30);
}

TEST_CASE("bench places: one drive with a file of pairs") {
  const Walks walks;
  const auto json = walks.json("lap", {"--pairs", walks.path("pairs.csv")});
  CHECK(json["images"] == 2 * kPlaces);
  CHECK(json["findable"] == kPlaces);
  CHECK(json["claims"].size() >= 40);
  CHECK(json["recall_at_100"].get<double>() >= 0.5);
  for (const auto& claim : json["claims"]) {
    const int query = claim["query"];
    const int found = claim["place"];
    CHECK(query - found > 20);
    CHECK(claim["right"] == (query >= kPlaces && std::abs(query - kPlaces - found) <= 1));
  }
  checkCurve(json);
  // Pairs over 60 images are none when so many are near.
  const Finished near = walks.bench("lap", {"--pairs", walks.path("pairs.csv"), "--near", "70"});
  CHECK(near.exit_code == 5);
  CHECK(contains(near.err,
                 "has no pair of the 120 images that were shown whose images are more "
                 "than 70 apart (--near)"));
}

TEST_CASE("bench places prints the curve, recalls, times and memory") {
  const Walks walks;
  const Finished finished = walks.bench("day", {"--second", walks.path("night")});
  INFO(finished.out << finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(finished.out.starts_with("places: place recogniser 'view_sequences', 120 images, "));
  CHECK(contains(finished.out, "\nscore"));
  CHECK(
      contains(finished.out, "\n60 images have a place to be found\nrecall at 100 % precision: "));
  CHECK(contains(finished.out, "\nrecall at 90 % precision: "));
  CHECK(contains(finished.out, "\ntime of a call: "));
  CHECK(contains(finished.out, "\nsaved state: "));
  CHECK(contains(finished.err, "frame 60 of 60 (100 %)"));
  // No more than a dozen points, the last one with all claims.
  const std::string table = finished.out.substr(0, finished.out.find("\n60 images"));
  CHECK(std::count(table.begin(), table.end(), '\n') <= 13);
}

TEST_CASE("bench places draws its curve, beside those of earlier measurements") {
  const Walks walks;
  const auto earlier =
      walks.json("day", {"--second", walks.path("night"), "--set", "name=earlier"});
  std::ofstream(walks.path("earlier.json")) << earlier;
  const std::string figure = walks.path("curves.svg");
  const Finished finished = walks.bench("day", {"--second", walks.path("night"), "--figure", figure,
                                                "--beside", walks.path("earlier.json")});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(contains(finished.out, "recall at 100 % precision: "));
  std::ifstream file(figure);
  const std::string svg{std::istreambuf_iterator<char>(file), {}};
  CHECK(svg.starts_with("<svg "));
  CHECK(contains(svg, ">places</text>"));
  CHECK(contains(svg, ">earlier</text>"));
  const auto first = svg.find("<polyline");
  CHECK(svg.find("<polyline", first + 1) != std::string::npos);
}

TEST_CASE("bench places: the passes differ in parameters of place recognition only") {
  const Walks walks;
  for (const char* set : {"source.step=2", "seed=7", "place.plugin=seqslam"}) {
    const Finished refused =
        walks.bench("day", {"--second", walks.path("night"), "--query-set", set});
    CHECK(refused.exit_code == 2);
    CHECK(contains(refused.err, std::string("'") + set + "' is no parameter of place"));
  }
}

TEST_CASE("bench places refuses figures that cannot be drawn or written") {
  const Walks walks;
  const Finished alone = walks.bench("day", {"--beside", walks.path("x.json")});
  CHECK(alone.exit_code == 2);
  std::ofstream(walks.path("odd.json")) << "{}";
  const Finished odd =
      walks.bench("day", {"--figure", walks.path("f.svg"), "--beside", walks.path("odd.json")});
  CHECK(odd.exit_code == 5);
  CHECK(contains(odd.err, "odd.json: is not what `tolman bench places --json` prints"));
  CHECK_FALSE(fs::exists(walks.path("f.svg")));
  const Finished nowhere = walks.bench(
      "day", {"--second", walks.path("night"), "--figure", walks.path("absent") + "/f.svg"});
  CHECK(nowhere.exit_code == 8);
  CHECK(contains(nowhere.out, "recall at 100 % precision: "));  // not lost
}

TEST_CASE("bench places: true poses decide where the source has them") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 40);
  std::ofstream(folder.path() / "drive.yaml")
      << "source: {plugin: kitti, path: sequence}\nplace: {plugin: view_templates}\n";
  const std::string config = folder.path() / "drive.yaml";
  const Finished finished = tolman::test::tolman({"bench", "places", config, "--json"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const auto json = nlohmann::json::parse(finished.out);
  CHECK(json["plugin"] == "view_templates");
  CHECK(json["images"] == 40);
  CHECK(json["findable"] == 0);  // straight ahead
  // The pictures repeat after 40 frames only; whatever is claimed is wrong.
  for (const auto& claim : json["claims"]) CHECK(claim["right"] == false);
  CHECK(json["recall_at_90"] == 0);
}

TEST_CASE("bench places: a truth of a part decides of that part") {
  const Walks walks;
  std::ofstream truth(walks.path("truth.csv"));
  truth << "frame,x,y,z,qx,qy,qz,qw\n";
  for (int i = 0; i < 2 * kPlaces; ++i) {
    const double angle = 2 * M_PI * i / kPlaces;  // clockwise on a circle, 3 m an image
    if (i >= 70 && i < 80) continue;
    truth << i << "," << 28.6 * (1 - std::cos(angle)) << ",0," << 28.6 * std::sin(angle) << ",0,"
          << std::sin(angle / 2) << ",0," << std::cos(angle / 2) << "\n";
  }
  truth.close();
  const Finished finished =
      walks.bench("lap", {"--set", "evaluation.truth=" + walks.path("truth.csv"), "--json"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(contains(finished.err, "10 of 120 images have no true pose"));
  const auto json = nlohmann::json::parse(finished.out);
  CHECK(json["findable"] == 51);  // from the last one of the first lap on
  CHECK(json["claims"].size() > 10);
  for (const auto& claim : json["claims"]) {
    CHECK((claim["query"] < 70 || claim["query"] >= 80));
    CHECK((claim["place"] < 70 || claim["place"] >= 80));
  }
}

TEST_CASE("bench places without truth says what is missing") {
  const Walks walks;
  const Finished nothing = walks.bench("lap", {});
  CHECK(nothing.exit_code == 3);
  CHECK(contains(nothing.err,
                 "nothing says which images show the same place: the source has no true poses; "
                 "give --pairs or --second"));
  const Finished absent = walks.bench("lap", {"--pairs", walks.path("absent.csv")});
  CHECK(absent.exit_code == 5);
  CHECK(contains(absent.err, walks.path("absent.csv") + ": is missing"));
  std::ofstream(walks.path("odd.csv")) << "query,match\n60,1\n61 2\n";
  const Finished odd = walks.bench("lap", {"--pairs", walks.path("odd.csv")});
  CHECK(odd.exit_code == 5);
  CHECK(contains(odd.err, "odd.csv:3: a pair is two numbers of images, 'query,match'"));
  std::ofstream(walks.path("far.csv")) << "query,match\n60000,1\n";
  const Finished far = walks.bench("lap", {"--pairs", walks.path("far.csv")});
  CHECK(far.exit_code == 5);
  CHECK(contains(far.err, "far.csv: names image 60000, and the recording has 120 images, from 0"));
  const Finished few =
      walks.bench("lap", {"--pairs", walks.path("far.csv"), "--set", "source.last=99"});
  CHECK(few.exit_code == 5);
  CHECK(contains(few.err, "far.csv: has no pair of the 100 images that were shown"));
  const Finished folder = walks.bench("day", {"--second", walks.path("dusk")});
  CHECK(folder.exit_code == 5);
  CHECK(contains(folder.err, "dusk"));
}

TEST_CASE("bench places: a figure replaces a file only by force") {
  const Walks walks;
  const std::string figure = walks.path("figure.svg");
  std::vector<std::string> words = {"--pairs", walks.path("pairs.csv"), "--figure", figure};
  std::ofstream(figure) << "years of work\n";
  const Finished refused = walks.bench("lap", words);
  CHECK(refused.exit_code == 8);
  CHECK(contains(refused.err,
                 figure + ": exists; choose another --figure, or replace it with --force"));
  words.emplace_back("--force");
  CHECK(walks.bench("lap", words).exit_code == 0);
  CHECK(readText(figure).starts_with("<svg"));
}

TEST_CASE("bench places refuses wrong options and configurations as other commands do") {
  const Walks walks;
  CHECK(tolman::test::tolman({"bench", "places"}).exit_code == 2);
  CHECK(walks.bench("day", {"--tolerance", "-1"}).exit_code == 2);
  CHECK(walks.bench("day", {"--metres-per-image", "0"}).exit_code == 2);
  CHECK(walks.bench("day", {"--near", "few"}).exit_code == 2);
  const Finished unknown = walks.bench("day", {"--thrid", "x"});
  CHECK(unknown.exit_code == 2);
  CHECK(contains(unknown.err, "--thrid"));
  const Finished misspelt = walks.bench("day", {"--set", "place.probabilty=1"});
  CHECK(misspelt.exit_code == 3);
  CHECK(contains(misspelt.err, "did you mean 'probability'?"));
  const std::string config = walks.path("alone.yaml");
  std::ofstream(config) << "source: {plugin: images, path: day, rate: 1}\n";
  const Finished alone = tolman::test::tolman({"bench", "places", config});
  CHECK(alone.exit_code == 3);
  CHECK(contains(alone.err, "place: the stage is missing"));
}
