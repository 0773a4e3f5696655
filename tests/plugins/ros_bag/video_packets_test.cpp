// SPDX-License-Identifier: BSD-3-Clause
// Cameras whose images are packets of H.264, as two kinds of messages have them.
#include <catch2/catch.hpp>
#include <cmath>

#include "bag_case.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/opt.h>
}

namespace tolman::ros_bag {
namespace {

constexpr int kSide = 64;   // px
constexpr int kGroup = 4;   // pictures
constexpr int kCount = 14;  // pictures; picture i is grey, of the value 30 + 10 i

struct Packet {
  std::string data;
  bool is_key = false;
};

/// Without pictures that need later ones. Empty where FFmpeg has no coder.
std::vector<Packet> coded() {
  const AVCodec* coder = avcodec_find_encoder_by_name("libx264");
  if (coder == nullptr) return {};
  AVCodecContext* context = avcodec_alloc_context3(coder);
  context->width = context->height = kSide;
  context->pix_fmt = AV_PIX_FMT_YUVJ420P;
  context->time_base = {1, 10};
  context->gop_size = kGroup;
  context->max_b_frames = 0;
  context->thread_count = 1;
  av_opt_set(context->priv_data, "tune", "zerolatency", 0);
  av_opt_set(context->priv_data, "x264-params", "scenecut=0:log=-1", 0);
  REQUIRE(avcodec_open2(context, coder, nullptr) >= 0);
  AVFrame* frame = av_frame_alloc();
  frame->format = context->pix_fmt;
  frame->width = frame->height = kSide;
  REQUIRE(av_frame_get_buffer(frame, 0) >= 0);
  AVPacket* packet = av_packet_alloc();
  std::vector<Packet> packets;
  for (int i = 0; i < kCount; ++i) {
    REQUIRE(av_frame_make_writable(frame) >= 0);
    for (int plane = 0; plane < 3; ++plane) {
      const int rows = plane == 0 ? kSide : kSide / 2;
      std::fill_n(frame->data[plane], frame->linesize[plane] * rows,
                  plane == 0 ? 30 + 10 * i : 128);
    }
    frame->pts = i;
    REQUIRE(avcodec_send_frame(context, frame) >= 0);
    while (avcodec_receive_packet(context, packet) >= 0) {
      packets.push_back(
          {{reinterpret_cast<const char*>(packet->data), static_cast<std::size_t>(packet->size)},
           (packet->flags & AV_PKT_FLAG_KEY) != 0});
      av_packet_unref(packet);
    }
  }
  av_packet_free(&packet);
  av_frame_free(&frame);
  avcodec_free_context(&context);
  REQUIRE(packets.size() == kCount);
  return packets;
}

test::RosMessage messageOf(const Packet& packet, int index, bool foxglove) {
  test::CdrWriter writer;
  writer.header(stampOf(index));
  if (foxglove) {
    writer.data(packet.data).text("h264");
    return {"/camera/video", std::string(kCompressedVideo), stampOf(index), writer.bytes()};
  }
  writer.number(std::int32_t{kSide}).number(std::int32_t{kSide}).text("libx264");
  writer.number(static_cast<std::uint64_t>(index));
  writer.number(static_cast<std::uint8_t>(packet.is_key)).number(std::uint8_t{0});
  writer.data(packet.data);
  return {"/camera/image_raw/ffmpeg", std::string(kVideoPacket), stampOf(index), writer.bytes()};
}

/// The mean value of each frame's image, -1 without one.
std::vector<int> greys(const Played& played) {
  std::vector<int> means;
  for (const Frame& frame : played.frames) {
    double sum = 0;
    for (int y = 0; y < frame.left.height(); ++y) {
      for (int x = 0; x < frame.left.width(); ++x) sum += frame.left.row(y)[x];
    }
    means.push_back(frame.left.empty() ? -1 : static_cast<int>(std::lround(sum / kSide / kSide)));
  }
  return means;
}

}  // namespace

TEST_CASE("packets of H.264 are images, in any order, from the first that can be decoded") {
  const std::vector<Packet> packets = coded();
  if (packets.empty()) return;
  for (const bool foxglove : {false, true}) {
    CAPTURE(foxglove);
    std::vector<test::RosMessage> messages;
    for (int i = 1; i < kCount; ++i) {  // the key of the first group was not recorded
      messages.push_back(messageOf(packets[static_cast<std::size_t>(i)], i, foxglove));
    }
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "video.mcap";
    test::writeBytes(file, test::mcapBytes(messages));
    const Played played(file);
    INFO(played.message);
    const std::vector<int> expected = {70, 80, 90, 100, 110, 120, 130, 140, 150, 160};
    const std::vector<int> found = greys(played);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(std::abs(found[i] - expected[i]) <= 2);
    REQUIRE(played.findings().size() == 1);
    CHECK(played.findings()[0].find("begins with 3 packets of video") != std::string::npos);
    std::vector<int> back = greys(Played(file, {{"order", std::string("backward")}}));
    std::reverse(back.begin(), back.end());
    CHECK(back == found);
    const std::vector<int> third = greys(Played(file, {{"step", std::int64_t{3}}}));
    CHECK(third == std::vector<int>{found[0], found[3], found[6], found[9]});
  }
}

TEST_CASE("a damaged packet takes the rest of its group with it, and no other picture") {
  std::vector<Packet> packets = coded();
  if (packets.empty()) return;
  packets[5].data.resize(3);
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < kCount; ++i) {
    messages.push_back(messageOf(packets[static_cast<std::size_t>(i)], i, false));
  }
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "video.mcap", test::mcapBytes(messages));
  const Played played(folder.path() / "video.mcap");
  REQUIRE(played.frames.size() == kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    CAPTURE(i);
    CHECK(played.frames[i].defect.empty() == (i < 5 || i >= 8));
  }
}

}  // namespace tolman::ros_bag
