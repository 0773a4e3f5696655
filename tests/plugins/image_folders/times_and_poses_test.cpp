// SPDX-License-Identifier: BSD-3-Clause
// Times and true poses of images, sound and broken.
#include "times_and_poses.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "tolman/geometry.hpp"

namespace tolman::image_folders {
namespace {

using List = std::vector<std::int64_t>;

/// What `read` makes of a file with this text; its refusal goes to `refusal`.
template <class Read>
auto reading(const std::string& text, const Read& read, std::string* refusal = nullptr) {
  const DataFolder data;
  data.write("f.txt", text);
  decltype(read(data.path("f.txt"))) result;
  try {
    result = read(data.path("f.txt"));
  } catch (const std::exception& error) {
    if (refusal == nullptr) throw;
    *refusal = data.anonymous(error.what());
  }
  return result;
}

template <class Read>
std::string refusalOf(const std::string& text, const Read& read) {
  std::string refusal;
  reading(text, read, &refusal);
  return refusal;
}

const auto kTimes = [](const std::filesystem::path& file) {
  return readTimes(file, "", TimeUnit::Seconds).stamps_ns;
};

}  // namespace

TEST_CASE("times as KITTI prints them, and a column of a table") {
  CHECK(reading("0.000000e+00\n1.044989e-01\n2.077935e-01\n", kTimes) ==
        List{0, 104498900, 207793500});
  const auto column = [](const std::filesystem::path& file) {
    return readTimes(file, "time_s", TimeUnit::Milliseconds).stamps_ns;
  };
  CHECK(reading("file,time_s,gyro\nimages/0.jpg,0.5,-0.04\nimages/1.jpg,63,0.09\n", column) ==
        List{500'000, 63'000'000});
  CHECK(refusalOf("file,time\na,0\n", column) ==
        "DATA/f.txt:1: names no column 'time_s'; correct stamps_column");
  CHECK(refusalOf("file,time_s\na,0\nb\n", column) ==
        "DATA/f.txt:3: has 1 columns; complete the line");
  CHECK(refusalOf("0.1 0.2\n", kTimes) ==
        "DATA/f.txt:1: has 2 columns; write one time a line, or set stamps_column");
  CHECK(refusalOf("# nothing\n", kTimes) == "DATA/f.txt: is empty; restore it");
  CHECK_THAT(refusalOf("-1.5\n", kTimes), Catch::Contains("'-1.5' is no time in s from 0"));
}

TEST_CASE("dates of KITTI's raw data") {
  CHECK(reading("2011-09-26 13:02:25.964389445\n1970-01-01 00:00:00.5\n", readDates) ==
        List{1317042145964389445, 500'000'000});
  for (const char* date : {"2011-13-26 13:02:25.9", "2011-09-26", "2011-09-26 25:02:25",
                           "2011-02-30 13:02:25", "2011-09-26 13:02:xx", "2011-9-26 13:02:25"}) {
    CAPTURE(date);
    CHECK_THAT(refusalOf(date, readDates),
               Catch::StartsWith("DATA/f.txt:1: is no date and time such as 2011-09-26"));
  }
}

TEST_CASE("images are sorted by the times that are their names") {
  const auto sorted = [](std::vector<std::filesystem::path> files, TimeUnit unit, const List& ns) {
    const StampedFiles found = sortedByTimes(std::move(files), unit);
    CHECK(found.stamps_ns == ns);
    std::string text;
    for (const std::filesystem::path& file : found.files) text += file.stem().string() + " ";
    return text;
  };
  CHECK(sorted({"d/1e1.png", "d/1e2.png", "d/2e1.png"}, TimeUnit::Milliseconds,
               {10'000'000, 20'000'000, 100'000'000}) == "1e1 2e1 1e2 ");
  CHECK(sorted({"d/1.1.png", "d/1.05.png", "d/+0.1.jpg", "d/1e-05.png"}, TimeUnit::Seconds,
               {10'000, 100'000'000, 1'050'000'000, 1'100'000'000}) == "1e-05 +0.1 1.05 1.1 ");
}

TEST_CASE("poses come as written, with clean rotations") {
  const Eigen::Matrix3d R = expSo3({0.1, -0.5, 0.2});
  char line[400];
  std::snprintf(line, sizeof line, "%e %e %e 1.5 %e %e %e -2 %e %e %e 1e2\n", R(0, 0), R(0, 1),
                R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2));
  const auto poses = reading(line, readKittiPoses);
  REQUIRE(poses.size() == 1);
  CHECK(poses[0].translation() == Eigen::Vector3d(1.5, -2, 100));
  CHECK(poses[0].linear().isApprox(R, 1e-6));
  CHECK((poses[0].linear() * poses[0].linear().transpose()).isIdentity(1e-15));
}

TEST_CASE("poses that are none") {
  const std::string good = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  CHECK(refusalOf(good + "1 0 0 nan 0 1 0 0 0 0 1 0\n", readKittiPoses) ==
        "DATA/f.txt:2: 'nan' is no finite number; correct the pose");
  CHECK(refusalOf("1 0 0\n", readKittiPoses) ==
        "DATA/f.txt:1: has 3 numbers instead of 12; correct the pose");
  for (const char* mirror : {"2 0 0 0 0 1 0 0 0 0 1 0\n", "-1 0 0 0 0 1 0 0 0 0 1 0\n"}) {
    CHECK_THAT(refusalOf(mirror, readKittiPoses), Catch::Contains("has no rotation"));
  }
  CHECK_THAT(refusalOf(good + "1 0 0 1e200 0 1 0 0 0 0 1 0\n", readKittiPoses),
             Catch::StartsWith("DATA/f.txt:2: has a position beyond 1e9 m"));
}

}  // namespace tolman::image_folders
