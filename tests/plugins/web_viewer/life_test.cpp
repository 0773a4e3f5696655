// SPDX-License-Identifier: BSD-3-Clause
// The observer: ports, addresses, log, and the end of a run.
#include <catch2/catch.hpp>
#include <filesystem>
#include <thread>

#include "browser.hpp"
#include "bundle.hpp"
#include "watched_run.hpp"

namespace tolman::test {
namespace {

std::size_t threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

Status configured(ParameterValues values) {
  TestContext context(std::move(values));
  return web_viewer::WebViewer().configure(context);
}

}  // namespace

TEST_CASE("the address is logged, returned, and written as an artefact") {
  const WatchedRun watched;
  REQUIRE(watched.context.log.size() == 1);
  const std::string url = "http://127.0.0.1:" + std::to_string(watched.port()) + "/";
  CHECK(watched.context.log[0] == "watch at " + url);
  CHECK(watched.viewer->url() == url);
  const auto json = nlohmann::json::parse(watched.context.artefacts.at("viewer.json"));
  CHECK(json == nlohmann::json({{"url", url}, {"port", watched.port()}}));
}

TEST_CASE("a port in use is an error with a remedy") {
  const WatchedRun watched;
  const Status status = configured({{"port", std::int64_t{watched.port()}}});
  CHECK(status.code() == StatusCode::InvalidParameter);
  CHECK(status.message() == "port " + std::to_string(watched.port()) +
                                " of 127.0.0.1 is in use by another program; give another 'port', "
                                "or 0 for any free port");
}

TEST_CASE("when the default port is in use a free one is used") {
  const WatchedRun first({{"port", std::int64_t{8080}}});
  const WatchedRun second({{"port", std::int64_t{8080}}});
  CHECK(first.port() != second.port());
  CHECK(get(second.port(), "/").status == 200);
  CHECK(second.context.log[0].find("port 8080 is in use, using port ") == 0);
}

TEST_CASE("invalid addresses and those of other machines are refused") {
  Status status = configured({{"bind", std::string("my-house")}, {"port", std::int64_t{0}}});
  CHECK(status.code() == StatusCode::InvalidParameter);
  CHECK(status.message() ==
        "bind: 'my-house' is not an IP address; give 127.0.0.1 for this machine alone, 0.0.0.0 for "
        "all "
        "networks");
  status = configured({{"bind", std::string("192.0.2.77")}, {"port", std::int64_t{0}}});
  CHECK(status.message() == "bind: 192.0.2.77 is not an address of this machine");
}

TEST_CASE("listening on all networks gives a warning") {
  const WatchedRun watched({{"bind", std::string("0.0.0.0")}});
  CHECK(get(watched.port(), "/").status == 200);
  CHECK(watched.context.log[0].find("everybody who reaches this machine") != std::string::npos);
  CHECK(watched.context.log[1].find("watch at http://127.0.0.1:") == 0);
}

TEST_CASE("finish ends the thread and frees the port; reset starts again") {
  const std::size_t before = threads();
  WatchedRun watched;
  CHECK(threads() == before + 1);
  watched.frames(3);
  watched.finish();
  CHECK(threads() == before);
  REQUIRE(watched.viewer->reset().isOk());
  RunInfo run;
  run.name = "another";
  REQUIRE(watched.viewer->begin(run).isOk());
  CHECK(nlohmann::json::parse(get(watched.port(), "/api/run").body)["run"]["name"] == "another");
  CHECK(parseContainer(get(watched.port(), "/api/history").body).header["total"] == 0);
  watched.viewer.reset();
  CHECK(threads() == before);
}

TEST_CASE("with stay it serves until interrupted, unless quiet") {
  WatchedRun watched({{"stay", true}});
  watched.frames(3);
  SECTION("quiet") {
    WatchedRun quiet({{"stay", true}, {"quiet", true}});
    quiet.finish();
  }
  SECTION("until interrupted") {
    LiveSocket socket(watched.port());
    Status ended;
    std::thread finishing([&] { ended = watched.end(); });
    CHECK(socket.next("end"));
    LiveSocket late(watched.port());
    CHECK(late.next("hello")->header["live"] == false);
    CHECK(late.next("end"));
    watched.context.cancelled = true;
    finishing.join();
    CHECK(ended.isOk());
    const auto close = late.next();
    REQUIRE(close);
    CHECK(close->closeCode() == 1000);
  }
}

TEST_CASE("the files of the page have media types") {
  CHECK(web_viewer::mediaType("index.html") == "text/html; charset=utf-8");
  CHECK(web_viewer::mediaType("assets/a.b.js") == "text/javascript; charset=utf-8");
  CHECK(web_viewer::mediaType("assets/a.css") == "text/css; charset=utf-8");
  CHECK(web_viewer::mediaType("LICENSE") == "application/octet-stream");
  bool has_page = false;
  for (const auto& file : web_viewer::bundle()) {
    CHECK_FALSE(file.bytes.empty());
    has_page = has_page || file.path == "index.html";
  }
  CHECK(has_page);
}

}  // namespace tolman::test
