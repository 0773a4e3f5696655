// SPDX-License-Identifier: BSD-3-Clause
// MP4, MOV and Matroska files with damage that FFmpeg reads over: each is told after the pictures
// that can be read, and the sound file is not.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "matroska_check.hpp"
#include "mp4_check.hpp"
#include "stream_checks.hpp"
#include "support/data.hpp"
#include "time_gaps.hpp"
#include "video_encoder.hpp"
#include "video_maker.hpp"

namespace tolman::video {
namespace {

constexpr int kPictures = 12;

std::vector<cv::Mat> flatPictures() {
  std::vector<cv::Mat> pictures;
  for (int i = 0; i < kPictures; ++i) pictures.push_back(flatPicture(i));
  return pictures;
}

/// A pattern that moves, so that pictures are coded as changes of those before.
std::vector<cv::Mat> movingPictures() {
  cv::Mat pattern(48, 64 + kPictures, CV_8UC1);
  cv::RNG(5).fill(pattern, cv::RNG::UNIFORM, 40, 200);
  std::vector<cv::Mat> pictures;
  for (int i = 0; i < kPictures; ++i) pictures.push_back(pattern.colRange(i, i + 64).clone());
  return pictures;
}

std::string logOf(const Played& played) {
  std::string all;
  for (const std::string& line : played.context.log) all += line + "\n";
  return all;
}

std::vector<bool> haveImages(const Played& played) {
  std::vector<bool> have;
  for (const Frame& frame : played.frames) have.push_back(!frame.left.empty());
  return have;
}

/// A video whose bytes are changed.
class Container {
 public:
  Container(const std::string& name, const std::string& codec, const Options& codec_options = {},
            const Options& container_options = {},
            const std::vector<cv::Mat>& pictures = flatPictures())
      : file_(folder_.path() / name) {
    encodeVideo(file_, codec, pictures, codec_options, container_options);
    std::ifstream stream(file_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
  }

  /// Where `text` begins for the time `index`, from 0 on.
  std::size_t find(const std::string& text, int index = 0) const {
    std::size_t at = bytes_.find(text);
    for (int i = 0; i < index; ++i) at = bytes_.find(text, at + 1);
    REQUIRE(at != std::string::npos);
    return at;
  }
  const std::string& bytes() const { return bytes_; }
  const std::filesystem::path& file() const { return file_; }

  Played play(const std::string& bytes, const ParameterValues& values = {}) const {
    std::ofstream(file_, std::ios::binary) << bytes;
    return Played(file_, values);
  }
  Played playWith(std::size_t at, const std::string& replaced) const {
    std::string changed = bytes_;
    return play(changed.replace(at, replaced.size(), replaced));
  }

 private:
  test::TemporaryFolder folder_;
  std::filesystem::path file_;
  std::string bytes_;
};

/// Each picture in a fragment of its own.
Container inFragments() {
  return {
      "video.mp4", "mjpeg", {}, {{"movflags", "frag_every_frame+empty_moov+default_base_moof"}}};
}

std::string bigEndian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes += static_cast<char>((number >> shift) & 0xffU);
  }
  return bytes;
}

/// Adds a box `mehd`, the length of all fragments in ms, which FFmpeg does not write.
std::string withLength(const Container& video, std::uint32_t length_ms) {
  const std::string box = bigEndian(16) + "mehd" + bigEndian(0) + bigEndian(length_ms);
  std::string bytes = video.bytes();
  for (const char* parent : {"moov", "mvex"}) {
    const std::size_t size = video.find(parent) - 4;
    const auto low = static_cast<unsigned char>(bytes[size + 3]) + box.size();
    const auto high = static_cast<unsigned char>(bytes[size + 2]) + low / 256;
    bytes[size + 3] = static_cast<char>(low % 256);
    bytes[size + 2] = static_cast<char>(high);
  }
  return bytes.insert(video.find("mvex") + 4, box);
}

using Catch::Contains;
const std::string kRemedy =
    ", and pictures can be missing; copy or record it again, or use what can be read by "
    "on_corrupt: skip";

}  // namespace

TEST_CASE("sound containers of FFmpeg's writers have no defect") {
  for (const char* name : {"a.mp4", "a.mov", "a.mkv", "a.avi", "a.ts"}) {
    for (const char* codec : {"mjpeg", "mpeg4", "libx264", "libx265"}) {
      const std::string both = std::string(name) + " " + codec;
      if (both == "a.ts mjpeg" || both == "a.avi libx265") continue;  // FFmpeg cannot read them
      CAPTURE(name, codec);
      const Options reordered = {{"bf", std::string_view(codec) == "mjpeg" ? "0" : "2"},
                                 {"x265-params", "log-level=none"}};
      const Container video(name, codec, reordered);
      const Played played = video.play(video.bytes());
      CHECK(played.message.empty());
      CHECK(played.context.log.empty());
      REQUIRE(played.frames.size() == kPictures);
      CHECK(played.stamps().back() == (kPictures - 1) * 100'000'000LL);
    }
  }
}

TEST_CASE("an MP4 file in fragments, damaged in one of them") {
  const Container video = inFragments();
  CHECK(video.play(video.bytes()).message.empty());
  const std::size_t fifth = video.find("moof", 4);
  const auto inFifth = [&](const char* box) { return video.bytes().find(box, fifth); };
  const Played type = video.playWith(fifth, "noof");
  CHECK(type.message == "video.mp4: is damaged: the box 'noof' at byte " +
                            std::to_string(fifth - 4) + " is of no known type" + kRemedy);
  CHECK(type.frames.size() == kPictures - 1);
  const Played size = video.playWith(fifth - 4, bigEndian(0x20000000));
  CHECK_THAT(size.message, Contains("is damaged at byte " + std::to_string(fifth - 4)));
  CHECK(size.frames.size() < kPictures);
  CHECK_THAT(video.playWith(inFifth("traf"), "xraf").message, Contains("'xraf'"));
  CHECK_THAT(video.playWith(inFifth("trun"), "xrun").message, Contains("'xrun'"));
  CHECK_THAT(video.playWith(inFifth("trun") + 8, bigEndian(0)).message,
             Contains("are of no picture"));
  CHECK_THAT(video.playWith(fifth - 4, std::string(64, '\0')).message, Contains("is damaged"));
}

TEST_CASE("an MP4 file in fragments that are missing, doubled or not in order") {
  const Container video = inFragments();
  const std::size_t third = video.find("moof", 2) - 4;
  const std::size_t fourth = video.find("moof", 3) - 4;
  const std::size_t fifth = video.find("moof", 4) - 4;
  std::string missing = video.bytes();
  missing.erase(third, fourth - third);
  CHECK(video.play(missing).message ==
        "video.mp4: is damaged: fragment 4 follows fragment 2, so that others are missing or not "
        "in order" +
            kRemedy);
  // The remedy that the message names.
  const Played used = video.play(missing, {{"on_corrupt", std::string("skip")}});
  CHECK(used.message.empty());
  CHECK(used.frames.size() == kPictures - 1);
  CHECK(used.context.log.size() == 1);
  std::string numbers = video.bytes();
  numbers.replace(video.find("mfhd", 3) + 8, 4, bigEndian(3));
  CHECK_THAT(video.play(numbers).message, Contains("fragment 3 follows fragment 3"));
  std::string swapped = video.bytes();
  const std::string moved = swapped.substr(third, fourth - third);
  swapped.erase(third, fourth - third).insert(fifth - moved.size(), moved);
  CHECK_FALSE(video.play(swapped).message.empty());
}

TEST_CASE("an MP4 file in fragments that ends before the length in its header") {
  const Container video = inFragments();
  CHECK(video.play(withLength(video, kPictures * 100)).message.empty());
  CHECK_THAT(video.play(withLength(video, (kPictures + 2) * 100)).message,
             Contains("ends before the end that its header promises, after 12 sound ones"));
}

TEST_CASE("tables of an MP4 file that have different numbers of pictures") {
  const Container video("video.mp4", "mjpeg");
  CHECK(video.play(video.bytes()).message.empty());
  // The only entry of the durations: how many pictures have the same.
  CHECK_THAT(video.playWith(video.find("stts") + 12, bigEndian(7)).message,
             Contains("is damaged: its table of times has 7 pictures, and that of their sizes 12"));
  CHECK_THAT(
      video.playWith(video.find("stsc") + 16, bigEndian(5)).message,
      Contains("is damaged: its table of places has 5 pictures, and that of their sizes 12"));
}

TEST_CASE("a Matroska file with damage in one cluster") {
  const Container video("video.mkv", "mjpeg", {}, {{"cluster_time_limit", "1"}});
  CHECK(video.play(video.bytes()).message.empty());
  const std::string cluster = "\x1f\x43\xb6\x75";
  const std::size_t fifth = video.find(cluster, 4);
  const Played id = video.playWith(fifth, "\x1e");
  CHECK(id.message == "video.mkv: is damaged: the element at byte " + std::to_string(fifth) +
                          " is of no known kind" + kRemedy);
  CHECK(id.frames.size() < kPictures);
  const std::string zeros(16, '\0');
  CHECK_THAT(video.playWith(fifth, zeros).message,
             Contains("at byte " + std::to_string(fifth) + ": no whole element begins there"));
  const std::size_t picture = video.bytes().find("\xff\xd8", fifth) + 200;
  const std::string bit(1, static_cast<char>(video.bytes()[picture] ^ 1));
  CHECK_FALSE(video.playWith(picture, bit).message.empty());
  std::string missing = video.bytes();
  missing.erase(fifth, video.find(cluster, 5) - fifth);
  CHECK_FALSE(video.play(missing).message.empty());
}

TEST_CASE("check sums of a Matroska file, of its clusters or of HEVC pictures") {
  const Container video("video.mkv", "libx264", {}, {{"cluster_time_limit", "1"}});
  const std::size_t cluster = video.find("\x1f\x43\xb6\x75");
  const std::size_t sum = video.bytes().find("\xbf\x84", cluster);
  REQUIRE(sum < cluster + 16);
  const std::string other(1, static_cast<char>(video.bytes()[sum + 2] ^ 1));
  CHECK(video.playWith(sum + 2, other).message == "video.mkv: is damaged: the check sum at byte " +
                                                      std::to_string(sum) + " does not match" +
                                                      kRemedy);
  const Container hashed("video.mp4", "libx265", {{"x265-params", "hash=1:log-level=none"}});
  CHECK(hashed.play(hashed.bytes()).message.empty());
  // The message of the sum: unit of type 40, one byte for the kind and 16 for each of three planes.
  const std::size_t md5 = hashed.find(std::string("\x50\x01\x84\x31\x00", 5), 3) + 9;
  const std::string changed(1, static_cast<char>(hashed.bytes()[md5] ^ 1));
  CHECK_THAT(hashed.playWith(md5, changed).message, Contains("is damaged"));
}

TEST_CASE("check sums of FFV1 pictures") {
  const bool has_sums = GENERATE(true, false);
  const Container video("video.mkv", "ffv1",
                        {{"level", "3"}, {"slicecrc", has_sums ? "1" : "0"}, {"slices", "4"}},
                        {{"cluster_time_limit", "1"}});
  CHECK(video.play(video.bytes()).message.empty());
  // One bit of the first or a later picture; the container's sum is known at the end only.
  for (const int picture : {0, 4}) {
    const std::size_t cluster = video.find("\x1f\x43\xb6\x75", picture);
    const std::size_t block = video.bytes().find("\xa3", video.bytes().find("\xe7", cluster) + 3);
    const std::string bit(1, static_cast<char>(video.bytes()[block + 12] ^ 1));
    const Played damaged = video.playWith(block + 12, bit);
    CHECK(damaged.frames.size() ==
          (has_sums ? static_cast<std::size_t>(std::max(picture, 1)) : 12));
    CHECK_THAT(damaged.message,
               Contains(has_sums ? "a check sum of its data" : "the check sum at byte"));
  }
}

TEST_CASE("a recording that begins between two pictures that are coded by themselves") {
  const Options six = {{"g", "6"}, {"bf", "0"}, {"sc_threshold", "1000000000"}};
  const Container mpeg2("video.ts", "mpeg2video", six, {}, movingPictures());
  constexpr std::size_t kFirstPicture = 8 * 188;  // bytes, with the header
  const Played played = mpeg2.play(mpeg2.bytes().substr(kFirstPicture));
  CHECK(played.message.empty());
  CHECK(played.frames.size() == 6);
  REQUIRE(played.context.log.size() == 1);
  CHECK_THAT(
      played.context.log[0],
      Contains("no picture came of 5 of its 11 coded pictures: they are damaged, or changes of "
               "one before the first"));
}

TEST_CASE("pictures that were coded as changes of a damaged one are left out with it") {
  const Container video("video.mp4", "libx264", {{"g", "6"}, {"bf", "0"}}, {}, movingPictures());
  constexpr std::size_t kEncoderText = 700;  // bytes before the first picture
  const std::size_t first = video.find("mdat") + 4 + kEncoderText;
  const std::size_t damaged = first + (video.find("moov") - first) / 6;
  std::string bytes = video.bytes();
  for (std::size_t at = damaged; at < damaged + 40; ++at) bytes[at] ^= 0x55;
  const Played skipped = video.play(bytes, {{"on_corrupt", std::string("skip")}});
  CHECK(skipped.message.empty());
  CHECK(haveImages(skipped) ==
        std::vector{false, false, false, false, false, false, true, true, true, true, true, true});
  CHECK_THAT(skipped.frames[0].defect, Contains("picture 0 is damaged"));
  CHECK_THAT(skipped.frames[5].defect,
             Contains("picture 5 was coded as a change of one that is damaged or missing"));
}

TEST_CASE("a Flash file with a damaged tag") {
  const Container video("video.flv", "flv", {}, {}, movingPictures());
  CHECK(video.play(video.bytes()).message.empty());
  std::string bytes = video.bytes();
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), 4096, '\0');
  CHECK_FALSE(video.play(bytes).message.empty());
  ContainerBytes file(video.file());
  CHECK_THAT(defectOfFlv(file), Contains("no whole tag begins there"));
}

TEST_CASE("a hole in a container is told by the gap in time as well") {
  const Container video("video.mkv", "mjpeg", {}, {{"cluster_time_limit", "1"}});
  const std::string cluster = "\x1f\x43\xb6\x75";
  const std::size_t begin = video.find(cluster, 3);
  const std::string hole(video.find(cluster, 9) - begin, '\0');
  std::string bytes = video.bytes();
  const Played used =
      video.play(bytes.replace(begin, hole.size(), hole), {{"on_corrupt", std::string("skip")}});
  CHECK(used.frames.size() == kPictures - 6);
  CHECK_THAT(logOf(used), Contains("pictures 2 and 3 are 0.7 s apart, and others 0.1 s"));
}

TEST_CASE("an Ogg file with a damaged, missing or doubled page") {
  const Container video("video.ogg", "libtheora", {{"g", "1"}}, {{"page_duration", "1"}},
                        movingPictures());
  CHECK(video.play(video.bytes()).message.empty());
  const std::size_t sixth = video.find("OggS", 5);
  const std::size_t seventh = video.find("OggS", 6);
  const std::string bit(1, static_cast<char>(video.bytes()[seventh - 20] ^ 1));
  CHECK_THAT(video.playWith(seventh - 20, bit).message,
             Contains("is damaged at byte " + std::to_string(sixth) +
                      ": the check sum of a page does not match"));
  CHECK_THAT(video.playWith(sixth, "Pgg").message, Contains(": no whole page begins there"));
  std::string missing = video.bytes();
  missing.erase(sixth, seventh - sixth);
  CHECK_THAT(video.play(missing).message, Contains(": pages before are missing"));
}

TEST_CASE("two MP4 files that were joined byte by byte") {
  const Container video("video.mp4", "mjpeg");
  CHECK_THAT(video.play(video.bytes() + video.bytes()).message,
             Contains("has a second header, the box 'moov' at byte"));
}

TEST_CASE("grey pictures of 16 bits that use fewer") {
  std::vector<cv::Mat> pictures;
  for (int i = 0; i < kPictures; ++i) {
    pictures.emplace_back(48, 64, CV_16UC1, cv::Scalar(300 * i + 16));
  }
  const Container video("video.mkv", "ffv1", {{"level", "3"}}, {}, pictures);
  const Played dark = video.play(video.bytes());
  REQUIRE(dark.frames.size() == kPictures);
  CHECK(dark.frames[10].left.data()[0] == 3016 / 256);
  REQUIRE(dark.context.log.size() == 1);
  CHECK_THAT(dark.context.log[0],
             Contains("video.mkv: the values of the first 10 images of 16 bits "
                      "stay below 4096") &&
                 Contains("set source.bits=12"));
  const Played right = video.play(video.bytes(), {{"bits", 12}});
  CHECK(right.frames[10].left.data()[0] == 3016 / 16);
  CHECK(right.context.log.empty());
}

TEST_CASE("the longest gap between times") {
  TimeGaps gaps;
  CHECK(gaps.warning().empty());
  std::int64_t time = 0;
  for (int i = 0; i < 20; ++i) gaps.add(time += 100'000'000);
  for (int i = 0; i < 20; ++i) gaps.add(time += 200'000'000);  // a longer exposure
  CHECK(gaps.warning().empty());
  gaps.add(time + 1'200'000'000);
  CHECK(gaps.warning() ==
        "pictures 39 and 40 are 1.2 s apart, and others 0.2 s: if the camera did not pause there, "
        "the file is damaged; copy or record it again");
}

TEST_CASE("elements that hold each other without end do not exhaust the stack") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "deep.mkv";
  std::string bytes = "\x18\x53\x80\x67\xff\x16\x54\xae\x6b\xff";
  for (int i = 0; i < 200'000; ++i) bytes += "\xae\xff";
  std::ofstream(file, std::ios::binary) << bytes;
  ContainerBytes deep(file);
  CHECK(defectOfMatroska(deep).empty());
  std::string boxes;
  for (int i = 0; i < 200'000; ++i) boxes += bigEndian(0) + "moov";
  std::ofstream(file, std::ios::binary) << boxes;
  ContainerBytes nested(file);
  CHECK(checkMp4(nested).defect.empty());
}

}  // namespace tolman::video
