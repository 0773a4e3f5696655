// SPDX-License-Identifier: BSD-3-Clause
#include "host/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "config/limits.hpp"
#include "config/text.hpp"

namespace tolman::host {

Status statusOf(const ValueProblem& problem) {
  return Status::failed(fmt::format(fmt::runtime(problem.what), problem.field));
}

namespace {

/// A name in quotes, shortened and printable.
std::string quoted(std::string_view name) {
  return "'" + config::printable(name.substr(0, config::kLongestName)) + "'";
}

Status checkName(std::string_view name) {
  const bool fits = !name.empty() && name.size() <= config::kLongestName;
  if (fits && config::isPrintable(name)) return Status::ok();
  return Status::failed(
      fmt::format("the array name {} is not of 1 to {} bytes of UTF-8 without control characters",
                  quoted(name), config::kLongestName));
}

Status checkText(std::string_view text, const std::string& array) {
  const bool fits = text.size() <= config::kLongestText;
  if (fits && config::printable(text) == text) return Status::ok();
  return Status::failed(
      fmt::format("a text that describes array '{}' is not of up to {} bytes of UTF-8 without "
                  "control characters: {}",
                  array, config::kLongestText, quoted(text)));
}

Status checkArray(const NamedArray& array) {
  if (Status status = checkName(array.name); !status.isOk()) return status;
  if (!config::shapeFits(array.shape, array.values.size())) {
    return Status::failed("array '" + array.name + "' has a size that differs from its shape");
  }
  if (std::ranges::all_of(array.values, [](float value) { return std::isfinite(value); })) {
    return Status::ok();
  }
  return Status::failed("array '" + array.name +
                        "' has NaN, infinity or a number beyond 3.4e38, the largest of 32 bits");
}

/// Whether two shapes differ at most in the length of the first axis.
bool differInLength(std::span<const int> a, std::span<const int> b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::ranges::equal(a.subspan(1), b.subspan(1));
}

Status changedShape(const NamedArray& array) {
  return Status::failed("array '" + array.name + "' changed its shape");
}

Status checkTexts(const ArrayInfo& info) {
  std::vector<std::string_view> texts = {info.unit, info.doc, info.population};
  for (const ArrayAxis& axis : info.axes) {
    texts.insert(texts.end(), {axis.name, axis.unit});
    texts.insert(texts.end(), axis.labels.begin(), axis.labels.end());
  }
  for (const std::string_view text : texts) {
    if (Status status = checkText(text, info.name); !status.isOk()) return status;
  }
  return Status::ok();
}

/// Checks the number of arrays, each array, and that names are unique.
template <class Named, class CheckOne>
Status checkEach(std::span<const Named> all, const CheckOne& check_one) {
  if (all.size() > config::kMaxArrays) {
    return Status::failed(
        fmt::format("{} arrays; at most {} are allowed", all.size(), config::kMaxArrays));
  }
  std::set<std::string_view> names;
  for (const Named& one : all) {
    if (Status status = check_one(one); !status.isOk()) return status;
    if (!names.insert(one.name).second) {
      return Status::failed("array '" + one.name + "' is given twice");
    }
  }
  return Status::ok();
}

}  // namespace

Status checkArrays(const std::vector<NamedArray>& arrays) {
  return checkEach(std::span(arrays), checkArray);
}

Status checkDescriptions(std::span<const ArrayInfo> arrays) {
  return checkEach(arrays, [](const ArrayInfo& info) {
    Status status = checkName(info.name);
    if (status.isOk()) status = checkValues(info);
    return status.isOk() ? checkTexts(info) : status;
  });
}

Status ArrayShapes::checkShapes(const std::vector<NamedArray>& arrays) {
  if (Status status = checkArrays(arrays); !status.isOk()) return status;
  for (const NamedArray& array : arrays) {
    const auto& [known, is_new] = known_.emplace(array.name, array.shape);
    if (!is_new && !differInLength(known->second, array.shape)) return changedShape(array);
  }
  return Status::ok();
}

Status ArrayShapes::check(const std::vector<NamedArray>& arrays) {
  if (Status status = checkArrays(arrays); !status.isOk()) return status;
  if (known_.empty()) {
    for (const NamedArray& array : arrays) known_.emplace(array.name, array.shape);
    return Status::ok();
  }
  for (const NamedArray& array : arrays) {
    const auto found = known_.find(array.name);
    if (found == known_.end()) {
      return Status::failed("array '" + array.name +
                            "' was not there before; the names stay the "
                            "same over a run");
    }
    if (found->second != array.shape) {
      return changedShape(array);
    }
  }
  if (arrays.size() == known_.size()) return Status::ok();
  const auto missing = std::ranges::find_if(known_, [&](const auto& known) {
    return std::ranges::find(arrays, known.first, &NamedArray::name) == arrays.end();
  });
  return Status::failed("array '" + missing->first +
                        "' is missing; the names stay the same over "
                        "a run");
}

}  // namespace tolman::host
