// SPDX-License-Identifier: BSD-3-Clause
// The page's declarations of the messages are those of the records. The hidden case [generate]
// writes them; scripts/build-page runs it.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "records_typescript.hpp"
#include "wire_records.hpp"

namespace tolman::web_viewer {

TEST_CASE("records.ts is generated from the present field lists") {
  std::ifstream file(TOLMAN_RECORDS_TYPESCRIPT);
  std::stringstream text;
  text << file.rdbuf();
  INFO("run scripts/build-page and commit the page");
  CHECK(text.str() == recordsTypeScript());
}

TEST_CASE("writes records.ts", "[.][generate]") {
  std::ofstream(TOLMAN_RECORDS_TYPESCRIPT) << recordsTypeScript();
}

TEST_CASE("a header is an object of the record's fields, with the record's name as type") {
  FrameHeader header;
  header.frame = 7;
  header.events = {{3, LogLevel::Warning, "map", "slow"}};
  const nlohmann::json event = {
      {"frame", 3}, {"level", "warning"}, {"source", "map"}, {"message", "slow"}};
  CHECK(headerJson(header) == nlohmann::json({{"type", "frame"},
                                              {"frame", 7},
                                              {"points_frame", -1},
                                              {"rows_from", 0},
                                              {"dropped", 0},
                                              {"events", {event}}}));
}

}  // namespace tolman::web_viewer
