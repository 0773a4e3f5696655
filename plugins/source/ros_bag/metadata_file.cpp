// SPDX-License-Identifier: BSD-3-Clause
#include "metadata_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <system_error>

#include "base/open_files.hpp"
#include "base/text_encoding.hpp"

namespace tolman::ros_bag {
namespace fs = std::filesystem;

namespace {

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

/// The number at the end of "drive_12.mcap.zstd"; empty without one.
std::optional<int> partNumber(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::string stem = name.substr(0, name.find('.', name.rfind('_') + 1));
  const std::string digits = stem.substr(stem.rfind('_') + 1);
  constexpr std::size_t kMost = 4;  // longer ones are dates
  if (digits == stem || digits.empty() || digits.size() > kMost) return std::nullopt;
  if (digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return std::stoi(digits);
}

/// A warning for numbers that are missing between those of several files.
std::vector<std::string> missingParts(const std::vector<fs::path>& files) {
  std::set<int> numbers;
  for (const fs::path& file : files) {
    const std::optional<int> number = partNumber(file);
    if (!number || !numbers.insert(*number).second) return {};
  }
  if (numbers.size() < 2) return {};
  int expected = 0;
  while (numbers.contains(expected)) ++expected;
  if (expected == static_cast<int>(numbers.size())) return {};
  return {files.front().parent_path().string() + ": part " + std::to_string(expected) +
          " of the recording is missing, while there are others up to " +
          std::to_string(*numbers.rbegin()) + "; copy the whole folder of the bag"};
}

}  // namespace

BagMetadata metadataOf(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return {};
  return parseMetadata(readText(path / "metadata.yaml"));
}

std::string missingMessages(const fs::path& path, const BagMetadata& metadata,
                            std::int64_t messages) {
  if (!metadata.messages || *metadata.messages <= messages) return "";
  return (path / "metadata.yaml").string() + ": says that the bag has " +
         std::to_string(*metadata.messages) + " messages, of which " + std::to_string(messages) +
         " could be read; copy the whole folder of the bag, or use them by on_corrupt: skip";
}

std::vector<std::string> oddFiles(const fs::path& path, const BagMetadata& metadata,
                                  const std::vector<fs::path>& used) {
  std::vector<std::string> warnings;
  std::error_code failure;
  if (!fs::is_directory(path, failure)) return warnings;
  if (metadata.files.empty()) return missingParts(used);
  // rosbag2 leaves a file that it has unpacked beside the packed one.
  const auto isOther = [](const fs::path& file, const fs::path& named) {
    const std::string a = file.filename().string();
    const std::string b = named.filename().string();
    return a != b && a != b + ".zstd" && a + ".zstd" != b;
  };
  for (fs::directory_iterator entry(path, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path& file = entry->path();
    const bool is_unnamed =
        isBagName(file) &&
        std::ranges::all_of(used, [&](const fs::path& named) { return isOther(file, named); });
    if (!is_unnamed) continue;
    warnings.push_back(file.string() +
                       ": is not read, because metadata.yaml does not name it; if it is a part of "
                       "the recording, write metadata.yaml anew (`ros2 bag reindex`)");
  }
  std::ranges::sort(warnings);
  return warnings;
}

Result<std::vector<fs::path>> findBagFiles(const fs::path& path) {
  std::error_code failure;
  if (!fs::is_directory(path, failure)) return std::vector<fs::path>{path};
  const fs::path metadata = path / "metadata.yaml";
  if (const std::string problem = text_encoding::encodingProblemOf(metadata); !problem.empty()) {
    return Status::invalidInput(metadata.string() + ": " + problem);
  }
  std::vector<fs::path> files;
  for (const std::string& name : parseMetadata(readText(metadata)).files) {
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
  return Status::invalidInput(
      path.string() + ": " +
      file_opening::notOpened("has no .mcap, .db3 or .bag file; check the path"));
}

}  // namespace tolman::ros_bag
