// SPDX-License-Identifier: BSD-3-Clause
// The order of images by names of all kinds, and when it is in doubt.
#include "name_order.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <numeric>
#include <random>

namespace tolman::image_folders {
namespace {

using Names = std::vector<std::string>;

Names inOrder(const Names& names, const NameOrder& order) {
  Names sorted;
  for (const std::size_t index : order.indices) sorted.push_back(names[index]);
  return sorted;
}

std::string textOf(const char* format, double value) {
  char text[80];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Whether something is told of the order or of two names.
bool isTold(const NameOrder& order) { return order.doubt || order.same; }

}  // namespace

TEST_CASE("names without doubt are in natural order") {
  for (const Names& names : {
           Names{},
           Names{"x"},
           Names{"000000", "000001", "000010"},
           Names{"7", "08", "9", "10", "011"},
           Names{"image2", "image10"},
           Names{"cam-1", "cam-2", "cam-10"},
           Names{"2024-01-02", "2024-01-10", "2024-02-01"},
           Names{"12.30.05", "12.30.10", "13.00.00"},
           Names{"10.0.0.2", "10.0.0.10", "10.0.1.1"},
           Names{"1305031102.175304", "1305031102.211214", "1305031103.000001"},
           Names{"9.95", "10.05", "10.10"},
           Names{"0.9", "0.95", "1", "1.5", "10"},
           Names{"img", "img (1)", "img (2)", "img (10)"},
           Names{"1", "1a", "2", "2a"},
           Names{"1a", "2a", "9a", "10a"},
           Names{"f1", "f9", "f10", "f11", "f99", "f100"},
           Names{"a1b", "a2b", "a3b", "a10b"},
           Names{"frame1", "frame5", "frame10", "frame11"},
           Names{"20240102_123005", "20240102_123006"},
           Names{"99999999999999999998", "99999999999999999999", "100000000000000000000"},
           Names{"0", "1", "thumb"},
           Names{"IMG_1", "IMG_2", "IMG_10"},
           Names{"seq1.9.1_2", "seq1.9.1_10", "seq1.10.1_1"},
       }) {
    Names reversed(names.rbegin(), names.rend());
    const NameOrder order = orderNames(reversed);
    INFO((names.empty() ? "" : names.front()));
    CHECK(inOrder(reversed, order) == names);
    CHECK(order.reading == NameOrder::Reading::Natural);
    CHECK_FALSE(isTold(order));
  }
}

TEST_CASE("where the numbers have another order, it is taken and told") {
  for (const Names& names : {
           Names{"1.05", "1.1", "1.2"},
           Names{"1.05", "1.1", "2", "thumb"},
           Names{"frame_1.05", "frame_1.1"},
           Names{"cam0_1.05_left", "cam0_1.1_left"},
           Names{"a1.05", "a1.1", "b1.05", "b1.1"},
           Names{"1,05", "1,1"},
           Names{"1.10", "1.9"},  // in doubt: may be the tenth
           Names{"-1.5", "-0.5", "0.5"},
           Names{"-3", "-2", "-1", "0", "1"},
           Names{"t_-2", "t_-1", "t_0"},
           Names{"1e1", "2e1", "1e2"},
           Names{"0.0", "1e-05", "0.0001", "0.1"},
           Names{"Frame_1", "frame_2", "Frame_3"},
           Names{"1", " 2", "3"},
           Names{"\xef\xbc\x92", "\xef\xbc\x91\xef\xbc\x90"},  // 2 and 10 of full width
           Names{"1305031102.175304", "1305031102.9"},
           Names{"seq1.2.3_0.05", "seq1.2.3_0.1"},
           Names{"frame_1e-05", "frame_0.0001", "frame_0.1"},
       }) {
    for (Names shuffled : {names, Names(names.rbegin(), names.rend())}) {
      const NameOrder order = orderNames(shuffled);
      INFO(names.front());
      CHECK(inOrder(shuffled, order) == names);
      CHECK(order.reading == NameOrder::Reading::Numbers);
      CHECK_FALSE(order.same);
      REQUIRE(order.doubt);
      const auto place = [&](std::size_t index) {
        return std::ranges::find(names, shuffled[index]) - names.begin();
      };
      CHECK(place(order.doubt->first) < place(order.doubt->second));
    }
  }
}

TEST_CASE("counts separated by points stay in natural order, which is told") {
  for (const Names& names : {
           Names{"1.1", "1.2", "1.9", "1.10"},
           Names{"1.1", "1.2", "1.05", "1.20"},
           Names{"1.1", "1.05", "1.10"},
           Names{"1.9", "1.10", "1.10.1", "1.11"},
           Names{"A1", "A2", "a1", "a2"},
           Names{"-1", "-2", "-02", "0"},
       }) {
    Names reversed(names.rbegin(), names.rend());
    const NameOrder order = orderNames(reversed);
    INFO(names.front());
    if (names.front() != "-1") CHECK(inOrder(reversed, order) == names);
    CHECK(order.reading == NameOrder::Reading::Natural);
    CHECK(order.doubt);
  }
}

TEST_CASE("commas may separate thousands: told, and read as decimal ones") {
  const NameOrder order = orderNames({"998", "999", "1,000", "1,001"});
  CHECK(order.indices == std::vector<std::size_t>{2, 3, 0, 1});
  CHECK(order.doubt == NameOrder::Pair(2, 0));
  CHECK_FALSE(isTold(orderNames({"1,050", "1,100", "9,999", "10,000"})));
  CHECK_FALSE(isTold(orderNames({"a 1,5 1", "a 1,5 2"})));
}

TEST_CASE("other separators of thousands are told as commas are") {
  for (const std::string separator : {"_", " ", "'"}) {
    INFO(separator);
    for (const std::string prefix : {"", "f-"}) {
      const Names names = {prefix + "998", prefix + "999", prefix + "1" + separator + "000",
                           prefix + "1" + separator + "001"};
      const NameOrder order = orderNames(names);
      CHECK(order.indices == std::vector<std::size_t>{2, 3, 0, 1});
      CHECK(order.doubt == NameOrder::Pair(2, 0));
    }
    const auto joined = [&](const char* a, const char* b) { return a + separator + b; };
    // Counts and dates that only contain three digits.
    CHECK_FALSE(isTold(orderNames({joined("1", "999"), joined("1", "1000")})));
    CHECK_FALSE(isTold(orderNames({joined("1", "998"), joined("1", "999"), joined("2", "000")})));
    CHECK_FALSE(isTold(orderNames({joined("20240102", "100"), joined("20240102", "200")})));
    CHECK_FALSE(isTold(orderNames({joined("01", "999"), joined("02", "000"), "500"})));
  }
}

TEST_CASE("points and the separators of Switzerland and France are told, decimals are not") {
  for (const std::string separator : {".", "\xe2\x80\x99", "\xe2\x80\xaf", "\xc2\xa0"}) {
    INFO(separator);
    const NameOrder order =
        orderNames({"998", "999", "1" + separator + "000", "1" + separator + "001"});
    CHECK(order.indices == std::vector<std::size_t>{2, 3, 0, 1});
    CHECK(order.doubt == NameOrder::Pair(2, 0));
  }
  CHECK(orderNames({"999.998", "999.999", "1.000.000"}).doubt);
  CHECK_FALSE(isTold(orderNames({"0.998", "0.999", "1.000", "1.001"})));
  CHECK_FALSE(isTold(orderNames({"1.050", "1.100", "1.150"})));
}

TEST_CASE("a dash behind a letter is told where other names lack it") {
  const NameOrder order = orderNames({"t-1.5", "t-0.5", "t0.5", "t1.5"});
  REQUIRE(order.doubt);
  CHECK(order.doubt == NameOrder::Pair(1, 0));
  CHECK_FALSE(isTold(orderNames({"cam-1", "cam-2", "cam-10"})));
  CHECK(orderNames({"t_-1.5", "t_0.5"}).indices.front() == 0);
}

TEST_CASE("other dashes are minus signs as well") {
  for (const std::string dash : {"\xe2\x80\x93", "\xef\xb9\xa3", "\xef\xbc\x8d"}) {
    const NameOrder order = orderNames({dash + "1", dash + "2", "0", "1"});
    CHECK(order.indices == std::vector<std::size_t>{1, 0, 2, 3});
    CHECK(order.doubt);
  }
}

TEST_CASE("U+2212 is a minus sign") {
  const std::string minus = "\xe2\x88\x92";
  const Names names = {minus + "0.5", minus + "1.5", minus + "2.5"};
  const NameOrder order = orderNames(names);
  CHECK(order.indices == std::vector<std::size_t>{2, 1, 0});
  CHECK(order.doubt);
  const NameOrder mixed = orderNames({"0.5", "1.5", minus + "0.5", "-1.5"});
  CHECK(mixed.indices == std::vector<std::size_t>{3, 2, 0, 1});
  CHECK(mixed.strays.empty());
}

TEST_CASE("two names of one number are told also where the order is not in doubt") {
  for (const Names& names : {Names{"01", "1", "2"}, Names{"1", "1.0", "2.0"}, Names{"A", "a", "b"},
                             Names{"1.1", "1.10"}, Names{"frame_007", "frame_7"}}) {
    const NameOrder order = orderNames(names);
    CHECK(inOrder(names, order) == names);
    CHECK_FALSE(order.doubt);
    CHECK(order.same == NameOrder::Pair(0, 1));
  }
  CHECK_FALSE(isTold(orderNames({"1", "1", "2"})));  // 1.png and 1.jpg
}

TEST_CASE("names unlike most are strays") {
  using Indices = std::vector<std::size_t>;
  CHECK(orderNames({"1", "2", "thumb", "3.5", "-4"}).strays == Indices{2});
  CHECK(orderNames({"cover", "f_1", "F_2", "f_30", "f_4 copy", "f_5"}).strays == Indices{0, 4});
  CHECK(orderNames({"left_1", "left_2", "right_1", "right_2"}).strays.empty());  // none has most
  CHECK(orderNames({"cam0_1", "cam0_2", "cam1_1"}).strays.empty());
  CHECK(orderNames({"00", "01", "02", "08", "09", "0a"}).strays.empty());
  CHECK(orderNames({"house", "tree", "car"}).strays.empty());
}

TEST_CASE("hexadecimal names are in the order of their values, which is told") {
  const Names names = {"frame_08", "frame_09", "frame_0a", "frame_0f",
                       "frame_10", "frame_1e", "frame_1f"};
  Names reversed(names.rbegin(), names.rend());
  const NameOrder order = orderNames(reversed);
  CHECK(inOrder(reversed, order) == names);
  CHECK(order.reading == NameOrder::Reading::Hexadecimal);
  CHECK(order.doubt);
  CHECK(orderNames({"10", "1a", "1b", "2a"}).doubt);  // 1a, 1b, 2a, 10 as text
  CHECK(orderNames({"1d9", "1da", "1e0", "1e1", "1ea"}).indices ==
        std::vector<std::size_t>{0, 1, 2, 3, 4});  // 1e0 is not 1
}

TEST_CASE("numbers in any format are in the order of their values, or it is told") {
  const std::vector<const char*> formats = {"%g",   "%.3f",  "%+.3f",    "%.1f",      "%08.2f",
                                            "%.9g", "%.4e",  "f_%g",     "f_%.2f s",  "%gs",
                                            "a-%g", "x%.0f", "t=%.3g,0", "2024-%g-1", "v1.2_%g"};
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> choice(0, formats.size() - 1);
  int told = 0;
  for (int round = 0; round < 3000; ++round) {
    const bool negative = round % 3 == 0;
    std::uniform_int_distribution<int> thousandths(negative ? -15000 : 0, 15000);
    const double unit = round % 2 == 0 ? 1000 : 10;
    const char* format = formats[choice(random)];
    std::vector<std::pair<double, std::string>> images;
    for (int i = 0; i < 12; ++i) {
      const double value = thousandths(random) / unit;
      images.emplace_back(value, textOf(format, value));
    }
    if (round % 5 == 0) images.emplace_back(1e9, "~stray");
    Names names;
    for (const auto& image : images) names.push_back(image.second);
    const NameOrder order = orderNames(names);
    const bool sorted =
        std::ranges::is_sorted(order.indices, {}, [&](std::size_t i) { return images[i].first; });
    INFO(format << ", " << names.front() << ", " << names.back());
    // A dash after a letter or a digit is a separator, and rounding to one name is no order.
    const bool dash_is_text = std::string(format) == "a-%g" || std::string(format) == "x%.0f" ||
                              std::string(format) == "2024-%g-1";
    if (negative && dash_is_text) continue;
    std::ranges::sort(names);
    if (std::ranges::adjacent_find(names) != names.end()) continue;
    REQUIRE((sorted || isTold(order)));
    told += isTold(order) ? 1 : 0;
  }
  CHECK(told > 0);
  CHECK(told < 3000);
}

TEST_CASE("numbers written in one way without sign are in order, and nothing is told") {
  std::mt19937 random(4);
  for (const char* format : {"%06.0f", "%.0f", "%.6f", "%09.3f", "frame%.0f", "a_%.2f_b", "(%.0f)",
                             "2024-01-%02.0f", "1403636579763555%03.0f"}) {
    std::vector<double> values(60);
    std::iota(values.begin(), values.end(), 5);
    std::ranges::shuffle(values, random);
    Names names;
    for (const double value : values) names.push_back(textOf(format, value));
    const NameOrder order = orderNames(names);
    INFO(format);
    CHECK(std::ranges::is_sorted(order.indices, {}, [&](std::size_t i) { return values[i]; }));
    CHECK_FALSE(isTold(order));
  }
}

TEST_CASE("the order of names does not depend on the order in which they are found") {
  const std::string letters = "019aAf.-_ e,+";
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1);
  for (int round = 0; round < 2000; ++round) {
    Names names(8);
    for (std::string& name : names) {
      for (int i = 0; i < 1 + round % 5; ++i) name += letters[letter(random)];
    }
    std::ranges::sort(names);
    const auto [last, end] = std::ranges::unique(names);
    names.erase(last, end);
    const Names first = inOrder(names, orderNames(names));
    std::ranges::shuffle(names, random);
    REQUIRE(inOrder(names, orderNames(names)) == first);
    REQUIRE(first.size() == names.size());
  }
}

}  // namespace tolman::image_folders
