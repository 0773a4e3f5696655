// SPDX-License-Identifier: BSD-3-Clause
// A named pipe that a program writes a video into, in place of a live camera.
#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

#include "support/data.hpp"
#include "video_maker.hpp"

namespace tolman::video {

TEST_CASE("a video from a pipe is read while it is written, and once") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "video.ts";
  const auto pipe = folder.path() / "pipe";
  writeFlatVideo(file, 40, 25, "MPG2");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::thread writer([&] {
    std::ifstream in(file, std::ios::binary);
    std::ofstream out(pipe, std::ios::binary);
    std::string piece(500, ' ');
    while (in.read(piece.data(), 500) || in.gcount() > 0) {
      out.write(piece.data(), in.gcount());
      out.flush();
    }
  });
  Played played(pipe);
  writer.join();
  CHECK(played.message.empty());
  CHECK(played.info.frames == -1);
  CHECK(played.numbers() == Played(file).numbers());
  CHECK(played.stamps().back() == 39 * 40'000'000LL);
  CHECK(played.source.reset().message().find("cannot be read twice") != std::string::npos);
}

}  // namespace tolman::video
