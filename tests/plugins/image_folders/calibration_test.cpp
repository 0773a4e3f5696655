// SPDX-License-Identifier: BSD-3-Clause
// calib.txt: values computed by hand, and each kind of invalid calibration.
#include "calibration.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"

namespace tolman::image_folders {
namespace {

using namespace std::string_literals;

std::string failure(const std::string& text, bool stereo = true, int left = 0) {
  const DataFolder data;
  data.write("calib.txt", text);
  Inspection inspection;
  const auto calibration = readKittiCalibration(data.path("calib.txt"), left, stereo, inspection);
  CHECK(calibration.has_value() != inspection.hasErrors());
  return data.anonymous(inspection.status().message());
}

const std::string kLeft = matrixLine("P0", 0);

}  // namespace

TEST_CASE("KITTI's grey pair of sequence 06") {
  const DataFolder data;
  data.write("calib.txt",
             "P0: 7.070912e+02 0 6.018873e+02 0 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n"
             "P1: 7.070912e+02 0 6.018873e+02 -3.798145e+02 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n"
             "Tr: 1 2 3\n");
  Inspection inspection;
  const auto calibration = readKittiCalibration(data.path("calib.txt"), 0, true, inspection);
  REQUIRE(calibration);
  CHECK(calibration->pinhole.fx == 707.0912);
  CHECK(calibration->pinhole.cy == 183.1104);
  CHECK(calibration->baseline == Approx(379.8145 / 707.0912).epsilon(1e-12));
  CHECK(calibration->t_left_camera0.norm() == 0);
  SECTION("one camera has no baseline") {
    CHECK(readKittiCalibration(data.path("calib.txt"), 0, false, inspection)->baseline == 0);
  }
}

TEST_CASE("KITTI's colour pair is 6 cm left of camera 0, and measured between its own cameras") {
  const DataFolder data;
  data.write("calib.txt",
             "P2: 718.856 0 607.1928 45.38225 0 718.856 185.2157 -0.1130887 0 0 1 0.003779761\n"
             "P3: 718.856 0 607.1928 -337.2877 0 718.856 185.2157 2.369057 0 0 1 0.004915215\n");
  Inspection inspection;
  const auto calibration = readKittiCalibration(data.path("calib.txt"), 2, true, inspection);
  INFO(inspection.status().message());
  REQUIRE(calibration);
  const double x2 = (45.38225 - 607.1928 * 0.003779761) / 718.856;
  const double x3 = (-337.2877 - 607.1928 * 0.004915215) / 718.856;
  CHECK(calibration->baseline == Approx(x2 - x3).epsilon(1e-12));
  CHECK(calibration->t_left_camera0.x() == Approx(x2).epsilon(1e-12));
  // The matrix puts a point of camera 0's frame where the pinhole puts it in camera 2's frame.
  const Eigen::Vector3d point(1, 2, 10);
  const Eigen::Vector2d pixel = calibration->pinhole.project(point + calibration->t_left_camera0);
  CHECK(pixel.x() == Approx((718.856 * 1 + 607.1928 * 10 + 45.38225) / (10 + 0.003779761)));
}

TEST_CASE("baselines that cannot be") {
  CHECK(
      failure(kLeft + matrixLine("P1", 0)) ==
      "DATA/calib.txt:2: baseline is 0.0000 m: both cameras are at one place; give -fx * baseline "
      "as the fourth number of the right camera's matrix, or set mono: true");
  CHECK(failure(kLeft + matrixLine("P1", 25)) ==
        "DATA/calib.txt:2: baseline is -0.5000 m: the right camera is left of the left one; swap "
        "the two image folders, or change the sign of the fourth number");
  CHECK(failure(kLeft + matrixLine("P1", -25000)) ==
        "DATA/calib.txt:2: baseline is 500.0000 m, more than 5 m; the fourth number must be "
        "-fx * baseline, in px m");
}

TEST_CASE("a camera that is infinitely far from camera 0, or nowhere, is none of the robot") {
  const std::string far =
      "DATA/calib.txt:1: puts the camera more than 1000 m away from camera 0; the fourth numbers "
      "of its rows are in px m";
  CHECK(failure("P0: 1e-308 0 1 1e308 0 1 1 0 0 0 1 0\n", false) == far);
  CHECK(failure("P0: 1 0 1e300 0 0 1 1 0 0 0 1 1e300\n", false) == far);
  CHECK(failure("P0: 700 0 600 700700 0 700 180 0 0 0 1 0\n", false) == far);
  CHECK(failure("P0: 700 0 600 699300 0 700 180 0 0 0 1 0\n", false).empty());
}

TEST_CASE("cameras that do not make a rectified pair") {
  CHECK(failure(kLeft + matrixLine("P1", -25, 51)) ==
        "DATA/calib.txt:2: the two cameras have different focal lengths or centres; rectify the "
        "images");
  CHECK(failure(kLeft + "P1: 50 0 31.5 -25 0 50 23.5 5 0 0 1 0\n") ==
        "DATA/calib.txt:2: the right camera is -0.1000 m below and 0.0000 m before the left one; "
        "rectify the images");
  CHECK(failure("P0: 50 1 31.5 0 0 50 23.5 0 0 0 1 0\n", false) ==
        "DATA/calib.txt:1: is not the matrix of a rectified camera (fx 0 cx a 0 fy cy b 0 0 1 c); "
        "rectify the images and give their matrix");
  CHECK(failure(matrixLine("P0", 0, -50), false) ==
        "DATA/calib.txt:1: focal lengths are -50.000 and -50.000 px; they must be positive");
}

TEST_CASE("a matrix that is given twice is refused at the second line, be it the same or not") {
  const std::string right = matrixLine("P1", -25);
  for (const std::string& again : {matrixLine("P0", 0), matrixLine("P0", 0, 90), "P0: 1\n"s}) {
    CHECK(failure(kLeft + right + again) ==
          "DATA/calib.txt:3: P0 is given twice; remove one of the two lines");
  }
  CHECK(failure(kLeft + right + right) ==
        "DATA/calib.txt:3: P1 is given twice; remove one of the two lines");
  CHECK(failure(kLeft + right + "Tr: 1\nTr: 2\n").empty());  // is not read
}

TEST_CASE("files that are no calibration") {
  CHECK(failure("") == "DATA/calib.txt: is empty; restore it");
  CHECK(failure(kLeft) == "DATA/calib.txt: has no P1; add it, or set mono: true");
  CHECK(failure(kLeft, false, 2) == "DATA/calib.txt: has no P2; add it");
  CHECK(failure("P0: 1 2 3\n", false) ==
        "DATA/calib.txt:1: has 3 numbers; a projection matrix has 12, row by row");
  CHECK(failure("P0: 50 0 nan 0 0 50 23.5 0 0 0 1 0\n", false) ==
        "DATA/calib.txt:1: 'nan' is no finite number; correct it");
  CHECK(failure("\x89PNG garbage\n", false) ==
        "DATA/calib.txt:1: is not of the form 'P0: 12 numbers'; correct it");
  SECTION("all problems are listed") {
    CHECK(failure("what\nP0: 1\nP1: 1\n") ==
          "DATA/calib.txt:1: is not of the form 'P0: 12 numbers'; correct it (and 2 more problems; "
          "`tolman dataset check` lists all)");
  }
}

}  // namespace tolman::image_folders
