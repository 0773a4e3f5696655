// SPDX-License-Identifier: BSD-3-Clause
// Calls into plugins: any exception becomes a failure that names stage, plugin, call and frame.
#include "host/guard.hpp"

#include <immintrin.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <clocale>
#include <csignal>
#include <ios>
#include <limits>
#include <locale>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

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

TEST_CASE("exceptions of any type become a failure with their text") {
  const auto thrown = [](auto error) {
    return guarded(kTrack, [&]() -> Status { throw error; }).message();
  };
  const std::string site = "odometry (mine), track, frame 12: threw";
  CHECK(thrown(std::runtime_error("no memory left")) == site + ": no memory left");
  CHECK(thrown(ShortLived()) == site + ": " + ShortLived().text);
  CHECK(thrown(std::bad_alloc()) ==
        site + ": std::bad_alloc (out of memory: `ulimit -v`, or that of the machine)");
  CHECK(thrown(std::logic_error("")) == site + ": ");
  CHECK(thrown(3) == site + " something that is not a std::exception");
  CHECK(thrown("text") == site + " something that is not a std::exception");
}

TEST_CASE("a failure keeps its code and gets the call site, with the frame if there is one") {
  for (const StatusCode code :
       {StatusCode::InvalidInput, StatusCode::InvalidParameter, StatusCode::Failed}) {
    const Status status = guarded(kConfigure, [&] { return Status(code, "is wrong"); });
    CHECK(status.code() == code);
    CHECK(status.message() == "map (mine), configure: is wrong");
  }
  CHECK(prefix({"source", "kitti", "next", 0}) == "source (kitti), next, frame 0: ");
}

TEST_CASE("a call that had no memory is told from one that failed, or met a limit of its own") {
  const auto failed = [](const auto& error) {
    return guarded(kTrack, [&]() -> Status { throw error; });
  };
  CHECK(isOutOfMemory(failed(std::bad_alloc())));
  CHECK(isOutOfMemory(Status::failed("odometry (mine), track: out of memory")));
  CHECK(isOutOfMemory(failed(std::runtime_error(
      "OpenCV(4.6.0) alloc.cpp:73: error: (-4:Insufficient memory) Failed to allocate 9 bytes"))));
  CHECK_FALSE(isOutOfMemory(failed(std::runtime_error("broken"))));
  CHECK_FALSE(isOutOfMemory(Status::ok()));
  const Status limited = failed(std::bad_alloc());
  CHECK_FALSE(
      isOutOfMemory(Status::failed(limited.message() + "; isolation.memory_limit is 200 MiB")));
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

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they end the process
TEST_CASE("a failure is reported even if there is no memory for its text") {
  struct Large : std::exception {
    std::string text = std::string(std::size_t{64} << 20U, 'x');
    const char* what() const noexcept override { return text.c_str(); }
  };
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_AS, &before) == 0);
  const rlimit short_of_memory = {std::size_t{1} << 20U, before.rlim_max};
  Status thrown;
  Status returned;
  std::string text(std::size_t{64} << 20U, 'x');
  try {
    throw Large();
  } catch (const Large&) {
    REQUIRE(::setrlimit(RLIMIT_AS, &short_of_memory) == 0);
    thrown = guarded(kTrack, []() -> Status { throw; });
    returned = guarded(kTrack, [&] { return Status::invalidInput(std::move(text)); });
    REQUIRE(::setrlimit(RLIMIT_AS, &before) == 0);
  }
  CHECK(thrown.message() == "odometry (mine), track, frame 12: out of memory");
  CHECK(returned.code() == StatusCode::InvalidInput);
  CHECK(returned.message().starts_with("odometry (mine), track, frame 12: xxxx"));
  CHECK(returned.message().size() < 11'000);  // cut
}
#endif

TEST_CASE(
    "a call leaves rounding, subnormal numbers, locales and handlers of signals as they were") {
  struct Decimal : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const auto halfOfLeast = [] {
    volatile double least = std::numeric_limits<double>::min();
    return least / 2;
  };
  const auto handler = std::signal(SIGTERM, SIG_IGN);
  std::set<std::string> changed;
  const auto change = [&] {
    _mm_setcsr(_mm_getcsr() | 0x8040U | _MM_ROUND_UP);  // as -ffast-math does, and more
    std::setlocale(LC_ALL, "C.UTF-8");
    std::locale::global(std::locale(std::locale(), new Decimal));
    std::signal(SIGTERM, SIG_DFL);
    CHECK(halfOfLeast() == 0);
    return Status::ok();
  };
  CHECK(guarded({"odometry", "mine", "configure", -1}, change, &changed).isOk());
  CHECK(halfOfLeast() > 0);
  CHECK((_mm_getcsr() & _MM_ROUND_MASK) == 0);
  CHECK(std::string(std::setlocale(LC_ALL, nullptr)) == "C");
  CHECK(std::locale() == std::locale::classic());
  CHECK(std::signal(SIGTERM, handler) == SIG_IGN);
  CHECK(changed == std::set<std::string>{"floating point control (denormals, traps)",
                                         "handler of signal 15", "locale of C", "locale of C++",
                                         "rounding mode"});
}
