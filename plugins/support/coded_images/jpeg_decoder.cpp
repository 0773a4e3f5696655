// SPDX-License-Identifier: BSD-3-Clause
#include "jpeg_decoder.hpp"

#include <jerror.h>
#include <jpeglib.h>  // before jerror.h

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>  // for jpeglib.h
#include <new>
#include <string>

namespace tolman::coded_images {
namespace {

/// Data of libjpeg's callbacks. They get a pointer to the error manager, so it must be the first
/// member.
struct Errors {
  jpeg_error_mgr base{};
  std::jmp_buf leave{};
  std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void fail(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<Errors*>(jpeg->err);
  errors->base.format_message(jpeg, errors->message.data());
  std::longjmp(errors->leave, 1);
}

/// Warnings have a negative level; all are failures but two about headers that do not affect
/// pixels.
void onMessage(j_common_ptr jpeg, int level) {
  const int code = jpeg->err->msg_code;
  if (level < 0 && code != JWRN_JFIF_MAJOR && code != JWRN_ADOBE_XFORM) fail(jpeg);
}

/// False after an error. On errors libjpeg returns here by longjmp, so no object in this function
/// may have a destructor.
bool readHeader(jpeg_decompress_struct& jpeg, Errors& errors, std::span<const std::uint8_t> bytes) {
  if (setjmp(errors.leave) != 0) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&jpeg, TRUE);
  return true;
}

/// Writes whole rows to `pixels`. As for readHeader(), no object may have a destructor.
bool readPixels(jpeg_decompress_struct& jpeg, Errors& errors, std::uint8_t* pixels,
                std::size_t stride) {
  if (setjmp(errors.leave) != 0) return false;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = pixels + stride * jpeg.output_scanline;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

/// libjpeg's state for one image.
class JpegReader {
 public:
  JpegReader() {
    jpeg_.err = jpeg_std_error(&errors_.base);
    errors_.base.error_exit = fail;
    errors_.base.emit_message = onMessage;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  Result<Image> decode(std::span<const std::uint8_t> bytes, bool colour) {
    if (Status begun = begin(bytes); !begun.isOk()) return begun;
    jpeg_.out_color_space = colour ? JCS_EXT_BGR : JCS_GRAYSCALE;
    const PixelFormat format = colour ? PixelFormat::Bgr8 : PixelFormat::Gray8;
    const auto stride = std::size_t{jpeg_.image_width} * (colour ? 3 : 1);
    bool whole = false;
    Image image = Image::create(
        static_cast<int>(jpeg_.image_width), static_cast<int>(jpeg_.image_height), format,
        [&](std::uint8_t* pixels) { whole = readPixels(jpeg_, errors_, pixels, stride); });
    if (!whole) return problem();
    return image;
  }

 private:
  Status begin(std::span<const std::uint8_t> bytes) {
    if (!readHeader(jpeg_, errors_, bytes)) return problem();
    constexpr std::uint64_t kMostPixels = 100'000'000;  // bounds memory
    if (std::uint64_t{jpeg_.image_width} * jpeg_.image_height > kMostPixels) {
      return Status::invalidInput("has a damaged header: it claims an impossible size");
    }
    const bool is_for_printing =
        jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
    if (!is_for_printing) return Status::ok();
    return Status::invalidInput("is a JPEG file for printing (CMYK); convert it to grey or RGB");
  }

  Status problem() const {
    const std::string text = errors_.message.data();
    if (errors_.base.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
    return Status::invalidInput("cannot be decoded, its data are damaged (libjpeg: " + text + ")");
  }

  Errors errors_;
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

Result<Image> decodeJpeg(std::span<const std::uint8_t> bytes, bool colour) {
  return JpegReader().decode(bytes, colour);
}

}  // namespace tolman::coded_images
