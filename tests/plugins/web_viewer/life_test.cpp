// SPDX-License-Identifier: BSD-3-Clause
// The observer itself: ports, addresses, what it says, and that it ends.
#include <catch2/catch.hpp>
#include <filesystem>
#include <thread>

#include "browser.hpp"
#include "bundle.hpp"
#include "drive.hpp"

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

TEST_CASE("the address is logged and written down") {
  const Drive drive;
  REQUIRE(drive.context.log.size() == 1);
  const std::string url = "http://127.0.0.1:" + std::to_string(drive.port()) + "/";
  CHECK(drive.context.log[0] == "watch at " + url);
  const auto json = nlohmann::json::parse(drive.context.artefacts.at("viewer.json"));
  CHECK(json == nlohmann::json({{"url", url}, {"port", drive.port()}}));
}

TEST_CASE("a port that is taken is an error with a remedy") {
  const Drive drive;
  const Status status = configured({{"port", std::int64_t{drive.port()}}});
  CHECK(status.code() == StatusCode::InvalidParameter);
  CHECK(status.message() == "port " + std::to_string(drive.port()) +
                                " of 127.0.0.1 is in use by another program; give another 'port', "
                                "or 0 for any that is free");
}

TEST_CASE("of the default port there may be many: the others get a free one") {
  const Drive first({{"port", std::int64_t{8080}}});
  const Drive second({{"port", std::int64_t{8080}}});
  CHECK(first.port() != second.port());
  CHECK(get(second.port(), "/").status == 200);
  CHECK(second.context.log[0].find("port 8080 is in use, port ") == 0);
}

TEST_CASE("addresses that are none, or another machine's, are refused") {
  Status status = configured({{"bind", std::string("my-house")}, {"port", std::int64_t{0}}});
  CHECK(status.code() == StatusCode::InvalidParameter);
  CHECK(status.message() ==
        "bind: 'my-house' is no address; give 127.0.0.1 for this machine alone, 0.0.0.0 for all "
        "networks");
  status = configured({{"bind", std::string("192.0.2.77")}, {"port", std::int64_t{0}}});
  CHECK(status.message() == "bind: 192.0.2.77 is no address of this machine");
}

TEST_CASE("to listen to the whole network is possible, and warned of") {
  const Drive drive({{"bind", std::string("0.0.0.0")}});
  CHECK(get(drive.port(), "/").status == 200);
  CHECK(drive.context.log[0].find("everybody who reaches this machine") != std::string::npos);
  CHECK(drive.context.log[1].find("watch at http://127.0.0.1:") == 0);
}

TEST_CASE("after finish nothing runs on and the port is free; reset begins anew") {
  const std::size_t before = threads();
  Drive drive;
  CHECK(threads() == before + 1);
  drive.frames(3);
  drive.finish();
  CHECK(threads() == before);
  REQUIRE(drive.viewer->reset().isOk());
  RunInfo run;
  run.name = "another";
  REQUIRE(drive.viewer->begin(run).isOk());
  CHECK(nlohmann::json::parse(get(drive.port(), "/api/run").body)["name"] == "another");
  CHECK(parseContainer(get(drive.port(), "/api/history").body).header["total"] == 0);
  drive.viewer.reset();
  CHECK(threads() == before);
}

TEST_CASE("it stays after the end until it is interrupted, except when nobody would know") {
  Drive drive({{"stay", true}});
  drive.frames(3);
  SECTION("quiet") {
    Drive quiet({{"stay", true}});
    quiet.context.quiet = true;
    REQUIRE(quiet.viewer->configure(quiet.context).isOk());
    quiet.finish();
  }
  SECTION("until interrupted") {
    LiveSocket socket(drive.port());
    std::thread finishing([&] { drive.finish(); });
    CHECK(socket.next("end"));
    LiveSocket late(drive.port());
    CHECK(late.next("hello")->header["live"] == false);
    CHECK(late.next("end"));
    drive.context.cancelled = true;
    finishing.join();
    const auto close = late.next();
    REQUIRE(close);
    CHECK(close->closeCode() == 1000);
  }
}

TEST_CASE("the page's files have media types") {
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
