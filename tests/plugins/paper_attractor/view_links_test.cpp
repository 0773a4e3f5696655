// SPDX-License-Identifier: BSD-3-Clause
// Links of local view cells: age of templates and habituation.
#include "view_links.hpp"

#include <catch2/catch.hpp>

using namespace tolman::paper_attractor;

namespace {

ViewLinks linksWith(int templates, const HabituationSettings& settings) {
  ViewLinks links(settings);
  for (int id = 0; id < templates; ++id) {
    links.countView();
    links.learn(id, {});
  }
  return links;
}

bool show(ViewLinks& links, std::int64_t id) {
  links.countView();
  return links.activate(id);
}

}  // namespace

TEST_CASE("the third view in a row no longer injects") {
  // decay 1.0, 2.0, 2.96: exp(1.2 * 2) = 11.0 < 30 < exp(1.2 * 2.96) = 34.9
  ViewLinks links = linksWith(20, {.first_views_ignored = 0});
  CHECK(show(links, 3));
  CHECK(show(links, 3));
  CHECK_FALSE(show(links, 3));
  CHECK_FALSE(show(links, 3));
  CHECK(show(links, 4));  // another one is fresh
}

TEST_CASE("habituation wears off by 0.04 a view") {
  // After the third view: 2.96. Four views later (and this one): 2.96 - 0.2 = 2.76 < 2.834.
  for (const auto& [others, expected] : {std::pair{2, false}, std::pair{4, true}}) {
    ViewLinks links = linksWith(20, {.first_views_ignored = 0});
    for (int i = 0; i < 3; ++i) show(links, 3);
    for (int i = 0; i < others; ++i) show(links, 5 + i);
    CHECK(show(links, 3) == expected);
  }
}

TEST_CASE("a view that alternates with others does not habituate") {
  ViewLinks links = linksWith(20, {.first_views_ignored = 0});
  for (int i = 0; i < 20; ++i) CHECK(show(links, i % 2));
}

TEST_CASE("the ten newest templates do not inject") {
  ViewLinks links = linksWith(20, {.first_views_ignored = 0});
  CHECK(show(links, 9));
  CHECK_FALSE(show(links, 10));
  CHECK_FALSE(show(links, 19));
  // With fewer than ten templates none does (an unsigned difference once got this wrong).
  ViewLinks few = linksWith(5, {.first_views_ignored = 0});
  CHECK_FALSE(show(few, 0));
}

TEST_CASE("nothing injects among the first fifty views") {
  ViewLinks links = linksWith(30, {});
  for (int view = 31; view <= 50; ++view) CHECK_FALSE(show(links, view % 2));
  CHECK(show(links, 1));  // view 51
}

TEST_CASE("a template that was never learned") {
  ViewLinks links = linksWith(20, {.first_views_ignored = 0});
  CHECK(links.find(99) == nullptr);
  CHECK_FALSE(show(links, 99));
  CHECK(links.find(99) == nullptr);
  CHECK(links.find(7)->order == 7);
}
