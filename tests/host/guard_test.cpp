// SPDX-License-Identifier: BSD-3-Clause
// Calls into plugins: whatever they throw becomes a failure that names stage, plugin, call and
// frame.
#include "host/guard.hpp"

#include <catch2/catch.hpp>
#include <ios>
#include <new>
#include <stdexcept>

using namespace tolman;
using namespace tolman::host;

namespace {

const CallSite kTrack = {"odometry", "mine", "track", 12};
const CallSite kConfigure = {"map", "mine", "configure"};

/// Its text is gone when the object is.
struct ShortLived : std::exception {
  std::string text = "a text of the plugin's own, too long for the small string";
  const char* what() const noexcept override { return text.c_str(); }
};

}  // namespace

TEST_CASE("what is thrown is told, of any type") {
  const auto thrown = [](auto error) {
    return guarded(kTrack, [&]() -> Status { throw error; }).message();
  };
  const std::string site = "odometry (mine), track, frame 12: threw";
  CHECK(thrown(std::runtime_error("no memory left")) == site + ": no memory left");
  CHECK(thrown(ShortLived()) == site + ": " + ShortLived().text);
  CHECK(thrown(std::bad_alloc()) == site + ": std::bad_alloc");
  CHECK(thrown(std::logic_error("")) == site + ": ");
  CHECK(thrown(3) == site + " something that is not a std::exception");
  CHECK(thrown("text") == site + " something that is not a std::exception");
}

TEST_CASE("a failure keeps its code and gets its place; without a frame none is named") {
  for (const StatusCode code :
       {StatusCode::InvalidInput, StatusCode::InvalidParameter, StatusCode::Failed}) {
    const Status status = guarded(kConfigure, [&] { return Status(code, "is wrong"); });
    CHECK(status.code() == code);
    CHECK(status.message() == "map (mine), configure: is wrong");
  }
  CHECK(prefix({"source", "kitti", "next", 0}) == "source (kitti), next, frame 0: ");
}

TEST_CASE("success and the end of a stream are no failures") {
  CHECK(guarded(kTrack, [] { return Status::ok(); }).message().empty());
  const Status end = guarded(kTrack, [] { return Status::endOfStream(); });
  CHECK(end.code() == StatusCode::EndOfStream);
  CHECK(end.message() == Status::endOfStream().message());
}

TEST_CASE("the work is done once, in the caller's thread, and may change what it captures") {
  int calls = 0;
  CHECK(guarded(kTrack, [&] {
          ++calls;
          return Status::ok();
        }).isOk());
  CHECK(calls == 1);
  CHECK_FALSE(contained([&]() -> Status {
                ++calls;
                throw std::ios_base::failure("closed");
              }).isOk());
  CHECK(calls == 2);
}
