// SPDX-License-Identifier: BSD-3-Clause
// Calibrations whose entries contradict each other about the second camera.
#include <catch2/catch.hpp>
#include <fstream>

#include "camera_files.hpp"
#include "support/data.hpp"

using namespace tolman;

namespace {

/// The refusal of a pair without the folder; empty for an accepted file.
std::string refusalOf(const std::string& text, const char* name, int cameras = 2) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / name) << text;
  const auto rig = camera_files::readCameras({folder.path() / name}, {cameras, 640, 480});
  const std::string message = rig.status().message();
  return message.empty() ? "" : message.substr(folder.path().string().size() + 1);
}

/// A pose that moves along x, and turns about z by a quarter where this is wanted.
std::string pose(const std::string& key, const std::string& x, bool turned = false) {
  const std::string first = turned ? "0, -1, 0, " : "1, 0, 0, ";
  const std::string second = turned ? "1, 0, 0, " : "0, 1, 0, ";
  return "  " + key + ":\n  - [" + first + x + "]\n  - [" + second + "0]\n  - [0, 0, 1, 0]\n" +
         "  - [0, 0, 0, 1]\n";
}

const char* const kLens =
    "  camera_model: pinhole\n  intrinsics: [500, 501, 321, 241]\n"
    "  distortion_model: radtan\n  distortion_coeffs: [0, 0, 0, 0]\n  resolution: [640, 480]\n";

std::string kalibr(const std::string& step, bool turned = false) {
  return std::string("cam0:\n") + kLens + pose("T_cam_imu", "0.2") + "cam1:\n" + kLens +
         pose("T_cam_imu", "0.1") + pose("T_cn_cnm1", step, turned);
}

std::string openCvMatrix(const std::string& key, int rows, int columns, const std::string& data) {
  return key + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
         "\n   cols: " + std::to_string(columns) + "\n   dt: d\n   data: [ " + data + " ]\n";
}

/// As stereo_calib writes it, in one file; more entries follow T, which is in line 28.
std::string openCv(const std::string& more) {
  const std::string K = "500., 0., 320., 0., 500., 240., 0., 0., 1.";
  const std::string D = "0., 0., 0., 0., 0.";
  return "%YAML:1.0\n---\n" + openCvMatrix("M1", 3, 3, K) + openCvMatrix("D1", 1, 5, D) +
         openCvMatrix("M2", 3, 3, K) + openCvMatrix("D2", 1, 5, D) +
         openCvMatrix("R", 3, 3, "1., 0., 0., 0., 1., 0., 0., 0., 1.") +
         openCvMatrix("T", 3, 1, "-0.1, 0., 0.") + more;
}

std::string projection(const std::string& fourth, const std::string& eighth = "0.") {
  return openCvMatrix(
      "P2", 3, 4, "450., 0., 320., " + fourth + ", 0., 450., 240., " + eighth + ", 0., 0., 1., 0.");
}

std::string disparityToDepth(const std::string& inverse) {
  return openCvMatrix(
      "Q", 4, 4,
      "1., 0., 0., -320., 0., 1., 0., -240., 0., 0., 0., 450., 0., 0., " + inverse + ", 0.");
}

}  // namespace

TEST_CASE("Kalibr: T_cn_cnm1 and the T_cam_imu of both cameras must say the same") {
  CHECK(refusalOf(kalibr("-0.1"), "c.yaml").empty());
  CHECK(refusalOf(kalibr("-0.1015"), "c.yaml").empty());  // 1.5 %: of few digits
  CHECK(refusalOf(kalibr("-0.2"), "c.yaml") ==
        "c.yaml:23: 'T_cn_cnm1' has the translation [-0.2, 0, 0] m, but 'T_cam_imu' of the two "
        "cameras give [-0.1, 0, 0] m; correct the wrong ones");
  CHECK_THAT(refusalOf(kalibr("0.1"), "c.yaml"), Catch::Contains("give [-0.1, 0, 0] m"));
  CHECK(refusalOf(kalibr("-0.1", true), "c.yaml") ==
        "c.yaml:23: 'T_cn_cnm1' turns by 90 degrees, but 'T_cam_imu' of the two cameras by 0 "
        "degrees, which is 90 degrees away; correct the wrong ones");
  CHECK(refusalOf(kalibr("-0.2"), "c.yaml", 1).empty());  // not needed for one camera
}

TEST_CASE("OpenCV: T must be that of P2 and Q") {
  CHECK(refusalOf(openCv(""), "c.yml").empty());
  CHECK(refusalOf(openCv(projection("-45.") + disparityToDepth("10.")), "c.yml").empty());
  CHECK(refusalOf(openCv(projection("0.", "-45.") + disparityToDepth("-10.")), "c.yml").empty());
  CHECK(refusalOf(openCv(projection("-90.")), "c.yml") ==
        "c.yml:28: by 'T' the cameras are 0.1 apart, but by 'P2' 0.2; correct the wrong one, or "
        "remove 'P2', which is not needed");
  CHECK(refusalOf(openCv(disparityToDepth("20.")), "c.yml") ==
        "c.yml:28: by 'T' the cameras are 0.1 apart, but by 'Q' 0.05; correct the wrong one, or "
        "remove 'Q', which is not needed");
  CHECK(refusalOf(openCv(projection("0.") + disparityToDepth("-.Inf")), "c.yml").empty());
}

TEST_CASE("OpenCV: R must be that between R1 and R2") {
  const std::string none = "1., 0., 0., 0., 1., 0., 0., 0., 1.";
  const std::string turned = "0.8, -0.6, 0., 0.6, 0.8, 0., 0., 0., 1.";
  const auto pair = [&](const std::string& R1, const std::string& R2, const std::string& R) {
    std::string text = openCv(openCvMatrix("R1", 3, 3, R1) + openCvMatrix("R2", 3, 3, R2));
    return text.replace(text.rfind(none, text.find("T: ")), none.size(), R);
  };
  CHECK(refusalOf(pair(turned, turned, none), "c.yml").empty());
  CHECK(refusalOf(pair(turned, none, turned), "c.yml").empty());
  CHECK(refusalOf(pair(none, none, turned), "c.yml").empty());  // not computed
  CHECK(refusalOf(pair(turned, none, none), "c.yml") ==
        "c.yml:23: 'R' turns by 0 degrees, but 'R1' and 'R2' by 36.87 degrees, which is 36.87 "
        "degrees away; correct the wrong ones");
  CHECK_THAT(refusalOf(pair(none, turned, turned), "c.yml"), Catch::Contains("73.74 degrees away"));
}
