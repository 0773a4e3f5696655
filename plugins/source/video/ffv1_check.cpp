// SPDX-License-Identifier: BSD-3-Clause
#include "ffv1_check.hpp"

extern "C" {
#include <libavutil/crc.h>
}

namespace tolman::video {

bool hasSoundSlices(std::span<const std::uint8_t> picture) {
  // Behind each slice: its size of three bytes, an error status of one, the sum of four.
  constexpr std::size_t kFooter = 8;
  const AVCRC* table = av_crc_get_table(AV_CRC_32_IEEE);
  while (!picture.empty()) {
    if (picture.size() < kFooter) return false;
    const auto footer = picture.last(kFooter);
    const std::size_t size =
        kFooter + ((std::size_t{footer[0]} << 16U) | (std::size_t{footer[1]} << 8U) | footer[2]);
    if (size > picture.size()) return false;
    // With the sum at its end, that of the whole is zero.
    if (av_crc(table, 0, picture.last(size).data(), size) != 0) return false;
    picture = picture.first(picture.size() - size);
  }
  return true;
}

bool Ffv1Check::isDamaged(std::span<const std::uint8_t> picture) {
  const bool matches = hasSoundSlices(picture);
  const bool damaged = has_sums_ ? !matches : matches && unclear_;
  unclear_ = !has_sums_ && !matches;
  has_sums_ = has_sums_ || matches;
  return damaged;
}

}  // namespace tolman::video
