// SPDX-License-Identifier: BSD-3-Clause
// Encoded messages, decoded byte by byte.
#include <catch2/catch.hpp>

#include "browser.hpp"
#include "frame_encoder.hpp"

namespace tolman::web_viewer {

using test::parseContainer;

TEST_CASE("a container without arrays is a length, a header and zeros") {
  const std::string message = encodeContainer({{"type", "end"}}, {});
  CHECK(message.size() % 8 == 0);
  const std::string text = R"({"arrays":[],"type":"end"})";
  CHECK(message.substr(0, 4) == std::string("\x1a\0\0\0", 4));
  CHECK(message.substr(4, text.size()) == text);
  CHECK(message.substr(4 + text.size()) == std::string(message.size() - 4 - text.size(), '\0'));
}

TEST_CASE("arrays keep type, shape and values") {
  const std::vector<std::uint8_t> bytes = {1, 2, 3};
  const std::vector<std::int32_t> integers = {-5, 7};
  const std::vector<float> floats = {0.5F, -1.25F, 3};
  const std::vector<double> doubles = {1e300, -0.1};
  const auto container = parseContainer(encodeContainer(
      {{"type", "x"}},
      {pack<std::uint8_t>("bytes", {3}, bytes), pack<std::int32_t>("integers", {1, 2}, integers),
       pack<float>("none", {0, 4}, {}), pack<float>("floats", {3}, floats),
       pack<double>("doubles", {2}, doubles)}));
  CHECK(container.arrays.at("bytes").as<std::uint8_t>() == bytes);
  CHECK(container.arrays.at("integers").as<std::int32_t>() == integers);
  CHECK(container.arrays.at("integers").shape == std::vector<std::size_t>{1, 2});
  CHECK(container.arrays.at("none").shape == std::vector<std::size_t>{0, 4});
  CHECK(container.arrays.at("floats").as<float>() == floats);
  CHECK(container.arrays.at("doubles").dtype == "f64");
  CHECK(container.arrays.at("doubles").as<double>() == doubles);
}

TEST_CASE("invalid UTF-8 is replaced") {
  const auto container = parseContainer(encodeContainer({{"name", "caf\xe9"}}, {}));
  CHECK(container.header["name"] == "caf\xef\xbf\xbd");
}

}  // namespace tolman::web_viewer
