// SPDX-License-Identifier: BSD-3-Clause
#include "engine/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include "config/text.hpp"

namespace tolman::run {

int terminalWidth(int descriptor) {
  winsize size{};
  const bool known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::string wipedLine(int descriptor) {
  if (::isatty(descriptor) != 1) return {};
  return "\r" + std::string(static_cast<std::size_t>(terminalWidth(descriptor) - 1), ' ') + "\r";
}

std::string printable(std::string_view text) { return config::printable(text, "?"); }

}  // namespace tolman::run
