// SPDX-License-Identifier: BSD-3-Clause
#include "file_access.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "support/context.hpp"
#include "support/data.hpp"

namespace tolman::video {

TEST_CASE("kinds of paths, and what to do where there is none") {
  const test::TemporaryFolder folder;
  OpenFile none;
  test::TestContext test_context;
  const Context context = test_context;
  const auto path = [&](const char* name) { return folder.path() / name; };
  const auto message = [&](const std::filesystem::path& file) {
    return findKind(file, none, context.cancellation, 0.01).status().message();
  };
  std::ofstream(path("video.mp4")) << "bytes";
  CHECK(findKind(path("video.mp4"), none, context.cancellation).value() == PathKind::File);
  CHECK(findKind("/dev/null", none, context.cancellation).value() == PathKind::Device);
  std::ofstream(path("empty.mp4")).flush();
  CHECK(message(path("empty.mp4")) ==
        path("empty.mp4").string() + ": is empty; copy or record it again");
  CHECK(message(path("none.mp4")) == path("none.mp4").string() +
                                         ": cannot be opened (No such file or directory); check "
                                         "path and permissions");
  CHECK(message(folder.path()).find("is a folder, not a video") != std::string::npos);
  CHECK(message("/dev/video99").find("(No such file or directory); connect the camera") !=
        std::string::npos);
}

TEST_CASE("a pipe that nothing is written into is reported after a while") {
  const test::TemporaryFolder folder;
  OpenFile none;
  test::TestContext test_context;
  const Context context = test_context;
  const auto pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const auto kind = findKind(pipe, none, context.cancellation, 0.01);
  REQUIRE_FALSE(kind.isOk());
  CHECK(kind.status().message().find("nothing was written into this pipe") != std::string::npos);
}

TEST_CASE("an interruption ends the wait for a pipe") {
  const test::TemporaryFolder folder;
  OpenFile none;
  test::TestContext test_context;
  test_context.cancelled = true;
  const Context context = test_context;
  const auto pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const auto kind = findKind(pipe, none, context.cancellation, 600);
  CHECK(kind.status().code() == StatusCode::Cancelled);
}

}  // namespace tolman::video
