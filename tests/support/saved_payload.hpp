// SPDX-License-Identifier: BSD-3-Clause
// The payload of a saved state, to damage it and keep a valid checksum.
#pragma once

#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <string_view>

#include "tolman/state_stream.hpp"

namespace tolman::test {

template <class Keeper>
std::string savedPayload(const Keeper& keeper) {
  std::ostringstream stream;
  REQUIRE(keeper.save(stream).isOk());
  return stream.str().substr(sizeof(detail::StateHeader));
}

template <class Keeper>
Status loadPayload(Keeper& keeper, std::string_view magic, std::uint64_t version,
                   const std::string& payload) {
  StateWriter writer;
  writer.putAll(std::span<const char>(payload.data(), payload.size()));
  std::ostringstream out;
  REQUIRE(writer.write(out, magic, version).isOk());
  std::istringstream in(out.str());
  return keeper.load(in);
}

}  // namespace tolman::test
