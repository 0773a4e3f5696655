// SPDX-License-Identifier: BSD-3-Clause
// Problems of a data set are collected in order, a bounded number from each file.
#include "inspection.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "image_dataset.hpp"

namespace tolman::image_folders {
namespace {

std::vector<std::string> texts(const std::vector<Finding>& findings) {
  std::vector<std::string> all;
  for (const Finding& f : findings) all.push_back(f.where + ": " + f.message);
  return all;
}

}  // namespace

TEST_CASE("without problems the status is ok; of several it tells the first and counts the rest") {
  Inspection inspection;
  CHECK(inspection.status().isOk());
  CHECK_FALSE(inspection.hasErrors());
  inspection.error("a.txt", 3, "is odd");
  CHECK(inspection.status().message() == "a.txt:3: is odd");
  inspection.error("b.txt", "is missing");
  CHECK(inspection.status().message() ==
        "a.txt:3: is odd (and 1 more problem; `tolman dataset check` lists all)");
  inspection.error("c.txt", 1, "is worse");
  CHECK(inspection.status().message() ==
        "a.txt:3: is odd (and 2 more problems; `tolman dataset check` lists all)");
  CHECK(inspection.status().code() == StatusCode::InvalidInput);
  CHECK(texts(inspection.findings()) ==
        std::vector<std::string>{"a.txt:3: is odd", "b.txt: is missing", "c.txt:1: is worse"});
}

TEST_CASE("warnings are listed and refuse nothing, before and between errors") {
  Inspection inspection;
  inspection.warning("w.txt", "is unusual");
  CHECK_FALSE(inspection.hasErrors());
  CHECK(inspection.status().isOk());
  inspection.error("a.txt", 3, "is odd");
  inspection.warning("w.txt", "is unusual again");
  inspection.error("b.txt", "is missing");
  CHECK(inspection.hasErrors());
  CHECK(inspection.status().message() ==
        "a.txt:3: is odd (and 1 more problem; `tolman dataset check` lists all)");
  CHECK(inspection.findings().size() == 4);
}

TEST_CASE("a file of garbage is cut short without hiding the problems of others") {
  Inspection inspection;
  for (int line = 1; line <= 500; ++line) inspection.error("bad.txt", line, "is odd");
  inspection.error("other.txt", 2, "is odd too");
  const std::vector<std::string> all = texts(inspection.findings());
  REQUIRE(all.size() == 22);
  CHECK(all[19] == "bad.txt:20: is odd");
  CHECK(all[20] == "bad.txt: has more problems; they are not listed");
  CHECK(all[21] == "other.txt:2: is odd too");
}

TEST_CASE("stamps of a rate are even to the nanosecond, after any time") {
  for (const double rate : {9.7, 10.0, 29.97, 1000.0 / 3}) {
    const std::vector<std::int64_t> stamps = uniformStamps(5000, rate);
    REQUIRE(stamps.size() == 5000);
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      const long double exact = static_cast<long double>(i) * 1e9L / static_cast<long double>(rate);
      REQUIRE(std::abs(static_cast<long double>(stamps[i]) - exact) <= 0.51L);
    }
  }
  CHECK(uniformStamps(0, 10).empty());
}

TEST_CASE("the size is that of the first sound image, and the others are measured by it") {
  const DataFolder data;
  data.write("image_0/000000.png", "damaged");
  data.writeImage("image_0/000002.png", 32, 48);
  data.writeImage("image_1/000003.png", 64, 47);
  ImageDataset dataset;
  Inspection inspection;
  readFolders(data.path("image_0"), data.path("image_1"), std::nullopt, dataset, inspection);
  CHECK_FALSE(inspection.hasErrors());  // damaged images are the business of on_corrupt
  CHECK(dataset.size() == ImageSize{64, 48});
  std::vector<Finding> findings;
  checkImageFiles(dataset, findings);
  REQUIRE(findings.size() == 3);
  CHECK(data.anonymous(findings[0].where) == "DATA/image_0/000000.png");
  CHECK(findings[0].message ==
        "is neither a PNG nor a JPEG file; copy or record it again, or leave it out by "
        "on_corrupt: skip");
  CHECK(findings[1].message ==
        "has 32x48 pixels, but the first image has 64x48; all must be of one size");
  CHECK(data.anonymous(findings[2].where) == "DATA/image_1/000003.png");
}

TEST_CASE("a data set without a single sound image is an error of its folder") {
  const DataFolder data;
  for (int i = 0; i < DataFolder::kFrames; ++i) {
    data.write("image_0/00000" + std::to_string(i) + ".png", "damaged");
  }
  ImageDataset dataset;
  Inspection inspection;
  readFolders(data.path("image_0"), "", std::nullopt, dataset, inspection);
  CHECK(data.anonymous(inspection.status().message()) ==
        "DATA/image_0: none of its 4 images can be read, as DATA/image_0/000000.png: is neither a "
        "PNG nor a JPEG file; copy or record them again");
  CHECK(dataset.right.empty());
}

TEST_CASE("a folder in place of an image is one damaged image") {
  const DataFolder data;
  data.remove("image_0/000001.png");
  std::filesystem::create_directory(data.path("image_0/000001.png"));
  ImageDataset dataset;
  Inspection inspection;
  readFolders(data.path("image_0"), "", std::nullopt, dataset, inspection);
  std::vector<Finding> findings;
  checkImageFiles(dataset, findings);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message.starts_with("is missing or no file"));
}

TEST_CASE("the description says what there is and what of it is used") {
  ImageDataset dataset;
  dataset.layout = "folders";
  dataset.left.resize(51);
  dataset.stamps_ns = uniformStamps(51, 9.7);
  dataset.rig.width = 1226;
  dataset.rig.height = 370;
  CHECK(descriptionOf(dataset, 51) ==
        "folders, 51 images of one camera of 1226x370 px at 9.7 Hz, uncalibrated, no truth");
  dataset.stamps_ns = uniformStamps(51, 0.0096);
  CHECK(descriptionOf(dataset, 51) ==
        "folders, 51 images of one camera of 1226x370 px at 0.0096 Hz, uncalibrated, no truth");
  dataset.stamps_ns = uniformStamps(51, 9.7);
  dataset.rig.calibrated = true;
  dataset.rig.baseline = 0.53716;
  dataset.T_world_left.resize(51);
  CHECK(descriptionOf(dataset, 20) ==
        "folders, 20 from 51 stereo pairs of 1226x370 px at 9.7 Hz, baseline 0.5372 m, with truth");
}

TEST_CASE("a principal point on the border or beyond is an error, just inside is none") {
  CameraRig rig;
  rig.width = 100;
  rig.height = 50;
  struct Case {
    double cx, cy;
    bool good;
  };
  for (const Case& c : {Case{50, 25, true},
                        {0.1, 49.9, true},
                        {0, 25, false},
                        {100, 25, false},
                        {50, 0, false},
                        {50, 50, false},
                        {-3, 25, false},
                        {50, 1e9, false}}) {
    rig.pinhole = {80, 80, c.cx, c.cy};
    Inspection inspection;
    checkPrincipalPoint("calib.txt", rig, inspection);
    CAPTURE(c.cx, c.cy);
    CHECK(inspection.hasErrors() != c.good);
  }
}

}  // namespace tolman::image_folders
