// SPDX-License-Identifier: BSD-3-Clause
// Saved states as inputs. The envelope has a checksum, so an input is only the payload and gets a
// valid envelope. An input that begins with the magic word is loaded without change.
#pragma once

#include <sstream>
#include <string>

#include "input.hpp"
#include "tolman/extras.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::fuzz {

inline Status loadState(StateKeeper& keeper, std::string_view magic, std::uint64_t version,
                        Bytes bytes) {
  std::string text(asText(bytes));
  if (!text.starts_with(magic)) {
    StateWriter writer;
    writer.putAll(std::span<const char>(text.data(), text.size()));
    std::ostringstream out;
    require(writer.write(out, magic, version).isOk(), "the state cannot be written");
    text = out.str();
  }
  std::istringstream in(text);
  const Status status = keeper.load(in);
  require(status.isOk() || status.code() == StatusCode::InvalidInput,
          "a state is refused with another code than InvalidInput");
  require(status.isOk() || !status.message().empty(), "a state is refused without a message");
  return status;
}

/// Saves, and loads what was saved.
inline void checkSaved(StateKeeper& keeper) {
  std::ostringstream out;
  require(keeper.save(out).isOk(), "an accepted state cannot be saved");
  std::istringstream in(out.str());
  require(keeper.load(in).isOk(), "an accepted state cannot be loaded after it was saved");
}

/// An answer to a call after the load: a failure, or finite values.
template <Record R>
void checkAnswer(const Status& status, const R& answer) {
  if (status.isOk()) require(firstInvalidField(answer).empty(), "an answer that is no number");
}

}  // namespace tolman::fuzz
