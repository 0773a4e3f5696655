// SPDX-License-Identifier: BSD-3-Clause
// Files that are damaged, truncated or not videos: what FFmpeg says becomes findings, and all sound
// pictures are given.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "support/data.hpp"
#include "video_encoder.hpp"
#include "video_maker.hpp"

namespace tolman::video {
namespace {

/// Pictures of noise, so that their data are long.
std::vector<cv::Mat> noise(int count = 30) {
  std::vector<cv::Mat> pictures;
  cv::RNG random(3);
  for (int i = 0; i < count; ++i) {
    cv::Mat picture(120, 160, CV_8UC1);
    random.fill(picture, cv::RNG::UNIFORM, 0, 255);
    pictures.push_back(picture);
  }
  return pictures;
}

std::size_t damagedFrames(const Played& played) {
  return static_cast<std::size_t>(
      std::count_if(played.frames.begin(), played.frames.end(),
                    [](const Frame& frame) { return !frame.defect.empty(); }));
}

/// Zeros in the middle of a file.
void damage(const std::filesystem::path& file, std::size_t bytes) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file) / 2));
  const std::string zeros(bytes, '\0');
  stream.write(zeros.data(), static_cast<std::streamsize>(zeros.size()));
}

}  // namespace

TEST_CASE("what is no video is refused with a remedy") {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "text.mp4") << "Dear diary,\n";
  CHECK(Played(folder.path() / "text.mp4").message ==
        "text.mp4: is no video that FFmpeg can read (Invalid data found when processing input); if "
        "it is one, it is cut off or damaged: copy or record it again");
  writeVideo(folder.path() / "late.mp4", "mp4v", 25, noise());
  cutFile(folder.path() / "late.mp4", 0.5);  // the table of pictures is at the end
  CHECK(Played(folder.path() / "late.mp4").message.starts_with("late.mp4: is no video"));
}

TEST_CASE("a recording that ends early gives its sound pictures and a finding") {
  const char* const name = GENERATE("video.avi", "video.mp4");
  const test::TemporaryFolder folder;
  const auto file = folder.path() / name;
  // With faststart the table of an MP4 file is at its begin, as in files for the web.
  encodeVideo(file, "mjpeg", noise(), {}, {{"movflags", "+faststart"}});
  CHECK(Played(file).context.findings.empty());
  cutFile(file, 0.6);
  const Played cut(file);
  CHECK(cut.message.empty());
  CHECK(cut.frames.size() > 8);
  CHECK(cut.frames.size() < 24);
  REQUIRE(!cut.context.findings.empty());
  CHECK(cut.context.findings.back().kind == Finding::Kind::Damaged);
  CHECK(damagedFrames(cut) <= 1);
}

TEST_CASE("damage in the middle is found by the decoder, or by the length in the header") {
  const std::string codec = GENERATE("mjpeg", "mpeg4");
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.mkv";
  encodeVideo(file, codec, noise());
  const Played sound(file);
  CHECK(sound.frames.size() == 30);
  CHECK(sound.context.findings.empty());
  damage(file, 3000);
  const Played damaged(file);
  CAPTURE(codec, damaged.frames.size(), damagedFrames(damaged), damaged.message);
  CHECK(damaged.frames.size() >= 5);
  CHECK((!damaged.message.empty() || !damaged.context.findings.empty()));
  if (codec == "mjpeg") CHECK(damaged.frames.back().source_index >= 28);  // a number for each
}

TEST_CASE("pictures that were coded as changes of a damaged one are left out with it") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.mp4";
  encodeVideo(file, "libx264", noise(12), {{"g", "6"}, {"bf", "0"}, {"sc_threshold", "0"}});
  std::ifstream stream(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  constexpr std::size_t kEncoderText = 700;  // bytes before the first picture
  const std::size_t first = bytes.find("mdat") + 4 + kEncoderText;
  for (std::size_t at = first + 200; at < first + 240; ++at) {
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
  }
  std::ofstream(file, std::ios::binary) << bytes;
  const Played damaged(file);
  REQUIRE(damaged.frames.size() == 12);
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    CHECK(damaged.frames[static_cast<std::size_t>(i)].left.empty() == (i < 6));
  }
  CHECK_THAT(damaged.frames[0].defect, Catch::Contains("picture 0 is damaged"));
  CHECK_THAT(damaged.frames[5].defect,
             Catch::Contains("picture 5 was coded as a change of one that is damaged or missing"));
}

TEST_CASE("raw streams state no times, and none are invented") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.m2v";
  writeFlatVideo(file, 12, 25, "MPG2");
  CHECK(Played(file).message == "video.m2v: does not state the time of picture 0; set rate");
  const Played timed(file, {{"rate", 25.0}});
  CHECK(timed.message.empty());
  CHECK(timed.stamps().at(11) == 11 * 40'000'000LL);
}

}  // namespace tolman::video
