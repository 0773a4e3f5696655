// SPDX-License-Identifier: BSD-3-Clause
#include "metadata_file.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>

#include "text_encoding.hpp"

namespace tolman::ros_bag {
namespace fs = std::filesystem;

namespace {

std::string_view trimmed(std::string_view text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  const bool quoted = text.size() >= 2 && text.front() == text.back() &&
                      (text.front() == '"' || text.front() == '\'');
  return quoted ? text.substr(1, text.size() - 2) : text;
}

bool isBagName(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".mcap") || name.ends_with(".db3") || name.ends_with(".bag") ||
         name.ends_with(".mcap.zstd") || name.ends_with(".db3.zstd");
}

/// bag_2 before bag_10.
bool comesBefore(const fs::path& a, const fs::path& b) {
  const std::string first = a.filename().string();
  const std::string second = b.filename().string();
  if (first.size() != second.size()) return first.size() < second.size();
  return first < second;
}

std::string readText(const fs::path& file) {
  constexpr std::size_t kMax = 16U << 20U;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored) || fs::file_size(file, ignored) > kMax) return {};
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::vector<std::string> filesInMetadata(const std::string& text) {
  std::vector<std::string> files;
  std::istringstream lines(text);
  bool in_list = false;
  for (std::string line; std::getline(lines, line);) {
    const std::string_view entry = trimmed(line);
    if (entry == "relative_file_paths:") {
      in_list = true;
    } else if (in_list && entry.starts_with("- ")) {
      files.emplace_back(trimmed(entry.substr(2)));
    } else if (in_list && !entry.empty()) {
      break;
    }
  }
  return files;
}

std::optional<std::int64_t> messagesInMetadata(const std::string& text) {
  constexpr std::string_view kKey = "message_count:";  // the first one; later ones are of topics
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string_view entry = trimmed(line);
    if (!entry.starts_with(kKey)) continue;
    const std::string_view digits = trimmed(entry.substr(kKey.size()));
    std::int64_t count = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return count;
  }
  return std::nullopt;
}

std::string missingMessages(const fs::path& path, std::int64_t messages) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return "";
  const fs::path file = path / "metadata.yaml";
  const std::optional<std::int64_t> said = messagesInMetadata(readText(file));
  if (!said || *said <= messages) return "";
  return file.string() + ": says that the bag has " + std::to_string(*said) +
         " messages, its files have " + std::to_string(messages) +
         "; copy the whole folder of the bag";
}

Result<std::vector<fs::path>> findBagFiles(const fs::path& path) {
  std::error_code failure;
  if (!fs::is_directory(path, failure)) return std::vector<fs::path>{path};
  const fs::path metadata = path / "metadata.yaml";
  if (const std::string problem = text_encoding::encodingProblemOf(metadata); !problem.empty()) {
    return Status::invalidInput(metadata.string() + ": " + problem);
  }
  std::vector<fs::path> files;
  for (const std::string& name : filesInMetadata(readText(metadata))) {
    // Only the file name: early versions wrote the folder, too, and no other folder may be read.
    files.push_back(path / fs::path(name).filename());
  }
  for (const fs::path& file : files) {
    if (fs::exists(file, failure)) continue;
    return Status::invalidInput(file.string() +
                                ": is missing, and metadata.yaml names it; copy "
                                "the whole folder of the bag");
  }
  if (!files.empty()) return files;
  for (fs::directory_iterator entry(path, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (isBagName(entry->path())) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end(), comesBefore);
  if (!files.empty()) return files;
  return Status::invalidInput(path.string() + ": has no .mcap, .db3 or .bag file; check the path");
}

}  // namespace tolman::ros_bag
