// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the structure of video containers, and check sums of FFV1 pictures. The corpus was
// written by FFmpeg's libraries (tests/plugins/video/video_encoder.cpp).
#include "ffv1_check.hpp"
#include "input.hpp"
#include "matroska_check.hpp"
#include "mp4_check.hpp"
#include "stream_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile memory({data, size});
  video::ContainerBytes file(memory.path());
  fuzz::require(file.size() == size, "a file of another size");
  const auto mp4 = video::checkMp4(file);
  fuzz::require(!mp4.promised_s || *mp4.promised_s > 0, "a length that is not positive");
  for (const auto& check : {video::defectOfMatroska, video::defectOfOgg, video::defectOfFlv}) {
    fuzz::require(check(file) == check(file), "another answer to the same file");
  }
  video::hasSoundSlices({data, size});
  return 0;
}
