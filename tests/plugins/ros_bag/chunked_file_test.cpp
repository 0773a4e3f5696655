// SPDX-License-Identifier: BSD-3-Clause
#include "chunked_file.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"
#include "bag_problems.hpp"

namespace tolman::ros_bag {
namespace {

/// A chunk at N is the text "chunk N"; one at 666 does not unpack.
class Letters final : public ChunkedFile {
 public:
  explicit Letters(FileBytes file) : ChunkedFile(std::move(file)) {}
  void visit(const MessageVisitor&, FileDamage&) override {}
  Result<Contents> readChunk(std::uint64_t at) override {
    unpacked.push_back(at);
    if (at == 666) return Status::invalidInput("does not unpack");
    const std::string text = "chunk " + std::to_string(at);
    return Contents(text.begin(), text.end());
  }
  std::string bytes(std::uint64_t at, std::uint64_t size) {
    Problems problems;
    const auto found = readBytes(at, size, 5, problems);
    return found ? std::string(found->begin(), found->end()) : problems.at(0);
  }
  std::string message(const MessagePlace& place) {
    const auto found = read(place);
    if (!found.isOk()) return found.status().message();
    return {found.value().begin(), found.value().end()};
  }

  std::vector<std::uint64_t> unpacked;
};

Letters lettersOf(const test::TemporaryFolder& folder, const std::string& text) {
  test::writeBytes(folder.path() / "bag", text);
  auto file = FileBytes::open(folder.path() / "bag");
  REQUIRE(file.isOk());
  return Letters(std::move(file).value());
}

}  // namespace

TEST_CASE("bytes of a record, within the file and a limit") {
  const test::TemporaryFolder folder;
  Letters letters = lettersOf(folder, "abcdefgh");
  CHECK(letters.bytes(2, 3) == "cde");
  CHECK(letters.bytes(8, 0).empty());
  CHECK(letters.bytes(2, 7) == endsWithin(5));
  CHECK(letters.bytes(2, ~std::uint64_t{0}) == endsWithin(5));
  std::filesystem::resize_file(folder.path() / "bag", (std::uintmax_t{256} << 20U) + 2);
  auto large = FileBytes::open(folder.path() / "bag");
  REQUIRE(large.isOk());
  CHECK(Letters(std::move(large).value()).bytes(0, (std::uint64_t{256} << 20U) + 1) ==
        "has a record of more than 256 MiB at byte 5; record it again");
}

TEST_CASE("messages in the file and in chunks; two chunks are kept") {
  const test::TemporaryFolder folder;
  Letters letters = lettersOf(folder, "abcdefgh");
  CHECK(letters.message({0, 6, 2}) == "gh");
  CHECK(letters.message({0, 6, 3}) == "cannot be read at byte 6; check the disk");
  CHECK(letters.message({3, 6, 1}) == "3");
  CHECK(letters.message({4, 0, 7}) == "chunk 4");
  CHECK(letters.message({3, 0, 5}) == "chunk");
  CHECK(letters.unpacked == std::vector<std::uint64_t>{3, 4});
  CHECK(letters.message({5, 6, 1}) == "5");
  CHECK(letters.message({4, 6, 1}) == "4");
  CHECK(letters.message({3, 6, 1}) == "3");
  CHECK(letters.unpacked == std::vector<std::uint64_t>{3, 4, 5, 3});
  CHECK(letters.message({3, 6, 2}) == "has changed while it was read");
  CHECK(letters.message({3, 8, 0}) == "has changed while it was read");
  CHECK(letters.message({666, 0, 1}) == "does not unpack");
}

}  // namespace tolman::ros_bag
