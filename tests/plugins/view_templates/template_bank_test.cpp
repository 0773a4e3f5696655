// SPDX-License-Identifier: BSD-3-Clause
// Views in fixed point: read back within half a step, from one block, also after saving.
#include "template_bank.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_templates;

namespace {

LocalView randomView(RandomStream& random, int cells) {
  LocalView view;
  for (int i = 0; i < cells; ++i) view.cells.push_back(static_cast<float>(random.uniform()));
  for (const float cell : view.cells) view.mean += static_cast<double>(cell) / cells;
  return view;
}

}  // namespace

TEST_CASE("fixed point keeps order and is exact to half a step, from 0 to 1") {
  CHECK(toFixed(0) == 0);
  CHECK(toFixed(1) == kOne);
  CHECK(int(toFixed(0.5F)) == 16384);  // 16383.5, rounded away from zero
  RandomStream random(2);
  for (int i = 0; i < 5000; ++i) {
    const auto a = static_cast<float>(random.uniform());
    const auto b = static_cast<float>(random.uniform());
    REQUIRE(std::abs(double(toFixed(a)) / kOne - double(a)) <= 0.5 / kOne + 1e-7);
    if (a < b) REQUIRE(toFixed(a) <= toFixed(b));
  }
}

TEST_CASE("views are found under their numbers, one behind the other in memory") {
  RandomStream random(3);
  TemplateBank bank(7, 5);
  std::vector<LocalView> views;
  for (std::int64_t id = 0; id < 300; ++id) {
    views.push_back(randomView(random, 35));
    REQUIRE(bank.add(views.back()) == id);
  }
  REQUIRE(bank.size() == 300);
  REQUIRE(bank.cellsPerTemplate() == 35);
  for (std::size_t id = 0; id < views.size(); ++id) {
    const auto cells = bank.cells(static_cast<std::int64_t>(id));
    REQUIRE(cells.data() == bank.allCells().data() + 35 * id);
    for (std::size_t k = 0; k < 35; ++k) REQUIRE(cells[k] == toFixed(views[id].cells[k]));
    REQUIRE(bank.mean(static_cast<std::int64_t>(id)) == views[id].mean);
  }
}

TEST_CASE("a bank restored from its parts is the same; parts that do not fit are refused") {
  RandomStream random(4);
  TemplateBank bank(4, 3);
  for (int i = 0; i < 20; ++i) bank.add(randomView(random, 12));
  const std::vector<FixedCell> cells(bank.allCells().begin(), bank.allCells().end());
  const std::vector<double> means(bank.allMeans().begin(), bank.allMeans().end());
  TemplateBank other(4, 3);
  other.add(randomView(random, 12));
  other.restore(cells, means);
  REQUIRE(other.size() == 20);
  CHECK(std::equal(cells.begin(), cells.end(), other.allCells().begin()));
  CHECK_THROWS_AS(other.restore(std::vector<FixedCell>(cells.begin(), cells.end() - 1), means),
                  std::invalid_argument);
  CHECK_THROWS_AS(other.restore({}, means), std::invalid_argument);
  CHECK(other.size() == 20);  // as before the refusals
  CHECK_THROWS_AS(other.add(randomView(random, 11)), std::invalid_argument);
  CHECK(other.size() == 20);
  other.clear();
  CHECK(other.size() == 0);
  CHECK(other.allCells().empty());
  CHECK(other.add(randomView(random, 12)) == 0);
}
