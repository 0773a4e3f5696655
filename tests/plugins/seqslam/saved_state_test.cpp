// SPDX-License-Identifier: BSD-3-Clause
// Saved states: continued at any image, of other parameters, and damaged.
#include <cstring>
#include <limits>

#include "support/saved_payload.hpp"
#include "walk.hpp"

using namespace tolman;
using namespace tolman::seqslam;
using namespace tolman::seqslam::test;

namespace {

constexpr const char* kMagic = "TLMSEQSL";

ParameterValues small(ParameterValues more = {}) {
  more.try_emplace("columns", std::int64_t{16});
  more.try_emplace("rows", std::int64_t{8});
  more.try_emplace("sequence", std::int64_t{4});
  more.try_emplace("recent", std::int64_t{5});
  return more;
}

std::string driven() {
  Walk walk(small());
  walk.see(0, 20);
  return walk.saved();
}

std::string payloadOf(const std::string& state) {
  return state.substr(sizeof(detail::StateHeader));
}

Status loadPayload(const std::string& payload) {
  Walk walk(small());
  return tolman::test::loadPayload(walk.plugin(), kMagic, 2, payload);
}

// Three parameters, then the number of images and of views.
constexpr std::size_t kImages = 3 * sizeof(double);
constexpr std::size_t kViews = kImages + sizeof(std::int64_t);
constexpr std::size_t kNumbers = kViews + sizeof(std::uint64_t);

template <class T>
std::string overwritten(std::string bytes, std::size_t at, T value) {
  REQUIRE(at + sizeof value <= bytes.size());
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

}  // namespace

TEST_CASE("a walk that is continued from a state at any image is the whole walk, to the bit") {
  const auto picture = [](int i) {
    return i % 11 == 5 ? Image() : placePicture(i % 25, std::uint64_t(i));
  };
  Walk whole(small());
  int familiar = 0;
  for (int i = 0; i < 70; ++i) {
    Walk continued(small());
    continued.see(90, 95);  // forgotten
    REQUIRE(continued.load(whole.saved()).isOk());
    REQUIRE(continued.saved() == whole.saved());
    continued.continueAt(i);
    const PlaceObservation a = whole.see(picture(i));
    const PlaceObservation b = continued.see(picture(i));
    CAPTURE(i);
    REQUIRE(a.recognition == b.recognition);
    REQUIRE(a.template_id == b.template_id);
    REQUIRE(a.score == b.score);
    REQUIRE(continued.saved() == whole.saved());
    familiar += a.recognition == Recognition::Familiar ? 1 : 0;
  }
  CHECK(familiar > 15);
}

TEST_CASE("states of other parameters are refused; those that only decide may differ") {
  const std::string state = driven();
  for (const char* name : {"columns", "rows"}) {
    Walk other(small({{name, std::int64_t{32}}}));
    CHECK(other.load(state).message() ==
          "the saved views were made with other columns, rows or sequence");
    CHECK(other.see(placePicture(0)).template_id == 0);
  }
  Walk decides(small({{"quotient", 1.0}, {"recent", std::int64_t{0}}}));
  CHECK(decides.load(state).isOk());
}

TEST_CASE("damage is found, and the instance is as after reset") {
  const std::string good = driven();
  const std::string payload = payloadOf(good);
  REQUIRE(loadPayload(payload).isOk());
  Walk walk(small());
  for (std::size_t at = 0; at < good.size(); at += 211) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    CHECK(walk.load(bad).code() == StatusCode::InvalidInput);
  }
  for (std::size_t length = kImages; length < payload.size(); length += 97) {
    CHECK(loadPayload(payload.substr(0, length)).message() == "the saved state is damaged");
  }
  CHECK(loadPayload(payload + '\0').message() == "the saved state is damaged");
  CHECK(walk.see(placePicture(0)).template_id == 0);
}

TEST_CASE("numbers that cannot be are refused") {
  const std::string payload = payloadOf(driven());
  for (const std::int64_t images : {std::int64_t{-1}, std::int64_t{19}, INT64_MAX}) {
    CHECK_FALSE(loadPayload(overwritten(payload, kImages, images)).isOk());
  }
  CHECK(loadPayload(overwritten(payload, kImages, std::int64_t{50})).isOk());
  for (const std::uint64_t views : {std::uint64_t{0}, std::uint64_t{21}, UINT64_MAX}) {
    CHECK_FALSE(loadPayload(overwritten(payload, kViews, views)).isOk());
  }
  for (const std::int64_t image : {-1, 0, 2, 100}) {  // of the second view
    CHECK_FALSE(loadPayload(overwritten(payload, kNumbers + 8, image)).isOk());
  }
  const std::size_t columns = kNumbers + 20 * (8 + 16 * 8);
  for (const std::uint64_t count : {std::uint64_t{5}, std::uint64_t{3}, UINT64_MAX}) {
    CHECK_FALSE(loadPayload(overwritten(payload, columns, count)).isOk());
  }
  CHECK_FALSE(loadPayload(overwritten(payload, columns + 8, UINT64_MAX)).isOk());
  const std::size_t last = payload.size() - sizeof(float);
  CHECK(loadPayload(overwritten(payload, last, 0.5F)).isOk());
  for (const float wild :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    CHECK_FALSE(loadPayload(overwritten(payload, last, wild)).isOk());
  }
}
