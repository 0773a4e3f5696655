// SPDX-License-Identifier: BSD-3-Clause
// Names that end in hexadecimal numbers.
#include "hexadecimal_names.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <random>

namespace tolman::image_folders {
namespace {

std::string hexText(const char* format, int value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::vector<std::string> ordered(const std::vector<std::string>& names) {
  std::vector<std::string> sorted;
  for (const std::size_t index : hexadecimalOrder(names)) sorted.push_back(names[index]);
  return sorted;
}

}  // namespace

TEST_CASE("hexadecimal numbers of one length are in the order of their values") {
  std::mt19937 random(2);
  for (const char* format : {"%04x", "0x%04X", "frame_%04x", "a b.%08x", "frame%05x"}) {
    std::vector<std::string> names;
    for (int i = 0; i < 300; ++i) names.push_back(hexText(format, 7 * i));
    const std::vector<std::string> wanted = names;
    std::ranges::shuffle(names, random);
    CHECK(ordered(names) == wanted);
    names.emplace_back("thumb");
    std::vector<std::string> with_stray = wanted;
    const bool is_before = std::string("thumb") < format && format[0] != '%' && format[0] != '0';
    with_stray.insert(is_before ? with_stray.begin() : with_stray.end(), "thumb");
    CHECK(ordered(names) == with_stray);
  }
}

TEST_CASE("other names are not taken for hexadecimal numbers") {
  using Names = std::vector<std::string>;
  for (const Names& names :
       {Names{}, Names{"1"}, Names{"1", "2", "a"}, Names{"10", "20", "30"}, Names{"face", "dead"},
        Names{"1e1", "1e2", "2e1"}, Names{"9", "a", "10"}, Names{"0a", "x", "y"},
        Names{"1.05", "1.1", "2", "thumb"}, Names{"img1", "img2"}, Names{"f1", "f10", "f11"},
        Names{"frame5", "frame10", "frame11"}, Names{"a1b", "a2b", "a10b"},
        Names{"0a", "0b", "0c", "1"}}) {
    CHECK(hexadecimalOrder(names).empty());
  }
}

}  // namespace tolman::image_folders
