// SPDX-License-Identifier: BSD-3-Clause
#include "image_listing.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <string>

#include "base/open_files.hpp"
#include "exact_decimal.hpp"
#include "image_name.hpp"
#include "name_order.hpp"
#include "name_series.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

void reportLonely(const fs::path& file, const fs::path& other_folder, Inspection& inspection) {
  inspection.error(other_folder, "has no " + file.stem().string() + ", the partner of " +
                                     (file.parent_path().filename() / file.filename()).string() +
                                     "; restore it, or remove the partner");
}

/// Two images of the same name are an error.
void checkDoubles(const fs::path& folder, const std::vector<fs::path>& sorted,
                  Inspection& inspection) {
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].stem() != sorted[i - 1].stem()) continue;
    inspection.error(folder, "has both " + sorted[i - 1].filename().string() + " and " +
                                 sorted[i].filename().string() + "; remove one of them");
  }
}

/// How names in doubt are read, and what to do, for the warning.
std::string readingOf(const NameOrder& order, const std::vector<fs::path>& files) {
  if (order.reading == NameOrder::Reading::Hexadecimal) {
    return ", as hexadecimal numbers; rename the images to decimal ones";
  }
  std::string text = order.reading == NameOrder::Reading::Numbers
                         ? ", by their numbers with sign and decimals"
                         : ", digits as whole numbers";
  if (order.reading == NameOrder::Reading::Natural && order.same) {
    text += ", because " + files[order.same->first].filename().string() + " and " +
            files[order.same->second].filename().string() + " are equal otherwise";
  }
  return text +
         "; rename the images to numbers of equally many digits without sign, or, if the names are "
         "times, set stamps_in_names (of `images`)";
}

/// Two names of the same number are only a warning, because they may be two frames, such as 1.1 and
/// 1.10.
void reportDoubts(const fs::path& folder, const std::vector<fs::path>& files,
                  const NameOrder& order, Inspection& inspection) {
  const auto name = [&](std::size_t index) { return files[index].filename().string(); };
  if (order.doubt) {
    inspection.warning(folder, "has names whose order is in doubt: " + name(order.doubt->first) +
                                   " is read before " + name(order.doubt->second) +
                                   readingOf(order, files));
  } else if (order.same) {
    inspection.warning(folder, "has both " + name(order.same->first) + " and " +
                                   name(order.same->second) +
                                   ", which are two frames; remove one if they are one image");
  }
  if (order.strays.empty()) return;
  const std::size_t count = order.strays.size();
  inspection.warning(folder, "has " + name(order.strays.front()) +
                                 (count == 1 ? ", which is named unlike most images and a frame "
                                               "as well; remove it if it is none"
                                             : " and other images, " + std::to_string(count) +
                                                   " in all, which are named unlike most and "
                                                   "frames as well; remove those that are none"));
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

/// Names that begin with a point, which file managers hide.
class HiddenImages {
 public:
  /// Whether an image is no frame. ".5" is, as bc and Fortran print it. "._NAME" of macOS, on disks
  /// of other systems, is no image at all, so it is not counted.
  bool leavesOut(const fs::path& file) {
    const std::string name = file.filename().string();
    if (!name.starts_with('.') || parseExactDecimal(file.stem().string())) return false;
    if (name.starts_with("._")) return true;
    ++count_;
    if (first_.empty() || name < first_) first_ = name;  // folders are read in no fixed order
    return true;
  }

  void report(const fs::path& folder, Inspection& inspection) const {
    if (count_ == 0) return;
    inspection.warning(
        folder,
        count_ == 1
            ? "has the hidden image " + first_ +
                  ", which is left out; if it is a frame, rename it without the point"
            : "has " + std::to_string(count_) + " hidden images, such as " + first_ +
                  ", which are left out; if they are frames, rename them without the point");
  }

 private:
  std::size_t count_ = 0;
  std::string first_;
};

}  // namespace

bool isImage(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

std::vector<fs::path> findImages(const fs::path& folder, Inspection& inspection) {
  std::vector<fs::path> images;
  HiddenImages hidden;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path& file = entry->path();
    if (isImage(file) && !hidden.leavesOut(file)) images.push_back(file);
  }
  if (failure) {
    inspection.error(folder, file_opening::notOpened("cannot be read (" + failure.message() +
                                                     "); check the path"));
    return {};
  }
  hidden.report(folder, inspection);
  if (images.empty()) inspection.error(folder, "has no .png or .jpg images; check the path");
  std::ranges::sort(images, [](const fs::path& a, const fs::path& b) {
    const std::string stem_a = a.stem().string();
    const std::string stem_b = b.stem().string();
    return stem_a != stem_b ? naturalLess(stem_a, stem_b) : a < b;
  });
  checkDoubles(folder, images, inspection);
  return images;
}

std::vector<fs::path> listImages(const fs::path& folder, Inspection& inspection) {
  const std::vector<fs::path> found = findImages(folder, inspection);
  std::vector<std::string> stems;
  stems.reserve(found.size());
  for (const fs::path& file : found) stems.push_back(file.stem().string());
  const NameOrder order = orderNames(stems);
  reportDoubts(folder, found, order, inspection);
  std::vector<fs::path> images;
  std::vector<fs::path> without_strays;
  for (const std::size_t index : order.indices) {
    images.push_back(found[index]);
    if (!std::ranges::binary_search(order.strays, index)) without_strays.push_back(found[index]);
  }
  checkNumbers(folder, without_strays, inspection);
  if (const auto two = twoOfOneNumber(images)) {
    inspection.warning(folder, "has both " + two->first.filename().string() + " and " +
                                   two->second.filename().string() +
                                   ", and so for most numbers: they are taken as frames of one "
                                   "camera; if they are of two, put the images of each into a "
                                   "folder of its own");
  }
  return images;
}

std::vector<fs::path> listPartners(const std::vector<fs::path>& left, const fs::path& folder,
                                   Inspection& inspection) {
  const std::vector<fs::path> right = findImages(folder, inspection);
  if (left.empty() || right.empty()) return right;  // an error was added
  std::map<std::string, fs::path> by_stem;
  for (const fs::path& file : right) by_stem.emplace(file.stem().string(), file);
  std::vector<fs::path> partners;
  for (const fs::path& file : left) {
    const auto found = by_stem.find(file.stem().string());
    if (found == by_stem.end()) {
      reportLonely(file, folder, inspection);
    } else {
      partners.push_back(found->second);
      by_stem.erase(found);
    }
  }
  for (const fs::path& file : right) {
    if (!by_stem.contains(file.stem().string())) continue;
    reportLonely(file, left.front().parent_path(), inspection);
    partners.push_back(file);
  }
  return partners;
}

}  // namespace tolman::image_folders
