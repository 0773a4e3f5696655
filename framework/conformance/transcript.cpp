// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/transcript.hpp"

#include <algorithm>

namespace tolman::conformance {

void BitHash::add(const void* bytes, std::size_t size) {
  const auto* byte = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < size; ++i) hash_ = (hash_ ^ byte[i]) * 0x100000001b3ULL;
}

void BitHash::add(const Image& image) {
  const int shape[] = {image.width(), image.height(), static_cast<int>(image.format())};
  add(shape, sizeof shape);
  const auto bytes =
      static_cast<std::size_t>(std::ptrdiff_t{image.width()} * bytesPerPixel(image.format()));
  for (int r = 0; r < image.height(); ++r) add(image.row(r), bytes);
}

void BitHash::add(const NamedArray& array) {
  add(array.name);
  add(array.shape);
  add(array.values.data(), array.values.size() * sizeof(float));
}

void BitHash::add(const std::string& text) { add(text.c_str(), text.size() + 1); }

std::optional<std::string> firstDifference(const Transcript& expected, const Transcript& found,
                                           std::size_t skip) {
  const std::size_t count = expected.size() - std::min(skip, expected.size());
  for (std::size_t i = 0; i < std::min(count, found.size()); ++i) {
    const TranscriptEntry& wanted = expected[skip + i];
    const TranscriptEntry& given = found[i];
    if (wanted.call != given.call) return "'" + given.call + "' instead of '" + wanted.call + "'";
    for (std::size_t f = 0; f < std::max(wanted.fields.size(), given.fields.size()); ++f) {
      if (f >= wanted.fields.size() || f >= given.fields.size())
        return wanted.call + ": its length";
      if (wanted.fields[f] != given.fields[f]) {
        return wanted.call + ": '" + wanted.fields[f].first + "'";
      }
    }
  }
  if (count == found.size()) return std::nullopt;
  return std::to_string(found.size()) + " answers instead of " + std::to_string(count);
}

}  // namespace tolman::conformance
