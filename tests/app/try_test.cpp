// SPDX-License-Identifier: BSD-3-Clause
// tolman try: combinations on a recording, ranked.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// A pose graph of two rounds of a square of 40 m, whose odometry turns 0.1 degrees a metre too
/// far; on the second round every place is recognised, with its pose.
void writeSquare(const fs::path& folder, bool with_truth) {
  constexpr int kSide = 40;
  constexpr int kRound = 4 * kSide;
  std::ofstream odometry(folder / "odometry.g2o");
  std::ofstream truth;
  if (with_truth) truth.open(folder / "ground_truth.g2o");
  std::ofstream loops(folder / "loop_candidates.g2o");
  for (int i = 1; i <= 2 * kRound; ++i) {
    const double turn = i % kSide < 5 ? std::acos(0.0) / 5 : 0;
    const char* information = "100 0 0 100 0 1000";
    odometry << fmt::format("EDGE_SE2 {} {} 1 0 {:.9f} {}\n", i - 1, i, turn + 0.0017, information);
    truth << fmt::format("EDGE_SE2 {} {} 1 0 {:.9f} {}\n", i - 1, i, turn, information);
    if (i > kRound) loops << fmt::format("EDGE_SE2 {} {} 0 0 0 {}\n", i - kRound, i, information);
  }
}

/// The command on that recording.
struct Tried {
  TemporaryFolder folder;
  fs::path recording = folder.path() / "square";
  fs::path out = folder.path() / "tried";
  Finished finished;

  explicit Tried(bool with_truth) {
    fs::create_directories(recording);
    writeSquare(recording, with_truth);
    finished = run();
  }
  Finished run() const {
    return tolman::test::tolman({"try", recording.string(), "--out", out.string()});
  }
};

}  // namespace

TEST_CASE("the best combination is named, with what the recording cannot decide") {
  const Tried square(true);
  const Finished& tried = square.finished;
  INFO(tried.err << tried.out);
  REQUIRE(tried.exit_code == 0);
  CHECK(tried.out.find("ended     6 of 6") != std::string::npos);
  const std::size_t best = tried.out.find("\nbest      cells=");
  REQUIRE(best != std::string::npos);
  CHECK(tried.out.find("m (95 %: ", best) != std::string::npos);
  CHECK(tried.out.find("never returns") == std::string::npos);
  const Finished again = tolman::test::tolman({"run", (square.out / "best.yaml").string(), "-q",
                                               "--out", (square.folder.path() / "again").string()});
  CHECK(again.exit_code == 0);
  CHECK(square.run().exit_code == 8);
}

TEST_CASE("without truth nothing is called best") {
  const Tried square(false);
  const Finished& tried = square.finished;
  INFO(tried.err << tried.out);
  REQUIRE(tried.exit_code == 0);
  CHECK(tried.out.find("without true poses nobody can say which is best") != std::string::npos);
  CHECK(fs::exists(square.out / "best.yaml"));
}
