// SPDX-License-Identifier: BSD-3-Clause
// Lines of constant speed through columns of known values.
#include "line_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::seqslam;

namespace {

using Columns = std::deque<std::vector<float>>;

/// Values by chance from 0 to 1 with a line of -2 that ends at view `end` at this speed.
Columns withLine(int images, int views, int end, double speed, RandomStream& random) {
  Columns columns;
  for (int image = 0; image < images; ++image) {
    std::vector<float> column;
    for (int i = 0; i < views; ++i) column.push_back(static_cast<float>(random.uniform()));
    const auto at = end - std::lround(speed * (images - 1 - image));
    if (at >= 0 && at < views) column[std::size_t(at)] = -2;
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace

TEST_CASE("a line is found at its end, at every speed that is tried") {
  RandomStream random(1);
  const LineSearch search({});
  for (const double speed : {0.8, 0.9, 1.0, 1.1, 1.2}) {
    for (const int end : {11, 30, 59}) {
      const auto found = search.best(withLine(10, 60, end, speed, random), 60);
      CAPTURE(speed, end);
      REQUIRE(found);
      CHECK(found->end == end);
      CHECK(found->score == Approx(-2));
      CHECK(found->rival > -1);
    }
  }
}

TEST_CASE("faster and slower lines are not seen whole") {
  RandomStream random(2);
  for (const double speed : {0.4, 1.8}) {
    const auto found = LineSearch({}).best(withLine(10, 60, 40, speed, random), 60);
    REQUIRE(found);
    CHECK(found->score > -1.8);
  }
  const LineSearch wide({10, 0.4, 1.8, 0.2, 5});
  CHECK(wide.best(withLine(10, 60, 40, 1.8, random), 60)->score == Approx(-2));
}

TEST_CASE("the best line is the least mean of all lines, searched one by one") {
  RandomStream random(3);
  const LineSettings settings{6, 0.5, 1.5, 0.25, 3};
  const LineSearch search(settings);
  for (int round = 0; round < 30; ++round) {
    const Columns columns = withLine(6, 40, -1, 1, random);
    std::vector<double> scores(40, std::numeric_limits<double>::infinity());
    for (const double speed : {0.5, 0.75, 1.0, 1.25, 1.5}) {
      for (int end = 0; end < 40; ++end) {
        double sum = 0;
        bool fits = true;
        for (int back = 0; back < 6; ++back) {
          const auto view = end - std::lround(speed * back);
          fits = fits && view >= 0;
          if (fits) sum += columns[std::size_t(5 - back)][std::size_t(view)];
        }
        if (fits) scores[std::size_t(end)] = std::min(scores[std::size_t(end)], sum / 6);
      }
    }
    const auto least = std::ranges::min_element(scores) - scores.begin();
    double rival = std::numeric_limits<double>::infinity();
    for (int end = 0; end < 40; ++end) {
      if (std::abs(end - least) > 3) rival = std::min(rival, scores[std::size_t(end)]);
    }
    const auto found = search.best(columns, 40);
    REQUIRE(found);
    CHECK(found->end == least);
    CHECK(found->score == Approx(scores[std::size_t(least)]));
    CHECK(found->rival == Approx(rival));
  }
}

TEST_CASE("no answer with too few columns, views or rivals") {
  RandomStream random(4);
  const LineSearch search({});
  CHECK_FALSE(search.best({}, 0));
  CHECK_FALSE(search.best(withLine(9, 60, 30, 1, random), 60));
  CHECK_FALSE(search.best(withLine(10, 60, 30, 1, random), 0));
  CHECK_FALSE(search.best(withLine(10, 60, 30, 1, random), -5));
  CHECK_FALSE(search.best(withLine(10, 7, 6, 1, random), 7));    // no line fits in
  CHECK_FALSE(search.best(withLine(10, 12, 9, 1, random), 12));  // nothing but the same place
  CHECK(search.best(withLine(10, 20, 9, 1, random), 20));
}

TEST_CASE("lines through views that were not yet stored do not count") {
  RandomStream random(5);
  Columns columns = withLine(10, 60, 59, 1, random);
  for (std::size_t image = 0; image < 10; ++image) columns[image].resize(40 + 2 * image);
  const auto found = LineSearch({}).best(columns, 60);
  REQUIRE(found);
  CHECK(found->end < 58);
}
