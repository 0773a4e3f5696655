// SPDX-License-Identifier: BSD-3-Clause
// Pictures of videos as grey or colour images, and the decoder of packets that come one by one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

struct AVCodecContext;
struct AVFrame;
struct AVPacket;
struct SwsContext;

namespace tolman::coded_video {

/// Converts to Gray8 (luminance, black 0 and white 255) or Bgr8, and turns the picture clockwise.
class PictureConverter {
 public:
  /// `quarter_turns`: 0 to 3, the display rotation that the file gives.
  PictureConverter(bool colour, int quarter_turns)
      : colour_(colour), quarter_turns_(quarter_turns) {}
  ~PictureConverter();
  PictureConverter(const PictureConverter&) = delete;
  PictureConverter& operator=(const PictureConverter&) = delete;

  Result<Image> convert(const AVFrame& picture);

 private:
  bool colour_;
  int quarter_turns_;
  SwsContext* scaler_ = nullptr;  ///< recreated by libswscale when size or format changes
};

/// The packets of a stream, each one picture, in their order.
struct Packets {
  std::size_t count = 0;
  std::function<bool(std::size_t)> is_key;  ///< whether decoding can begin there
  std::function<Result<std::vector<std::uint8_t>>(std::size_t)> read;
};

class PacketDecoder {
 public:
  /// `codec`: a name that contains that of the standard, such as "h264_nvenc", "libx265" or "hevc".
  static Result<std::unique_ptr<PacketDecoder>> open(const std::string& codec, bool colour);
  ~PacketDecoder();
  PacketDecoder(const PacketDecoder&) = delete;
  PacketDecoder& operator=(const PacketDecoder&) = delete;

  /// Decodes from the last key packet, or goes on from the picture before. InvalidInput, to
  /// complete the sentence "PICTURE ...", for one that is damaged.
  Result<Image> picture(std::size_t index, const Packets& packets);

 private:
  explicit PacketDecoder(bool colour) : converter_(colour, 0) {}
  void send(const Packets& packets);

  AVCodecContext* decoder_ = nullptr;
  AVPacket* packet_ = nullptr;
  AVFrame* frame_ = nullptr;
  PictureConverter converter_;
  std::size_t next_ = 0;   ///< packet to send
  bool is_held_ = false;   ///< frame_ is a later picture than the last that was asked for
  bool is_broken_ = true;  ///< the next picture cannot be decoded from those before
};

}  // namespace tolman::coded_video
