// SPDX-License-Identifier: BSD-3-Clause
// A video file, or a pipe that a program writes a video into, read by FFmpeg's libraries.
//
// They are called directly, not through OpenCV. OpenCV gives each picture the time of the last
// packet that was read, which is wrong if the coder reorders pictures, and it cannot distinguish
// the end of a file from damage.
#pragma once

#include <filesystem>
#include <memory>

#include "capture.hpp"
#include "container_check.hpp"
#include "ffv1_check.hpp"
#include "picture_converter.hpp"
#include "time_gaps.hpp"
#include "tolman/context.hpp"

struct AVCodecContext;
struct AVFormatContext;
struct AVFrame;
struct AVPacket;
struct AVStream;

namespace tolman::video {

/// How pictures become images; see PictureConverter.
struct PixelChoice {
  bool colour = false;
  int bits = 16;
};

class VideoFile final : public Capture {
 public:
  /// Opens the first video stream. InvalidInput with a remedy if it is not a video. `pipe`: the
  /// open pipe, which must outlive this object, or -1 for a file. `cancellation` ends the wait for
  /// a pipe.
  static Result<std::unique_ptr<VideoFile>> open(const std::filesystem::path& path, int pipe,
                                                 PixelChoice pixels,
                                                 const Cancellation& cancellation);
  ~VideoFile() override;

  PictureSize size() const override { return size_; }
  std::string description() const override;
  /// Number of coded pictures. Reads to the end without decoding, so next() has none afterwards.
  std::int64_t countPackets();
  /// A picture that is damaged, or not complete at the end of the file, has a `defect`.
  Status next(bool wanted, Picture& picture) override;
  /// The defect is that of a file that ends within a picture or before the end in its header, or
  /// that is damaged in a way that FFmpeg reads over; the warning is of pictures that it dropped,
  /// or of a gap in time.
  StreamEnd end() const override { return {defectOfEnd(), warningOfEnd()}; }

 private:
  VideoFile(std::filesystem::path path, const Cancellation& cancellation)
      : path_(std::move(path)), cancellation_(cancellation) {}
  Status openStream();
  Status openDecoder();
  /// Sends one packet of the stream, or the end, to the decoder.
  Status feed();
  /// What is wrong with the data of packet_, as far as it shows before they are decoded.
  std::string damageOfPacket();
  /// Whether bytes are left behind the last packet, of a format whose pictures have all one size.
  bool hasRest() const;
  bool endsEarly() const;
  std::string defectOfEnd() const;
  std::string warningOfEnd() const;
  Status fill(bool wanted, Picture& picture);
  bool saysTimes() const;
  std::int64_t timeOfFrame();
  /// Why the picture in frame_ cannot be used; empty: it can.
  std::string defectOfFrame();

  std::filesystem::path path_;
  const Cancellation& cancellation_;
  AVFormatContext* container_ = nullptr;
  AVCodecContext* decoder_ = nullptr;
  AVPacket* packet_ = nullptr;
  AVFrame* frame_ = nullptr;
  AVStream* stream_ = nullptr;  ///< of container_
  std::unique_ptr<PictureConverter> converter_;
  PictureSize size_;
  int quarter_turns_ = 0;
  int pipe_ = -1;
  bool fed_all_ = false;
  bool cut_ = false;                ///< the last packet was not complete
  std::string damage_;              ///< error of a packet that the decoder rejected
  bool complete_ = false;           ///< a picture without others was decoded since the last damage
  ContainerCheck container_check_;  ///< of a file that was read to its end
  Ffv1Check ffv1_;
  TimeGaps gaps_;
  std::int64_t end_ = 0;    ///< of the pictures in the packets so far, units of the stream
  std::int64_t start_ = 0;  ///< time of the first picture, units of the stream
  std::int64_t time_ = 0;   ///< of the last picture, units of the stream
  std::int64_t pictures_ = 0;
  std::int64_t packets_end_ = 0;  ///< byte behind the last one
  std::int64_t packets_ = 0;      ///< with data, of the stream
  std::int64_t indexed_ = 0;      ///< that an index names; 0 without one
  std::int64_t sound_ = 0;        ///< pictures before the first damaged one
};

}  // namespace tolman::video
