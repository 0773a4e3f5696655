// SPDX-License-Identifier: BSD-3-Clause
// Records are written to SQLite and read again by their field lists.
#include <catch2/catch.hpp>

#include "record/by_hand.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// A record with a record in it, as the SDK allows.
struct Outer {
  static constexpr const char* kRecord = "outer";
  CameraRig rig;
  float weight = 0;
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(rig, "", "cameras");
    TOLMAN_FIELD(weight, "kg", "mass");
  }
};

template <class T>
void checkSame(std::string_view name, const T& a, const T& b) {
  INFO(name);
  if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    CHECK((a.matrix() - b.matrix()).norm() < 1e-14);
  } else if constexpr (Record<T>) {
    visitFields(a, [&](const Field& field, const auto& left) {
      visitFields(b, [&](const Field& other, const auto& right) {
        if constexpr (std::is_same_v<decltype(left), decltype(right)>) {
          if (field.name == other.name) checkSame(field.name, left, right);
        }
      });
    });
  } else if constexpr (!StoredElsewhere<T>) {
    CHECK((a == b));  // bit by bit, floating point too
  }
}

template <Record R>
void checkRoundTrip(RandomStream& random) {
  Database database = openDatabase(":memory:", Access::Create);
  database.exec(createSql({R::kRecord, "", columnsOf<R>(), ""}));
  std::vector<R> records;
  for (int i = 0; i < 20; ++i) records.push_back(test::randomRecord<R>(random));
  for (const R& record : records) {
    Statement row(database, insertSql(R::kRecord, columnsOf<R>()));
    Codec<R>::bind(row, record);
    row.run();
  }
  Statement rows(database, std::string("SELECT ") + columnList(columnsOf<R>()) + " FROM \"" +
                               R::kRecord + "\" ORDER BY rowid");
  for (const R& record : records) {
    REQUIRE(rows.step());
    R read;
    Codec<R>::read(rows, read);
    checkSame(R::kRecord, record, read);
  }
}

}  // namespace

TEST_CASE("every record survives the round trip, bit by bit but for rotations") {
  RandomStream random(21);
  checkRoundTrip<CameraRig>(random);
  checkRoundTrip<Frame>(random);
  checkRoundTrip<Motion>(random);
  checkRoundTrip<MotionRevision>(random);
  checkRoundTrip<Candidate>(random);
  checkRoundTrip<PlaceObservation>(random);
  checkRoundTrip<PlaceHypothesis>(random);
  checkRoundTrip<Decision>(random);
  checkRoundTrip<EarlierLoop>(random);
  checkRoundTrip<MapUpdate>(random);
  checkRoundTrip<Experience>(random);
  checkRoundTrip<Link>(random);
  checkRoundTrip<Outer>(random);
}

TEST_CASE("columns follow from the declaration") {
  std::vector<std::string> names;
  for (const Column& column : columnsOf<Outer>()) names.push_back(column.name);
  CHECK(names == std::vector<std::string>{"rig_width", "rig_height", "rig_calibrated",
                                          "rig_pinhole_fx", "rig_pinhole_fy", "rig_pinhole_cx",
                                          "rig_pinhole_cy", "rig_baseline", "weight"});
  std::string pose;
  for (const Column& column : columnsOf<Experience>())
    pose += column.name + ":" + column.type + " ";
  CHECK(pose ==
        "id:INTEGER frame:INTEGER template_id:INTEGER T_world_experience_x:REAL "
        "T_world_experience_y:REAL T_world_experience_z:REAL T_world_experience_qx:REAL "
        "T_world_experience_qy:REAL T_world_experience_qz:REAL T_world_experience_qw:REAL ");
  for (const Column& column : columnsOf<Frame>()) CHECK(column.name != "left");  // no images
}

TEST_CASE("an independent reader finds matrices where the page says") {
  const test::TemporaryFolder folder;
  {
    auto recorder = Recorder::open(folder.path()).value();
    const Frame frame = test::frameAt(0);
    Motion motion = test::motionAt(0);
    motion.covariance(0, 1) = 1;  // row 0, column 1: the second double
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  CHECK(
      test::queryByHand(folder.path(),
                        "SELECT hex(substr(covariance, 9, 8)) || length(covariance) FROM motion") ==
      std::vector<std::string>{"000000000000F03F288"});
}

TEST_CASE("values that the schema forbids are refused on reading") {
  Database database = openDatabase(":memory:", Access::Create);
  Statement word(database, "SELECT 'asleep'");
  REQUIRE(word.step());
  TrackingState state{};
  CHECK_THROWS_WITH(Codec<TrackingState>::read(word, state),
                    "'asleep' is none of the values that this column has");
  Statement blob(database, "SELECT x'0102'");
  REQUIRE(blob.step());
  Matrix6d matrix;
  CHECK_THROWS_WITH(Codec<Matrix6d>::read(blob, matrix), "a matrix has 2 bytes, which do not fit");
}
