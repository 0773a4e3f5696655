// SPDX-License-Identifier: BSD-3-Clause
#include "report/svg.hpp"

#include <catch2/catch.hpp>

using namespace tolman::report;

TEST_CASE("names from a configuration cannot become markup") {
  CHECK(escaped("<script>\"a\" & b</script>") ==
        "&lt;script&gt;&quot;a&quot; &amp; b&lt;/script&gt;");
  Svg svg(10, 10);
  svg.text({1, 2}, "</text><script>");
  const std::string text = svg.take();
  CHECK(text.find("<script>") == std::string::npos);
  CHECK(text.find("&lt;/text&gt;&lt;script&gt;") != std::string::npos);
}

TEST_CASE("control characters and damaged UTF-8 are replaced: XML forbids them") {
  CHECK(escaped("a\033[31m\xff\n") == "a\xef\xbf\xbd[31m\xef\xbf\xbd\n");
}

TEST_CASE("a picture says its size and draws what it is told") {
  Svg svg(120, 80);
  svg.line({1, 2}, {3, 4}, kBlue, 2);
  svg.circle({5, 6}, 3, kGreen);
  svg.rectangle({7, 8}, {9, 10}, "none", kGrey);
  svg.text({1, 1}, "up", {TextAnchor::End, 10, -90, true});
  const std::string text = svg.take();
  CHECK(text.find("width=\"120\" height=\"80\"") != std::string::npos);
  CHECK(text.find("<line x1=\"1.0\" y1=\"2.0\" x2=\"3.0\" y2=\"4.0\"") != std::string::npos);
  CHECK(text.find("<circle cx=\"5.0\" cy=\"6.0\" r=\"3\" fill=\"#009E73\"") != std::string::npos);
  CHECK(text.find("rotate(-90 1.0 1.0)") != std::string::npos);
  CHECK(text.ends_with("</svg>\n"));
}
