// SPDX-License-Identifier: BSD-3-Clause
#include "libav_error.hpp"

#include <array>

extern "C" {
#include <libavutil/error.h>
}

namespace tolman::video {

std::string libavError(int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  return text.data();
}

}  // namespace tolman::video
