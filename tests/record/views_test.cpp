// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "record/by_hand.hpp"
#include "record/sample_run.hpp"
#include "record/schema.hpp"
#include "support/data.hpp"
#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// A run with two experiences, a link between them, an array and a turn.
struct Run {
  Run() {
    auto recorder = Recorder::open(folder.path()).value();
    REQUIRE(recorder->begin(RunInfo()).isOk());
    Frame frame = test::frameAt(0);
    frame.has_truth = true;
    frame.T_world_camera_truth = fromPlanar({3, 4, 0.75});
    Link link = test::linkBetween(0, 0, 1, 0);
    link.kind = LinkKind::Loop;
    link.T_from_to = fromPlanar({1, -2, -2.5});
    MapGraph graph{0, {test::experienceAt(0, 0, 0), test::experienceAt(1, 0, 0)}, {link}, {}};
    for (Experience& experience : graph.experiences) experience.frame = 0;
    const std::vector<NamedArray> cells = {{"hd.activity", {2}, {1, 0.5F}}};
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.cells = &cells;
    snapshot.graph = &graph;
    const Status recorded = recorder->snapshot(snapshot);
    INFO(recorded.message());
    REQUIRE(recorded.isOk());
    REQUIRE(recorder->close().isOk());
  }
  std::vector<std::string> query(const std::string& sql) const {
    return test::queryByHand(folder.path(), sql);
  }
  test::TemporaryFolder folder;
};

}  // namespace

TEST_CASE("headings are numbers, as toPlanar() has them") {
  const Run run;
  CHECK(run.query("SELECT frame || ' ' || round(x, 6) || ' ' || round(y, 6) || ' ' || "
                  "round(heading, 6) FROM true_path") ==
        std::vector<std::string>{"0 3.0 4.0 0.75"});
  CHECK(run.query("SELECT round(x, 6) || ' ' || round(y, 6) || ' ' || round(heading, 6) FROM "
                  "map_link") == std::vector<std::string>{"1.0 -2.0 -2.5"});
}

TEST_CASE("no column of a view must be quoted") {
  const Run run;
  CHECK(run.query("SELECT from_experience || ' ' || to_experience || ' ' || kind FROM map_link") ==
        std::vector<std::string>{"0 1 loop"});
  CHECK(run.query("SELECT length(data) FROM array_data WHERE name = 'hd.activity'") ==
        std::vector<std::string>{"8"});
  for (const SqlView& view : views()) {
    for (const std::string& column :
         run.query("SELECT name FROM pragma_table_info('" + view.name + "')")) {
      INFO(view.name << "." << column);
      CHECK_NOTHROW(run.query("SELECT " + column + " FROM " + view.name));
      const bool is_named = view.doc.find("`" + column + "`") != std::string::npos;
      CHECK((is_named || view.name == "true_path"));
    }
  }
}

TEST_CASE("the reference page names every view") {
  for (const SqlView& view : views()) {
    CHECK(recordsMarkdown().find("- `" + view.name + "`: " + view.doc) != std::string::npos);
  }
}
