// SPDX-License-Identifier: BSD-3-Clause
// Damaged sequences: what cannot be used at all is a failure, the rest findings, and the run can go
// on with what is sound.
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "data_folder.hpp"
#include "image_file.hpp"

namespace tolman::image_folders {
namespace {

using Kitti = Opened<KittiParameters>;

}  // namespace

TEST_CASE("what cannot be used at all is refused before frame 0") {
  const DataFolder data;
  CHECK(Kitti(data, {{"path", data.path("image_0").string()}}).message ==
        "DATA/image_0: has neither image_0 nor image_2; set path to a sequence, such as "
        ".../sequences/06, or take the source of another layout (`tolman init` finds it)");
  const auto refusal = [&](const char* file, const std::string& text) {
    const std::string sound = data.read(file);
    data.write(file, text);
    const std::string message = Kitti(data).message;
    data.write(file, sound);
    return message;
  };
  CHECK(refusal("calib.txt", "") == "DATA/calib.txt: has no P0; restore the file");
  CHECK_THAT(refusal("calib.txt", matrixLine("P0", 0) + matrixLine("P1", 25)),
             Catch::StartsWith("DATA/calib.txt: has a baseline of -0.5 m"));
  CHECK_THAT(refusal("calib.txt", matrixLine("P0", 0) + matrixLine("P1", -25000)),
             Catch::StartsWith("DATA/calib.txt: has a baseline of 500 m"));
  CHECK(refusal("calib.txt", "P0: 700 0 600 0 0 700 180 0 0 0 1 0\n" + matrixLine("P1", -25)) ==
        "DATA/calib.txt: has rectified cameras of different focal lengths or centres; calibrate "
        "them as a pair");
  CHECK(refusal("times.txt", "0.0\nabc\n") ==
        "DATA/times.txt:2: 'abc' is no time in s from 0; correct it, or set stamps_unit (of "
        "`images`)");
  data.remove("calib.txt");
  CHECK(Kitti(data).message == "DATA/calib.txt: is missing; restore it, or correct the path");
}

TEST_CASE("counts that differ, times that do not rise and a broken truth are findings") {
  const DataFolder data;
  std::string finding;
  std::size_t frames = 4;
  bool has_truth = true;
  SECTION("a missing right image") {
    data.remove("image_1/000002.png");
    finding =
        "error DATA/image_0/000002.png: has no partner of the same name from the other camera";
    frames = 3;
  }
  SECTION("a missing left image: times and poses may be of other images") {
    data.remove("image_0/000003.png");
    finding = "error DATA/times.txt: has 4 times, but there are 3 images";
    frames = 3;
    has_truth = false;
  }
  SECTION("times going back") {
    data.write("times.txt", "0.0\n0.2\n0.1\n0.3\n");
    finding =
        "error DATA/image_0/000002.png: has a time no later than the image before: time 3 of "
        "DATA/times.txt";
    frames = 3;
  }
  SECTION("too few times") {
    data.write("times.txt", "0.0\n0.2\n0.3\n");
    finding = "error DATA/times.txt: has 3 times, but there are 4 images";
    frames = 3;
    has_truth = false;
  }
  SECTION("milliseconds") {
    data.write("times.txt", "0\n100\n200\n300\n");
    finding =
        "error DATA/image_0: has images 100 s apart (median), so the times are of another unit";
  }
  SECTION("NaN in the poses") {
    std::string poses = data.read("poses.txt");
    data.write("poses.txt", poses.replace(poses.find("2.5"), 3, "nan"));
    finding = "error truth: DATA/poses.txt:3: 'nan' is no finite number; correct the pose";
    has_truth = false;
  }
  SECTION("too many poses") {
    data.write("poses.txt", data.read("poses.txt") + "1 0 0 0 0 1 0 0 0 0 1 0\n");
    finding = "error DATA/poses.txt: has 5 poses, but there are 4 images";
    has_truth = false;
  }
  const Kitti run(data);
  CHECK(run.message.empty());
  CHECK(run.frames.size() == frames);
  CHECK(run.info.has_truth == has_truth);
  INFO((run.findings.empty() ? "" : run.findings[0]));
  CHECK(std::count(run.findings.begin(), run.findings.end(), finding) == 1);
}

TEST_CASE("a damaged image is a finding, and its frame has no images") {
  const DataFolder data;
  std::string expected;
  SECTION("truncated PNG") {
    data.truncate("image_1/000001.png", 0.5);
    expected = "DATA/image_1/000001.png: cannot be decoded, its data are damaged";
  }
  SECTION("changed pixels, found by the check sum") {
    std::string bytes = data.read("image_0/000001.png");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
    data.write("image_0/000001.png", bytes);
    expected = "DATA/image_0/000001.png: cannot be decoded, its data are damaged";
  }
  SECTION("no image") {
    data.write("image_0/000001.png", "garbage");
    expected = "DATA/image_0/000001.png: is neither a PNG nor a JPEG image";
  }
  SECTION("another size, right") {
    data.writeImage("image_1/000001.png", 32, 48);
    expected = "DATA/image_1/000001.png: has 32x48 pixels, but the first image has 64x48 pixels";
  }
  SECTION("truncated JPEG, which OpenCV takes for whole") {
    data.remove("image_0/000001.png");
    data.writeImage("image_0/000001.jpg", 64, 48);
    data.truncate("image_0/000001.jpg", 0.7);
    expected =
        "DATA/image_0/000001.jpg: cannot be decoded, its data are damaged (libjpeg: "
        "Premature end of JPEG file)";
  }
  const Kitti run(data);
  CHECK(run.message.empty());
  CHECK(run.findings == std::vector<std::string>{"error " + expected});
  CHECK(run.context.findings[0].kind == Finding::Kind::Damaged);
  REQUIRE(run.frames.size() == 4);
  CHECK(run.frames[1].left.empty());
  CHECK(run.frames[1].right.empty());
  CHECK(data.anonymous(run.frames[1].defect) == expected);
  CHECK(run.frames[1].stamp_ns == 100'000'000);
  CHECK(run.frames[2].defect.empty());
  CHECK_FALSE(run.frames[2].left.empty());
}

TEST_CASE("a folder without a readable image is refused, one with a damaged first image is not") {
  const DataFolder data;
  data.truncate("image_0/000000.png", 0.3);
  CHECK(Kitti(data).frames.size() == 4);
  for (const char* name : {"1", "2", "3"}) {
    data.write(std::string("image_0/00000") + name + ".png", "");
  }
  CHECK(Kitti(data).message ==
        "DATA/image_0/000000.png: cannot be decoded, its data are damaged, and so are all 4 "
        "images; copy or record them again");
}

TEST_CASE("an image that cannot be opened is a failure, not damage") {
  const DataFolder data;
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &before) == 0);
  const rlimit none = {0, before.rlim_max};
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &none) == 0);
  const Status status = readBytes(data.path("image_0/000000.png")).status();
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &before) == 0);
  CHECK(status.code() == StatusCode::Failed);
  CHECK(status.message() ==
        "cannot be read (Too many open files); check its permissions and the disk");
  CHECK(readBytes(data.path("none.png")).status().message() == "is missing");
}

TEST_CASE("an image that is stored turned is used as stored, with one warning") {
  const DataFolder data;
  // EXIF data with orientation 6, between the header of a JPEG and its first segment.
  const std::string exif(
      "\xff\xe1\0\x22"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36);
  for (const char* name : {"image_0/000001", "image_0/000002"}) {
    data.remove(std::string(name) + ".png");
    data.writeImage(std::string(name) + ".jpg", 64, 48);
    data.write(std::string(name) + ".jpg", data.read(std::string(name) + ".jpg").insert(2, exif));
  }
  const Kitti run(data);
  CHECK(run.frames[1].left.width() == 64);
  REQUIRE(run.findings.size() == 1);
  CHECK_THAT(run.findings[0], Catch::StartsWith("warning DATA/image_0/000001.jpg: is stored turned "
                                                "or mirrored (EXIF orientation)"));
}

TEST_CASE("garbage in any text file is an error, never a crash") {
  RandomStream random(5);
  for (const std::string name : {"calib.txt", "times.txt", "poses.txt"}) {
    const DataFolder data;
    const std::string sound = data.read(name);
    for (int i = 0; i < 40; ++i) {
      std::string text = sound;
      const std::uint64_t changes = 1 + random.below(20);
      for (std::uint64_t c = 0; c < changes; ++c) {
        text[random.below(text.size())] = static_cast<char>(random.below(256));
      }
      data.write(name, text);
      const Kitti run(data);
      CHECK((run.message.empty() || run.frames.empty()));
    }
    data.write(name, std::string(3000, '\xff'));
    const Kitti run(data);
    CHECK((run.message + (run.findings.empty() ? "" : run.findings[0])).find(name) !=
          std::string::npos);
  }
}

}  // namespace tolman::image_folders
