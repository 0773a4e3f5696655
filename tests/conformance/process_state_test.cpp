// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/process_state.hpp"

#include <fcntl.h>
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

/// The differences that `change` causes; `undo` reverts it.
std::vector<std::string> changed(auto&& change, auto&& undo) {
  const ProcessState before = processState();
  change();
  const ProcessState after = processState();
  undo();
  CHECK(differences(before, processState()).empty());
  return differences(before, after);
}

}  // namespace

TEST_CASE("an unchanged process has no differences") {
  const ProcessState before = processState();
  CHECK(differences(before, processState()).empty());
  CHECK(before.at("locale of C") == "C");
}

TEST_CASE("each change is one difference, with the value before and after") {
  const auto locale =
      changed([] { std::setlocale(LC_NUMERIC, "C.UTF-8"); }, [] { std::setlocale(LC_ALL, "C"); });
  REQUIRE(locale.size() == 1);
  CHECK(locale[0].starts_with("locale of C: 'C' became "));

  const auto rounding =
      changed([] { std::fesetround(FE_DOWNWARD); }, [] { std::fesetround(FE_TONEAREST); });
  CHECK(rounding == std::vector<std::string>{"rounding mode: '0' became '1024'"});

  const auto variable =
      changed([] { ::setenv("TOLMAN_TEST_X", "1", 1); }, [] { ::unsetenv("TOLMAN_TEST_X"); });
  CHECK(variable == std::vector<std::string>{
                        "environment variable TOLMAN_TEST_X: nothing became 'TOLMAN_TEST_X=1'"});

  const auto handler =
      changed([] { std::signal(SIGUSR2, SIG_IGN); }, [] { std::signal(SIGUSR2, SIG_DFL); });
  REQUIRE(handler.size() == 1);
  CHECK(handler[0].starts_with("handler of signal 12: "));
}

TEST_CASE("raised floating point flags are not a difference") {
  const ProcessState before = processState();
  volatile double zero = 0;
  volatile double infinite = 1 / zero;
  CHECK(infinite > 1);
  CHECK(differences(before, processState()).empty());
  std::feclearexcept(FE_ALL_EXCEPT);
}

TEST_CASE("threads and open files are counted") {
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

TEST_CASE("OutputCapture captures all ways to write, and restores the streams") {
  std::string out;
  std::string err;
  {
    const OutputCapture standard(STDOUT_FILENO);
    const OutputCapture errors(STDERR_FILENO);
    std::cout << "one ";
    std::printf("two ");
    CHECK(standard.text() == "one two ");
    CHECK(::write(STDERR_FILENO, "three", 5) == 5);
    out = standard.text();
    err = errors.text();
  }
  CHECK(out == "one two ");
  CHECK(err == "three");
  CHECK(OutputCapture(STDOUT_FILENO).text().empty());
}
