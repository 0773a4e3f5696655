// SPDX-License-Identifier: BSD-3-Clause
// Edit distance against known values and its definition, and which names are near.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "config/text.hpp"
#include "tolman/context.hpp"

namespace tolman {
namespace {

/// The recursive definition, without a table.
std::size_t slowDistance(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::size_t m = a.size();
  const std::size_t n = b.size();
  std::size_t best = std::min(
      {slowDistance(a.substr(0, m - 1), b) + 1, slowDistance(a, b.substr(0, n - 1)) + 1,
       slowDistance(a.substr(0, m - 1), b.substr(0, n - 1)) + (a[m - 1] == b[n - 1] ? 0 : 1)});
  if (m > 1 && n > 1 && a[m - 1] == b[n - 2] && a[m - 2] == b[n - 1]) {
    best = std::min(best, slowDistance(a.substr(0, m - 2), b.substr(0, n - 2)) + 1);
  }
  return best;
}

std::string randomWord(RandomStream& random) {
  std::string word;
  for (std::uint64_t i = random.below(6); i > 0; --i) {
    word += static_cast<char>('a' + random.below(3));
  }
  return word;
}

}  // namespace

TEST_CASE("Edit distances of textbook examples") {
  CHECK(config::editDistance("kitten", "sitting") == 3);
  CHECK(config::editDistance("", "abc") == 3);
  CHECK(config::editDistance("abc", "") == 3);
  CHECK(config::editDistance("plugni", "plugin") == 1);  // a swap is one slip
  CHECK(config::editDistance("Active-Points", "active_points") == 0);
}

TEST_CASE("The distance agrees with its recursive definition and is symmetric") {
  RandomStream random(11);
  for (int i = 0; i < 200; ++i) {
    const std::string a = randomWord(random);
    const std::string b = randomWord(random);
    CAPTURE(a, b);
    CHECK(config::editDistance(a, b) == slowDistance(a, b));
    CHECK(config::editDistance(a, b) == config::editDistance(b, a));
  }
}

TEST_CASE("The nearest name is a likely one, or none") {
  const std::vector<std::string> known = {"threshold", "thresholds", "columns", "rows", "x"};
  CHECK(config::nearestName("treshold", known) == "threshold");
  CHECK(config::nearestName("colums", known) == "columns");
  CHECK(config::nearestName("row", known) == "rows");
  CHECK_FALSE(config::nearestName("window_size", known));
  CHECK_FALSE(config::nearestName("ab", known));  // two changes of two letters mean nothing
  CHECK_FALSE(config::nearestName("", known));
  CHECK_FALSE(config::nearestName("rows", {}));
  CHECK(config::didYouMean("row", known) == "; did you mean 'rows'?");
  CHECK(config::didYouMean("window_size", known).empty());
}

}  // namespace tolman
