// SPDX-License-Identifier: BSD-3-Clause
// The mean of a pass: a plain mean at first, then one that follows the light; after a break the old
// mean has less weight.
#include <catch2/catch.hpp>
#include <cmath>

#include "edge_grid.hpp"
#include "part_state.hpp"
#include "random_views.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

EdgeValues filled(float value) {
  EdgeValues view;
  view.fill(value);
  return view;
}

std::string bytesOf(const MeanView& mean) {
  return savedBytes([&](StateWriter& writer) { mean.save(writer); });
}

bool takes(MeanView& mean, const std::string& bytes) {
  StateReader reader = readerOf(bytes);
  return mean.load(reader) && reader.complete();
}

}  // namespace

TEST_CASE("the mean of up to a hundred views is their plain mean") {
  RandomStream random(1);
  MeanView mean;
  std::array<double, kValues> sums{};
  for (int n = 1; n <= 100; ++n) {
    const EdgeValues view = randomLevels(random);
    mean.add(view);
    for (std::size_t i = 0; i < kValues; ++i) sums[i] += view[i];
    if (n % 11 != 1) continue;
    for (std::size_t i = 0; i < kValues; ++i) {
      REQUIRE(mean.mean()[i] == Approx(sums[i] / n).margin(1e-4));
    }
  }
}

TEST_CASE("then it follows what the last hundred or so look like") {
  MeanView mean;
  for (int i = 0; i < 500; ++i) mean.add(filled(2));
  CHECK(mean.mean()[7] == Approx(2));
  for (int i = 0; i < 100; ++i) mean.add(filled(10));
  CHECK(mean.mean()[7] == Approx(10 - 8 / std::exp(1)).margin(0.1));
  for (int i = 0; i < 500; ++i) mean.add(filled(10));
  CHECK(mean.mean()[7] == Approx(10).margin(0.1));
}

TEST_CASE("after a break new views count for more") {
  MeanView plain;
  MeanView broken;
  for (int i = 0; i < 200; ++i) {
    plain.add(filled(2));
    broken.add(filled(2));
  }
  broken.beginPass();
  CHECK(broken.mean()[0] == Approx(2));  // until there are some
  for (int i = 0; i < 20; ++i) {
    plain.add(filled(10));
    broken.add(filled(10));
  }
  CHECK(broken.mean()[0] == Approx(6).margin(0.2));  // twenty carried, twenty new
  CHECK(plain.mean()[0] < 4);
  MeanView fresh;
  fresh.beginPass();
  fresh.add(filled(5));
  CHECK(fresh.mean() == filled(5));
}

TEST_CASE("a loaded mean goes on as the saved one would; damaged ones are refused") {
  RandomStream random(2);
  MeanView saved;
  for (int i = 0; i < 30; ++i) saved.add(randomLevels(random));
  MeanView loaded;
  loaded.add(filled(3));
  const std::string sound = bytesOf(saved);
  REQUIRE(takes(loaded, sound));
  for (int i = 0; i < 10; ++i) {
    const EdgeValues view = randomLevels(random);
    saved.add(view);
    loaded.add(view);
  }
  CHECK(saved.mean() == loaded.mean());
  for (const float wild : {float{NAN}, float{INFINITY}, -1.0F, 1e30F}) {
    for (const std::size_t at : {std::size_t{0}, std::size_t{4}, sound.size() - 4}) {
      MeanView other;
      CAPTURE(wild, at);
      CHECK_FALSE(takes(other, overwritten(sound, at, wild)));
    }
  }
  MeanView other;
  CHECK_FALSE(takes(other, sound.substr(0, sound.size() - 1)));
}
