// SPDX-License-Identifier: BSD-3-Clause
#include "video_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>

#include "jpeg_decoder.hpp"
#include "libav_error.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
}

namespace tolman::video {
namespace {

constexpr std::int64_t kMaxPixels = 100'000'000;

/// FFmpeg's callback to stop waiting.
int isCancelled(void* cancellation) {
  return static_cast<const Cancellation*>(cancellation)->requested() ? 1 : 0;
}

/// Clockwise display rotation of the stream, in quarter turns.
int quarterTurns(const AVStream& stream) {
  const std::uint8_t* matrix = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, nullptr);
  if (matrix == nullptr) return 0;
  const double angle = av_display_rotation_get(reinterpret_cast<const std::int32_t*>(matrix));
  if (!std::isfinite(angle)) return 0;
  return ((static_cast<int>(std::lround(-angle / 90)) % 4) + 4) % 4;
}

bool isAvi(const AVFormatContext& container) {
  return std::string_view(container.iformat->name) == "avi";
}

/// Pictures in the index of an AVI file, where it has one; chunks without bytes repeat a picture.
std::int64_t indexedPictures(const AVFormatContext& container, AVStream& stream) {
  std::int64_t count = 0;
  const int entries = isAvi(container) ? avformat_index_get_entries_count(&stream) : 0;
  for (int i = 0; i < entries; ++i) {
    const AVIndexEntry* entry = avformat_index_get_entry(&stream, i);
    if (entry != nullptr && entry->size > 0) ++count;
  }
  return count;
}

/// The end of the stream by its header, in the stream's units. Only some headers contain it; for
/// several streams it is that of the longest one, which is not used. `fragments_s`: length of all
/// fragments, if known.
std::optional<std::int64_t> promisedEnd(const AVFormatContext& container, const AVStream& stream,
                                        std::optional<double> fragments_s) {
  const std::int64_t start = stream.start_time == AV_NOPTS_VALUE ? 0 : stream.start_time;
  if (fragments_s) return start + std::llround(*fragments_s / av_q2d(stream.time_base));
  if (stream.nb_frames > 0 && stream.duration > 0) {
    // Of an AVI file without its index FFmpeg shortens the duration to what there is.
    const AVRational rate = stream.avg_frame_rate;
    const std::int64_t pictures =
        isAvi(container) && rate.num > 0 && rate.den > 0
            ? av_rescale_q(stream.nb_frames, {rate.den, rate.num}, stream.time_base)
            : 0;
    return start + std::max(stream.duration, pictures);
  }
  const bool in_header = container.duration_estimation_method == AVFMT_DURATION_FROM_STREAM;
  if (container.nb_streams != 1 || !in_header || container.duration <= 0) return std::nullopt;
  return start + av_rescale_q(container.duration, {1, AV_TIME_BASE}, stream.time_base);
}

std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::span<const std::uint8_t> bytesOf(const AVPacket& packet) {
  return {packet.data, static_cast<std::size_t>(packet.size)};
}

/// Whether a picture of a Motion JPEG can be decoded as a JPEG file; FFmpeg conceals damage. True
/// for variants of the format.
bool isSoundJpeg(const AVPacket& packet) {
  constexpr std::array<std::uint8_t, 2> kBegin = {0xff, 0xd8};
  const auto bytes = bytesOf(packet);
  return !std::equal(kBegin.begin(), kBegin.end(), bytes.begin()) ||
         jpeg_images::checkJpeg(bytes).isOk();
}

/// Whether a picture of a Motion JPEG ends with the marker EOI. Without it FFmpeg fills in the
/// missing part.
bool hasJpegEnd(const AVPacket& packet) {
  constexpr std::array<std::uint8_t, 2> kEnd = {0xff, 0xd9};
  const auto bytes = bytesOf(packet);
  // Not of std::ranges: clang 14, and so clang-tidy, cannot compile its result.
  return std::find_end(bytes.begin(), bytes.end(), kEnd.begin(), kEnd.end()) != bytes.end();
}

}  // namespace

Result<std::unique_ptr<VideoFile>> VideoFile::open(const std::filesystem::path& path, int pipe,
                                                   PixelChoice pixels,
                                                   const Cancellation& cancellation) {
  std::unique_ptr<VideoFile> file(new VideoFile(path, cancellation));
  file->pipe_ = pipe;
  Status status = file->openStream();
  if (status.isOk()) status = file->openDecoder();
  if (!status.isOk()) return Status(status.code(), path.string() + ": " + status.message());
  file->converter_ =
      std::make_unique<PictureConverter>(pixels.colour, pixels.bits, file->quarter_turns_);
  return file;
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
  indexed_ = indexedPictures(*container_, *stream_);  // reading adds entries
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
                               ", which FFmpeg cannot decode here; convert "
                               "it");
  }
  decoder_ = avcodec_alloc_context3(codec);
  if (decoder_ == nullptr) return Status::failed("no memory for a video");
  int status = avcodec_parameters_to_context(decoder_, &coded);
  decoder_->pkt_timebase = stream_->time_base;
  decoder_->max_pixels = kMaxPixels;
  if (coded.codec_id == AV_CODEC_ID_HEVC) {  // else its check sums of pictures are not compared
    decoder_->err_recognition = AV_EF_CRCCHECK | AV_EF_EXPLODE;
  }
  decoder_->thread_count = 1;  // threads of FFmpeg would run between two calls
  if (status >= 0) status = avcodec_open2(decoder_, codec, nullptr);
  if (status < 0) {
    return Status::invalidInput("the decoder of " + name + " does not start (" +
                                libavError(status) + "); convert the video");
  }
  const bool sane =
      coded.width > 0 && coded.height > 0 && std::int64_t{coded.width} * coded.height <= kMaxPixels;
  if (!sane) return Status::invalidInput("has pictures of no size; copy or record it again");
  quarter_turns_ = quarterTurns(*stream_);
  size_ = {coded.width, coded.height};
  if (quarter_turns_ % 2 == 1) std::swap(size_.width, size_.height);
  return Status::ok();
}

bool VideoFile::saysTimes() const {
  // Raw streams have no times; FFmpeg invents some, of 25 pictures a second.
  return (container_->iformat->flags & AVFMT_NOTIMESTAMPS) == 0 &&
         std::string_view(container_->iformat->name).find("pipe") == std::string_view::npos &&
         container_->iformat->raw_codec_id == AV_CODEC_ID_NONE;
}

std::string VideoFile::description() const {
  const std::string codec = avcodec_get_name(stream_->codecpar->codec_id);
  std::string text = codec + " in " + container_->iformat->name + ", " +
                     std::to_string(size_.width) + "x" + std::to_string(size_.height) + " px";
  const AVRational rate = stream_->avg_frame_rate;
  if (saysTimes() && rate.num > 0 && rate.den > 0) text += " at " + rounded(av_q2d(rate)) + " Hz";
  if (!saysTimes()) text += ", without times";
  if (container_->duration > 0 && saysTimes()) {
    text += ", " + rounded(static_cast<double>(container_->duration) / AV_TIME_BASE) + " s";
  }
  return text;
}

std::int64_t VideoFile::countPackets() {
  std::int64_t count = 0;
  while (!cancellation_.requested() && av_read_frame(container_, packet_) >= 0) {
    if (packet_->stream_index == stream_->index) ++count;
    av_packet_unref(packet_);
  }
  return count;
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
  }
}

Status VideoFile::feed() {
  if (cancellation_.requested()) return {StatusCode::Cancelled, "reading was cancelled"};
  av_packet_unref(packet_);
  const int read = av_read_frame(container_, packet_);
  if (read < 0) {
    fed_all_ = true;
    if (pipe_ < 0) container_check_ = checkContainer(path_, container_->iformat->name);
    cut_ = cut_ || read != AVERROR_EOF || hasRest();
    const int ended = avcodec_send_packet(decoder_, nullptr);
    return ended >= 0 || ended == AVERROR_EOF
               ? Status::ok()
               : Status::failed(path_.string() + ": the decoder fails: " + libavError(ended));
  }
  if (packet_->stream_index != stream_->index) return Status::ok();
  if (packet_->size > 0) ++packets_;
  packets_end_ = packet_->pos + packet_->size;
  if (std::string damage = damageOfPacket(); !damage.empty()) damage_ = std::move(damage);
  // Of pictures that are coded in another order AVI has no times, but those of the packets.
  const std::int64_t time = packet_->pts != AV_NOPTS_VALUE ? packet_->pts : packet_->dts;
  if (time != AV_NOPTS_VALUE) end_ = std::max(end_, time + packet_->duration);
  const int sent = avcodec_send_packet(decoder_, packet_);
  if (sent < 0 && sent != AVERROR(EAGAIN)) damage_ = libavError(sent);
  return Status::ok();
}

std::string VideoFile::damageOfPacket() {
  const AVCodecID codec = stream_->codecpar->codec_id;
  const bool is_jpeg = codec == AV_CODEC_ID_MJPEG;
  cut_ = (packet_->flags & AV_PKT_FLAG_CORRUPT) != 0 || (is_jpeg && !hasJpegEnd(*packet_));
  if (cut_) return "its data are not complete";
  if (is_jpeg && !isSoundJpeg(*packet_)) return "its data cannot be decoded";
  const bool has_slices = codec == AV_CODEC_ID_FFV1 && packet_->size > 0;
  if (!has_slices || !ffv1_.isDamaged(bytesOf(*packet_))) return {};
  return "a check sum of its data, or of those before, does not match";
}

bool VideoFile::hasRest() const {
  const bool is_y4m = std::string_view(container_->iformat->name) == "yuv4mpegpipe";
  return is_y4m && packets_ > 0 && avio_tell(container_->pb) > packets_end_;
}

bool VideoFile::endsEarly() const {
  if (packets_ < indexed_) return true;
  const std::optional<std::int64_t> promised =
      promisedEnd(*container_, *stream_, container_check_.promised_s);
  const AVRational rate = stream_->avg_frame_rate;
  if (!promised || !saysTimes() || rate.num <= 0 || rate.den <= 0) return false;
  const std::int64_t one = av_rescale_q(1, {rate.den, rate.num}, stream_->time_base);
  return end_ < *promised - one - one / 2;
}

std::string VideoFile::defectOfEnd() const {
  const bool in_picture = cut_ || !damage_.empty();
  if (!in_picture && !endsEarly()) {
    if (container_check_.defect.empty()) return {};
    return path_.string() + ": " + container_check_.defect +
           ", and pictures can be missing; copy or record it again, or use what can be read by "
           "on_corrupt: skip";
  }
  if (!in_picture &&
      isAvi(*container_)) {  // it has no times, so a gap in the middle moves the rest
    return path_.string() + ": has " + std::to_string(pictures_) + " pictures, and its header " +
           "promises " + std::to_string(std::max(stream_->nb_frames, indexed_)) +
           ": they are missing at the end, or in the middle, and then the times of all that "
           "follow " +
           "are wrong; copy or record it again";
  }
  std::string text = path_.string() + ": ends ";
  text += in_picture ? "in the middle of a picture" : "before the end that its header promises";
  if (sound_ == 0) return text + "; copy or record it again";
  return text + ", after " + std::to_string(sound_) +
         " sound ones; copy or record it again, or set last: " + std::to_string(sound_ - 1) +
         " to use those";
}

std::string VideoFile::warningOfEnd() const {
  const std::int64_t lost = packets_ - pictures_;
  const std::string gap = gaps_.warning();
  if (!gap.empty()) return path_.string() + ": " + gap;
  if (lost <= 0) return {};
  return path_.string() + ": no picture came of " + std::to_string(lost) + " of its " +
         std::to_string(packets_) +
         " coded pictures: they are damaged, or changes of one before the first";
}

std::int64_t VideoFile::timeOfFrame() {
  std::int64_t time = frame_->best_effort_timestamp;
  const AVRational rate = stream_->avg_frame_rate;
  // AVI has one rate, and no times of pictures that are coded in another order.
  const bool at_rate = isAvi(*container_) && pictures_ > 0 && rate.num > 0 && rate.den > 0;
  if (time == AV_NOPTS_VALUE && at_rate && time_ != AV_NOPTS_VALUE) {
    time = time_ + av_rescale_q(1, {rate.den, rate.num}, stream_->time_base);
  }
  return time_ = time;
}

std::string VideoFile::defectOfFrame() {
  const std::string picture = "picture " + std::to_string(pictures_ - 1);
  const bool concealed =
      frame_->decode_error_flags != 0 || (frame_->flags & AV_FRAME_FLAG_CORRUPT) != 0;
  if (!damage_.empty() || concealed) {
    complete_ = false;
    return picture + " is damaged" + (damage_.empty() ? "" : ": " + std::exchange(damage_, ""));
  }
  const AVCodecDescriptor* codec = decoder_->codec_descriptor;
  const bool by_itself = frame_->key_frame != 0 || frame_->pict_type == AV_PICTURE_TYPE_I ||
                         (codec != nullptr && (codec->props & AV_CODEC_PROP_INTRA_ONLY) != 0);
  complete_ = complete_ || by_itself;
  return complete_ ? "" : picture + " was coded as a change of one that is damaged or missing";
}

Status VideoFile::fill(bool wanted, Picture& picture) {
  const std::int64_t time = timeOfFrame();
  if (pictures_ == 0) start_ = time;
  ++pictures_;
  picture.timed = saysTimes() && time != AV_NOPTS_VALUE && start_ != AV_NOPTS_VALUE;
  if (picture.timed) {
    picture.stamp_ns = av_rescale_q(time - start_, stream_->time_base, {1, 1'000'000'000});
    gaps_.add(picture.stamp_ns);
  }
  picture.defect = defectOfFrame();
  if (!picture.defect.empty()) return Status::ok();
  if (sound_ == pictures_ - 1) sound_ = pictures_;
  if (!wanted) return Status::ok();
  Result<Image> image = converter_->convert(*frame_, picture.widths);
  if (!image.isOk()) {
    return {image.status().code(), path_.string() + ": " + image.status().message()};
  }
  picture.image = std::move(image).value();
  if (PictureSize{picture.image.width(), picture.image.height()} == size_) return Status::ok();
  return Status::invalidInput(path_.string() + ": its pictures change their size after picture " +
                              std::to_string(pictures_ - 2) + "; cut the video there");
}

}  // namespace tolman::video
