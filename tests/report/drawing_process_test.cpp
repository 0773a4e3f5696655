// SPDX-License-Identifier: BSD-3-Clause
// Drawing where the address space is limited.
#include "report/drawing_process.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <new>

#include "report/raster.hpp"
#include "report/svg.hpp"

using namespace tolman;
using namespace tolman::report;

namespace {

/// A limit that is far away, until the end of the scope.
class Limited {
 public:
  Limited() {
    ::getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = rlim_t{1} << 40U;
    REQUIRE(::setrlimit(RLIMIT_AS, &limit) == 0);
  }
  ~Limited() { ::setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};

}  // namespace

TEST_CASE("a figure has the same bytes with a limit and without") {
  Svg svg(100, 60);
  svg.text({10, 30}, "metres");
  const std::string text = svg.take();
  const std::string png = pngOf(text).value();
  const std::string pdf = pdfOf(text).value();
  const Limited limited;
  CHECK(pngOf(text).value() == png);
  CHECK(pdfOf(text).value() == pdf);
  CHECK(pngOf("no SVG").status().message().find("cannot be drawn") != std::string::npos);
}

TEST_CASE("a library that ends the process is told as memory that is short") {
  const Limited limited;
  for (const int signal : {SIGTRAP, SIGSEGV, SIGABRT, SIGKILL}) {
    const auto draw = [signal]() -> Result<std::string> {
      std::signal(signal, SIG_DFL);  // not the handler of the test program
      std::raise(signal);
      return std::string("never");
    };
    CHECK_THROWS_AS(drawnSafely(draw), std::bad_alloc);
  }
  CHECK_THROWS_AS(drawnSafely([]() -> Result<std::string> { throw std::bad_alloc(); }),
                  std::bad_alloc);
  CHECK_THROWS_AS(drawnSafely([]() -> Result<std::string> { std::_Exit(0); }), std::bad_alloc);
  CHECK(drawnSafely([]() -> Result<std::string> { return std::string(5'000'000, 'x'); })
            .value()
            .size() == 5'000'000);
}
