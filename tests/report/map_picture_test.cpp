// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <regex>

#include "report/figures.hpp"
#include "report/sample_pages.hpp"

using namespace tolman;

namespace {

evaluation::Trajectory path(std::initializer_list<Eigen::Vector2d> right_forward) {
  evaluation::Trajectory trajectory;
  for (const Eigen::Vector2d& p : right_forward) {
    auto& pose = trajectory.emplace_back();
    pose.frame = static_cast<std::int64_t>(trajectory.size()) - 1;
    pose.T_world_camera.translation() << p.x(), 0, p.y();
  }
  return trajectory;
}

/// The pixels of the n-th polyline.
std::vector<Eigen::Vector2d> polyline(const std::string& svg, int n) {
  const std::regex line("<polyline[^>]*points=\"([^\"]*)\"");
  auto found = std::sregex_iterator(svg.begin(), svg.end(), line);
  std::advance(found, n);
  const std::string text = (*found)[1];
  const std::regex pair("([-0-9.]+),([-0-9.]+)");
  std::vector<Eigen::Vector2d> points;
  for (std::sregex_iterator it(text.begin(), text.end(), pair), end; it != end; ++it) {
    points.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  }
  return points;
}

}  // namespace

TEST_CASE("the picture keeps right angles and scale: forward is up, right is right") {
  report::MapPicture picture;
  picture.map = path({{0, 0}, {0, 40}, {40, 40}});
  const auto pixels = polyline(report::mapFigure({picture}), 1);  // odometry comes first
  REQUIRE(pixels.size() == 3);
  CHECK(pixels[1].x() == Approx(pixels[0].x()));
  CHECK(pixels[1].y() < pixels[0].y());  // y of a picture grows downwards
  CHECK(pixels[2].x() > pixels[1].x());
  CHECK((pixels[1] - pixels[0]).norm() == Approx((pixels[2] - pixels[1]).norm()));
}

TEST_CASE("a long straight street lies down, and a left turn stays a left turn") {
  report::MapPicture picture;
  picture.map = path({{0, 0}, {0, 100}, {-10, 100}});
  const auto pixels = polyline(report::mapFigure({picture}), 1);
  CHECK(pixels[1].x() > pixels[0].x());
  CHECK(pixels[1].y() == Approx(pixels[0].y()));
  CHECK(pixels[2].y() < pixels[1].y());  // left of rightwards is up
}

TEST_CASE("experiences are circles, loop links lines; the title cannot break the file") {
  report::MapPicture picture;
  picture.title = "a<b & c";
  picture.map = path({{0, 0}, {0, 10}});
  picture.graph.experiences.resize(3);
  for (std::int64_t i = 0; i < 3; ++i)
    picture.graph.experiences[static_cast<std::size_t>(i)].id = i;
  picture.graph.links.resize(3);
  for (std::int64_t i = 0; i < 3; ++i) {
    Link& link = picture.graph.links[static_cast<std::size_t>(i)];
    link.id = i;
    link.from = 0;
    link.to = 2;
    link.kind = i == 0 ? LinkKind::Odometry : LinkKind::Loop;
  }
  picture.graph.rejected = {2};
  const std::string svg = report::mapFigure({picture});
  CHECK(test::countOf(svg, "<circle") == 3);
  CHECK(test::countOf(svg, "stroke-width=\"2\"/>") == 1);
  CHECK(svg.find("a&lt;b &amp; c") != std::string::npos);
  CHECK(svg.find("3 experiences") != std::string::npos);
  CHECK(svg.find("1 loop link<") != std::string::npos);
}

TEST_CASE("axes are in metres") {
  report::MapPicture picture;
  picture.map = path({{0, 0}, {0, 100}, {60, 100}});
  const std::string svg = report::mapFigure({picture});
  CHECK(svg.find("right of the start (m)") != std::string::npos);
  CHECK(svg.find("ahead of the start (m)") != std::string::npos);
}

TEST_CASE("an empty run is an empty picture, not a crash") {
  const std::string svg = report::mapFigure({report::MapPicture()});
  CHECK(svg.starts_with("<svg"));
  CHECK(svg.find("nan") == std::string::npos);
}
