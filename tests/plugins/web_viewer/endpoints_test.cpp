// SPDX-License-Identifier: BSD-3-Clause
// Every URL of the server, requested over a socket.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "browser.hpp"
#include "watched_run.hpp"
#include "wire_records.hpp"

namespace tolman::test {
namespace {

/// A run of 25 frames that has ended and is still served.
struct Served {
  explicit Served(ParameterValues values = {}) : watched(staying(std::move(values))) {
    watched.frames(25);
    finishing = std::thread([this] { ended = watched.end(); });
    while (nlohmann::json::parse(get(watched.port(), "/api/run").body)["live"] == true) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  ~Served() {
    watched.context.cancelled = true;
    finishing.join();
    CHECK(ended.isOk());
  }
  static ParameterValues staying(ParameterValues values) {
    values["stay"] = true;
    return values;
  }
  HttpAnswer get(int port, const std::string& target) const { return test::get(port, target); }
  HttpAnswer get(const std::string& target) const { return test::get(watched.port(), target); }

  WatchedRun watched;
  Status ended;
  std::thread finishing;
};

std::size_t columnIndex(std::string_view name) {
  const auto& columns = web_viewer::rowColumns();
  const auto found = std::ranges::find(columns, name, &web_viewer::RowColumn::name);
  REQUIRE(found != columns.end());
  return static_cast<std::size_t>(found - columns.begin());
}

cv::Mat decoded(const std::string& jpeg) {
  return cv::imdecode(std::vector<char>(jpeg.begin(), jpeg.end()), cv::IMREAD_GRAYSCALE);
}

}  // namespace

TEST_CASE("the page has security headers") {
  const Served served;
  const HttpAnswer page = served.get("/");
  CHECK(page.status == 200);
  CHECK(page.headers.at("content-type") == "text/html; charset=utf-8");
  CHECK(page.headers.at("x-content-type-options") == "nosniff");
  CHECK(page.headers.at("content-security-policy").find("default-src 'self'") == 0);
  // uPlot and three.js set styles of elements; inline scripts are not allowed.
  CHECK(page.headers.at("content-security-policy").find("style-src 'self' 'unsafe-inline'") !=
        std::string::npos);
  CHECK(page.headers.at("content-security-policy").find("script-src") == std::string::npos);
  CHECK(page.body.find("<html") != std::string::npos);
  CHECK(served.get("/index.html").body == page.body);
  const HttpAnswer head = get(served.watched.port(), "/", "HEAD");
  CHECK(head.status == 200);
  CHECK(head.headers.at("content-length") == std::to_string(page.body.size()));
}

TEST_CASE("/api/run describes the run and the columns") {
  const Served served;
  const HttpAnswer answer = served.get("/api/run");
  CHECK(answer.headers.at("content-type") == "application/json");
  CHECK(answer.headers.at("cache-control") == "no-store");
  const auto hello = nlohmann::json::parse(answer.body);
  const auto& run = hello["run"];
  CHECK(run["name"] == "made up");
  CHECK(run["directory"] == "/runs/made-up");
  CHECK(run["source"]["description"] == "a straight road");
  CHECK(run["source"]["frames"] == 100);
  CHECK(run["source"]["has_truth"] == true);
  CHECK(run["source"]["rig"]["pinhole.fx"] == 80);
  CHECK(run["source"]["rig"]["baseline"] == 0.5);
  CHECK(run["arrays"][0]["name"] == "hd.activity");
  CHECK(run["arrays"][0]["kind"] == "activity");
  CHECK(run["arrays"][0]["axes"][0]["unit"] == "rad");
  CHECK(hello["live"] == false);
  CHECK(hello["columns"].size() == web_viewer::rowColumns().size());
  CHECK(hello["columns"][1] ==
        nlohmann::json(
            {{"name", "frame.time"}, {"unit", "s"}, {"doc", "data time of the exposure"}}));
}

TEST_CASE("/api/history returns rows from any number on") {
  const Served served;
  const Container all = parseContainer(served.get("/api/history").body);
  CHECK(all.header["type"] == "history");
  CHECK(all.header["total"] == 25);
  const std::size_t columns = web_viewer::rowColumns().size();
  CHECK(all.arrays.at("rows").shape == std::vector<std::size_t>{25, columns});
  const auto rows = all.arrays.at("rows").as<double>();
  for (std::size_t i = 0; i < 25; ++i) {
    CHECK(rows[columns * i] == static_cast<double>(i));
    // A metre forward per frame.
    CHECK(rows[columns * i + columnIndex("odometry.z")] == Approx(static_cast<double>(i)));
    CHECK(rows[columns * i + columnIndex("truth.z")] == Approx(static_cast<double>(i)));
  }
  const Container some = parseContainer(served.get("/api/history?from=10&count=3").body);
  CHECK(some.header["from"] == 10);
  CHECK(some.arrays.at("rows").as<double>()[0] == 10);
  CHECK(some.arrays.at("rows").shape[0] == 3);
  CHECK(parseContainer(served.get("/api/history?from=25").body).arrays.at("rows").shape[0] == 0);
  const char* const odd[] = {
      "from", "from=", "from=-1", "from=1x", "count=1&x=2", "from=%3", "from=99999999999999999999"};
  for (const char* query : odd) {
    CAPTURE(query);
    CHECK(served.get(std::string("/api/history?") + query).status == 400);
  }
}

TEST_CASE("/api/frame returns the last stored frame up to a number, with all arrays") {
  const Served served({{"rate", 0.0}});
  const Container frame = parseContainer(served.get("/api/frame/7").body);
  CHECK(frame.header["type"] == "frame");
  CHECK(frame.header["frame"] == 7);
  CHECK(frame.header["points_frame"] == 7);
  CHECK_FALSE(frame.has("rows"));
  CHECK(frame.arrays.at("points").shape == std::vector<std::size_t>{2, 4});
  CHECK(frame.arrays.at("points").as<float>() ==
        std::vector<float>{10, 5, 0.5F, 0.01F, 20, 6, 0.25F, 0.02F});
  CHECK(frame.arrays.at("cells.hd.activity").as<float>() == std::vector<float>{0.25F, 0.5F, 7});
  CHECK(frame.arrays.at("cells.grid.activity").shape == std::vector<std::size_t>{2, 2});
  const cv::Mat image = decoded(frame.arrays.at("image").bytes);
  REQUIRE(image.cols == 96);
  CHECK(std::abs(image.at<std::uint8_t>(20, 30) - 37) < 12);  // column + frame
  CHECK(parseContainer(served.get("/api/frame/10").body).header["events"][0]["message"] ==
        "new view");
  CHECK(parseContainer(served.get("/api/frame/1000").body).header["frame"] == 24);
  CHECK(served.get("/api/frame/x").status == 400);
  CHECK(served.get("/api/frame/-1").status == 400);
}

TEST_CASE("wide images are reduced") {
  const Served served({{"rate", 0.0}, {"image_width", std::int64_t{48}}});
  const Container frame = parseContainer(served.get("/api/frame/3").body);
  const cv::Mat image = decoded(frame.arrays.at("image").bytes);
  CHECK(image.cols == 48);
  CHECK(image.rows == 24);
}

TEST_CASE("/api/graph returns the newest graph") {
  const Served served;
  const Container graph = parseContainer(served.get("/api/graph").body);
  CHECK(graph.header["type"] == "graph");
  CHECK(graph.header["version"] == 2);
  CHECK(graph.arrays.at("experience").as<float>() ==
        std::vector<float>{0, 0, 0, 0, 0, 0, 10, 0, 0, 0, 20, 0});
  CHECK(graph.arrays.at("link").as<std::int32_t>() == std::vector<std::int32_t>{0, 1, 1, 2, 2, 0});
  CHECK(graph.arrays.at("link_kind").as<std::uint8_t>() == std::vector<std::uint8_t>{0, 0, 1});
  CHECK(graph.arrays.at("link_rejected").as<std::uint8_t>() == std::vector<std::uint8_t>{0, 0, 1});
}

TEST_CASE("/api/template returns the image of a template") {
  const Served served;
  const HttpAnswer view = served.get("/api/template/2");
  CHECK(view.status == 200);
  CHECK(view.headers.at("content-type") == "image/jpeg");
  const cv::Mat image = decoded(view.body);
  REQUIRE(image.cols == 96);
  CHECK(std::abs(image.at<std::uint8_t>(10, 50) - 70) < 12);  // made at frame 20
  CHECK(served.get("/api/template/3").status == 404);
  CHECK(served.get("/api/template/x").status == 400);
}

TEST_CASE("before the first frame there is an empty history, an empty graph, and no frame") {
  const WatchedRun watched;
  const auto run = nlohmann::json::parse(get(watched.port(), "/api/run").body);
  CHECK(run["live"] == true);
  CHECK(parseContainer(get(watched.port(), "/api/history").body).header["total"] == 0);
  CHECK(parseContainer(get(watched.port(), "/api/graph").body).arrays.at("link").shape[0] == 0);
  CHECK(get(watched.port(), "/api/frame/0").status == 404);
}

TEST_CASE("a connection serves many requests") {
  const Served served;
  Wire wire(served.watched.port());
  for (int i = 0; i < 20; ++i) {
    wire.send("GET /api/run HTTP/1.1\r\nHost: localhost\r\n\r\n");
    CHECK(readAnswer(wire).status == 200);
  }
}

}  // namespace tolman::test
