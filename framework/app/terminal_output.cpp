// SPDX-License-Identifier: BSD-3-Clause
#include "app/terminal_output.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "config/json_text.hpp"
#include "engine/terminal.hpp"

namespace tolman::app {

TerminalOutput::~TerminalOutput() {
  passOn();
  stream_.rdbuf(below_);
}

TerminalOutput::int_type TerminalOutput::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  line_ += traits_type::to_char_type(c);
  return line_.back() != '\n' || passOn() ? c : traits_type::eof();
}

int TerminalOutput::sync() { return passOn() ? below_->pubsync() : -1; }

bool TerminalOutput::passOn() {
  const std::string text = run::printable(std::exchange(line_, {}));
  const auto size = static_cast<std::streamsize>(text.size());
  return below_->sputn(text.data(), size) == size;
}

std::string jsonText(const nlohmann::ordered_json& json) {
  return config::jsonText(json, 2) + "\n";
}

}  // namespace tolman::app
