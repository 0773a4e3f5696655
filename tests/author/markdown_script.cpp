// SPDX-License-Identifier: BSD-3-Clause
#include "author/markdown_script.hpp"

#include <sstream>

namespace tolman::test {
namespace {

/// "…, `name`:" gives "name"; any other line gives nothing.
std::string announcedFile(const std::string& line) {
  if (!line.ends_with("`:")) return {};
  const std::size_t end = line.size() - 2;
  const std::size_t start = line.rfind('`', end - 1);
  return start == std::string::npos ? std::string() : line.substr(start + 1, end - start - 1);
}

std::string blockOf(std::istringstream& lines) {
  std::string block;
  for (std::string line; std::getline(lines, line) && line != "```";) block += line + "\n";
  return block;
}

}  // namespace

std::string scriptOf(const std::string& page) {
  std::istringstream lines(page);
  std::string script;
  std::string file;  // announced by the last line of text
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("```")) {
      if (!line.empty()) file = announcedFile(line);
      continue;
    }
    const std::string block = blockOf(lines);
    if (line == "```sh") {
      script += "set -x\n" + block + "{ set +x; } 2>/dev/null\n";
    } else if (!file.empty()) {
      script += "cat >" + file + " <<'END OF FILE'\n" + block + "END OF FILE\n";
    }
    file.clear();
  }
  return script;
}

}  // namespace tolman::test
