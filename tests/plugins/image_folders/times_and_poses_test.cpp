// SPDX-License-Identifier: BSD-3-Clause
// times.txt, tables with a time column, and poses.txt, sound and broken.
#include "times_and_poses.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "text_file.hpp"
#include "tolman/geometry.hpp"

namespace tolman::image_folders {
namespace {

using List = std::vector<std::int64_t>;

/// Writes a file, reads it back, and keeps the message.
struct Reading {
  explicit Reading(const std::string& text) { data.write("f.txt", text); }
  List times(const std::string& column = "") {
    const List list = readTimes(data.path("f.txt"), column, inspection);
    message = data.anonymous(inspection.status().message());
    return list;
  }
  std::vector<Eigen::Isometry3d> poses() {
    const auto list = readKittiPoses(data.path("f.txt"), inspection);
    message = data.anonymous(inspection.status().message());
    return list;
  }
  DataFolder data;
  Inspection inspection;
  std::string message;
};

std::string timesFailure(const std::string& text, const std::string& column = "") {
  Reading reading(text);
  reading.times(column);
  return reading.message;
}

std::string posesFailure(const std::string& text) {
  Reading reading(text);
  reading.poses();
  return reading.message;
}

}  // namespace

TEST_CASE("times as KITTI prints them") {
  Reading reading("0.000000e+00\n1.044989e-01\n2.077935e-01\n");
  CHECK(reading.times() == List{0, 104498900, 207793500});
  CHECK(reading.message.empty());
}

TEST_CASE("a column of a table") {
  Reading reading("file,time_s,gyro\nimages/0.jpg,0.000,-0.04\nimages/1.jpg,0.063,0.09\n");
  CHECK(reading.times("time_s") == List{0, 63000000});
  CHECK(timesFailure("file,time\na,0\n", "time_s") ==
        "DATA/f.txt:1: names no column 'time_s'; correct stamps_column");
  CHECK(timesFailure("time,file,time\n0,a,1\n", "time") ==
        "DATA/f.txt:1: names two columns 'time'; rename one of them");
  CHECK(timesFailure("file,time\na,0\nb\n", "time") ==
        "DATA/f.txt:3: has 1 columns, fewer than the first line");
}

TEST_CASE("times that no run can have") {
  CHECK(timesFailure("0.1\n0.3\n\n0.2\n") ==
        "DATA/f.txt:4: time goes back by 0.100000 s; sort the data");
  CHECK(timesFailure("0.1\n0.1\n") ==
        "DATA/f.txt:2: has the time of the frame before; remove one of the two");
  CHECK(timesFailure("0.1\nabc\n") == "DATA/f.txt:2: 'abc' is no time in seconds; correct it");
  CHECK(timesFailure("0.1\nnan\n") == "DATA/f.txt:2: 'nan' is no time in seconds; correct it");
  CHECK(timesFailure("0.1 0.2\n") ==
        "DATA/f.txt:1: has 2 columns; write one time a line, or set "
        "stamps_column");
  CHECK(timesFailure("# nothing\n") == "DATA/f.txt: is empty; restore it");
  SECTION("a bad line still counts, so that counts are not reported too") {
    Reading reading("0.1\nabc\n0.2\n");
    CHECK(reading.times().size() == 3);
    CHECK(reading.inspection.findings().size() == 1);
  }
}

TEST_CASE("times that are not in seconds are told by their steps") {
  const auto drive = [](double first, double step, int frames) {
    std::string text;
    for (int i = 0; i < frames; ++i) text += fixed(first + i * step, 6) + "\n";
    return text;
  };
  const std::string apart =
      " s apart (median); times are in seconds: divide nanoseconds by 1e9, "
      "microseconds by 1e6, milliseconds by 1000, or set stamps_unit (of `images`)";
  CHECK(timesFailure(drive(0, 1e8, 40)) == "DATA/f.txt: has images 100000000.0" + apart);
  CHECK(timesFailure(drive(7e8, 1e5, 40)) == "DATA/f.txt: has images 100000.0" + apart);
  CHECK(timesFailure(drive(0, 33333.3, 2)) == "DATA/f.txt: has images 33333.3" + apart);
  CHECK(timesFailure(drive(0, 33.3, 40)) == "DATA/f.txt: has images 33.3" + apart);
  SECTION("a slow camera, or milliseconds of a fast one: a warning") {
    for (const double step : {5.1, 8.3, 10.0}) {
      Reading reading(drive(0, step, 40));
      CHECK(reading.times().size() == 40);
      CHECK(reading.message.empty());
      REQUIRE(reading.inspection.findings().size() == 1);
      CHECK(reading.inspection.findings()[0].message ==
            "has images " + fixed(step, 1) +
                " s apart (median); if the times are in milliseconds, divide them by 1000");
    }
  }
  SECTION("single gaps of a drive do not count") {
    Reading reading("0\n0.1\n5000\n5000.1\n5000.2\n");
    CHECK(reading.times().size() == 5);
    CHECK(reading.inspection.findings().empty());
  }
  SECTION("a gap of more than a day is told") {
    Reading reading("0\n0.1\n1000000\n1000000.1\n1000000.2\n");
    CHECK(reading.times().size() == 5);
    REQUIRE(reading.inspection.findings().size() == 1);
    CHECK(reading.inspection.findings()[0].message ==
          "image 2 is 1000000 s after the one before; a realtime run waits as long");
  }
}

TEST_CASE("images are sorted by the times that are their names") {
  const auto sorted = [](std::vector<std::filesystem::path> files, TimeUnit unit,
                         std::vector<std::int64_t> ns) {
    Inspection inspection;
    CHECK(sortByTimes(files, unit, inspection) == ns);
    std::string text;
    for (const std::filesystem::path& file : files) text += file.stem().string() + " ";
    return text + inspection.status().message();
  };
  CHECK(sorted({"d/1e1.png", "d/1e2.png", "d/2e1.png"}, TimeUnit::Milliseconds,
               {10'000'000, 20'000'000, 100'000'000}) == "1e1 2e1 1e2 ");
  CHECK(sorted({"d/1.1.png", "d/1.05.png", "d/+0.1.jpg", "d/1e-05.png"}, TimeUnit::Seconds,
               {10'000, 100'000'000, 1'050'000'000, 1'100'000'000}) == "1e-05 +0.1 1.05 1.1 ");
  CHECK(sorted({"d/1.10.png", "d/1.2.png", "d/1.1.jpg"}, TimeUnit::Seconds,
               {1'100'000'000, 1'100'000'000, 1'200'000'000}) ==
        "1.10 1.1 1.2 d/1.1.jpg: its name is the same time as that of 1.10.png; correct one of the "
        "names, or remove one of the images");
  CHECK(sorted({"d/0.2.png", "d/0.1.png"}, TimeUnit::Nanoseconds, {0, 0}).find("the same time") !=
        std::string::npos);
  CHECK(sorted({"d/-1.5.png", "d/2.png"}, TimeUnit::Seconds, {-1'500'000'000, 2'000'000'000}) ==
        "-1.5 2 d/-1.5.png: its name is a time before 0, and times are counted from 0; add one "
        "number to all");
  CHECK(sorted({"d/x.png", "d/2.png", "d/1.png"}, TimeUnit::Seconds,
               {1'000'000'000, 2'000'000'000, 0}) ==
        "1 2 x d/x.png: its name is no time in seconds; name the file of times by stamps");
}

TEST_CASE("times before 0 are refused") {
  CHECK(timesFailure("-1.5\n-0.5\n0.5\n") ==
        "DATA/f.txt:1: '-1.5' is a time before 0, and times are counted from 0; add one number to "
        "all (and 1 more problem; `tolman dataset check` lists all)");
}

TEST_CASE("poses come as written, with clean rotations") {
  const Eigen::Matrix3d R = expSo3({0.1, -0.5, 0.2});
  char line[400];
  std::snprintf(line, sizeof line, "%e %e %e 1.5 %e %e %e -2 %e %e %e 1e2\n", R(0, 0), R(0, 1),
                R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2));
  Reading reading(line);
  const auto poses = reading.poses();
  REQUIRE(poses.size() == 1);
  CHECK(poses[0].translation() == Eigen::Vector3d(1.5, -2, 100));
  CHECK(poses[0].linear().isApprox(R, 1e-6));
  CHECK((poses[0].linear() * poses[0].linear().transpose()).isIdentity(1e-15));
}

TEST_CASE("poses that are none") {
  const std::string good = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  CHECK(posesFailure(good + "1 0 0 nan 0 1 0 0 0 0 1 0\n") ==
        "DATA/f.txt:2: 'nan' is no finite number; correct the pose, or remove the file to run "
        "without truth");
  CHECK(posesFailure("1 0 0\n") == "DATA/f.txt:1: has 3 numbers; a pose has 12, row by row");
  const std::string no_rotation =
      "DATA/f.txt:1: its first three columns are no rotation; write camera-to-world poses";
  CHECK(posesFailure("2 0 0 0 0 1 0 0 0 0 1 0\n") == no_rotation);
  CHECK(posesFailure("-1 0 0 0 0 1 0 0 0 0 1 0\n") == no_rotation);  // a mirror
  CHECK(posesFailure("0 0 0 0 0 0 0 0 0 0 0 0\n") == no_rotation);
  for (const char* far : {"1 0 0 1e200 0 1 0 0 0 0 1 0", "1 0 0 0 0 1 0 0 0 0 1 -1.1e9",
                          "1 0 0 0 0 1 0 2e9 0 0 1 0"}) {
    CHECK(posesFailure(good + far + "\n") ==
          "DATA/f.txt:2: its position is beyond 1e9 m; write metres, as the fourth, eighth and "
          "twelfth number");
  }
  CHECK(posesFailure("1 0 0 1e9 0 1 0 0 0 0 1 -1e9\n").empty());
}

TEST_CASE("one entry an image") {
  Inspection inspection;
  checkCount("t.txt", 4, 4, inspection);
  checkCount("t.txt", 0, 4, inspection);  // unreadable: explained before
  CHECK_FALSE(inspection.hasErrors());
  checkCount("t.txt", 5, 4, inspection);
  CHECK(inspection.status().message() ==
        "t.txt: has 5 entries, but there are 4 images; one line per image is needed");
}

}  // namespace tolman::image_folders
