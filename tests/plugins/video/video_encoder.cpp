// SPDX-License-Identifier: BSD-3-Clause
#include "video_encoder.hpp"

#include <catch2/catch.hpp>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

// Of the leak sanitizer, where the test is built with it.
extern "C" __attribute__((weak)) void __lsan_disable();
extern "C" __attribute__((weak)) void __lsan_enable();

namespace tolman::video {
namespace {

/// libx265 loses a kilobyte for each encoder.
int openEncoder(AVCodecContext* codec, const AVCodec* coder, AVDictionary** options) {
  if (__lsan_disable != nullptr) __lsan_disable();
  const int opened = avcodec_open2(codec, coder, options);
  if (__lsan_enable != nullptr) __lsan_enable();
  return opened;
}

constexpr AVRational kFrame = {1, 10};  // s

class Dictionary {
 public:
  explicit Dictionary(const Options& options) {
    for (const auto& [key, value] : options) av_dict_set(&entries_, key.c_str(), value.c_str(), 0);
  }
  ~Dictionary() { av_dict_free(&entries_); }
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;
  AVDictionary** get() { return &entries_; }

 private:
  AVDictionary* entries_ = nullptr;
};

class Encoder {
 public:
  Encoder(const std::filesystem::path& file, const std::string& codec, const cv::Mat& picture,
          const Options& codec_options, const Options& container_options) {
    REQUIRE(avformat_alloc_output_context2(&container_, nullptr, nullptr, file.c_str()) >= 0);
    const AVCodec* coder = avcodec_find_encoder_by_name(codec.c_str());
    REQUIRE(coder != nullptr);
    codec_ = avcodec_alloc_context3(coder);
    codec_->width = picture.cols;
    codec_->height = picture.rows;
    codec_->pix_fmt = coder->id == AV_CODEC_ID_MJPEG ? AV_PIX_FMT_YUVJ420P : AV_PIX_FMT_YUV420P;
    if (picture.depth() == CV_16U) codec_->pix_fmt = AV_PIX_FMT_GRAY16;
    codec_->time_base = kFrame;
    codec_->framerate = av_inv_q(kFrame);
    if ((container_->oformat->flags & AVFMT_GLOBALHEADER) != 0) {
      codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    }
    Dictionary of_codec(codec_options);
    REQUIRE(openEncoder(codec_, coder, of_codec.get()) >= 0);
    stream_ = avformat_new_stream(container_, nullptr);
    stream_->time_base = kFrame;
    stream_->avg_frame_rate = codec_->framerate;
    avcodec_parameters_from_context(stream_->codecpar, codec_);
    REQUIRE(avio_open(&container_->pb, file.c_str(), AVIO_FLAG_WRITE) >= 0);
    Dictionary of_container(container_options);
    REQUIRE(avformat_write_header(container_, of_container.get()) >= 0);
  }
  ~Encoder() {
    av_packet_free(&packet_);
    avcodec_free_context(&codec_);
    avio_closep(&container_->pb);
    avformat_free_context(container_);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void write(const cv::Mat& picture, std::int64_t index) {
    AVFrame* frame = av_frame_alloc();
    frame->format = codec_->pix_fmt;
    frame->width = picture.cols;
    frame->height = picture.rows;
    REQUIRE(av_frame_get_buffer(frame, 0) >= 0);
    const auto plane = [&](int i, int rows, int columns) {
      return cv::Mat(rows, columns, picture.type(), frame->data[i],
                     static_cast<std::size_t>(frame->linesize[i]));
    };
    cv::Mat grey = plane(0, picture.rows, picture.cols);
    picture.copyTo(grey);
    if (picture.depth() == CV_8U) {
      for (const int i : {1, 2}) plane(i, picture.rows / 2, picture.cols / 2).setTo(128);
    }
    frame->pts = index;
    REQUIRE(avcodec_send_frame(codec_, frame) >= 0);
    av_frame_free(&frame);
    writePackets();
  }

  void end() {
    avcodec_send_frame(codec_, nullptr);
    writePackets();
    REQUIRE(av_write_trailer(container_) >= 0);
  }

 private:
  void writePackets() {
    while (avcodec_receive_packet(codec_, packet_) >= 0) {
      packet_->duration = 1;
      av_packet_rescale_ts(packet_, kFrame, stream_->time_base);
      REQUIRE(av_interleaved_write_frame(container_, packet_) >= 0);
    }
  }

  AVFormatContext* container_ = nullptr;
  AVCodecContext* codec_ = nullptr;
  AVStream* stream_ = nullptr;
  AVPacket* packet_ = av_packet_alloc();
};

}  // namespace

void encodeVideo(const std::filesystem::path& file, const std::string& codec,
                 const std::vector<cv::Mat>& pictures, const Options& codec_options,
                 const Options& container_options) {
  Encoder encoder(file, codec, pictures.front(), codec_options, container_options);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    encoder.write(pictures[i], static_cast<std::int64_t>(i));
  }
  encoder.end();
}

}  // namespace tolman::video
