// SPDX-License-Identifier: BSD-3-Clause
// Tables whose times contradict the names of their images.
#include "named_times.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "euroc_source.hpp"
#include "images_source.hpp"
#include "tum_source.hpp"

namespace tolman::image_folders {
namespace {

constexpr std::int64_t kStart_ns = 1'317'000'000'000'000'000;

/// Stamps at 10 Hz.
std::vector<std::int64_t> tenAHz(std::size_t count, std::int64_t start_ns) {
  std::vector<std::int64_t> stamps;
  for (std::size_t i = 0; i < count; ++i) {
    stamps.push_back(start_ns + static_cast<std::int64_t>(i) * 100'000'000);
  }
  return stamps;
}

/// The warning for images of these names at 10 Hz; "" for none.
std::string nameWarning(const std::vector<std::string>& names, std::int64_t start_ns = kStart_ns,
                        TimeUnit unit = TimeUnit::Seconds) {
  std::vector<std::filesystem::path> images;
  for (const std::string& name : names) images.push_back("rgb/" + name + ".png");
  Inspection inspection;
  checkNamedTimes("rgb.txt", images, tenAHz(names.size(), start_ns), unit, inspection);
  CHECK_FALSE(inspection.hasErrors());
  if (inspection.findings().empty()) return "";
  CHECK(inspection.findings().size() == 1);
  return inspection.findings()[0].where + ": " + inspection.findings()[0].message;
}

/// The error for a table of the four images of DataFolder; "" for none.
std::string errorFor(const DataFolder& data, const std::string& table) {
  data.write("frames.csv", table);
  ImagesSource source;
  return data.anonymous(configure(source, {{"path", data.path().string()},
                                           {"left", std::string("image_0")},
                                           {"stamps", std::string("frames.csv")},
                                           {"stamps_column", std::string("t")}}));
}

}  // namespace

TEST_CASE("names that are the times of their rows are silent, also rounded and in other units") {
  CHECK(nameWarning({"1317000000.000000", "1317000000.100000", "1317000000.200000"}).empty());
  CHECK(nameWarning({"1317000000.0", "1317000000.1", "1317000000.2"}).empty());
  CHECK(nameWarning({"1317000000", "1317000000", "1317000001"}).empty());  // whole seconds
  CHECK(nameWarning({"1317000000000", "1317000000100", "1317000000200"}).empty());
  CHECK(nameWarning({"1317000000000000004", "1317000000100000000", "1317000000200000000"},
                    kStart_ns, TimeUnit::Nanoseconds)
            .empty());
  CHECK(nameWarning({"cam0_1317000000.02", "cam0_1317000000.12"}).empty());
}

TEST_CASE("counters, other clocks and other names are silent") {
  CHECK(nameWarning({"000007", "000008", "000009"}).empty());
  CHECK(nameWarning({"1", "2", "3"}, 0).empty());
  CHECK(nameWarning({"frame_1.9", "frame_1.10", "frame_1.11"}).empty());
  CHECK(nameWarning({"0.0", "0.1", "0.2"}).empty());  // since the first image
  CHECK(nameWarning({"c", "b", "a"}).empty());
  CHECK(nameWarning({"a3", "b2", "c1"}).empty());
  CHECK(nameWarning({"-3", "-2", "-1"}).empty());
}

TEST_CASE("names that are other times than those of their rows are told once") {
  CHECK(nameWarning({"1317000000.500000", "1317000000.600000", "1317000000.700000"}) ==
        "rgb.txt: gives 1317000000.500000.png a time 0.500000 s before that of its name (more than "
        "half a frame: 3 of 3 rows); if the names are right, correct the times, or read the names "
        "as times (`images` with stamps_in_names)");
  CHECK_THAT(nameWarning({"1317000000.0", "1317000000.1", "1317000007.2"}),
             Catch::Contains("gives 1317000007.2.png a time 7.000000 s before") &&
                 Catch::Contains("1 of 3 rows"));
  CHECK_THAT(nameWarning({"1316999999900", "1317000000000"}), Catch::Contains("0.100000 s behind"));
  CHECK_THAT(nameWarning({"1317000000200000000", "1317000000100000000", "1317000000000000000"},
                         kStart_ns, TimeUnit::Nanoseconds),
             Catch::Contains("2 of 3 rows"));
  CHECK_THAT(nameWarning({"0.10", "0.20", "0.30", "0.40"}, 0), Catch::Contains("4 of 4 rows"));
}

TEST_CASE("counters that fall while the times rise are told") {
  CHECK(nameWarning({"frame_1", "frame_10", "frame_2"}) ==
        "rgb.txt: gives frame_2.png a later time than frame_10.png, whose number is higher; if the "
        "numbers are the order of the images, sort the names in the table by them");
}

TEST_CASE("tum and euroc tell of such tables and go on") {
  const DataFolder data;
  std::string rgb;
  std::string table;
  for (int i = 0; i < 3; ++i) {
    const std::string name = std::to_string(1'317'000'000 + i);
    data.writeImage("rgb/" + name + ".png", 64, 48, i);
    rgb += std::to_string(1'317'000'000 + i - 3) + " rgb/" + name + ".png\n";
    const std::string ns = std::to_string(kStart_ns - i * 50'000'000LL);
    data.writeImage("cam0/data/" + ns + ".png", 64, 48, i);
    table += std::to_string(kStart_ns + i * 50'000'000LL) + "," + ns + ".png\n";
  }
  data.write("rgb.txt", rgb);
  data.write("cam0/data.csv", table);
  data.write("cam0/sensor.yaml",
             "%YAML:1.0\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, "
             "0, 0, 0, 1]\n"
             "resolution: [64, 48]\ncamera_model: pinhole\nintrinsics: [50, 51, 31, 23]\n"
             "distortion_model: radial-tangential\ndistortion_coefficients: [0, 0, 0, 0]\n");
  TumSource tum;
  REQUIRE(configure(tum, {{"path", data.path().string()},
                          {"depth", false},
                          {"cx", 31.5},
                          {"cy", 23.5},
                          {"fx", 50.0},
                          {"fy", 50.0}})
              .empty());
  CHECK_THAT(data.anonymous(inspect(tum)[0]),
             Catch::Contains("DATA/rgb.txt: gives 1317000000.png a time 3.000000 s before"));
  EurocSource euroc;
  REQUIRE(configure(euroc, {{"path", data.path().string()}, {"mono", true}}) == "");
  CHECK_THAT(data.anonymous(inspect(euroc)[0]),
             Catch::Contains("DATA/cam0/data.csv: gives 1316999999950000000.png a time"));
}

TEST_CASE("a table of `images` must name the images in their order") {
  const DataFolder data;
  CHECK(errorFor(data,
                 "file,t\nimage_0/000000.png,0\nimage_0/000001.png,1\nimage_0/000002.png,2\n"
                 "image_0/000003.png,3\n")
            .empty());
  CHECK(errorFor(data,
                 "file,t\nimage_0/000003.png,0\nimage_0/000002.png,1\nimage_0/000001.png,2\n"
                 "image_0/000000.png,3\n") ==
        "DATA/frames.csv:2: names 'image_0/000003.png' where 000000.png is the next image of "
        "DATA/image_0; give each image the row with its name, in the order of the names of the "
        "images");
  const std::string shifted =
      "t,file\n0,old/000001.png\n1,old/000002.png\n2,old/000003.png\n3,old/000004.png\n";
  CHECK_THAT(errorFor(data, shifted), Catch::StartsWith("DATA/frames.csv:2: names"));
}

TEST_CASE("columns of counters, of other cameras and a second column are silent") {
  const DataFolder data;
  CHECK(errorFor(data, "frame,t\n1,0\n2,1\n3,2\n4,3\n").empty());
  CHECK(errorFor(data,
                 "other,file,t\n000001.png,000000.png,0\n000002.png,000001.png,1\n"
                 "000003.png,000002.png,2\n000004.png,000003.png,3\n")
            .empty());
  data.writeImage("image_1/000004.png", 64, 48);
  CHECK(errorFor(data,
                 "t,file\n0,image_1/000001.png\n1,image_1/000002.png\n2,image_1/000003.png\n"
                 "3,image_1/000004.png\n")
            .empty());
}

TEST_CASE("one time a line beside images whose names are other times is told") {
  const DataFolder data;
  for (const char* name : {"0.50", "0.65", "0.80"}) {
    data.writeImage("timed/" + std::string(name) + ".png", 64, 48);
  }
  data.write("t.txt", "0.65\n0.8\n0.95\n");
  ImagesSource source;
  REQUIRE(configure(source, {{"path", data.path().string()},
                             {"left", std::string("timed")},
                             {"stamps", std::string("t.txt")}})
              .empty());
  CHECK_THAT(data.anonymous(inspect(source)[0]),
             Catch::Contains("DATA/t.txt: gives 0.50.png a time 0.150000 s behind"));
}

}  // namespace tolman::image_folders
