// SPDX-License-Identifier: BSD-3-Clause
// Files that are damaged, truncated or not videos: one clear error each, and all undamaged pictures
// before it.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "support/data.hpp"
#include "video_maker.hpp"

namespace tolman::video {
namespace {

std::vector<std::string> findings(const std::filesystem::path& path, ParameterValues values = {}) {
  Played played(path, std::move(values));
  std::vector<Finding> found;
  REQUIRE(played.source.inspect(found).isOk());
  std::vector<std::string> texts;
  for (const Finding& finding : found) {
    texts.push_back(std::string(enumName(finding.severity)) + ": " + finding.message);
  }
  return texts;
}

/// The same pictures, of noise, so that their data are long.
void writeNoise(const std::filesystem::path& file, const std::string& codec, int count = 30) {
  std::vector<cv::Mat> pictures;
  cv::RNG random(3);
  for (int i = 0; i < count; ++i) {
    cv::Mat picture(120, 160, CV_8UC1);
    random.fill(picture, cv::RNG::UNIFORM, 0, 255);
    pictures.push_back(picture);
  }
  writeVideo(file, codec, 25, pictures);
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Where picture `index` of an AVI file begins.
std::size_t chunkOf(const std::string& bytes, int index) {
  std::size_t at = bytes.find("movi");
  for (int i = 0; i <= index; ++i) at = bytes.find("00dc", at + 4);
  REQUIRE(at != std::string::npos);
  return at;
}

}  // namespace

TEST_CASE("what is no video is refused with a remedy") {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "text.mp4") << "Dear diary,\n";
  const Played text(folder.path() / "text.mp4");
  CHECK(text.message ==
        "text.mp4: is no video that FFmpeg can read (Invalid data found when processing input); if "
        "it is one, it is cut off or damaged: copy or record it again");
  const auto found = findings(folder.path() / "text.mp4");
  REQUIRE(found.size() == 1);
  CHECK(found[0].starts_with("error: "));
  writeNoise(folder.path() / "late.mp4", "mp4v");
  cutFile(folder.path() / "late.mp4", 0.5);  // the table of pictures is at the end
  CHECK(Played(folder.path() / "late.mp4").message.starts_with("late.mp4: is no video"));
}

TEST_CASE("a recording that ends in the middle of a picture") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.avi";
  writeNoise(file, "MJPG");
  cutFile(file, 0.5);
  const Played stopped(file);
  const auto sound = stopped.frames.size();
  REQUIRE(sound > 8);
  REQUIRE(sound < 20);
  const std::string number = std::to_string(sound);
  CHECK(stopped.message == "video.avi: picture " + number +
                               " is damaged: its data are not complete; copy or record it again, "
                               "or leave it out by on_corrupt: skip");
  const Played skipped(file, {{"on_corrupt", std::string("skip")}});
  CHECK(skipped.message.empty());
  REQUIRE(skipped.frames.size() == sound + 1);
  CHECK(skipped.frames.back().left.empty());
  CHECK_FALSE(skipped.frames.back().defect.empty());
  REQUIRE(skipped.context.log.size() == 1);
  CHECK(skipped.context.log[0].find("ends in the middle of a picture, after " + number +
                                    " sound ones") != std::string::npos);
  // The remedy that the message names.
  const Played used(file, {{"last", static_cast<std::int64_t>(sound) - 1}});
  CHECK(used.message.empty());
  CHECK(used.frames.size() == sound);
  CHECK(findings(file).size() == 3);
}

TEST_CASE("a recording that ends between two pictures, before the end that it promises") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.mkv";
  writeNoise(file, "FFV1");
  cutFile(file, 0.5);
  const Played stopped(file);
  const auto sound = stopped.frames.size();
  REQUIRE(sound > 8);
  CHECK(stopped.message ==
        "video.mkv: ends before the end that its header promises, after " + std::to_string(sound) +
            " sound ones; copy or record it again, or set last: " + std::to_string(sound - 1) +
            " to use those");
  // The other orders know it before the first frame.
  CHECK(Played(file, {{"order", std::string("backward")}}).frames.empty());
  const Played backward(
      file, {{"order", std::string("backward")}, {"last", static_cast<std::int64_t>(sound) - 1}});
  CHECK(backward.message.empty());
  CHECK(backward.frames.size() == sound);
}

TEST_CASE("an AVI file that lacks pictures at its end, or in the middle") {
  for (const int pictures : {9, 15, 28}) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "video.avi";
    writeNoise(file, "MJPG");
    const std::string bytes = bytesOf(file);
    std::ofstream(file, std::ios::binary) << bytes.substr(0, chunkOf(bytes, pictures));
    CHECK(Played(file).message ==
          "video.avi: has " + std::to_string(pictures) +
              " pictures, and its header promises 30: they are missing at the end, or in the "
              "middle, and then the times of all that follow are wrong; copy or record it again");
  }
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.avi";
  writeNoise(file, "MJPG");
  const std::string bytes = bytesOf(file);
  const auto at = [&](int index) {
    return bytes.begin() + static_cast<std::ptrdiff_t>(chunkOf(bytes, index));
  };
  const auto losePictures = [&](int first, int last) {
    std::string damaged = bytes;
    std::fill(damaged.begin() + (at(first) - bytes.begin()),
              damaged.begin() + (at(last) - bytes.begin()), '\0');
    std::ofstream(file, std::ios::binary) << damaged;
  };
  losePictures(10, 13);
  CHECK_THAT(Played(file).message, Catch::StartsWith("video.avi: has 27 pictures"));
  losePictures(10, 11);  // one that the index names
  CHECK_THAT(Played(file).message, Catch::StartsWith("video.avi: has 29 pictures"));
}

TEST_CASE("a picture that is damaged in the middle of a sound file") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.avi";
  writeNoise(file, "MJPG");
  {
    std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file) / 2));
    const std::string zeros(3000, '\0');
    bytes.write(zeros.data(), static_cast<std::streamsize>(zeros.size()));
  }
  const Played skipped(file, {{"on_corrupt", std::string("skip")}});
  CHECK(skipped.message.empty());
  CHECK(skipped.frames.size() >= 28);
}

TEST_CASE("a picture of a Motion JPEG that has lost its second half, with or without its end") {
  const bool keeps_end = GENERATE(false, true);
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.avi";
  writeNoise(file, "MJPG");
  std::string bytes = bytesOf(file);
  const std::size_t chunk = chunkOf(bytes, 18);
  const std::size_t next = chunkOf(bytes, 19);
  const std::size_t half = (chunk + next) / 2;
  const std::size_t end = keeps_end ? bytes.rfind("\xff\xd9", next) : next;
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(half),
            bytes.begin() + static_cast<std::ptrdiff_t>(end), '\0');
  std::ofstream(file, std::ios::binary) << bytes;
  CHECK_THAT(Played(file).message, Catch::Contains("picture 18 is damaged"));
  const Played skipped(file, {{"on_corrupt", std::string("skip")}});
  REQUIRE(skipped.frames.size() == 30);
  CHECK(skipped.frames[18].left.empty());
  CHECK_FALSE(skipped.frames[19].left.empty());
}

TEST_CASE("a Y4M stream that ends in the middle of a picture") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.y4m";
  constexpr std::size_t kPixels = 64 * 48;
  std::string bytes = "YUV4MPEG2 W64 H48 F10:1 Cmono\n";
  for (int i = 0; i < 12; ++i)
    bytes += "FRAME\n" + std::string(kPixels, static_cast<char>(100 + i));
  const ParameterValues rate = {{"rate", 10.0}};
  const auto write = [&](std::size_t lost) {
    std::ofstream(file, std::ios::binary) << bytes.substr(0, bytes.size() - lost);
  };
  write(0);
  const Played whole(file, rate);
  CHECK(whole.message.empty());
  CHECK(whole.frames.size() == 12);
  for (const std::size_t lost : {std::size_t{1}, kPixels - 1, 5 * kPixels}) {
    CAPTURE(lost);
    write(lost);
    CHECK_THAT(Played(file, rate).message, Catch::Contains("ends in the middle of a picture"));
  }
  write(kPixels + 6);  // between two pictures: nothing tells
  CHECK(Played(file, rate).frames.size() == 11);
}

TEST_CASE("raw streams say no times, and none are invented") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.m2v";
  writeFlatVideo(file, 12, 25, "MPG2");
  CHECK(Played(file).message == "video.m2v: says no time of picture 0; set rate");
  const Played timed(file, {{"rate", 25.0}});
  CHECK(timed.message.empty());
  CHECK(timed.stamps().at(11) == 11 * 40'000'000LL);
  const auto found = findings(file);
  REQUIRE(found.size() == 2);
  CHECK(found[1] == "error: says no times of its pictures; set rate");
}

}  // namespace tolman::video
