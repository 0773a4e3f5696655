// SPDX-License-Identifier: BSD-3-Clause
#include "host/stack_report.hpp"

#include <signal.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <sstream>
#include <thread>

#include "config/text.hpp"

namespace tolman::isolation {
namespace {

namespace fs = std::filesystem;

static_assert(kStackSignal == SIGUSR2);

constexpr std::size_t kMaxStackBytes = std::size_t{1} << 16U;
constexpr std::chrono::milliseconds kStackPatience{500};
constexpr std::chrono::milliseconds kStackPoll{10};

/// A line `  File "PATH", line N in FUNCTION`.
struct StackLine {
  fs::path file;
  std::string line;
  std::string function;

  std::string text() const {
    return config::printable(file.filename().string() + ":" + line + ", in " + function);
  }
};

std::optional<StackLine> parsed(const std::string& line) {
  constexpr std::string_view kFile = "  File \"";
  constexpr std::string_view kLine = "\", line ";
  constexpr std::string_view kIn = " in ";
  const std::size_t end = line.rfind(kLine);
  if (!line.starts_with(kFile) || end == std::string::npos || end < kFile.size()) return {};
  const std::size_t number = end + kLine.size();
  const std::size_t in = line.find(kIn, number);
  if (in == std::string::npos) return {};
  return StackLine{line.substr(kFile.size(), end - kFile.size()), line.substr(number, in - number),
                   line.substr(in + kIn.size())};
}

/// Whether the file lies in the folder or below it, but is no installed package.
bool isOwn(const fs::path& file, const fs::path& folder) {
  const fs::path below = file.lexically_relative(folder);
  return !below.empty() && *below.begin() != ".." &&
         std::find(below.begin(), below.end(), "site-packages") == below.end();
}

}  // namespace

std::string placeInStack(const std::string& stack, const std::string& program) {
  const fs::path folder = fs::path(program).parent_path();
  std::istringstream lines(stack);
  for (std::string line; std::getline(lines, line);) {
    const std::optional<StackLine> found = parsed(line);
    if (found && isOwn(found->file, folder)) return found->text();
  }
  return "";
}

std::string StackReport::text() const {
  std::array<char, kMaxStackBytes> bytes;
  const ssize_t size = ::pread(memory_.descriptor(), bytes.data(), bytes.size(), 0);
  return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

std::string StackReport::left(const std::string& program) const {
  return program.empty() ? "" : placeInStack(text(), program);
}

std::string StackReport::ask(const ChildProcess& process, const std::string& program) const {
  const std::string before = text();
  if (before.empty() || program.empty()) return "";
  process.signal(kStackSignal);
  const auto end = std::chrono::steady_clock::now() + kStackPatience;
  std::string now = before;
  while (std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kStackPoll);
    const std::string later = text();
    if (later.size() > before.size() && later.size() == now.size()) break;  // it is complete
    now = later;
  }
  return placeInStack(now.substr(before.size()), program);
}

}  // namespace tolman::isolation
