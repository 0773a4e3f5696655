// SPDX-License-Identifier: BSD-3-Clause
#include "picture_converter.hpp"

#include <array>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "tolman/image_cv.hpp"

extern "C" {
#include <libavutil/frame.h>
#include <libswscale/swscale.h>
}

namespace tolman::video {
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

PictureSize halved(PictureSize size, PictureLayout layout) {
  if (layout == PictureLayout::SideBySide) size.width /= 2;
  if (layout == PictureLayout::TopBottom) size.height /= 2;
  return size;
}

/// The part of `picture` of this size that begins at column x and row y.
Image part(const Image& picture, int x, int y, PictureSize size) {
  const std::ptrdiff_t column = std::ptrdiff_t{x} * bytesPerPixel(picture.format());
  return {picture.row(y) + column, size.width,       size.height,
          picture.stride(),        picture.format(), picture.owner()};
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

Result<PictureSize> cameraSize(PictureSize picture, PictureLayout layout) {
  const PictureSize size = halved(picture, layout);
  const bool whole = (layout != PictureLayout::SideBySide || size.width * 2 == picture.width) &&
                     (layout != PictureLayout::TopBottom || size.height * 2 == picture.height);
  if (whole && size.width > 0 && size.height > 0) return size;
  return Status::invalidParameter(
      "pictures of " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
      " px are not two equal halves " +
      (layout == PictureLayout::SideBySide ? "side by side" : "one above the other") +
      "; correct layout");
}

Image leftImage(const Image& picture, PictureLayout layout) {
  if (picture.empty() || layout == PictureLayout::Mono) return picture;
  return part(picture, 0, 0, halved({picture.width(), picture.height()}, layout));
}

Image rightImage(const Image& picture, PictureLayout layout) {
  if (picture.empty() || layout == PictureLayout::Mono) return {};
  const PictureSize size = halved({picture.width(), picture.height()}, layout);
  const bool beside = layout == PictureLayout::SideBySide;
  return part(picture, beside ? size.width : 0, beside ? 0 : size.height, size);
}

}  // namespace tolman::video
