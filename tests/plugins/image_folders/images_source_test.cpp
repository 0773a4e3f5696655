// SPDX-License-Identifier: BSD-3-Clause
// The images source: one or two folders, with and without calibration.
#include "images_source.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "data_folder.hpp"

namespace tolman::image_folders {
namespace {

/// Configures with the folder as path; the failure's message goes to `message`.
struct ImagesOpened {
  ImagesOpened(const DataFolder& data, ParameterValues values) {
    values["path"] = data.path().string();
    message = data.anonymous(configure(source, std::move(values)));
    if (!message.empty()) return;
    REQUIRE(source.info(info).isOk());
    std::string failure;
    frames = readAll(source, failure);
    REQUIRE(failure.empty());
  }
  ImagesSource source;
  SourceInfo info;
  std::string message;
  std::vector<Frame> frames;
};

const ParameterValues kPair = {{"left", std::string("image_0")}, {"right", std::string("image_1")}};

ParameterValues pairWith(ParameterValues more) {
  more.insert(kPair.begin(), kPair.end());
  return more;
}

}  // namespace

TEST_CASE("one uncalibrated folder") {
  const DataFolder data;
  const ImagesOpened mono(data, {{"left", std::string("image_0")}});
  CHECK(mono.message.empty());
  CHECK(mono.info.description ==
        "images, 4 images of one camera of 64x48 px at 10.0 Hz, uncalibrated, no truth");
  CHECK_FALSE(mono.info.rig.calibrated);
  REQUIRE(mono.frames.size() == 4);
  CHECK(mono.frames[3].stamp_ns == 300'000'000);
  CHECK(mono.frames[3].right.empty());
}

TEST_CASE("the left folder is found where none is named") {
  const DataFolder data;
  CHECK(ImagesOpened(data, {}).message == "DATA/: has no .png or .jpg images; check the path");
  data.writeImage("top.png", 8, 8);
  CHECK(ImagesOpened(data, {}).frames.size() == 1);
  std::filesystem::rename(data.path("image_0"), data.path("images"));
  CHECK(ImagesOpened(data, {}).frames.size() == 4);
}

TEST_CASE("a pair with a calibration file") {
  const DataFolder data;
  const ImagesOpened stereo(data, pairWith({{"calibration", std::string("calib.txt")}}));
  CHECK(stereo.message.empty());
  CHECK(stereo.info.rig.baseline == Approx(0.5));
  CHECK_FALSE(stereo.frames[0].right.empty());
}

TEST_CASE("a pair with numbers: the centre of the image is the default centre") {
  const DataFolder data;
  const ImagesOpened stereo(data, pairWith({{"fx", 40.0}, {"baseline", 0.2}, {"cy", 20.0}}));
  CHECK(stereo.message.empty());
  const CameraRig& rig = stereo.info.rig;
  CHECK(rig.calibrated);
  CHECK(rig.pinhole.fx == 40);
  CHECK(rig.pinhole.fy == 40);
  CHECK(rig.pinhole.cx == 31.5);
  CHECK(rig.pinhole.cy == 20);
  CHECK(rig.baseline == 0.2);
}

TEST_CASE("a raw pair with the calibration of another program") {
  const DataFolder data;
  const std::string camera =
      "image_width: 64\nimage_height: 48\ncamera_matrix: {rows: 3, cols: 3, data: [50, 0, 31, 0, "
      "50, "
      "23, 0, 0, 1]}\ndistortion_coefficients: [-0.1, 0, 0, 0, 0]\n";
  data.write("left.yaml", camera);
  data.write("right.yml", camera + "R: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [-0.2, 0, 0]\n");
  ImagesOpened pair(data, pairWith({{"calibration", std::string("left.yaml")},
                                    {"calibration_right", std::string("right.yml")}}));
  CHECK(pair.message.empty());
  RawRig rig;
  REQUIRE(pair.source.rawRig(rig).isOk());
  REQUIRE(rig.cameras.size() == 2);
  CHECK(rig.cameras[1].T_reference_camera.translation().x() == 0.2);
  CHECK_FALSE(pair.info.rig.calibrated);
  CHECK_FALSE(pair.info.rig.isStereo());
  data.write("left.yaml", "nothing: here\n");
  CHECK_THAT(ImagesOpened(data, pairWith({{"calibration", std::string("left.yaml")}})).message,
             Catch::StartsWith("DATA/left.yaml: is no calibration of Kalibr"));
}

TEST_CASE("stamps in other units, and in the names of the images") {
  const DataFolder data;
  data.write("us.txt", "1403715273262142\n1403715273312143\n1403715273362142\n1403715273412143\n");
  const auto stamps = [&](ParameterValues values) {
    values["left"] = std::string("image_0");
    const ImagesOpened opened(data, std::move(values));
    INFO(opened.message);
    REQUIRE(opened.frames.size() == 4);
    return opened.frames[1].stamp_ns;
  };
  CHECK(stamps({{"stamps", std::string("us.txt")}, {"stamps_unit", std::string("us")}}) ==
        1403715273312143000);
  CHECK(stamps({{"stamps_in_names", true}, {"stamps_unit", std::string("ms")}}) == 1'000'000);
  const ImagesOpened seconds(data,
                             {{"left", std::string("image_0")}, {"stamps", std::string("us.txt")}});
  CHECK_THAT(seconds.message, Catch::Contains("or set stamps_unit (of `images`) to ns or us"));
  data.writeImage("image_0/later.png", 64, 48);
  const ImagesOpened unnamed(data, {{"left", std::string("image_0")}, {"stamps_in_names", true}});
  CHECK_THAT(unnamed.message, Catch::Contains("later.png: its name is no time in seconds"));
}

TEST_CASE("a pair is in the order of the times in the names, on both sides") {
  const DataFolder data;
  const std::vector<std::string> names = {"1e-1", "0.05", "2e-1", "0.15"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (const char* folder : {"image_0/", "image_1/"}) {
      std::filesystem::rename(data.path(folder + ("00000" + std::to_string(i) + ".png")),
                              data.path(folder + names[i] + ".png"));
    }
  }
  const ImagesOpened plain(data, pairWith({{"fx", 40.0}, {"baseline", 0.2}}));
  const ImagesOpened timed(data,
                           pairWith({{"fx", 40.0}, {"baseline", 0.2}, {"stamps_in_names", true}}));
  CHECK(timed.message.empty());
  const DataFolder original;
  const ImagesOpened unnamed(original, pairWith({{"fx", 40.0}, {"baseline", 0.2}}));
  const std::vector<std::size_t> wanted = {1, 0, 3, 2};
  REQUIRE(timed.frames.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(timed.frames[i].stamp_ns == static_cast<std::int64_t>(i + 1) * 50'000'000);
    for (const ImagesOpened* opened : {&plain, &timed}) {
      const Frame& frame = opened->frames[i];
      const Frame& same = unnamed.frames[wanted[i]];
      CHECK(std::equal(frame.left.row(0), frame.left.row(0) + 64, same.left.row(0)));
      CHECK(std::equal(frame.right.row(0), frame.right.row(0) + 64, same.right.row(0)));
    }
  }
  std::filesystem::rename(data.path("image_0/2e-1.png"), data.path("image_0/0.10.png"));
  const ImagesOpened twice(data, {{"left", std::string("image_0")}, {"stamps_in_names", true}});
  CHECK(twice.message ==
        "DATA/image_0/1e-1.png: its name is the same time as that of 0.10.png; correct one of the "
        "names, or remove one of the images");
}

TEST_CASE("stamps from a file") {
  const DataFolder data;
  ParameterValues values = {{"left", std::string("image_0")},
                            {"stamps", std::string("frames.csv")},
                            {"stamps_column", std::string("t")}};
  data.write("frames.csv", "name,t\na,0.5\nb,0.75\nc,1\nd,2\n");
  const ImagesOpened mono(data, values);
  CHECK(mono.message.empty());
  CHECK(mono.frames[1].stamp_ns == 750'000'000);
  data.write("frames.csv", "name,t\na,0.5\nb,0.75\n");
  CHECK(ImagesOpened(data, values).message ==
        "DATA/frames.csv: has 2 entries, but there are 4 images; one line per image is needed");
}

TEST_CASE("a warning is listed and told in the log, and the run goes on") {
  const DataFolder data;
  data.write("ms.txt", "0\n8\n16\n24\n");
  test::TestContext services({{"path", data.path().string()},
                              {"left", std::string("image_0")},
                              {"stamps", std::string("ms.txt")}});
  ImagesSource source;
  REQUIRE(source.configure(services).isOk());
  const std::string warning = data.path("ms.txt").string() +
                              ": has images 8.0 s apart (median); if the times are in "
                              "milliseconds, divide them by 1000";
  CHECK(services.log == std::vector<std::string>{warning});
  std::vector<Finding> findings;
  REQUIRE(source.inspect(findings).isOk());
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].severity == Finding::Severity::Warning);
  CHECK(findings[0].where + ": " + findings[0].message == warning);
  CHECK(findings[1].severity == Finding::Severity::Note);
}

TEST_CASE("contradictions are refused") {
  const DataFolder data;
  CHECK(ImagesOpened(data, kPair).message ==
        "two cameras need a calibration; give the file, or fx and baseline");
  CHECK(ImagesOpened(data, pairWith({{"fx", 40.0}})).message ==
        "two cameras need a calibration; give the file, or fx and baseline");
  CHECK(ImagesOpened(data, {{"baseline", 0.2}}).message ==
        "baseline is given without right; name the right folder");
  CHECK(ImagesOpened(data, pairWith({{"calibration", std::string("calib.txt")}, {"fx", 4.0}}))
            .message == "calibration and fx or baseline are both given; keep one");
  CHECK(ImagesOpened(data, {{"stamps_column", std::string("t")}}).message ==
        "stamps_column is given without stamps; name the file");
  CHECK(
      ImagesOpened(data, {{"left", std::string("image_0")}, {"fx", 40.0}, {"cx", 640.0}}).message ==
      "cx, cy: principal point (640.0, 23.5) is outside of the 64x48 image; give the calibration "
      "of these images");
}

TEST_CASE("folders of unequal counts") {
  const DataFolder data;
  data.remove("image_0/000000.png");
  CHECK(ImagesOpened(data, pairWith({{"calibration", std::string("calib.txt")}})).message ==
        "DATA/image_0: has no 000000, the partner of image_1/000000.png; restore it, or remove the "
        "partner");
}

}  // namespace tolman::image_folders
