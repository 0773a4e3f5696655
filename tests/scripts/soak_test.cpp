// SPDX-License-Identifier: BSD-3-Clause
// scripts/soak judges tables whose growth is known.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// What changes from one row to the next, of 100 frames each.
struct Growth {
  double resident_mib = 0;
  double descriptors = 0;
  double latency_ms = 0;
};

Finished judged(const Growth& growth, int rows) {
  const TemporaryFolder folder;
  const fs::path table = folder.path() / "soak.tsv";
  std::ofstream file(table);
  file << "seconds\tframe\tdropped\tresident_mib\tdescriptors\tthreads\tserved\tlatency_ms\t"
          "latency_95_ms\tcpu_ms\tload\n";
  for (int i = 0; i < rows; ++i) {
    const double disturbance = i % 7 == 0 ? 3 : 0;  // a client more, a busy machine
    file << 10 * i << '\t' << 100 * i << "\t0\t" << 90 + growth.resident_mib * i + disturbance
         << '\t' << 17 + growth.descriptors * i + disturbance << "\t6\t" << i << '\t'
         << 10 + growth.latency_ms * i + disturbance << "\t30\t15\t1.0\n";
  }
  file.close();
  return run({inSource("scripts/soak"), "judge", table.string()});
}

}  // namespace

TEST_CASE("A soak without growth is flat, whatever single rows say") {
  const Finished finished = judged({}, 100);
  INFO(finished.out << finished.err);
  CHECK(finished.exit_code == 0);
  CHECK_FALSE(contains(finished.out, "GROWS"));
}

TEST_CASE("A soak names what grows") {
  const auto [growth, name] = GENERATE(table<Growth, std::string>(
      {{{0.5, 0, 0}, "memory"}, {{0, 0.1, 0}, "descriptors"}, {{0, 0, 0.1}, "latency"}}));
  const Finished finished = judged(growth, 100);
  INFO(name << "\n" << finished.out << finished.err);
  CHECK(finished.exit_code == 1);
  const auto line = finished.out.find(name);
  REQUIRE(line != std::string::npos);
  CHECK(contains(finished.out.substr(line, finished.out.find('\n', line) - line), "GROWS"));
}

TEST_CASE("A soak that is too short is not called flat") {
  const Finished finished = judged({}, 10);
  CHECK(finished.exit_code == 1);
  CHECK(contains(finished.out, "too few"));
}
