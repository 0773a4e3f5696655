// SPDX-License-Identifier: BSD-3-Clause
// Records in tables, written and read, with nested lists.
#include <cstring>

#include "record/by_hand.hpp"
#include "record/sample_run.hpp"
#include "record/schema.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// All tables, and the frames 0 to 2.
struct Tables {
  Database database = openDatabase(":memory:", Access::Create);
  StoreWriter store{database};

  Tables() {
    for (const Table& table : schema()) database.exec(createSql(table));
    for (std::int64_t i = 0; i < 3; ++i) store.insert(test::frameAt(i));
  }
  std::vector<NamedArray> cells(std::int64_t frame) const {
    std::vector<NamedArray> arrays;
    RowsOf<RecordedArray>(database, "WHERE frame = ? AND source = 'cells'")
        .each([&](const RecordedArray& row) { arrays.push_back(arrayOf(row)); }, frame);
    return arrays;
  }
  template <Record R>
  std::vector<R> rows(const std::string& condition = "") const {
    std::vector<R> all;
    forEachRow<R>(database, condition, [&](const R& row) { all.push_back(row); });
    return all;
  }
};

}  // namespace

TEST_CASE("an upsert replaces every column of the row with its id, and no other row") {
  Tables tables;
  RandomStream random(67);
  for (std::int64_t id = 0; id < 3; ++id) tables.store.upsert(test::experienceAt(id, id, 0));
  const Experience other{1, 2, 99, test::randomPose(random)};
  tables.store.upsert(other);
  const auto rows = tables.rows<Experience>();
  REQUIRE(rows.size() == 3);
  CHECK(rows[1].frame == 2);
  CHECK(rows[1].template_id == 99);
  CHECK(rows[1].T_world_experience.isApprox(other.T_world_experience, 1e-14));
  CHECK(rows[0].template_id == 0);
  CHECK(rows[2].template_id == 2);
}

TEST_CASE("revisions are read back with their motion, in order") {
  Tables tables;
  for (std::int64_t i = 0; i < 3; ++i) {
    Motion motion = test::motionAt(i);
    for (std::int64_t earlier = i; earlier >= 0; --earlier) {
      motion.revisions.emplace_back().frame = earlier;
    }
    tables.store.insert(motion);
  }
  MotionRevision owed;
  owed.frame = 2;
  tables.store.insertAnnounced(std::nullopt, owed);  // after the last frame: of no motion
  const auto motions = tables.rows<Motion>();
  REQUIRE(motions.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    REQUIRE(motions[i].revisions.size() == i + 1);
    CHECK(motions[i].revisions.front().frame == static_cast<std::int64_t>(i));
    CHECK(motions[i].revisions.back().frame == 0);
  }
  CHECK(tables.rows<MotionRevision>().size() == 7);
  CHECK(tables.rows<MotionRevision>("WHERE announced_at IS NULL").size() == 1);
}

TEST_CASE("loops of earlier frames are read back with their decision") {
  Tables tables;
  RandomStream random(5);
  Decision decision;
  decision.frame = 2;
  for (const std::int64_t frame : {0, 1}) {
    decision.earlier.push_back({frame, frame + 20, test::randomPose(random), Matrix6d::Identity()});
  }
  tables.store.insert(decision);
  const auto read = tables.rows<Decision>();
  REQUIRE(read.size() == 1);
  REQUIRE(read[0].earlier.size() == 2);
  CHECK(read[0].earlier[1].frame == 1);
  CHECK(read[0].earlier[1].experience == 21);
  CHECK(read[0].earlier[0].T_experience_camera.isApprox(decision.earlier[0].T_experience_camera));
  CHECK(read[0].earlier[0].covariance == Matrix6d::Identity());
}

TEST_CASE("arrays are read back with name, shape, source and every bit") {
  Tables tables;
  const std::vector<NamedArray> arrays = {
      {"scalar", {}, {std::numeric_limits<float>::denorm_min()}},
      {"grid", {2, 1, 3}, {1, -0.0F, 3, 4, 5, std::numeric_limits<float>::max()}},
      {"nothing", {0, 36}, {}}};
  tables.store.insertArrays(1, "cells", arrays);
  tables.store.insertArrays(1, "sensors", {{"grid", {1}, {7}}});
  const auto read = tables.cells(1);
  REQUIRE(read.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(read[i].name == arrays[i].name);
    CHECK(read[i].shape == arrays[i].shape);
    REQUIRE(read[i].values.size() == arrays[i].values.size());
    CHECK(std::equal(read[i].values.begin(), read[i].values.end(), arrays[i].values.begin()));
  }
  CHECK(std::signbit(read[1].values[1]));
  CHECK(tables.rows<Frame>("WHERE frame = 1").at(0).sensors.at(0).values.at(0) == 7);
  CHECK(tables.cells(0).empty());
}

TEST_CASE("a shape or a blob that cannot be is refused") {
  for (const char* shape : {"axb", "2x", "7", "3000x3000", "-2x-3"}) {
    INFO(shape);
    Tables tables;
    tables.store.insertArrays(0, "cells", {{"a", {2, 3}, {1, 2, 3, 4, 5, 6}}});
    tables.database.exec("UPDATE array SET shape = '" + std::string(shape) + "'");
    CHECK_THROWS_AS(tables.cells(0), std::domain_error);
  }
  Tables tables;
  tables.store.insertArrays(0, "cells", {{"a", {1}, {1}}});
  tables.database.exec("UPDATE array SET \"values\" = x'010203'");
  CHECK_THROWS_WITH(tables.cells(0), "a matrix has 3 bytes, which do not fit");
}

TEST_CASE("all bits of poses come back, those of nested lists too") {
  Tables tables;
  RandomStream random(8);
  Motion motion = test::motionAt(1);
  motion.T_previous_current = test::randomPose(random);
  motion.T_previous_current.translation().x() = -0.0;
  motion.revisions = {{0, test::randomPose(random), Matrix6d::Zero()}};
  tables.store.insert(motion);
  tables.store.insert(exactPosesOf(1, motion));
  Motion read = tables.rows<Motion>().at(0);
  restorePoses(tables.rows<ExactPoses>("WHERE \"of\" = 'motion'").at(0), read);
  const auto same = [](const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    return std::memcmp(a.data(), b.data(), sizeof(double) * 16) == 0;
  };
  CHECK(same(read.T_previous_current, motion.T_previous_current));
  CHECK(same(read.revisions.at(0).T_previous_current, motion.revisions[0].T_previous_current));
  CHECK_THROWS_AS(restorePoses(exactPosesOf(1, test::frameAt(1)), read), std::domain_error);
}
