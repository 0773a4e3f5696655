// SPDX-License-Identifier: BSD-3-Clause
// Answers to request targets without a socket: valid, refused and random targets.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <set>

#include "browser.hpp"
#include "bundle.hpp"
#include "http_connection.hpp"
#include "support/paths.hpp"
#include "tolman/context.hpp"
#include "watched_run.hpp"

namespace tolman::web_viewer {
namespace {

/// A store with rows, frames at 0, 4, 8, ..., and templates.
struct Filled {
  explicit Filled(std::int64_t frames) {
    Handover handover(false);
    for (std::int64_t i = 0; i < frames; ++i) {
      (void)handover.put(test::TestFrame(i).snapshot());
      PendingData pending;
      handover.take(pending, i % 4 == 0, true);
      store.add(pending);
    }
  }
  RunStore store = {{}, 64U << 20U};
};

unsigned statusOf(const RunStore& store, std::string_view target) {
  return respond("GET", target, store).status;
}

}  // namespace

TEST_CASE("history: any part of the rows, by numbers that are whole and not negative") {
  const Filled run(25);
  const RunStore& store = run.store;
  struct Case {
    const char* query;
    std::size_t rows, first;
  };
  for (const Case& c : {Case{"", 25, 0}, Case{"?from=7", 18, 7}, Case{"?count=3", 3, 0},
                        Case{"?from=24&count=9", 1, 24}, Case{"?count=2&from=5", 2, 5},
                        Case{"?from=25", 0, 0}, Case{"?from=9223372036854775807", 0, 0},
                        Case{"?count=0", 0, 0}, Case{"?from=3&from=6", 19, 6}}) {
    CAPTURE(c.query);
    const HttpResponse got = respond("GET", std::string("/api/history") + c.query, store);
    REQUIRE(got.status == 200);
    const test::Container history = test::parseContainer(got.body);
    CHECK(history.header["total"] == 25);
    const auto& rows = history.arrays.at("rows");
    REQUIRE(rows.shape == std::vector<std::size_t>{c.rows, rowColumns().size()});
    if (c.rows > 0) CHECK(rows.as<double>()[0] == static_cast<double>(c.first));
  }
  for (const char* query : {"?from=-1", "?from=", "?from", "?from=1x", "?from= 1", "?from=+1",
                            "?from=0x1", "?from=1.0", "?from=9223372036854775808", "?until=3",
                            "?from=1&&count=2", "?FROM=1", "?from=1;count=2"}) {
    CAPTURE(query);
    CHECK(statusOf(store, std::string("/api/history") + query) == 400);
  }
  CHECK(respond("GET", "/api/history?from=%31&count=%35", store).body ==
        respond("GET", "/api/history?from=1&count=5", store).body);
}

TEST_CASE("a frame's message is the last stored one up to it") {
  const Filled run(23);
  const RunStore& store = run.store;
  for (std::int64_t asked = 0; asked < 40; ++asked) {
    const HttpResponse got = respond("GET", "/api/frame/" + std::to_string(asked), store);
    REQUIRE(got.status == 200);
    CHECK(test::parseContainer(got.body).header["frame"] ==
          std::min<std::int64_t>(asked, 22) / 4 * 4);
  }
  for (const char* bad : {"/api/frame/", "/api/frame/-1", "/api/frame/one", "/api/frame/1/",
                          "/api/frame/1?x=1", "/api/template/x"}) {
    CAPTURE(bad);
    CHECK(statusOf(store, bad) == 400);
  }
  CHECK(respond("GET", "/api/frame/-1", store).body ==
        "'-1' is no frame: give a whole number from 0.\n");
  CHECK(respond("GET", "/api/history?from=-1", store).body ==
        "'-1' is no value of from: give a whole number from 0.\n");
  CHECK(statusOf(Filled(0).store, "/api/frame/5") == 404);
  CHECK(statusOf(store, "/api/template/0") == 200);
  CHECK(statusOf(store, "/api/template/999") == 404);
}

TEST_CASE("every file of the page is served under its own name, and / is the index") {
  const Filled run(0);
  const RunStore& store = run.store;
  for (const BundleFile& file : bundle()) {
    const HttpResponse got = respond("GET", "/" + std::string(file.path), store);
    CHECK(got.status == 200);
    CHECK(got.body == file.bytes);
    CHECK(got.type == mediaType(file.path));
    CHECK(got.cacheable);
  }
  CHECK(respond("GET", "/", store).body == respond("GET", "/index.html", store).body);
  CHECK_FALSE(respond("GET", "/api/run", store).cacheable);
}

TEST_CASE("only paths are looked up, and each refusal says what it is") {
  const Filled run(1);
  const RunStore& store = run.store;
  CHECK(respond("POST", "/", store).status == 405);
  CHECK(respond("get", "/", store).status == 405);
  CHECK(respond("HEAD", "/", store).status == 200);
  for (const char* target : {"", "index.html", "http://localhost/", "*"}) {
    CHECK(statusOf(store, target) == 400);
  }
  for (const char* target : {"/../../etc/passwd", "//index.html", "/index.html/", "/api/",
                             "/api/runs", "/api/history/", "/INDEX.HTML", "/%2e%2e/x"}) {
    CAPTURE(target);
    CHECK(statusOf(store, target) == 404);
  }
  std::set<std::string> texts;
  for (const unsigned status : {400U, 403U, 404U, 405U, 431U, 503U}) {
    const HttpResponse refusal = errorResponse(status);
    CHECK(refusal.status == status);
    CHECK(refusal.body.ends_with(".\n"));
    CHECK(texts.insert(refusal.body).second);
  }
}

TEST_CASE("targets at random get an answer of the table") {
  RandomStream random(77);
  const Filled run(9);
  const RunStore& store = run.store;
  const std::vector<std::string> pieces = {"/",
                                           "api",
                                           "/api/",
                                           "frame/",
                                           "history",
                                           "?",
                                           "from=",
                                           "count=",
                                           "&",
                                           "=",
                                           "12",
                                           "-",
                                           "graph",
                                           "run",
                                           "%00",
                                           "template/",
                                           "..",
                                           "\xff",
                                           "99999999999999999999"};
  std::set<unsigned> seen;
  for (int i = 0; i < 20'000; ++i) {
    std::string target = "/";
    for (std::size_t k = random.below(6); k > 0; --k) target += pieces[random.below(pieces.size())];
    if (random.below(4) == 0) target += static_cast<char>(random.below(256));
    const unsigned status = statusOf(store, target);
    CAPTURE(target);
    REQUIRE((status == 200 || status == 400 || status == 404));
    seen.insert(status);
  }
  CHECK(seen.size() == 3);
}

TEST_CASE("the library holds the page as it was built last") {
  REQUIRE_FALSE(bundle().empty());
  for (const BundleFile& file : bundle()) {
    INFO(file.path);
    const std::string name = "plugins/observer/web_viewer/page/dist/" + std::string(file.path);
    std::ifstream stream(test::inSource(name), std::ios::binary);
    const std::string built{std::istreambuf_iterator<char>(stream), {}};
    CHECK(built == file.bytes);
  }
}

}  // namespace tolman::web_viewer
