// SPDX-License-Identifier: BSD-3-Clause
// Calibrations as other programs write them; those of OpenCV are written by OpenCV itself.
#include "camera_files.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <opencv2/core.hpp>

#include "calibration_cameras.hpp"
#include "data_error.hpp"
#include "given_pinhole.hpp"
#include "support/data.hpp"

using namespace tolman;
using camera_files::readCameras;

namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
    return folder.path() / name;
  }
  /// The refusal without the folder's path; empty for files that are accepted.
  std::string refusalOf(const std::vector<fs::path>& files,
                        const camera_files::WantedCameras& wanted) const {
    try {
      (void)readCameras(files, wanted);
      return "";
    } catch (const source_parameters::DataError& error) {
      return std::string(error.what()).substr(folder.path().string().size() + 1);
    }
  }
  std::string refusal(const std::string& text, camera_files::WantedCameras wanted = {},
                      const char* name = "c.yaml") const {
    return refusalOf({write(name, text)}, wanted);
  }
  test::TemporaryFolder folder;
};

RawRig rigOf(const std::vector<fs::path>& files, const camera_files::WantedCameras& wanted) {
  return readCameras(files, wanted);
}

const char* const kKalibr =
    "cam0:\n  camera_model: omni\n  intrinsics: [1.5, 800, 801, 320.5, 240.5]\n"
    "  distortion_model: radtan\n  distortion_coeffs: [-0.1, 0.02, 0.001, -0.002]\n"
    "  resolution: [640, 480]\n"
    "cam1:\n  camera_model: pinhole\n  intrinsics: [500, 501, 321, 241]\n"
    "  distortion_model: equidistant\n  distortion_coeffs: [0.1, 0.2, 0.3, 0.4]\n"
    "  resolution: [640, 480]\n"
    "  T_cn_cnm1:\n  - [1, 0, 0, -0.12]\n  - [0, 1, 0, 0.01]\n  - [0, 0, 1, 0]\n"
    "  - [0, 0, 0, 1]\n";

const char* const kRos =
    "image_width: 640\nimage_height: 480\ncamera_name: left\n"
    "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [430.1, 0, 320.2, 0, 430.3, 240.4, 0, 0, 1]\n"
    "distortion_model: plumb_bob\n"
    "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [-0.3, 0.1, 0.001, 0.002, 0.05]\n"
    "rectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
    "projection_matrix:\n  rows: 3\n  cols: 4\n"
    "  data: [400, 0, 310, FOURTH, 0, 400, 235, 0, 0, 0, 1, 0]\n";

std::string ros(const std::string& fourth) {
  std::string text = kRos;
  return text.replace(text.find("FOURTH"), 6, fourth);
}

constexpr camera_files::WantedCameras kPair = {2, 640, 480};

}  // namespace

TEST_CASE("Kalibr's camera chain") {
  const Folder folder;
  const RawRig rig = rigOf({folder.write("camchain.yaml", kKalibr)}, kPair);
  REQUIRE(rig.cameras.size() == 2);
  const RawCamera& left = rig.cameras[0];
  CHECK(left.model == LensModel::Omnidirectional);
  CHECK(left.xi == 1.5);
  CHECK(left.pinhole.fx == 800);
  CHECK(left.distortion[3] == -0.002);
  const RawCamera& right = rig.cameras[1];
  CHECK(right.model == LensModel::Equidistant);
  CHECK(right.pinhole.cy == 241);
  CHECK(right.distortion[3] == 0.4);
  CHECK(right.T_reference_camera.translation().isApprox(Eigen::Vector3d(0.12, -0.01, 0)));
  CHECK_FALSE(rig.has_rectified);
  CHECK(rigOf({folder.write("camchain.yaml", kKalibr)}, {1, 640, 480}).cameras.size() == 1);
}

TEST_CASE("double sphere, extended unified and FOV, as Kalibr and Basalt write them") {
  const Folder folder;
  const auto kalibr = [&](const std::string& model, const std::string& intrinsics,
                          const std::string& distortion, const std::string& k) {
    return rigOf(
               {folder.write("camchain.yaml",
                             "cam0:\n  camera_model: " + model + "\n  intrinsics: [" + intrinsics +
                                 "]\n  distortion_model: " + distortion +
                                 "\n  distortion_coeffs: [" + k + "]\n  resolution: [640, 480]\n")},
               {1, 640, 480})
        .cameras[0];
  };
  const auto check = [](const RawCamera& camera, const char* name, std::vector<double> parameters,
                        double focal) {
    CAPTURE(name);
    REQUIRE(camera.model == LensModel::Equidistant);
    const auto lens = camera_files::roundLens(name, parameters);
    REQUIRE(lens);
    for (double t = 0.05; t < 0.8; t += 0.05) {
      const auto& k = camera.distortion;
      const double s = t * t;
      const double radius =
          camera.pinhole.fx * t * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
      CHECK(radius == Approx(focal * (*lens)(t)).margin(0.05));
    }
  };
  check(kalibr("ds", "-0.25, 0.57, 300, 301, 320, 240", "none", ""), "ds", {-0.25, 0.57}, 300);
  check(kalibr("eucm", "0.63, 1.04, 300, 301, 320, 240", "none", ""), "eucm", {0.63, 1.04}, 300);
  check(kalibr("pinhole", "300, 301, 320, 240", "fov", "0.9"), "fov", {0.9}, 300);
  // A mirror of the unified model is an extended one of beta = 1: alpha = xi / (1 + xi).
  const auto unified = *camera_files::roundLens("eucm", std::vector{0.6, 1.0});
  CHECK(unified(0.7) == Approx(std::sin(0.7) / (0.6 + 0.4 * std::cos(0.7))));
  const RawRig basalt = rigOf({folder.write("calibration.json",
                                            R"({"value0": {"T_imu_cam": [
            {"px": 0.1, "py": 0, "pz": 0, "qx": 0, "qy": 0, "qz": 0, "qw": 1},
            {"px": 0.2, "py": 0, "pz": 0, "qx": 0, "qy": 0, "qz": 0, "qw": 1}],
            "intrinsics": [
            {"camera_type": "ds", "intrinsics": {"fx": 300, "fy": 300, "cx": 320, "cy": 240,
             "xi": -0.25, "alpha": 0.57}},
            {"camera_type": "kb4", "intrinsics": {"fx": 310, "fy": 310, "cx": 320, "cy": 240,
             "k1": 0.01, "k2": 0, "k3": 0, "k4": 0}}],
            "resolution": [[640, 480], [640, 480]]}})")},
                              kPair);
  check(basalt.cameras[0], "ds", {-0.25, 0.57}, 300);
  CHECK(basalt.cameras[1].distortion[0] == 0.01);
  CHECK(basalt.cameras[1].T_reference_camera.translation().x() == 0.2);
}

TEST_CASE("camera.txt of TUM's monocular sets: shares of the image, and models by name") {
  const Folder folder;
  const auto camera = [&](const std::string& text) {
    return rigOf({folder.write("camera.txt", text)}, {1, 1280, 1024}).cameras[0];
  };
  const RawCamera fov = camera("0.35 0.4375 0.5 0.498046875 0.93\n1280 1024\ncrop\n640 480\n");
  CHECK(fov.pinhole.cx == 639.5);  // the left edge is at -0.5
  CHECK(fov.pinhole.cy == 509.5);
  REQUIRE(fov.model == LensModel::Equidistant);
  for (double angle = 0.1; angle < 0.8; angle += 0.1) {
    const double published = std::atan(2 * std::tan(angle) * std::tan(0.93 / 2)) / 0.93;
    const double s = angle * angle;
    const auto& k = fov.distortion;
    const double radius = angle * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
    CHECK(fov.pinhole.fx * radius == Approx(448 * published).margin(0.05));
  }
  const RawCamera radtan = camera("RadTan 450 451 640 510 -0.2 0.05 0.001 0.002\n1280 1024\n");
  CHECK(radtan.model == LensModel::RadialTangential);
  CHECK(radtan.pinhole.fy == 451);
  CHECK(radtan.distortion[2] == 0.001);
  CHECK(camera("Pinhole 450 451 640 510 0\n1280 1024\nnone\n1280 1024\n").distortion.isZero());
  CHECK_THROWS_WITH(camera("0.35 0.4375 0.5 0.498 0.93\n640 480\n"),
                    Catch::Contains("camera.txt:1: is the calibration of images of 640x480"));
}

TEST_CASE("ROS: a pair prescribes its rectified cameras, a single camera does not") {
  const Folder folder;
  const fs::path left = folder.write("left.yaml", ros("0"));
  const RawRig rig = rigOf({left, folder.write("right.yaml", ros("-48.5"))}, kPair);
  CHECK(rig.cameras[0].model == LensModel::RadialTangential);
  CHECK(rig.cameras[0].distortion[4] == 0.05);
  CHECK(rig.has_rectified);
  CHECK(rig.rectified.pinhole.cx == 310);
  CHECK(rig.rectified.baseline == 48.5 / 400);
  CHECK(rig.rectified.width == 640);
  CHECK_FALSE(rigOf({left}, {1, 640, 480}).has_rectified);
  CHECK_THAT(folder.refusalOf({folder.write("right.yaml", ros("-48.5")), left}, kPair),
             Catch::StartsWith("left.yaml: has a baseline of -0.1212 m"));
}

TEST_CASE("OpenCV: intrinsics and extrinsics of stereo_calib, as YAML and as XML") {
  const Folder folder;
  const char* const extension = GENERATE(".yml", ".xml");
  const fs::path intrinsics = folder.folder.path() / (std::string("intrinsics") + extension);
  const fs::path extrinsics = folder.folder.path() / (std::string("extrinsics") + extension);
  const cv::Matx33d M(533.12345678901234, 0, 342.2, 0, 533.5, 234.6, 0, 0, 1);
  const cv::Mat D =
      (cv::Mat_<double>(1, 14) << -0.28, 0.04, 1e-3, -2e-4, 0.1, 0.2, 0.3, 0.4, 0, 0, 0, 0, 0, 0);
  {
    cv::FileStorage file(intrinsics.string(), cv::FileStorage::WRITE);
    file << "M1" << cv::Mat(M) << "D1" << D << "M2" << cv::Mat(M) << "D2" << D.colRange(0, 5);
  }
  {
    cv::FileStorage file(extrinsics.string(), cv::FileStorage::WRITE);
    file << "R" << cv::Mat(cv::Matx33d::eye()) << "T" << cv::Mat(cv::Vec3d(-3.34, 0.05, -0.01));
  }
  const RawRig rig = rigOf({intrinsics, extrinsics}, kPair);
  CHECK(rig.cameras[0].pinhole.fx == 533.12345678901234);
  CHECK(rig.cameras[0].distortion[7] == 0.4);
  CHECK(rig.cameras[0].width == 640);
  CHECK(rig.cameras[1].distortion[4] == 0.1);
  CHECK(rig.cameras[1].distortion[5] == 0);
  CHECK(
      rig.cameras[1].T_reference_camera.translation().isApprox(Eigen::Vector3d(3.34, -0.05, 0.01)));
  CHECK_THAT(folder.refusalOf({intrinsics}, kPair),
             Catch::Contains("does not state where the right camera is"));
}

TEST_CASE("OpenCV: one camera as the sample program writes it") {
  const Folder folder;
  const std::string text =
      "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\nfisheye_model: FISHEYE\n"
      "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
      "   data: [ 6.5e+02, 0., 3.2e+02, 0., 6.5e+02, 2.4e+02, 0., 0., 1. ]\n"
      "distortion_coefficients: !!opencv-matrix\n   rows: 4\n   cols: 1\n   dt: d\n"
      "   data: [ -0.4, 0.5, 0.001, 0.002 ]\n";
  const auto with = [&](const std::string& fisheye) {
    std::string changed = text;
    changed.replace(changed.find("FISHEYE"), 7, fisheye);
    return rigOf({folder.write("camera.yml", changed)}, {1, 640, 480}).cameras[0];
  };
  CHECK(with("0").model == LensModel::RadialTangential);
  CHECK(with("0").distortion[1] == 0.5);
  CHECK(with("1").model == LensModel::Equidistant);
}

TEST_CASE("what is missing or cannot be is named with file, line and remedy") {
  const Folder folder;
  CHECK(folder.refusal("a: 1\n") ==
        "c.yaml: is no calibration of Kalibr (cam0), Basalt (value0), EuRoC (intrinsics), ROS or "
        "OpenCV "
        "(camera_matrix; M1, D1, M2, D2, R, T); give one of these");
  const std::string camera =
      "camera_model: pinhole\nintrinsics: [400, 400, 320, 240]\n"
      "distortion_model: MODEL\ndistortion_coefficients: [COEFFICIENTS]\nresolution: [640, 480]\n";
  const auto refusal = [&](const std::string& model, const std::string& coefficients,
                           camera_files::WantedCameras wanted = {1, 640, 480}) {
    std::string text = camera;
    text.replace(text.find("MODEL"), 5, model);
    text.replace(text.find("COEFFICIENTS"), 12, coefficients);
    return folder.refusal(text, wanted);
  };
  CHECK(refusal("radial-tangential", "1, 2, 3, 4").empty());
  CHECK(refusal("fov", "1").empty());
  CHECK(
      refusal("polynomial", "1") ==
      "c.yaml:4: has the distortion model 'polynomial', which is not known; calibrate with radtan "
      "(plumb_bob), rational_polynomial or equidistant");
  CHECK(refusal("equidistant", "1, 2, 3, 4, 5") ==
        "c.yaml:4: has 5 coefficients of the model 'equidistant'; known are 4");
  CHECK(refusal("radtan", "1, 2, x, 4") == "c.yaml:4: 'x' is no finite number; correct it");
  CHECK(refusal("radtan", "1, 2, 3, 4", {1, 320, 240}) ==
        "c.yaml: is the calibration of images of 640x480 px, but they have 320x240 px; give "
        "the calibration of these images");
  CHECK_THAT(refusal("radtan", "1, 2, 3, 4", kPair),
             Catch::Contains("has 1 cameras instead of 2; name the file of the right camera too"));
  CHECK(folder.refusalOf({folder.folder.path() / "none.yaml"}, kPair) ==
        "none.yaml: is missing; restore it, or correct the path");
}

TEST_CASE("a key that is given twice is refused at the second") {
  const Folder folder;
  const auto twice = [&](std::string text, const char* line, const char* name = "c.yaml") {
    return folder.refusal(text + line, {1, 640, 480}, name);
  };
  CHECK(twice(kKalibr, "  resolution: [640, 480]\n") ==
        "c.yaml:18: 'resolution' is given twice, first in line 12; remove one of the two");
  CHECK(twice(ros("0"), "camera_matrix:\n  rows: 3\n") ==
        "c.yaml:21: 'camera_matrix' is given twice, first in line 4; remove one of the two");
  CHECK(twice(ros("0"), "K: [1]\n") ==
        "c.yaml:21: 'K' means the same as 'camera_matrix' in line 4; remove one of the two");
  CHECK(twice("calib_time: 9\nK_00: 1 2 3\nS_00: 640 480\n", "K_00: 1 2 3\n", "c.txt") ==
        "c.txt:4: K_00 is given twice, first in line 2; remove one of the two");
}

TEST_CASE("each mistake of a sensor.yaml is told at its own line") {
  const Folder folder;
  const std::vector<std::string> sound = {"%YAML:1.0",
                                          "# General sensor definitions.",
                                          "sensor_type: camera",
                                          "",
                                          "T_BS:",
                                          "  cols: 4",
                                          "  rows: 4",
                                          "  data: [1, 0, 0, 0,",
                                          "         0, 1, 0, 0,",
                                          "         0, 0, 1, 0,",
                                          "         0, 0, 0, 1]",
                                          "# Camera specific definitions.",
                                          "resolution: [640, 480]",
                                          "camera_model: pinhole",
                                          "intrinsics: [400, 400, 320, 240] #fu, fv, cu, cv",
                                          "distortion_model: radial-tangential",
                                          "distortion_coefficients: [-0.1, 0.02, 0, 0]"};
  const auto refusal = [&](std::size_t line, const std::string& changed) {
    std::string text;
    for (std::size_t i = 0; i < sound.size(); ++i) {
      text += (i + 1 == line ? changed : sound[i]) + "\n";
    }
    return folder.refusal(text, {1, 640, 480});
  };
  CHECK(refusal(0, "").empty());
  CHECK_THAT(refusal(5, "T_BS: [1, 2]"), Catch::StartsWith("c.yaml:6: is no YAML"));
  CHECK_THAT(refusal(8, "  data: [1, 0, 0,"), Catch::StartsWith("c.yaml:5: 'T_BS' has 15 numbers"));
  CHECK_THAT(refusal(8, "  data: [2, 0, 0, 0,"), Catch::StartsWith("c.yaml:5: has no rotation"));
  CHECK_THAT(refusal(10, "         0, 0, one, 0,"), Catch::StartsWith("c.yaml:10: 'one' is no"));
  CHECK_THAT(refusal(13, "resolution: [640]"), Catch::StartsWith("c.yaml:13: 'resolution' must"));
  CHECK_THAT(refusal(13, "resolution: [64, 48]"), Catch::StartsWith("c.yaml: is the calib"));
  CHECK_THAT(refusal(14, "camera_model: fov"), Catch::StartsWith("c.yaml:14: the camera model"));
  CHECK_THAT(refusal(15, "intrinsics: [400, 400, 320]"),
             Catch::StartsWith("c.yaml:15: 'intrinsics' has 3 numbers"));
  CHECK_THAT(refusal(15, "intrinsics: [0, 400, 320, 240]"),
             Catch::StartsWith("c.yaml: the focal lengths are not positive"));
  CHECK_THAT(refusal(15, "intrinsics: [400, 400, 320, 2400]"),
             Catch::StartsWith("c.yaml: the principal point (320, 2400) is outside"));
  CHECK(refusal(16, "") == "c.yaml: has no 'distortion_model'; add it");
}

TEST_CASE("a named distortion without coefficients is no lens without distortion") {
  const Folder folder;
  const auto refusal = [&](const std::string& lines) {
    return folder.refusal(
        "resolution: [640, 480]\nintrinsics: [400, 400, 320, 240]\n" + lines + "\n", {1, 640, 480});
  };
  const std::string missing =
      "'radtan' has no coefficients; add them, or [] for a lens without distortion";
  CHECK(refusal("distortion_model: radtan\ndistortion_coefficients:") == "c.yaml:3: " + missing);
  CHECK(refusal("distortion_model: radtan") == "c.yaml:3: " + missing);
  CHECK_THAT(refusal("distortion_model:\ndistortion_coeffs: [0.1, 0.2, 0, 0]"),
             Catch::StartsWith("c.yaml:4: has the distortion model ''"));
  CHECK(refusal("distortion_model: radtan\ndistortion_coeffs: []").empty());
  CHECK(refusal("distortion_model: ''\ndistortion_coeffs: [0, 0, 0, 0]").empty());
  CHECK(refusal("distortion_model: none").empty());
}

TEST_CASE("coefficients by the names of models, filled up with zeros as drivers do") {
  using Numbers = std::vector<double>;
  const auto cameraOf = [](const char* model, const Numbers& coefficients) {
    RawCamera camera;
    const Status status = source_parameters::setLens(model, coefficients, camera);
    INFO(status.message());
    REQUIRE(status.isOk());
    return camera;
  };
  const Numbers eight = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
  Numbers fourteen = eight;
  fourteen.resize(14);
  for (const char* model : {"rational_polynomial", "radtan", "plumb_bob"}) {
    CHECK(cameraOf(model, eight).distortion == cameraOf(model, fourteen).distortion);
    CHECK(cameraOf(model, eight).distortion[7] == 0.8);
  }
  CHECK(cameraOf("plumb_bob", {0.1, 0, 0, 0}).model == LensModel::RadialTangential);
  CHECK(cameraOf("equidistant", {0.1, 0.2, 0.3, 0.4, 0}).distortion[3] == 0.4);
  CHECK(cameraOf("fisheye", {0, 0, 0, 0}).model == LensModel::Equidistant);
  for (const char* model : {"plumb_bob", "Inverse Brown Conrady", ""}) {
    CHECK(cameraOf(model, {0, 0, 0, 0, 0}).model == LensModel::Pinhole);
  }
  RawCamera camera;
  for (const auto& [model, coefficients] :
       {std::pair("plumb_bob", Numbers{0.1, 0.2}), std::pair("fisheye", Numbers{0.1, 0.2}),
        std::pair("Inverse Brown Conrady", Numbers{0.1, 0, 0, 0, 0}),
        std::pair("rational_polynomial", Numbers(9, 0.1)), std::pair("equi", Numbers(5, 0.1))}) {
    CHECK_FALSE(source_parameters::setLens(model, coefficients, camera).isOk());
  }
}

TEST_CASE("KITTI's calib.txt: the grey pair of sequence 06, and the colour pair") {
  const Folder folder;
  const auto file = folder.write(
      "calib.txt",
      "P0: 7.070912e+02 0 6.018873e+02 0 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n"
      "P1: 7.070912e+02 0 6.018873e+02 -3.798145e+02 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n"
      "P2: 718.856 0 607.1928 45.38225 0 718.856 185.2157 -0.1130887 0 0 1 0.003779761\n"
      "P3: 718.856 0 607.1928 -337.2877 0 718.856 185.2157 2.369057 0 0 1 0.004915215\n"
      "Tr: 1 2 3\n");
  const auto grey = camera_files::readRectified(file, {2, 1226, 370});
  CHECK(grey.rig.pinhole.fx == 707.0912);
  CHECK(grey.rig.pinhole.cy == 183.1104);
  CHECK(grey.rig.baseline == Approx(379.8145 / 707.0912).epsilon(1e-12));
  CHECK(grey.t_left_camera0.norm() == 0);
  CHECK(camera_files::readRectified(file, {1, 1226, 370}).rig.baseline == 0);
  const auto colour = camera_files::readRectified(file, {2, 1226, 370, 2});
  const double x2 = (45.38225 - 607.1928 * 0.003779761) / 718.856;
  const double x3 = (-337.2877 - 607.1928 * 0.004915215) / 718.856;
  CHECK(colour.rig.baseline == Approx(x2 - x3).epsilon(1e-12));
  CHECK(colour.t_left_camera0.x() == Approx(x2).epsilon(1e-12));
  // The matrix puts a point of camera 0's frame where the pinhole puts it in camera 2's frame.
  const Eigen::Vector3d point(1, 2, 10);
  const Eigen::Vector2d pixel = colour.rig.pinhole.project(point + colour.t_left_camera0);
  CHECK(pixel.x() == Approx((718.856 * 1 + 607.1928 * 10 + 45.38225) / (10 + 0.003779761)));
}

TEST_CASE("KITTI's calib.txt that is none of a rectified pair") {
  const Folder folder;
  const auto refusal = [&](const std::string& text, int count) {
    try {
      (void)camera_files::readRectified(folder.write("calib.txt", text), {count, 64, 48});
      return std::string();
    } catch (const source_parameters::DataError& error) {
      return std::string(error.what()).substr(folder.folder.path().string().size() + 1);
    }
  };
  const std::string left = "P0: 50 0 31.5 0 0 50 23.5 0 0 0 1 0\n";
  CHECK(refusal(left, 1).empty());
  CHECK(refusal(left, 2) == "calib.txt: has no P1; restore the file");
  CHECK_THAT(refusal(left + "P1: 50 0 31.5 0 0 50 23.5 0 0 0 1 0\n", 2),
             Catch::Contains("has a baseline of 0 m, which must be 1 mm to 5 m"));
  CHECK_THAT(refusal(left + "P1: 50 0 31.5 25 0 50 23.5 0 0 0 1 0\n", 2),
             Catch::Contains("has a baseline of -0.5 m"));
  CHECK_THAT(refusal(left + "P1: 51 0 31.5 -25 0 51 23.5 0 0 0 1 0\n", 2),
             Catch::Contains("different focal lengths"));
  CHECK_THAT(refusal(left + "P1: 50 0 31.5 -25 0 50 23.5 5 0 0 1 0\n", 2),
             Catch::Contains("has a right camera -0.1 m below and 0 m before the left one"));
  CHECK_THAT(refusal("P0: 50 1 31.5 0 0 50 23.5 0 0 0 1 0\n", 1),
             Catch::StartsWith("calib.txt:1: is not the matrix"));
  CHECK_THAT(refusal("P0: -50 0 31.5 0 0 -50 23.5 0 0 0 1 0\n", 1),
             Catch::Contains("focal lengths that are not positive"));
  CHECK_THAT(refusal("P0: 50 0 310.5 0 0 50 23.5 0 0 0 1 0\n", 1),
             Catch::Contains("the principal point (310.5, 23.5) is outside"));
  CHECK(refusal("P0: 1 2 3\n", 1) == "calib.txt:1: P0 has 3 numbers instead of 12");
  CHECK(refusal("what\n", 1) == "calib.txt:1: is not of the form 'NAME: numbers'; correct it");
}

TEST_CASE("a camera matrix with skew or another scale, and a lower right camera, are refused") {
  const Folder folder;
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string sound = ros("0");
  CHECK(folder.refusal(sound, {1, 640, 480}).empty());
  CHECK_THAT(folder.refusal(changed(sound, "[430.1, 0,", "[430.1, 3,"), {1, 640, 480}),
             Catch::StartsWith("c.yaml:4: is not the matrix"));
  CHECK_THAT(folder.refusal(changed(sound, "240.4, 0, 0, 1]", "240.4, 0, 0, 2]"), {1, 640, 480}),
             Catch::StartsWith("c.yaml:4: is not the matrix"));
  CHECK_THAT(folder.refusal(changed(sound, "235, 0, 0, 0, 1, 0]", "235, 0, 0, 0, 2, 0]")),
             Catch::Contains("is not the matrix"));
  const auto left = folder.write("left.yaml", sound);
  const auto right = folder.write("right.yaml", changed(ros("-40"), "235, 0,", "235, 4,"));
  CHECK_THAT(folder.refusalOf({left, right}, kPair),
             Catch::Contains("has a right camera -0.01 m below"));
}

TEST_CASE("calibrations of raw cameras are told from KITTI's rectified ones") {
  const Folder folder;
  CHECK(camera_files::isRawCalibration(folder.write("a.yaml", "x")));
  CHECK(camera_files::isRawCalibration(folder.write("a.txt", "calib_time: 9\nK_00: 1\n")));
  CHECK_FALSE(camera_files::isRawCalibration(folder.write("calib.txt", "P0: 1 0 0\n")));
}

// The numbers below are copied from the files by hand.
TEST_CASE("real calibrations of four data sets, to the last digit", "[data]") {
  const auto euroc = test::dataOrSkip("euroc_v101");
  const auto tumvi = test::dataOrSkip("tumvi_room1");
  const auto kitti = test::dataOrSkip("kitti_raw_unrectified");
  if (euroc) {
    const RawRig rig =
        rigOf({*euroc / "mav0/cam0/sensor.yaml", *euroc / "mav0/cam1/sensor.yaml"}, {2, 752, 480});
    CHECK(rig.cameras[0].pinhole.fx == 458.654);
    CHECK(rig.cameras[0].distortion[3] == 1.76187114e-05);
    CHECK(rig.cameras[0].T_reference_camera(0, 1) == Approx(-0.999880929698).epsilon(1e-9));
    CHECK(rig.cameras[0].T_reference_camera(2, 3) == 0.00981073058949);
    const Eigen::Isometry3d T_left_right =
        rig.cameras[0].T_reference_camera.inverse() * rig.cameras[1].T_reference_camera;
    CHECK(T_left_right.translation().norm() == Approx(0.110).margin(5e-4));
    CHECK(T_left_right.translation().x() > 0.1);
  }
  if (tumvi) {
    const RawRig rig = rigOf({*tumvi / "camchain.yaml"}, {2, 1024, 1024});
    CHECK(rig.cameras[0].model == LensModel::Equidistant);
    CHECK(rig.cameras[0].pinhole.fx == 380.81042871360756);
    CHECK(rig.cameras[1].distortion[3] == -0.002347858896562788);
    CHECK(rig.cameras[1].T_reference_camera.translation().x() == Approx(0.1009).margin(5e-4));
  }
  if (kitti) {
    const RawRig rig = rigOf({*kitti / "calib_cam_to_cam.txt"}, {2, 1392, 512});
    CHECK(rig.cameras[1].pinhole.cy == 245.559);
    CHECK(rig.cameras[1].distortion[4] == -5.314062e-02);
    CHECK(rig.has_rectified);
    CHECK(rig.rectified.width == 1242);
    CHECK(rig.rectified.pinhole.fx == 721.5377);
    CHECK(rig.rectified.baseline == Approx(387.5744 / 721.5377));
    CHECK(rig.cameras[1].R_rectified_camera(0, 2) == Approx(2.331651e-02).epsilon(1e-5));
  }
}
