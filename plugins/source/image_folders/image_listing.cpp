// SPDX-License-Identifier: BSD-3-Clause
#include "image_listing.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "name_order.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

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

void reportPartnerless(const std::vector<fs::path>& files, const std::vector<fs::path>& others,
                       Inspection& inspection) {
  std::set<std::string> stems;
  for (const fs::path& other : others) stems.insert(other.stem().string());
  for (const fs::path& file : files) {
    if (stems.contains(file.stem().string())) continue;
    reportLonely(file, others.front().parent_path(), inspection);
  }
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
    } else if (!warned && sameButForZeros(before, here)) {
      warned = true;
      inspection.warning(folder, both + ", which are two frames; remove one if they are one image");
    }
  }
}

std::vector<std::string> stemsOf(const std::vector<fs::path>& files) {
  std::vector<std::string> stems;
  for (const fs::path& file : files) stems.push_back(file.stem().string());
  return stems;
}

/// Warns where reading the names as decimal numbers changes the order, because they may be counts
/// separated by a point, of which 1.10 comes after 1.9.
void sortByName(const fs::path& folder, std::vector<fs::path>& images, Inspection& inspection) {
  const auto sortBy = [&](const auto& isLess) {
    std::ranges::sort(images, [&](const fs::path& a, const fs::path& b) {
      const std::string stem_a = a.stem().string();
      const std::string stem_b = b.stem().string();
      return stem_a != stem_b ? isLess(stem_a, stem_b) : a < b;
    });
  };
  sortBy(naturalLess);
  if (!areDecimals(stemsOf(images))) return;
  const std::vector<fs::path> natural = images;
  sortBy(decimalLess);
  const auto [here, there] = std::ranges::mismatch(images, natural);
  if (here == images.end()) return;
  inspection.warning(folder,
                     "has names that are read as decimal numbers: " + here->filename().string() +
                         " before " + there->filename().string() +
                         "; write all with the same number of decimals to leave no doubt");
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
  sortByName(folder, images, inspection);
  checkDoubles(folder, images, inspection);
  checkNumbers(folder, images, inspection);
  return images;
}

void checkPairs(const std::vector<fs::path>& left, const std::vector<fs::path>& right,
                Inspection& inspection) {
  if (left.empty() || right.empty()) return;  // listImages() has added an error
  reportPartnerless(left, right, inspection);
  reportPartnerless(right, left, inspection);
}

}  // namespace tolman::image_folders
