// SPDX-License-Identifier: BSD-3-Clause
#include "tolman/state_stream.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <sstream>

using namespace tolman;

namespace {

std::string saved() {
  StateWriter writer;
  writer.put(42);
  writer.put(2.5);
  writer.putAll<float>(std::array<float, 3>{1, 2, 3});
  std::ostringstream stream;
  REQUIRE(writer.write(stream, "toystate", 3).isOk());
  return stream.str();
}

Status open(const std::string& bytes, std::uint64_t version = 3) {
  std::istringstream stream(bytes);
  return StateReader::open(stream, "toystate", version).status();
}

}  // namespace

TEST_CASE("what was put comes back, and the end is known") {
  std::istringstream stream(saved());
  auto reader = StateReader::open(stream, "toystate", 3);
  REQUIRE(reader.isOk());
  CHECK(reader.value().get<int>() == 42);
  CHECK(reader.value().get<double>() == 2.5);
  CHECK_FALSE(reader.value().complete());
  std::array<float, 3> values{};
  reader.value().getAll<float>(values);
  CHECK(values[2] == 3);
  CHECK(reader.value().complete());
  CHECK(reader.value().get<int>() == 0);  // beyond the end
  CHECK_FALSE(reader.value().complete());
}

TEST_CASE("after a read beyond the end nothing remains, so loops over the rest stop") {
  std::istringstream stream(saved());
  auto reader = StateReader::open(stream, "toystate", 3);
  REQUIRE(reader.isOk());
  reader.value().get<int>();
  CHECK(reader.value().remaining() > 0);
  std::array<double, 100> values{};
  reader.value().getAll<double>(values);
  CHECK(values[0] == 0);
  CHECK(reader.value().remaining() == 0);
  CHECK_FALSE(reader.value().complete());
}

TEST_CASE("any byte but 0 is a bool that is true") {
  for (const int byte : {0, 1, 2, 63, 255}) {
    CAPTURE(byte);
    StateWriter writer;
    writer.put(static_cast<std::uint8_t>(byte));
    std::stringstream stream;
    REQUIRE(writer.write(stream, "toystate", 3).isOk());
    auto reader = StateReader::open(stream, "toystate", 3);
    REQUIRE(reader.isOk());
    CHECK(reader.value().get<bool>() == (byte != 0));
    CHECK(reader.value().complete());
  }
}

TEST_CASE("foreign, older and damaged states are refused with their reason") {
  const std::string good = saved();
  CHECK(open("hello").message() == "this is not a saved state of 'toystate'");
  CHECK(open(good, 4).message() == "the saved state has version 3, this plugin reads version 4");
  for (std::size_t at = 32; at < good.size(); ++at) {
    std::string damaged = good;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    CHECK(open(damaged).message() == "the saved state is damaged: its checksum does not agree");
  }
  CHECK_FALSE(open(good.substr(0, good.size() - 1)).isOk());
  std::string huge = good;
  huge[22] = '\x7f';  // a size of many gigabytes must not be believed
  CHECK_FALSE(open(huge).isOk());
}
