// SPDX-License-Identifier: BSD-3-Clause
#include "bag_problems.hpp"

#include <catch2/catch.hpp>

namespace tolman::ros_bag {

TEST_CASE("problems of a bag say the place and a remedy") {
  CHECK(endsWithin(13) ==
        "ends within the record at byte 13: the recording was cut off; use what is there by "
        "on_corrupt: skip");
  CHECK(
      hasNoEnd(4096) ==
      "has no end at byte 4096: the recording was cut off; use what is there by on_corrupt: skip");
  CHECK(cannotBeRead(7) == "cannot be read at byte 7; check the disk");
  CHECK(hasPart("a damaged message", 7) ==
        "has a damaged message at byte 7; copy it again, or leave it out by on_corrupt: skip");
  CHECK(badChunk(7, "does not unpack") ==
        "the chunk at byte 7 does not unpack; copy the file again, or leave it out by on_corrupt: "
        "skip");
  CHECK(chunkEndsWithin(7) ==
        "the chunk at byte 7 ends within a record; record it again, or leave it out by "
        "on_corrupt: skip");
}

}  // namespace tolman::ros_bag
