// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/process_state.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <thread>

using namespace tolman::conformance;

namespace {

/// What `change` changed, as the kit would say it; `undo` puts it back.
std::vector<std::string> changed(auto&& change, auto&& undo) {
  const ProcessState before = processState();
  change();
  const ProcessState after = processState();
  undo();
  CHECK(differences(before, processState()).empty());
  return differences(before, after);
}

}  // namespace

TEST_CASE("a quiet process has no differences") {
  const ProcessState before = processState();
  CHECK(differences(before, processState()).empty());
  CHECK(before.at("locale of C") == "C");
}

TEST_CASE("each disturbance is one difference, with what was and what is") {
  const auto locale =
      changed([] { std::setlocale(LC_NUMERIC, "C.UTF-8"); }, [] { std::setlocale(LC_ALL, "C"); });
  REQUIRE(locale.size() == 1);
  CHECK(locale[0].starts_with("locale of C: 'C' became "));

  const auto rounding =
      changed([] { std::fesetround(FE_DOWNWARD); }, [] { std::fesetround(FE_TONEAREST); });
  CHECK(rounding.size() == 2);  // the rounding of x87 and of SSE

  const auto variable =
      changed([] { ::setenv("TOLMAN_TEST_X", "1", 1); }, [] { ::unsetenv("TOLMAN_TEST_X"); });
  CHECK(variable == std::vector<std::string>{
                        "environment variable TOLMAN_TEST_X: nothing became 'TOLMAN_TEST_X=1'"});

  const auto handler =
      changed([] { std::signal(SIGUSR2, SIG_IGN); }, [] { std::signal(SIGUSR2, SIG_DFL); });
  REQUIRE(handler.size() == 1);
  CHECK(handler[0].starts_with("handler of signal 12: "));

  mode_t mask = 0;
  const auto umask = changed([&] { mask = ::umask(0123); }, [&] { ::umask(mask); });
  CHECK(umask.size() == 1);
}

TEST_CASE("a calculation that raises flags is no disturbance") {
  const ProcessState before = processState();
  volatile double zero = 0;
  volatile double infinite = 1 / zero;
  CHECK(infinite > 1);
  CHECK(differences(before, processState()).empty());
  std::feclearexcept(FE_ALL_EXCEPT);
}

TEST_CASE("threads and files are counted as they are") {
  const std::size_t before = threadCount(SIZE_MAX);
  std::atomic<bool> stop = false;
  std::thread thread([&] { stop.wait(false); });
  CHECK(threadCount(SIZE_MAX) == before + 1);
  stop = true;
  stop.notify_all();
  thread.join();
  CHECK(threadCount(before) == before);

  const auto files = openFiles();
  const int descriptor = ::open("/dev/null", O_RDONLY);
  const auto more = openFiles();
  CHECK(more.size() == files.size() + 1);
  CHECK(more.at(descriptor) == "/dev/null");
  ::close(descriptor);
  CHECK(openFiles() == files);
}

TEST_CASE("the heap knows what was allocated") {
  const std::size_t before = heapBytes();
  auto block = std::make_unique<char[]>(10'000'000);
  CHECK(heapBytes() >= before + 10'000'000);
  block.reset();
  CHECK(heapBytes() < before + 1'000'000);
  CHECK(peakResidentMib() >= residentMib());
}

TEST_CASE("a trap catches all ways to write, and lets go") {
  std::string out;
  std::string err;
  {
    const OutputTrap trap;
    std::cout << "one ";
    std::printf("two ");
    CHECK(trap.out() == "one two ");
    CHECK(::write(STDERR_FILENO, "three", 5) == 5);
    out = trap.out();
    err = trap.err();
  }
  CHECK(out == "one two ");
  CHECK(err == "three");
  const OutputTrap fresh;
  CHECK(fresh.out().empty());
}
