// SPDX-License-Identifier: BSD-3-Clause
#include "record/fingerprint.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "record/rows.hpp"

using namespace tolman;
using namespace tolman::record;

TEST_CASE("a record has the fingerprint of its values") {
  RecordedLink link;
  link.from = 3;
  link.to = 4;
  link.weight = 0.5;
  const Fingerprint before = fingerprintOf(link);
  CHECK(fingerprintOf(RecordedLink(link)) == before);
  RecordedLink changed = link;
  changed.rejected = true;
  CHECK_FALSE(fingerprintOf(changed) == before);
  changed = link;
  std::swap(changed.from, changed.to);
  CHECK_FALSE(fingerprintOf(changed) == before);
  changed = link;
  changed.weight = std::nextafter(0.5, 1.0);
  CHECK_FALSE(fingerprintOf(changed) == before);
  changed = link;
  changed.T_from_to.translation().y() = -0.0;
  CHECK(fingerprintOf(changed) == before);  // 0 and -0 are the same value
}

TEST_CASE("fingerprints of a hundred thousand neighbouring records differ") {
  std::set<std::pair<std::uint64_t, std::uint64_t>> seen;
  Experience experience;
  for (int i = 0; i < 100'000; ++i) {
    experience.id = i % 10;
    experience.T_world_experience.translation().x() = 1e-9 * (i / 10);
    const Fingerprint fingerprint = fingerprintOf(experience);
    seen.emplace(fingerprint.first, fingerprint.second);
  }
  CHECK(seen.size() == 100'000);
}
