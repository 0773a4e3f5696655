// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/terminal.hpp"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

namespace tolman::test {
namespace {

/// The position behind a sequence such as "\x1b[32m" at `at`; `at` where there is none.
std::size_t behindSequence(const std::string& text, std::size_t at) {
  if (text[at] != '\x1b') return at;
  const std::size_t end = text.find_first_of("mKJhlABCDH", at + 1);
  return end == std::string::npos ? text.size() : end + 1;
}

}  // namespace

Terminal::Terminal(const std::vector<std::string>& command, int columns) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns);
  size.ws_row = 50;
  pid_ = ::forkpty(&master_, nullptr, nullptr, &size);
  if (pid_ < 0) throw std::runtime_error("no terminal");
  if (pid_ > 0) return;
  ::setenv("TERM", "xterm", 1);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

Terminal::~Terminal() {
  ::close(master_);
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void Terminal::type(std::string_view keys) const {
  if (::write(master_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    throw std::runtime_error("the terminal takes no input");
  }
}

bool Terminal::read(int milliseconds) {
  pollfd ready{master_, POLLIN, 0};
  if (::poll(&ready, 1, milliseconds) <= 0) return false;
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(master_, buffer.data(), buffer.size());
  if (count <= 0) return false;  // the program has ended
  output_.append(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

bool Terminal::waitFor(const std::string& text) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  std::size_t found = output_.find(text, waited_);
  while (found == std::string::npos && std::chrono::steady_clock::now() < end) {
    read(100);
    found = output_.find(text, waited_);
  }
  if (found == std::string::npos) return false;
  waited_ = found + text.size();
  return true;
}

int Terminal::finish() {
  while (read(60'000)) {
  }
  int state = 0;
  ::waitpid(pid_, &state, 0);
  pid_ = -1;
  return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

std::vector<std::string> shownLines(const std::string& output, std::size_t columns) {
  std::vector<std::string> lines(1);
  std::size_t column = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (const std::size_t behind = behindSequence(output, i); behind != i) {
      i = behind - 1;
      continue;
    }
    const char c = output[i];
    if (c == '\r') {
      column = 0;
    } else if (c == '\n') {  // the terminal's driver writes "\r\n" for it
      lines.emplace_back();
    } else {
      if (column == columns) {
        lines.emplace_back();
        column = 0;
      }
      if (lines.back().size() <= column) lines.back().resize(column + 1, ' ');
      lines.back()[column++] = c;
    }
  }
  for (std::string& line : lines) line.resize(line.find_last_not_of(' ') + 1);
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace tolman::test
