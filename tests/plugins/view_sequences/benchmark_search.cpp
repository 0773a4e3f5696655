// SPDX-License-Identifier: BSD-3-Clause
// Time of one step of the search among many stored views, on one thread, and the memory a view
// takes. Not a test: run it by hand.
//   benchmark_place_search [VIEWS...]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "place_search.hpp"

using namespace tolman::view_sequences;

namespace {

/// Random views, each like the one before it.
class Walk {
 public:
  PackedView next() {
    for (std::uint8_t& byte : view_) {
      if (random() % 4 == 0) byte = static_cast<std::uint8_t>(random());
    }
    return view_;
  }
  EdgeValues levels() const {
    std::array<std::int16_t, kValues> levels;
    unpack(view_, levels);
    EdgeValues values;
    std::copy(levels.begin(), levels.end(), values.begin());
    return values;
  }

 private:
  std::uint32_t random() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::uint32_t>(state_ >> 33U);
  }
  std::uint64_t state_ = 1;
  PackedView view_{};
};

double residentMib() {
  std::ifstream statm("/proc/self/statm");
  double total = 0;
  double resident = 0;
  statm >> total >> resident;
  return resident * 4096 / (1 << 20);
}

void measure(std::int64_t views) {
  const double before = residentMib();
  PlaceSearch search{SearchSettings{}};
  Walk walk;
  for (std::int64_t i = 0; i < views; ++i) search.add(walk.next(), static_cast<double>(i), i - 1);
  EdgeValues mean;
  mean.fill(7.5F);
  std::vector<double> times;
  for (int step = 0; step < 21; ++step) {
    walk.next();
    const auto begin = std::chrono::steady_clock::now();
    const ViewQuery query(walk.levels(), mean);
    search.step(query, static_cast<double>(views + 100 + step), 1);
    const auto found = search.candidates(5);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - begin;
    times.push_back(spent.count() + 0 * static_cast<double>(found.size()));
  }
  std::ranges::sort(times);
  std::printf("%9lld views: %7.2f ms median, %7.2f ms most; %6.0f bytes a view\n",
              static_cast<long long>(views), times[times.size() / 2], times.back(),
              (residentMib() - before) * (1 << 20) / static_cast<double>(views));
}

}  // namespace

int main(int count, char** words) {
  std::vector<std::int64_t> sizes = {1000, 10000, 100000};
  if (count > 1) sizes.clear();
  for (int i = 1; i < count; ++i) sizes.push_back(std::atoll(words[i]));
  for (const std::int64_t views : sizes) measure(views);
}
