// SPDX-License-Identifier: BSD-3-Clause
// Landmarks on disk: read as they were stored; damaged states; no space for the file.
#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>

#include "part_state.hpp"
#include "place_verifier.hpp"
#include "support/data.hpp"
#include "support/environment.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;
using tolman::landmarks::kDescriptionBytes;
using tolman::landmarks::kPatchBytes;

namespace {

StoredLandmarks someLandmarks(int count, RandomStream& random) {
  StoredLandmarks landmarks;
  landmarks.corners.descriptions.create(count, kDescriptionBytes, CV_8U);
  for (int i = 0; i < count; ++i) {
    const auto any = [&] { return static_cast<float>(random.uniform(-50, 50)); };
    const float x = any();
    const float y = any();
    landmarks.corners.points.emplace_back(x, y, any());
    const auto byte = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    for (int k = 0; k < kDescriptionBytes; ++k) {
      landmarks.corners.descriptions.at<std::uint8_t>(i, k) = byte();
    }
    std::ranges::generate(landmarks.patches.emplace_back(), byte);
  }
  return landmarks;
}

bool areEqual(const StoredLandmarks& a, const StoredLandmarks& b) {
  const cv::Mat& bits_a = a.corners.descriptions;
  const cv::Mat& bits_b = b.corners.descriptions;
  if (a.corners.points != b.corners.points || bits_a.rows != bits_b.rows) return false;
  for (int i = 0; i < bits_a.rows; ++i) {
    if (std::memcmp(bits_a.ptr(i), bits_b.ptr(i), kDescriptionBytes) != 0) return false;
  }
  return a.patches == b.patches;
}

std::string bytesOf(const LandmarkStore& store) {
  return savedBytes([&](StateWriter& writer) { REQUIRE(store.save(writer).isOk()); });
}

Status loadBytes(LandmarkStore& store, const std::string& bytes, std::int64_t views) {
  StateReader reader = readerOf(bytes);
  return store.load(reader, views);
}

constexpr const char* kRemedy =
    "; does the folder for temporary files (TMPDIR) exist, and is it full? Set landmarks to 0 to "
    "do without";

}  // namespace

TEST_CASE("landmarks are read as they were stored, in any order") {
  RandomStream random(1);
  LandmarkStore store;
  std::vector<StoredLandmarks> stored;
  for (int i = 0; i < 30; ++i) {
    stored.push_back(someLandmarks(static_cast<int>(random.below(400)), random));
    REQUIRE(store.add(3 * i, stored.back()).isOk());
  }
  for (int trial = 0; trial < 60; ++trial) {
    const auto i = random.below(30);
    const auto found = store.read(static_cast<std::int64_t>(3 * i));
    REQUIRE(found.isOk());
    CHECK(areEqual(found.value(), stored[i]));
  }
}

TEST_CASE("the nearest view with landmarks, of two equally near ones the older") {
  LandmarkStore store;
  CHECK_FALSE(store.nearest(5, 1000));
  RandomStream random(2);
  const std::set<std::int64_t> views = {4, 10, 11, 30};
  for (const std::int64_t view : views) REQUIRE(store.add(view, someLandmarks(3, random)).isOk());
  CHECK(store.nearest(7, 3) == 4);
  for (std::int64_t at = 0; at < 45; ++at) {
    for (const std::int64_t reach : {0, 1, 3, 9, 100}) {
      std::optional<std::int64_t> expected;
      for (const std::int64_t view : views) {
        if (std::abs(view - at) > reach) continue;
        if (!expected || std::abs(view - at) < std::abs(*expected - at)) expected = view;
      }
      CAPTURE(at, reach);
      CHECK(store.nearest(at, reach) == expected);
    }
  }
}

TEST_CASE("a loaded store has what the saved one had") {
  RandomStream random(3);
  LandmarkStore saved;
  std::vector<StoredLandmarks> stored;
  for (int i = 0; i < 12; ++i) {
    stored.push_back(someLandmarks(5 * i, random));
    REQUIRE(saved.add(7 * i + 2, stored.back()).isOk());
  }
  LandmarkStore loaded;
  REQUIRE(loaded.add(1, stored[3]).isOk());  // forgotten
  REQUIRE(loadBytes(loaded, bytesOf(saved), 100).isOk());
  CHECK(bytesOf(loaded) == bytesOf(saved));
  CHECK(loaded.nearest(0, 10) == 2);
  for (int i = 0; i < 12; ++i)
    CHECK(areEqual(loaded.read(7 * i + 2).value(), stored[std::size_t(i)]));
  REQUIRE(loaded.add(90, stored[4]).isOk());
  CHECK(areEqual(loaded.read(90).value(), stored[4]));
  LandmarkStore empty;
  CHECK(loadBytes(empty, bytesOf(LandmarkStore()), 0).isOk());
}

TEST_CASE("damaged landmarks are refused without asking for memory") {
  RandomStream random(4);
  LandmarkStore store;
  REQUIRE(store.add(2, someLandmarks(20, random)).isOk());
  REQUIRE(store.add(9, someLandmarks(10, random)).isOk());
  const std::string sound = bytesOf(store);
  const auto refusal = [](const std::string& bytes, std::int64_t views = 10) {
    LandmarkStore other;
    const Status status = loadBytes(other, bytes, views);
    CHECK((status.isOk() || status.code() == StatusCode::InvalidInput));
    return status.message();
  };
  const std::string damaged = "the landmarks are damaged";
  REQUIRE(refusal(sound).empty());
  CHECK(refusal(sound, 9) == damaged);  // of a view that is not stored
  CHECK(refusal(overwritten(sound, 0, std::uint64_t{3})) == damaged);
  CHECK(refusal(overwritten(sound, 0, ~std::uint64_t{0})) == damaged);
  CHECK(refusal(overwritten(sound, 8, std::int64_t{-1})) == damaged);
  CHECK(refusal(overwritten(sound, 8, std::int64_t{9})) == damaged);  // 9 twice
  for (const std::int64_t count :
       {std::int64_t{-1}, INT64_MAX, INT64_MAX / (44 + kPatchBytes), std::int64_t{1000}}) {
    CHECK(refusal(overwritten(sound, 16, count)) == damaged);
  }
  for (std::size_t length = 0; length + 1 < sound.size(); length += 37) {
    LandmarkStore other;
    StateReader reader = readerOf(sound.substr(0, length));
    const bool taken = other.load(reader, 10).isOk() && reader.complete();
    CHECK_FALSE(taken);
  }
}

TEST_CASE("the file has no name: nothing is left in the folder for temporary files") {
  const tolman::test::TemporaryFolder folder;
  const tolman::test::Environment set("TMPDIR", folder.path().string());
  RandomStream random(5);
  LandmarkStore store;
  REQUIRE(store.add(0, someLandmarks(100, random)).isOk());
  CHECK(std::filesystem::is_empty(folder.path()));
  LandmarkStore moved = std::move(store);
  CHECK(moved.read(0).value().corners.points.size() == 100);
}

TEST_CASE("without a folder for temporary files the error says so and gives the remedy") {
  const tolman::test::TemporaryFolder folder;
  RandomStream random(6);
  const auto refusal = [&](const std::filesystem::path& path) {
    const tolman::test::Environment set("TMPDIR", path.string());
    LandmarkStore store;
    const Status status = store.add(0, someLandmarks(3, random));
    CHECK(status.code() == StatusCode::Failed);
    CHECK_FALSE(store.nearest(0, 1));
    return status.message();
  };
  CHECK(refusal(folder.path() / "absent") ==
        std::string("landmarks cannot be stored: No such file or directory") + kRemedy);
  std::ofstream(folder.path() / "file") << "text";
  CHECK(refusal(folder.path() / "file") ==
        std::string("landmarks cannot be stored: Not a directory") + kRemedy);
}

TEST_CASE("a full disk is an error, and what was stored before can still be read") {
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  RandomStream random(7);
  LandmarkStore store;
  const StoredLandmarks first = someLandmarks(50, random);
  REQUIRE(store.add(0, first).isOk());
  rlimit small = before;
  small.rlim_cur = 4000;
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  const Status status = store.add(3, someLandmarks(100, random));
  REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
  std::signal(SIGXFSZ, handler);
  CHECK(status.message() == std::string("landmarks cannot be stored: File too large") + kRemedy);
  CHECK(store.nearest(3, 0) == std::nullopt);
  CHECK(areEqual(store.read(0).value(), first));
  const StoredLandmarks later = someLandmarks(60, random);
  REQUIRE(store.add(6, later).isOk());
  CHECK(areEqual(store.read(6).value(), later));
}
