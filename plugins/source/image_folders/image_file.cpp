// SPDX-License-Identifier: BSD-3-Clause
#include "image_file.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/open_files.hpp"
#include "bytes.hpp"
#include "jpeg_decoder.hpp"
#include "orientation.hpp"
#include "png_chunks.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kRemedy =
    "; copy or record it again, or leave it out by on_corrupt: skip";
using Bytes = std::span<const std::uint8_t>;

Status problem(std::string_view what) { return Status::invalidInput(std::string(what)); }

/// Failure for a cause outside of the file: limits, memory, a failing disk. The image is not
/// damaged, so on_corrupt does not apply.
Status unread(int error) {
  const bool descriptors = file_opening::isDescriptorLimit(error);
  return Status::failed("cannot be read (" + std::generic_category().message(error) + "); " +
                        (descriptors ? "allow more open files (`ulimit -n`)"
                                     : "check its permissions, the disk and the memory"));
}

Result<ImageSize> plausibleSize(std::int64_t width, std::int64_t height) {
  constexpr std::int64_t kMaxPixels = 100'000'000;
  if (width < 1 || height < 1 || width > kMaxPixels || height > kMaxPixels / width) {
    return problem("claims an impossible size of " + std::to_string(width) + "x" +
                   std::to_string(height) + " pixels");
  }
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

Result<ImageSize> checkPng(Bytes bytes) {
  constexpr std::size_t kHeaderEnd = 33;  // signature, then IHDR with length, name, data and CRC
  if (bytes.size() < kHeaderEnd || asText(bytes).substr(12, 4) != "IHDR") {
    return problem("is a PNG file with a damaged header");
  }
  if (asText(bytes).rfind("IEND") == std::string_view::npos) {
    return problem("is a truncated PNG file");
  }
  return plausibleSize(bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4));
}

/// Reads the segments up to the frame header SOF, which contains the size.
Result<ImageSize> jpegSize(Bytes bytes) {
  std::size_t at = 2;
  while (at + 9 <= bytes.size() && bytes[at] == 0xff) {
    const std::uint8_t marker = bytes[at + 1];
    if (marker == 0xff) {  // fill byte
      ++at;
      continue;
    }
    const bool is_table = marker == 0xc4 || marker == 0xc8 || marker == 0xcc;
    if (marker >= 0xc0 && marker <= 0xcf && !is_table) {
      return plausibleSize(bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2));
    }
    at += 2 + static_cast<std::size_t>(bigEndian(bytes, at + 2, 2));
  }
  return problem("is a JPEG file with a damaged header");
}

Result<ImageSize> checkJpeg(Bytes bytes) {
  using namespace std::string_view_literals;
  Result<ImageSize> size = jpegSize(bytes);
  if (!size.isOk()) return size;
  // Neither marker can occur in compressed data. Padding after the end is harmless.
  const std::size_t last_scan = asText(bytes).rfind("\xff\xda"sv);
  const std::size_t end = asText(bytes).rfind("\xff\xd9"sv);
  const bool complete =
      last_scan != std::string_view::npos && end != std::string_view::npos && end > last_scan;
  return complete ? size : problem("is a truncated JPEG file: its end marker is missing");
}

Result<std::vector<std::uint8_t>> readBytes(const fs::path& file) {
  constexpr std::uintmax_t kMaxBytes = 512U << 20U;
  std::error_code failure;
  const fs::file_status status = fs::status(file, failure);
  if (status.type() == fs::file_type::none) return unread(failure.value());
  if (!fs::is_regular_file(status)) return problem("is missing or no file");
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure || size > kMaxBytes) return problem("is larger than 512 MiB");
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) return unread(errno);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream) return unread(errno == 0 ? EIO : errno);
  return bytes;
}

/// The bytes of an image file whose header has the size `expected`.
Result<std::vector<std::uint8_t>> checkedBytes(const fs::path& file, ImageSize expected) {
  Result<std::vector<std::uint8_t>> bytes = readBytes(file);
  if (!bytes.isOk()) return bytes.status();
  const Result<ImageSize> size = checkImageBytes(bytes.value());
  if (!size.isOk()) return size.status();
  if (size.value() == expected) return bytes;
  return problem("has " + std::to_string(size.value().width) + "x" +
                 std::to_string(size.value().height) + " pixels, but the first image has " +
                 std::to_string(expected.width) + "x" + std::to_string(expected.height));
}

Result<Image> checkAndDecode(const fs::path& file, bool colour, ImageSize expected, int bits,
                             ImageNotes& notes) {
  Result<std::vector<std::uint8_t>> bytes = checkedBytes(file, expected);
  if (!bytes.isOk()) return bytes.status();
  notes.orientation = orientationOf(bytes.value());
  Result<Image> image = isPng(bytes.value()) ? decodePng(bytes.value(), colour, bits, &notes.values)
                                             : jpeg_images::decodeJpeg(bytes.value(), colour);
  if (!image.isOk()) return image;
  if (ImageSize{image.value().width(), image.value().height()} != expected) {
    return problem("has a damaged header");
  }
  return image;
}

/// Adds the name of the file to a failure, and the remedy if the file is damaged.
Status named(const fs::path& file, const Status& status) {
  const bool damaged = status.code() == StatusCode::InvalidInput;
  return {status.code(),
          file.string() + ": " + status.message() + std::string(damaged ? kRemedy : "")};
}

}  // namespace

Result<ImageSize> checkImageBytes(Bytes bytes) {
  using namespace std::string_view_literals;
  if (bytes.empty()) return problem("is empty");
  if (isPng(bytes)) return checkPng(bytes);
  if (asText(bytes).starts_with("\xff\xd8"sv)) return checkJpeg(bytes);
  return problem("is neither a PNG nor a JPEG file");
}

Result<ImageHeader> checkImageFile(const fs::path& file) {
  const Result<std::vector<std::uint8_t>> bytes = readBytes(file);
  if (!bytes.isOk()) return named(file, bytes.status());
  const Result<ImageSize> size = checkImageBytes(bytes.value());
  if (!size.isOk()) return named(file, size.status());
  return ImageHeader{size.value(), orientationOf(bytes.value())};
}

Result<Image> readImageFile(const fs::path& file, bool colour, ImageSize expected, int bits,
                            ImageNotes* notes) {
  ImageNotes found;
  if (notes != nullptr && notes->values.widths) found.values.widths.emplace();
  Result<Image> image = checkAndDecode(file, colour, expected, bits, found);
  if (notes != nullptr) *notes = found;
  return image.isOk() ? image : named(file, image.status());
}

Result<std::vector<std::uint16_t>> readDepthFile(const fs::path& file, ImageSize expected) {
  Result<std::vector<std::uint8_t>> bytes = checkedBytes(file, expected);
  if (!bytes.isOk()) return named(file, bytes.status());
  Result<std::vector<std::uint16_t>> depth = decodeDeepPng(bytes.value());
  const auto pixels =
      static_cast<std::size_t>(expected.width) * static_cast<std::size_t>(expected.height);
  if (depth.isOk() && depth.value().size() != pixels) depth = problem("has a damaged header");
  return depth.isOk() ? depth : named(file, depth.status());
}

}  // namespace tolman::image_folders
