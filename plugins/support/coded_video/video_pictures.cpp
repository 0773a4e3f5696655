// SPDX-License-Identifier: BSD-3-Clause
#include "video_pictures.hpp"

#include <array>
#include <cstring>
#include <opencv2/core.hpp>
#include <string_view>
#include <utility>

#include "tolman/image_cv.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/frame.h>
#include <libswscale/swscale.h>
}

namespace tolman::coded_video {

namespace {

Image turned(const Image& image, int quarter_turns) {
  if (quarter_turns == 0) return image;
  constexpr std::array kTurns = {cv::ROTATE_90_CLOCKWISE, cv::ROTATE_180,
                                 cv::ROTATE_90_COUNTERCLOCKWISE};
  cv::Mat result;
  cv::rotate(asMat(image), result, kTurns.at(static_cast<std::size_t>(quarter_turns - 1)));
  return asImage(result);
}

/// The formats of JPEG are those of video with the full range of values. libswscale has the range
/// as a separate setting and warns about the old formats.
AVPixelFormat plainFormat(AVPixelFormat format) {
  switch (format) {
    case AV_PIX_FMT_YUVJ420P:
      return AV_PIX_FMT_YUV420P;
    case AV_PIX_FMT_YUVJ422P:
      return AV_PIX_FMT_YUV422P;
    case AV_PIX_FMT_YUVJ444P:
      return AV_PIX_FMT_YUV444P;
    case AV_PIX_FMT_YUVJ440P:
      return AV_PIX_FMT_YUV440P;
    default:
      return format;
  }
}

}  // namespace

PictureConverter::~PictureConverter() { sws_freeContext(scaler_); }

Result<Image> PictureConverter::convert(const AVFrame& picture) {
  const auto format = static_cast<AVPixelFormat>(picture.format);
  const AVPixelFormat plain = plainFormat(format);
  scaler_ = sws_getCachedContext(scaler_, picture.width, picture.height, plain, picture.width,
                                 picture.height, colour_ ? AV_PIX_FMT_BGR24 : AV_PIX_FMT_GRAY8,
                                 SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr,
                                 nullptr, nullptr);
  if (scaler_ == nullptr) return Status::unsupported("has a pixel format that cannot be converted");
  const bool full = plain != format || picture.color_range == AVCOL_RANGE_JPEG;
  const bool hd = picture.colorspace == AVCOL_SPC_BT709;
  const int* coefficients = sws_getCoefficients(hd ? SWS_CS_ITU709 : SWS_CS_DEFAULT);
  // 0, 1 << 16, 1 << 16: brightness, contrast and saturation are not changed.
  sws_setColorspaceDetails(scaler_, coefficients, full ? 1 : 0, coefficients, 1, 0, 1 << 16,
                           1 << 16);
  const PixelFormat wanted = colour_ ? PixelFormat::Bgr8 : PixelFormat::Gray8;
  // libswscale writes whole vector registers, so rows and the end of the image are padded.
  constexpr int kPadding = 64;
  const int stride = (picture.width * bytesPerPixel(wanted) + kPadding - 1) / kPadding * kPadding;
  const auto bytes = static_cast<std::size_t>(stride) * static_cast<std::size_t>(picture.height);
  const std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[bytes + kPadding]());
  const std::array<std::uint8_t*, 4> planes = {pixels.get()};
  const std::array<int, 4> strides = {stride};
  const int rows = sws_scale(scaler_, picture.data, picture.linesize, 0, picture.height,
                             planes.data(), strides.data());
  if (rows != picture.height) return Status::failed("a picture could not be converted");
  const Image image(pixels.get(), picture.width, picture.height, stride, wanted, pixels);
  return turned(image, quarter_turns_);
}

namespace {

AVCodecID codecOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, AVCodecID>, 7> kNames = {
      {{"264", AV_CODEC_ID_H264},
       {"265", AV_CODEC_ID_HEVC},
       {"hevc", AV_CODEC_ID_HEVC},
       {"vp9", AV_CODEC_ID_VP9},
       {"vp8", AV_CODEC_ID_VP8},
       {"av1", AV_CODEC_ID_AV1},
       {"mjpeg", AV_CODEC_ID_MJPEG}}};
  for (const auto& [part, id] : kNames) {
    if (name.find(part) != std::string_view::npos) return id;
  }
  return AV_CODEC_ID_NONE;
}

}  // namespace

Result<std::unique_ptr<PacketDecoder>> PacketDecoder::open(const std::string& codec, bool colour) {
  const AVCodec* known = avcodec_find_decoder(codecOf(codec));
  if (known == nullptr) {
    return Status::unsupported("is coded as '" + codec.substr(0, 40) +
                               "', which FFmpeg cannot decode here; convert it");
  }
  std::unique_ptr<PacketDecoder> opened(new PacketDecoder(colour));
  opened->decoder_ = avcodec_alloc_context3(known);
  opened->packet_ = av_packet_alloc();
  opened->frame_ = av_frame_alloc();
  if (opened->decoder_ == nullptr || opened->packet_ == nullptr || opened->frame_ == nullptr) {
    return Status::failed("no memory for a video");
  }
  opened->decoder_->thread_count = 1;  // threads of FFmpeg would run between two calls
  opened->decoder_->flags |= AV_CODEC_FLAG_LOW_DELAY;
  opened->decoder_->max_pixels = 100'000'000;
  if (avcodec_open2(opened->decoder_, known, nullptr) >= 0) return opened;
  return Status::failed("the decoder of '" + codec.substr(0, 40) + "' does not start");
}

PacketDecoder::~PacketDecoder() {
  av_frame_free(&frame_);
  av_packet_free(&packet_);
  avcodec_free_context(&decoder_);
}

/// Sends the next packet, or the end.
void PacketDecoder::send(const Packets& packets) {
  if (next_ >= packets.count) {
    (void)avcodec_send_packet(decoder_, nullptr);
    return;
  }
  const std::size_t index = next_++;
  const auto data = packets.read(index);
  const auto size = data.isOk() ? static_cast<int>(data.value().size()) : 0;
  if (size == 0 || av_new_packet(packet_, size) < 0) {
    is_broken_ = true;
    return;
  }
  std::memcpy(packet_->data, data.value().data(), data.value().size());
  packet_->pts = packet_->dts = static_cast<std::int64_t>(index);
  if (packets.is_key(index)) packet_->flags |= AV_PKT_FLAG_KEY;
  if (avcodec_send_packet(decoder_, packet_) < 0) is_broken_ = true;
  av_packet_unref(packet_);
}

Result<Image> PacketDecoder::picture(std::size_t index, const Packets& packets) {
  constexpr std::size_t kLatest = 32;  // packets until a picture comes
  std::size_t key = index;
  while (key > 0 && !packets.is_key(key)) --key;
  const auto wanted = static_cast<std::int64_t>(index);
  const bool is_later = is_held_ && frame_->pts >= wanted;
  if ((!is_later && index < next_) || next_ < key || next_ == 0) {
    avcodec_flush_buffers(decoder_);
    next_ = key;
    is_held_ = is_broken_ = false;
  }
  while (true) {
    if (!is_held_) {
      const int status = avcodec_receive_frame(decoder_, frame_);
      if (status == AVERROR(EAGAIN) && next_ <= index + kLatest) {
        send(packets);
        continue;
      }
      if (status < 0) return Status::invalidInput("gives no picture; it is damaged");
      is_held_ = true;
    }
    if (frame_->pts > wanted) return Status::invalidInput("gives no picture; it is damaged");
    is_held_ = false;
    const bool is_key = frame_->key_frame != 0;
    const bool concealed =
        frame_->decode_error_flags != 0 || (frame_->flags & AV_FRAME_FLAG_CORRUPT) != 0;
    is_broken_ = concealed || (is_broken_ && !is_key);
    if (frame_->pts < wanted) continue;
    if (!is_broken_) return converter_.convert(*frame_);
    return Status::invalidInput(concealed ? "is damaged"
                                          : "was coded as a change of one that is damaged");
  }
}

}  // namespace tolman::coded_video
