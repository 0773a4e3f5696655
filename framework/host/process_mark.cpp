// SPDX-License-Identifier: BSD-3-Clause
#include "host/process_mark.hpp"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

namespace tolman::isolation {
namespace {

constexpr const char* kVariable = "TOLMAN_PROCESS";

bool hasMark(const std::filesystem::path& process, const std::string& mark) {
  std::ifstream file(process / "environ", std::ios::binary);
  const std::string environment{std::istreambuf_iterator<char>(file), {}};
  return environment.find(mark) != std::string::npos;
}

/// Kills all processes with the mark that exist now. Returns whether there was one.
bool killOnce(const std::string& mark) {
  bool any = false;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc", error), end; entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto id = static_cast<pid_t>(std::strtol(name.c_str(), nullptr, 10));
    if (id == ::getpid() || !hasMark(entry->path(), mark)) continue;
    any = ::kill(id, SIGKILL) == 0 || any;
  }
  return any;
}

}  // namespace

std::string newMark() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  const std::string own = ownMark();
  const std::string unique = std::to_string(::getpid()) + "." + std::to_string(::gettid()) + "." +
                             std::to_string(now) + ";";
  return (own.empty() ? std::string(kVariable) + "=" : own) + unique;
}

std::string ownMark() {
  const char* value = std::getenv(kVariable);
  return value == nullptr ? "" : std::string(kVariable) + "=" + value;
}

std::vector<std::string> environmentWith(const std::string& mark) {
  std::vector<std::string> variables = {mark};
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (!text.starts_with(std::string(kVariable) + "=")) variables.push_back(text);
  }
  return variables;
}

void killMarked(const std::string& mark) {
  constexpr int kMaxPasses = 20;   // they may start others meanwhile
  constexpr int kEmptyPasses = 3;  // a process has no environment while it starts a program
  if (mark.empty()) return;
  for (int pass = 0, empty = 0; pass < kMaxPasses && empty < kEmptyPasses; ++pass) {
    empty = killOnce(mark) ? 0 : empty + 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace tolman::isolation
