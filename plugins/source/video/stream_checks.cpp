// SPDX-License-Identifier: BSD-3-Clause
#include "stream_checks.hpp"

#include <array>
#include <map>
#include <vector>

extern "C" {
#include <libavutil/bswap.h>
#include <libavutil/crc.h>
}

namespace tolman::video {
namespace {

std::string damagedAt(std::uint64_t at, const std::string& reason) {
  return "is damaged at byte " + std::to_string(at) + ": " + reason;
}

struct OggPage {
  std::uint64_t size = 0;  ///< bytes; 0: none is there
  bool matches = false;    ///< its check sum
  std::uint32_t stream = 0;
  std::uint32_t number = 0;  ///< within the stream
};

OggPage oggPageAt(ContainerBytes& file, std::uint64_t at) {
  constexpr std::uint64_t kOggS = 0x4f676753;
  constexpr std::size_t kHeader = 27;
  constexpr std::size_t kSum = 22;
  if (file.number(at, 4) != kOggS) return {};
  const auto segments = file.number(at + kHeader - 1, 1);
  if (!segments) return {};
  std::uint64_t size = kHeader + *segments;
  for (std::uint64_t i = 0; i < *segments; ++i) {
    size += file.number(at + kHeader + i, 1).value_or(0);
  }
  std::vector<std::uint8_t> bytes(size);
  if (!file.read(at, bytes)) return {};
  OggPage page{size};
  const auto number = [&](std::size_t offset) {
    return static_cast<std::uint32_t>(bytes[offset] | bytes[offset + 1] << 8 |
                                      bytes[offset + 2] << 16) |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24U;
  };
  page.stream = number(14);
  page.number = number(18);
  const std::uint32_t sum = number(kSum);
  std::fill_n(bytes.begin() + kSum, 4, std::uint8_t{0});
  // FFmpeg keeps the bits of this sum in the order of memory.
  page.matches = av_bswap32(av_crc(av_crc_get_table(AV_CRC_32_IEEE), 0, bytes.data(), size)) == sum;
  return page;
}

}  // namespace

std::string defectOfOgg(ContainerBytes& file) {
  std::map<std::uint32_t, std::uint32_t> next;  // number of a page, by stream
  for (std::uint64_t at = 0; at < file.size();) {
    const OggPage page = oggPageAt(file, at);
    if (page.size == 0) return damagedAt(at, "no whole page begins there");
    if (!page.matches) return damagedAt(at, "the check sum of a page does not match");
    const auto [expected, is_first] = next.try_emplace(page.stream, page.number);
    if (page.number != expected->second) return damagedAt(at, "pages before are missing");
    ++expected->second;
    at += page.size;
  }
  return {};
}

std::string defectOfFlv(ContainerBytes& file) {
  constexpr std::uint64_t kTagHeader = 11;
  constexpr std::uint64_t kSizeBehind = 4;
  constexpr std::array<std::uint64_t, 3> kTypes = {8, 9, 18};  // sound, pictures, data
  const std::uint64_t first = file.number(5, 4).value_or(0);
  for (std::uint64_t at = first + kSizeBehind; at < file.size();) {
    const auto type = file.number(at, 1);
    const auto size = file.number(at + 1, 3);
    const bool known = type && (*type == kTypes[0] || *type == kTypes[1] || *type == kTypes[2]);
    if (!known || !size || at + kTagHeader + *size > file.size()) {
      return damagedAt(at, "no whole tag begins there");
    }
    at += kTagHeader + *size + kSizeBehind;
  }
  return {};
}

}  // namespace tolman::video
