// SPDX-License-Identifier: BSD-3-Clause
#include "record/sha256.hpp"

#include <catch2/catch.hpp>

using tolman::record::Sha256;

namespace {

std::string sha256(std::string_view text) {
  Sha256 sha;
  sha.add(text);
  return sha.digest();
}

}  // namespace

TEST_CASE("SHA-256 of the test vectors of FIPS 180-4") {
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1'000'000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("pieces do not matter, for every length around the block size") {
  for (std::size_t size = 50; size < 140; ++size) {
    const std::string text(size, 'x');
    Sha256 pieces;
    for (const char& c : text) pieces.add(std::string_view(&c, 1));
    CHECK(pieces.digest() == sha256(text));
  }
}
