// SPDX-License-Identifier: BSD-3-Clause
// A video file, or a pipe that a program writes a video into, read by FFmpeg's libraries.
//
// They are called directly, not through OpenCV. OpenCV gives each picture the time of the last
// packet that was read, which is wrong if the coder reorders pictures, and it cannot distinguish
// the end of a file from damage. What is damaged is what the libraries say.
#pragma once

#include <filesystem>
#include <memory>

#include "capture.hpp"
#include "picture_converter.hpp"
#include "tolman/context.hpp"

struct AVCodecContext;
struct AVFormatContext;
struct AVFrame;
struct AVPacket;
struct AVStream;

namespace tolman::video {

class VideoFile final : public Capture {
 public:
  /// Opens the first video stream. InvalidInput with a remedy if it is not a video. `pipe`: the
  /// open pipe, which must outlive this object, or -1 for a file. `bits`: see PictureConverter.
  /// `cancellation` ends the wait for a pipe.
  static Result<std::unique_ptr<VideoFile>> open(const std::filesystem::path& path, int pipe,
                                                 bool colour, source_parameters::UsedBits& bits,
                                                 const Cancellation& cancellation);
  ~VideoFile() override;

  PictureSize size() const override { return size_; }
  std::string description() const override;
  /// A picture that is damaged, or not complete at the end of the file, has a `defect`.
  Status next(bool wanted, Picture& picture) override;
  /// Of a file that ends before the end that its header promises, or cannot be read to its end.
  std::string defectOfEnd() const override;

 private:
  VideoFile(std::filesystem::path path, int pipe, const Cancellation& cancellation)
      : path_(std::move(path)), pipe_(pipe), cancellation_(cancellation) {}
  Status openStream();
  Status openDecoder();
  /// Sends one packet of the stream, or the end, to the decoder.
  Status feed();
  Status fill(bool wanted, Picture& picture);
  Status fillLost(Picture& picture);
  void setTime(std::int64_t time, Picture& picture);
  bool hasTimes() const;
  /// Why the picture in frame_ cannot be used; empty: it can.
  std::string defectOfFrame();

  std::filesystem::path path_;
  int pipe_;
  const Cancellation& cancellation_;
  AVFormatContext* container_ = nullptr;
  AVCodecContext* decoder_ = nullptr;
  AVPacket* packet_ = nullptr;
  AVFrame* frame_ = nullptr;
  AVStream* stream_ = nullptr;  ///< of container_
  std::unique_ptr<PictureConverter> converter_;
  PictureSize size_;
  int quarter_turns_ = 0;
  int read_error_ = 0;        ///< that ended the reading; 0: the end of the file
  std::string damage_;        ///< of data since the last picture
  bool intra_only_ = false;   ///< each packet is one picture
  bool is_lost_ = false;      ///< the last packet gave no picture
  bool complete_ = false;     ///< a picture without others was decoded since the last damage
  std::int64_t start_ = 0;    ///< time of the first picture, units of the stream
  std::int64_t packets_ = 0;  ///< with data, of the stream
  std::int64_t pictures_ = 0;
  std::int64_t last_ns_ = 0;  ///< time of the last picture, since the first
};

}  // namespace tolman::video
