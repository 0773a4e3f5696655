// SPDX-License-Identifier: BSD-3-Clause
// Every version that this processor supports, against bits compared one by one.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "place_codes.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_sequences;

namespace {

PlaceCode randomCode(RandomStream& random) {
  PlaceCode code;
  for (std::uint64_t& word : code)
    word = (random.below(1ULL << 32U) << 32U) + random.below(1ULL << 32U);
  return code;
}

bool bitOf(const PlaceCode& code, int bit) {
  return ((code[static_cast<std::size_t>(bit / 64)] >> (bit % 64)) & 1U) != 0;
}

PlaceCode withFlipped(PlaceCode code, int bits) {
  for (int bit = 0; bit < bits; ++bit) {
    code[static_cast<std::size_t>(bit / 64)] ^= std::uint64_t{1} << (bit % 64);
  }
  return code;
}

int fewestDiffering(const PlaceCode& code, const CodeQueries& queries) {
  int fewest = kCodeBits;
  for (const PlaceCode& query : queries) {
    int differing = 0;
    for (int bit = 0; bit < kCodeBits; ++bit) differing += bitOf(code, bit) != bitOf(query, bit);
    fewest = std::min(fewest, differing);
  }
  return fewest;
}

}  // namespace

TEST_CASE("every scan counts the bits, for any number of codes, and writes no further") {
  RandomStream random(11);
  CodeQueries queries;
  for (PlaceCode& query : queries) query = randomCode(random);
  std::vector<PlaceCode> codes;
  for (int bits = 0; bits <= kCodeBits; bits += 4) {
    codes.push_back(withFlipped(queries[codes.size() % queries.size()], bits));
    codes.push_back(randomCode(random));
  }
  std::vector<std::uint16_t> expected;
  for (const PlaceCode& code : codes) {
    expected.push_back(static_cast<std::uint16_t>(fewestDiffering(code, queries)));
  }
  REQUIRE_FALSE(hammingScans().empty());
  for (const HammingScan scan : hammingScans()) {
    for (std::size_t count = 0; count <= codes.size(); count += count < 40 ? 1 : 15) {
      constexpr std::uint16_t kUntouched = 9999;
      std::vector<std::uint16_t> bits(codes.size() + 1, kUntouched);
      scan(codes.data(), static_cast<std::int64_t>(count), queries, bits.data());
      CAPTURE(count);
      REQUIRE(std::equal(bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(count),
                         expected.begin()));
      REQUIRE(bits[count] == kUntouched);
    }
  }
}

TEST_CASE("codes that are a query, or its opposite, have no bit or all bits differing") {
  RandomStream random(12);
  CodeQueries same;
  same.fill(randomCode(random));
  const std::vector<PlaceCode> codes = {same[0], withFlipped(same[0], kCodeBits)};
  for (const HammingScan scan : hammingScans()) {
    std::vector<std::uint16_t> bits(2);
    scan(codes.data(), 2, same, bits.data());
    CHECK(bits == std::vector<std::uint16_t>{0, kCodeBits});
  }
}
