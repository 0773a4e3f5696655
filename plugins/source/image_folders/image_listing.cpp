// SPDX-License-Identifier: BSD-3-Clause
#include "image_listing.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <string>

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Removes the leading digits from `text` and returns them without leading zeros.
std::string_view takeNumber(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

/// Negative, 0 or positive if a is before, equal to or after b; leading zeros are ignored.
int naturalOrder(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const std::string_view number_a = takeNumber(a);
      const std::string_view number_b = takeNumber(b);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size() ? -1 : 1;
      if (const int order = number_a.compare(number_b); order != 0) return order;
    } else {
      if (a.front() != b.front()) return a.front() < b.front() ? -1 : 1;
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return static_cast<int>(!a.empty()) - static_cast<int>(!b.empty());
}

bool isImage(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

std::string shortName(const fs::path& file) {
  return (file.parent_path().filename() / file.filename()).string();
}

void reportLonely(const fs::path& file, const fs::path& other_folder, Inspection& inspection) {
  inspection.error(other_folder, "has no " + file.stem().string() + ", the partner of " +
                                     shortName(file) + "; restore it, or remove the partner");
}

/// Two images of the same name are an error. Two of the same number are only a warning, because
/// names may be decimal numbers, of which 1.5 and 1.05 are different.
void checkDoubles(const fs::path& folder, const std::vector<fs::path>& sorted,
                  Inspection& inspection) {
  bool warned = false;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const std::string before = sorted[i - 1].stem().string();
    const std::string here = sorted[i].stem().string();
    const std::string both =
        "has both " + sorted[i - 1].filename().string() + " and " + sorted[i].filename().string();
    if (here == before) {
      inspection.error(folder, both + "; remove one of them");
    } else if (!warned && naturalOrder(before, here) == 0) {
      warned = true;
      inspection.warning(folder, both + ", which are two frames; remove one if they are one image");
    }
  }
}

/// The number in a name such as "frame_000123", if the rest of the name is `rest` ("frame_#").
std::optional<std::int64_t> numberOf(const fs::path& file, std::string& rest) {
  const std::string name = file.stem().string();
  const auto first = std::ranges::find_if(name, isDigit);
  const auto last = std::find_if_not(first, name.end(), isDigit);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(name.data() + (first - name.begin()),
                                            name.data() + (last - name.begin()), number);
  if (first == last || error != std::errc()) return std::nullopt;
  const std::string now = std::string(name.begin(), first) + "#" + std::string(last, name.end());
  if (rest.empty()) rest = now;
  return now == rest ? std::optional(number) : std::nullopt;
}

/// Warns of numbers that are missing where most images follow at the same step: times that
/// go by the position of an image would be wrong behind them.
void checkNumbers(const fs::path& folder, const std::vector<fs::path>& sorted,
                  Inspection& inspection) {
  std::string rest;
  std::map<std::int64_t, std::size_t> steps;
  std::vector<std::int64_t> numbers;
  for (const fs::path& file : sorted) {
    const auto number = numberOf(file, rest);
    if (!number) return;
    if (!numbers.empty()) ++steps[*number - numbers.back()];
    numbers.push_back(*number);
  }
  const auto usual = std::ranges::max_element(steps, {}, [](const auto& of) { return of.second; });
  if (steps.size() < 2 || 2 * usual->second <= numbers.size() - 1) return;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] - numbers[i - 1] <= usual->first) continue;
    inspection.warning(folder, "has no image between " + sorted[i - 1].filename().string() +
                                   " and " + sorted[i].filename().string() +
                                   "; times and poses by position are wrong from there on, unless "
                                   "their lines are missing as well");
    return;
  }
}

}  // namespace

bool naturalLess(std::string_view a, std::string_view b) {
  const int order = naturalOrder(a, b);
  return order != 0 ? order < 0 : a < b;
}

std::vector<fs::path> listImages(const fs::path& folder, Inspection& inspection) {
  std::vector<fs::path> images;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    // Hidden files are no frames: macOS adds ._NAME.png on disks of other systems.
    const bool is_hidden = entry->path().filename().string().starts_with('.');
    if (!is_hidden && isImage(entry->path())) images.push_back(entry->path());
  }
  if (failure) {
    inspection.error(folder, "cannot be read (" + failure.message() + "); check the path");
    return {};
  }
  if (images.empty()) inspection.error(folder, "has no .png or .jpg images; check the path");
  std::sort(images.begin(), images.end(), [](const fs::path& a, const fs::path& b) {
    const std::string stem_a = a.stem().string();
    const std::string stem_b = b.stem().string();
    return stem_a != stem_b ? naturalLess(stem_a, stem_b) : a < b;
  });
  checkDoubles(folder, images, inspection);
  checkNumbers(folder, images, inspection);
  return images;
}

void checkPairs(const std::vector<fs::path>& left, const std::vector<fs::path>& right,
                Inspection& inspection) {
  if (left.empty() || right.empty()) return;  // listImages() has added an error
  const fs::path left_folder = left.front().parent_path();
  const fs::path right_folder = right.front().parent_path();
  auto l = left.begin();
  auto r = right.begin();
  while (l != left.end() || r != right.end()) {
    if (l != left.end() && r != right.end() && l->stem() == r->stem()) {
      ++l;
      ++r;
    } else if (r == right.end() ||
               (l != left.end() && naturalLess(l->stem().string(), r->stem().string()))) {
      reportLonely(*l++, right_folder, inspection);
    } else {
      reportLonely(*r++, left_folder, inspection);
    }
  }
}

}  // namespace tolman::image_folders
