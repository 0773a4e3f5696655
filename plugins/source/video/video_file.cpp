// SPDX-License-Identifier: BSD-3-Clause
// A video file, or a pipe that a program writes a video into, read by FFmpeg's libraries.
//
// They are called directly, not through OpenCV. OpenCV gives each picture the time of the last
// packet that was read, which is wrong if the coder reorders pictures, and it cannot distinguish
// the end of a file from damage. What is damaged is what the libraries say.
#include <array>
#include <cmath>
#include <string_view>

#include "base/text_file.hpp"
#include "capture.hpp"
#include "video_pictures.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
}

namespace tolman::video {
namespace {

constexpr std::int64_t kMostPixels = 100'000'000;

/// FFmpeg's callback to stop waiting.
int isCancelled(void* cancellation) {
  return static_cast<const Cancellation*>(cancellation)->requested() ? 1 : 0;
}

/// The text of one of FFmpeg's error codes.
std::string libavError(int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  return text.data();
}

/// Clockwise display rotation of the stream, in quarter turns.
int quarterTurns(const AVStream& stream) {
  const std::uint8_t* matrix = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, nullptr);
  if (matrix == nullptr) return 0;
  const double angle = av_display_rotation_get(reinterpret_cast<const std::int32_t*>(matrix));
  if (!std::isfinite(angle)) return 0;
  return ((static_cast<int>(std::lround(-angle / 90)) % 4) + 4) % 4;
}

class VideoFile final : public Capture {
 public:
  VideoFile(std::filesystem::path path, int pipe, const Cancellation& cancellation)
      : path_(std::move(path)), pipe_(pipe), cancellation_(cancellation) {}
  /// Messages begin without the path.
  Status open(bool colour);
  ~VideoFile() override;

  PictureSize size() const override { return size_; }
  std::string description() const override;
  /// A picture that is damaged, or not complete at the end of the file, has a `defect`.
  Status next(bool wanted, Picture& picture) override;
  /// Of a file that ends before the end that its header promises, or cannot be read to its end.
  std::string defectOfEnd() const override;

 private:
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
  std::unique_ptr<coded_video::PictureConverter> converter_;
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

Status VideoFile::open(bool colour) {
  Status status = openStream();
  if (status.isOk()) status = openDecoder();
  if (status.isOk())
    converter_ = std::make_unique<coded_video::PictureConverter>(colour, quarter_turns_);
  return status;
}

VideoFile::~VideoFile() {
  av_frame_free(&frame_);
  av_packet_free(&packet_);
  avcodec_free_context(&decoder_);
  avformat_close_input(&container_);
}

Status VideoFile::openStream() {
  container_ = avformat_alloc_context();
  packet_ = av_packet_alloc();
  frame_ = av_frame_alloc();
  if (container_ == nullptr || packet_ == nullptr || frame_ == nullptr) {
    return Status::failed("no memory for a video");
  }
  container_->interrupt_callback = {isCancelled, const_cast<Cancellation*>(&cancellation_)};
  // Containers can refer to other files and to servers; only the given file is read.
  AVDictionary* options = nullptr;
  av_dict_set(&options, "protocol_whitelist", "file,pipe", 0);
  const std::string address =
      pipe_ < 0 ? "file:" + path_.string() : "pipe:" + std::to_string(pipe_);
  const int opened = avformat_open_input(&container_, address.c_str(), nullptr, &options);
  av_dict_free(&options);
  const int found = opened < 0 ? opened : avformat_find_stream_info(container_, nullptr);
  if (cancellation_.requested()) return {StatusCode::Cancelled, "opening was cancelled"};
  if (found < 0) {
    return Status::invalidInput("is no video that FFmpeg can read (" + libavError(found) +
                                "); if it is one, it is cut off or damaged: copy or record it "
                                "again");
  }
  const int best = av_find_best_stream(container_, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
  if (best < 0) return Status::invalidInput("has no pictures; name a video");
  stream_ = container_->streams[best];
  for (unsigned i = 0; i < container_->nb_streams; ++i) {
    if (static_cast<int>(i) != best) container_->streams[i]->discard = AVDISCARD_ALL;
  }
  return Status::ok();
}

Status VideoFile::openDecoder() {
  const AVCodecParameters& coded = *stream_->codecpar;
  const AVCodec* codec = avcodec_find_decoder(coded.codec_id);
  const std::string name = avcodec_get_name(coded.codec_id);
  if (codec == nullptr) {
    return Status::unsupported("is coded as " + name +
                               ", which FFmpeg cannot decode here; convert it");
  }
  decoder_ = avcodec_alloc_context3(codec);
  if (decoder_ == nullptr) return Status::failed("no memory for a video");
  int status = avcodec_parameters_to_context(decoder_, &coded);
  decoder_->pkt_timebase = stream_->time_base;
  decoder_->max_pixels = kMostPixels;
  const AVCodecDescriptor* about = avcodec_descriptor_get(coded.codec_id);
  intra_only_ = about != nullptr && (about->props & AV_CODEC_PROP_INTRA_ONLY) != 0;
  // Others conceal damage, which is in the flags of the picture, and give as many pictures.
  if (intra_only_ || coded.codec_id == AV_CODEC_ID_HEVC) {
    decoder_->err_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;
  }
  decoder_->thread_count = 1;  // threads of FFmpeg would run between two calls
  if (status >= 0) status = avcodec_open2(decoder_, codec, nullptr);
  if (status < 0) {
    return Status::invalidInput("the decoder of " + name + " does not start (" +
                                libavError(status) + "); convert the video");
  }
  const bool sane = coded.width > 0 && coded.height > 0 &&
                    std::int64_t{coded.width} * coded.height <= kMostPixels;
  if (!sane) return Status::invalidInput("has pictures of no size; copy or record it again");
  quarter_turns_ = quarterTurns(*stream_);
  size_ = {coded.width, coded.height};
  if (quarter_turns_ % 2 == 1) std::swap(size_.width, size_.height);
  return Status::ok();
}

bool VideoFile::hasTimes() const {
  // Raw streams have no times; FFmpeg invents some, of 25 pictures a second.
  return (container_->iformat->flags & AVFMT_NOTIMESTAMPS) == 0 &&
         std::string_view(container_->iformat->name).find("pipe") == std::string_view::npos &&
         container_->iformat->raw_codec_id == AV_CODEC_ID_NONE;
}

std::string VideoFile::description() const {
  const std::string codec = avcodec_get_name(stream_->codecpar->codec_id);
  std::string text = codec + " in " + container_->iformat->name + ", " +
                     std::to_string(size_.width) + "x" + std::to_string(size_.height) + " px";
  if (!hasTimes()) return text + ", without times";
  const AVRational rate = stream_->avg_frame_rate;
  const double seconds = static_cast<double>(container_->duration) / AV_TIME_BASE;
  if (rate.num > 0 && rate.den > 0) {
    text += " at " + text_encoding::rounded(av_q2d(rate)) + " Hz";
  }
  return seconds > 0 ? text + ", " + text_encoding::rounded(seconds) + " s" : text;
}

Status VideoFile::next(bool wanted, Picture& picture) {
  picture = {};
  while (true) {
    const int status = avcodec_receive_frame(decoder_, frame_);
    if (status >= 0) return fill(wanted, picture);
    if (status == AVERROR_EOF) return Status::endOfStream();
    if (status != AVERROR(EAGAIN)) {
      damage_ = libavError(status);
      continue;  // the decoder can continue with the next packet
    }
    if (Status fed = feed(); !fed.isOk()) return fed;
    if (is_lost_) return fillLost(picture);
  }
}

/// Where each packet is one picture, one that cannot be decoded keeps its number and time.
Status VideoFile::fillLost(Picture& picture) {
  is_lost_ = false;
  setTime(packet_->pts, picture);
  picture.defect =
      "picture " + std::to_string(pictures_ - 1) + " is damaged: " + std::exchange(damage_, "");
  return Status::ok();
}

void VideoFile::setTime(std::int64_t time, Picture& picture) {
  if (pictures_ == 0) start_ = time;
  ++pictures_;
  picture.timed = hasTimes() && time != AV_NOPTS_VALUE && start_ != AV_NOPTS_VALUE;
  if (!picture.timed) return;
  picture.stamp_ns = av_rescale_q(time - start_, stream_->time_base, {1, 1'000'000'000});
  last_ns_ = picture.stamp_ns;
}

Status VideoFile::feed() {
  if (cancellation_.requested()) return {StatusCode::Cancelled, "reading was cancelled"};
  av_packet_unref(packet_);
  const int read = av_read_frame(container_, packet_);
  if (read < 0) {
    read_error_ = read == AVERROR_EOF ? 0 : read;
    const int ended = avcodec_send_packet(decoder_, nullptr);
    return ended >= 0 || ended == AVERROR_EOF
               ? Status::ok()
               : Status::failed(path_.string() + ": the decoder fails: " + libavError(ended));
  }
  if (packet_->stream_index != stream_->index) return Status::ok();
  if (packet_->size > 0) ++packets_;
  if ((packet_->flags & AV_PKT_FLAG_CORRUPT) != 0) damage_ = "its data are not complete";
  const int sent = avcodec_send_packet(decoder_, packet_);
  if (sent >= 0 || sent == AVERROR(EAGAIN)) return Status::ok();
  damage_ = libavError(sent);
  is_lost_ = intra_only_;
  return Status::ok();
}

std::string VideoFile::defectOfEnd() const {
  const std::string found = std::to_string(pictures_) + " pictures";
  if (read_error_ != 0) return "cannot be read beyond " + found + ": " + libavError(read_error_);
  if (!damage_.empty()) return "ends within a picture after " + found + ": " + damage_;
  if (stream_->nb_frames > packets_) {
    return "ends after " + found + ", and its header promises " +
           std::to_string(stream_->nb_frames);
  }
  // Containers without that number, such as Matroska, have a length.
  const bool has_length = container_->nb_streams == 1 && hasTimes() && container_->duration > 0 &&
                          container_->duration_estimation_method == AVFMT_DURATION_FROM_STREAM;
  const double length = static_cast<double>(container_->duration) / AV_TIME_BASE;
  const double last = static_cast<double>(last_ns_) * 1e-9;
  const double step = pictures_ > 1 ? last / static_cast<double>(pictures_ - 1) : length;
  if (!has_length || last + 2.5 * step > length) return {};
  return "ends after " + found + " and " + text_encoding::rounded(last) +
         " s, and its header promises " + text_encoding::rounded(length) + " s";
}

std::string VideoFile::defectOfFrame() {
  const std::string picture = "picture " + std::to_string(pictures_ - 1);
  const bool concealed =
      frame_->decode_error_flags != 0 || (frame_->flags & AV_FRAME_FLAG_CORRUPT) != 0;
  if (!damage_.empty() || concealed) {
    complete_ = false;
    return picture + " is damaged" + (damage_.empty() ? "" : ": " + std::exchange(damage_, ""));
  }
  const bool by_itself =
      frame_->key_frame != 0 || frame_->pict_type == AV_PICTURE_TYPE_I || intra_only_;
  complete_ = complete_ || by_itself;
  return complete_ ? "" : picture + " was coded as a change of one that is damaged or missing";
}

Status VideoFile::fill(bool wanted, Picture& picture) {
  setTime(frame_->best_effort_timestamp, picture);
  picture.defect = defectOfFrame();
  if (!picture.defect.empty() || !wanted) return Status::ok();
  Result<Image> image = converter_->convert(*frame_);
  if (!image.isOk()) {
    return {image.status().code(), path_.string() + ": " + image.status().message()};
  }
  picture.image = std::move(image).value();
  if (PictureSize{picture.image.width(), picture.image.height()} == size_) return Status::ok();
  return Status::invalidInput(path_.string() + ": its pictures change their size after picture " +
                              std::to_string(pictures_ - 2) + "; cut the video there");
}

}  // namespace

Result<std::unique_ptr<Capture>> openVideo(const std::filesystem::path& path, int pipe, bool colour,
                                           const Cancellation& cancellation) {
  auto file = std::make_unique<VideoFile>(path, pipe, cancellation);
  const Status status = file->open(colour);
  if (!status.isOk()) return Status(status.code(), path.string() + ": " + status.message());
  return std::unique_ptr<Capture>(std::move(file));
}

}  // namespace tolman::video
