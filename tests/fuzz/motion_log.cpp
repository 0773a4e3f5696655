// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: a motion log. The input is three g2o files, divided by lines "%%": odometry, truth,
// loop candidates. If they are accepted, all frames are read.
#include "motion_log.hpp"

#include <array>

#include "input.hpp"
#include "support/context.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  constexpr std::array kNames = {"odometry.g2o", "ground_truth.g2o", "loop_candidates.g2o"};
  const fuzz::ScratchFolder folder;
  folder.write(kNames[2], "");
  const auto parts = fuzz::partsOf(fuzz::asText({data, size}));
  for (std::size_t i = 0; i < parts.size() && i < kNames.size(); ++i) {
    folder.write(kNames[i], parts[i]);
  }
  test::TestContext context({{"path", folder.path().string()}});
  motion_log::MotionLog source;
  if (!source.configure(context).isOk()) return 0;
  SourceInfo info;
  fuzz::require(source.info(info).isOk(), "no description of what was accepted");
  for (std::int64_t i = 0; i < info.frames; ++i) {
    Frame frame;
    fuzz::require(source.next(frame).isOk(), "fewer frames than were promised");
    fuzz::require(firstInvalidField(frame).empty(), "a frame with a number that is none");
  }
  return 0;
}
