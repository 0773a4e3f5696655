// SPDX-License-Identifier: BSD-3-Clause
// The visible text of a terminal on which a run draws its progress line: every other line is
// separate.
#include "end_to_end/terminal.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

constexpr int kColumns = 100;

/// A short drive with a progress line. Images that stand still and an odometry that throws make the
/// host warn.
struct Drive {
  TemporaryFolder folder;
  fs::path sequence = folder.path() / "sequence";

  Drive() {
    writeTinyKitti(sequence, 60);
    for (int k = 21; k < 40; ++k) {
      for (const char* side : {"image_0", "image_1"}) {
        const auto image = [&](int number) {
          return sequence / side / ("0000" + std::to_string(number) + ".png");
        };
        fs::copy_file(image(20), image(k), fs::copy_options::overwrite_existing);
      }
    }
  }
  std::vector<std::string> command(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {tolmanProgram().string()};
    const auto run = tinyRun(writeTinyConfig(folder.path(), sequence), folder.path() / "run");
    words.insert(words.end(), run.begin(), run.end());
    words.insert(words.end(), {"--set", "observers=[{plugin: progress}]", "--set",
                               "odometry.plugin=throws_in_track"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

/// How many of the lines match the whole of `pattern`.
std::ptrdiff_t matching(const std::vector<std::string>& lines, const std::string& pattern) {
  const std::regex regex(pattern);
  return std::count_if(lines.begin(), lines.end(),
                       [&](const std::string& line) { return std::regex_match(line, regex); });
}

std::ptrdiff_t containing(const std::vector<std::string>& lines, const std::string& part) {
  return std::count_if(lines.begin(), lines.end(),
                       [&](const std::string& line) { return contains(line, part); });
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Lines with `part` that also have something of the progress line beside it.
std::ptrdiff_t broken(const std::vector<std::string>& lines, const std::string& part) {
  return std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
    return contains(line, part) && (contains(line, " of 60 (") || contains(line, "frames/s") ||
                                    contains(line, " template"));
  });
}

}  // namespace

TEST_CASE("the screen of a test is that of a terminal") {
  CHECK(shownLines("abc\rx\r\n\x1b[32mgreen\x1b[0m  \r\n", 80) ==
        std::vector<std::string>{"xbc", "green"});
  CHECK(shownLines("12345", 3) == std::vector<std::string>{"123", "45"});
}

TEST_CASE("warnings, the viewer's address and the progress line stand on lines of their own") {
  const Drive drive;
  Terminal terminal(drive.command({"--view", "--set", "odometry.on_failure=skip"}), kColumns);
  CHECK(terminal.finish() == 0);
  const auto lines = shownLines(terminal.output(), kColumns);
  INFO(joined(lines));
  CHECK(contains(terminal.output(), " of 60 ("));  // a progress line was drawn
  CHECK(matching(lines, "watch at http://127\\.0\\.0\\.1:[0-9]+/") == 1);
  CHECK(containing(lines, "watch at") == 1);
  CHECK(containing(lines, "warning: odometry: ") >= 1);
  CHECK(broken(lines, "warning:") == 0);
  CHECK(matching(lines, "60 frames in [0-9.]+ s, .* loop links?") == 1);
  CHECK(containing(lines, " of 60 (") == 0);  // nothing of the progress line is left
}

TEST_CASE("the message of a run that fails stands on a line of its own") {
  const Drive drive;
  Terminal terminal(drive.command({}), kColumns);
  CHECK(terminal.finish() == 7);
  const auto lines = shownLines(terminal.output(), kColumns);
  INFO(joined(lines));
  CHECK(contains(terminal.output(), " of 60 ("));
  CHECK(containing(lines, "track gives up") >= 1);
  CHECK(broken(lines, "track gives up") == 0);
}
