// SPDX-License-Identifier: BSD-3-Clause
#include "image_file.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "base/text_file.hpp"
#include "data_error.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;

namespace {

bool isImage(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return (extension == ".png" || extension == ".jpg" || extension == ".jpeg") &&
         !file.filename().string().starts_with('.');
}

constexpr std::string_view kDigits = "0123456789";

/// How many characters at the begin of `name` are a prefix of all names: not within a number.
std::size_t commonBegin(const std::vector<std::string>& names) {
  std::size_t length = names.front().size();
  for (const std::string& name : names) {
    const auto [end, other] = std::ranges::mismatch(names.front(), name);
    length = std::min(length, static_cast<std::size_t>(end - names.front().begin()));
  }
  const auto withoutDigits = [&] {
    return names.front().find_last_not_of(kDigits, length - 1) + 1;  // npos + 1 is 0
  };
  if (length > 0) length = withoutDigits();
  const bool in_decimals = length > 1 && names.front()[length - 1] == '.' &&
                           kDigits.find(names.front()[length - 2]) != std::string_view::npos;
  if (in_decimals) length = names.front().find_last_not_of(kDigits, length - 2) + 1;
  return length;
}

/// The names without what all of them begin and end with.
std::vector<std::string> middlesOf(std::vector<std::string> names) {
  for (int i = 0; i < 2; ++i) {
    const std::size_t length = commonBegin(names);
    for (std::string& name : names) {
      name.erase(0, length);
      std::ranges::reverse(name);
    }
  }
  return names;
}

/// A number as text that compares by length, then by characters; empty for what is none.
std::string numberKey(std::string text, std::size_t decimals) {
  const std::size_t point = text.find('.');
  if ((point == std::string::npos ? 0 : text.size() - point) != decimals) return "";
  std::erase(text, '.');
  if (text.empty() || text.find_first_not_of(kDigits) != std::string::npos) return "";
  const std::size_t first = text.find_first_not_of('0');
  return first == std::string::npos ? "0" : text.substr(first);
}

}  // namespace

std::vector<fs::path> findImages(const fs::path& folder) {
  std::vector<fs::path> images;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (isImage(entry->path())) images.push_back(entry->path());
  }
  if (failure) {
    throw DataError(folder, "cannot be read (" + failure.message() + "); check the path");
  }
  if (images.empty()) throw DataError(folder, "has no .png or .jpg images; check the path");
  std::ranges::sort(images);
  return images;
}

std::vector<fs::path> numberedImages(const fs::path& folder) {
  const std::vector<fs::path> images = findImages(folder);
  if (images.size() == 1) return images;
  std::vector<std::string> names;
  for (const fs::path& image : images) names.push_back(image.stem().string());
  names = middlesOf(std::move(names));
  const std::size_t point = names.front().find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : names.front().size() - point;
  std::vector<std::pair<std::string, fs::path>> keyed;
  for (std::size_t i = 0; i < images.size(); ++i) {
    keyed.emplace_back(numberKey(names[i], decimals), images[i]);
    if (!keyed.back().first.empty()) continue;
    throw DataError(folder,
                    "has images whose order is not clear from their names, such as " +
                        images.front().filename().string() + " and " +
                        images.back().filename().string() +
                        "; rename them to one prefix and a number each, or read them by the source "
                        "`images` with their order in a file (list), or with their times as names "
                        "(stamps_in_names)");
  }
  std::ranges::sort(keyed, [](const auto& a, const auto& b) {
    return std::pair(a.first.size(), a.first) < std::pair(b.first.size(), b.first);
  });
  std::vector<fs::path> ordered;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i > 0 && keyed[i].first == keyed[i - 1].first) {
      throw DataError(folder, "has two images of one number, " +
                                  ordered.back().filename().string() + " and " +
                                  keyed[i].second.filename().string() +
                                  "; remove one of them, or put the images of each camera into a "
                                  "folder of their own");
    }
    ordered.push_back(keyed[i].second);
  }
  return ordered;
}

std::vector<fs::path> listedImages(const fs::path& list, const fs::path& folder) {
  std::vector<fs::path> images;
  std::error_code ignored;
  const std::string text = source_parameters::valueOf(text_encoding::readText(list));
  for (const text_encoding::TextLine& line : text_encoding::contentLines(text)) {
    const auto fields = text_encoding::splitFields(line.text);
    const auto found = std::ranges::find_if(
        fields, [](std::string_view field) { return isImage(fs::path(field)); });
    if (found == fields.end() && line.number == 1) continue;  // the names of columns
    if (found == fields.end()) throw DataError(list, line.number, "names no image; correct it");
    const fs::path beside = list.parent_path() / *found;
    images.push_back(fs::exists(beside, ignored) ? beside : folder / *found);
  }
  if (images.empty()) throw DataError(list, "names no images; write one name a line");
  return images;
}

Result<std::vector<std::uint8_t>> readBytes(const fs::path& file) {
  constexpr std::uintmax_t kMostBytes = std::uintmax_t{512} << 20U;
  std::error_code failure;
  const std::uintmax_t size = fs::is_regular_file(file, failure) ? fs::file_size(file, failure) : 0;
  if (size > kMostBytes) return Status::invalidInput("is larger than 512 MiB");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (stream) return bytes;
  const int error = errno == 0 ? EIO : errno;
  if (error == ENOENT) return Status::invalidInput("is missing");
  return Status::failed("cannot be read (" + std::generic_category().message(error) +
                        "); check its permissions and the disk");
}

Result<coded_images::DepthValues> readDepthFile(const fs::path& file) {
  const Result<std::vector<std::uint8_t>> bytes = readBytes(file);
  if (!bytes.isOk()) return bytes.status();
  return coded_images::decodeDepth(bytes.value());
}

}  // namespace tolman::image_folders
