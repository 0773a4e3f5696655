// SPDX-License-Identifier: BSD-3-Clause
// The parts of YAML and XML that calibration files consist of.
#include "text_tree.hpp"

#include <catch2/catch.hpp>

using namespace tolman::camera_files;

namespace {

/// "LINE: what" of a text that is refused.
template <class Parse>
std::string refusalOf(const Parse& parse, std::string_view text) {
  try {
    parse(text);
  } catch (const FileError& error) {
    return std::to_string(error.line) + ": " + error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("maps, lists, comments, tags, quotes, and values over several lines") {
  const Node tree = parseYaml(
      "%YAML:1.0\n---\n# a comment\n"
      "name: \"left # one\"   # that was a name\n"
      "matrix: !!opencv-matrix\n   rows: 1\n   data: [ 1., 2.5e+0,\n       -3. ]\n"
      "rows:\n- [1, 2]\n- [3, 4]\n"
      "deep:\n  list:\n    - a: 7\n      b: 8\n    - 9\n"
      "flow: {rows: 2, data: [5, 6]}\n"
      "note: two\n  lines\nempty:\nlast: .5\n");
  CHECK(tree.find({"name"})->text == "left # one");
  CHECK(tree.find({"matrix"})->find({"data"})->numbers() == std::vector<double>{1, 2.5, -3});
  CHECK(tree.find({"rows"})->numbers() == std::vector<double>{1, 2, 3, 4});
  CHECK(tree.find({"rows"})->line == 9);
  CHECK(tree.line == 0);
  const Node& list = *tree.find({"deep"})->find({"list"});
  REQUIRE(list.children.size() == 2);
  CHECK(list.children[0].find({"b"})->number() == 8);
  CHECK(list.children[1].number() == 9);
  CHECK(tree.find({"flow"})->find({"data"})->numbers() == std::vector<double>{5, 6});
  CHECK(tree.find({"note"})->text == "two lines");
  CHECK(tree.find({"empty"})->text.empty());
  CHECK(tree.find({"missing", "last"})->number() == 0.5);
  CHECK(tree.find({"missing"}) == nullptr);
}

TEST_CASE("broken YAML is refused at its line") {
  CHECK(refusalOf(parseYaml, "") == "0: is empty; restore it");
  CHECK(refusalOf(parseYaml, "a: 1\nfoo\n") ==
        "2: 'foo' is not of the form 'name: value'; correct it");
  CHECK(refusalOf(parseYaml, "a: [1, 2\nb: 3\n") == "2: a comma or a closing bracket is missing");
  CHECK(refusalOf(parseYaml, "a: [1 2] 3\n") ==
        "1: something follows the closing bracket; remove it");
  CHECK(refusalOf(parseYaml, "  a: 1\n b: 2\n") ==
        "2: is not indented like the lines above; correct the file");
  CHECK_THAT(refusalOf(parseYaml, "a: " + std::string(50, '[')), Catch::Contains("too deeply"));
  std::string deep;
  for (std::size_t i = 0; i < 40; ++i) deep += std::string(i, ' ') + "a:\n";
  CHECK_THAT(refusalOf(parseYaml, deep), Catch::Contains("too deeply"));
  const Node tree = parseYaml("a: 1\nb: [1, two]\nc: nan\n");
  CHECK_THROWS_WITH(tree.find({"b"})->numbers(), "'two' is no finite number; correct it");
  CHECK_THROWS_WITH(tree.find({"c"})->number(), "'nan' is no finite number; correct it");
}

TEST_CASE("a key is given once in a map, and is not empty") {
  CHECK(refusalOf(parseYaml, "# the left\na: 1\n\nb: 2\na: 1\n") ==
        "5: 'a' is given twice, first in line 2; remove one of the two");
  CHECK(refusalOf(parseYaml, "a:\n  b: 1\n  c: 2\n  \"b\":\n    - 1\n") ==
        "4: 'b' is given twice, first in line 2; remove one of the two");
  CHECK(refusalOf(parseYaml, "- a: 1\n  a: 2\n") ==
        "2: 'a' is given twice, first in line 1; remove one of the two");
  CHECK(refusalOf(parseYaml, "m: {rows: 2, # of two\n  data: [5,\n\n  6],\n\n  rows: 3}\n") ==
        "6: 'rows' is given twice, first in line 1; remove one of the two");
  CHECK(refusalOf(parseYaml, "a: {b: 1}\nc: {b: 1}\n").empty());
  CHECK(refusalOf(parseYaml, "a: 1\n---\na: 2\n") ==
        "3: 'a' is given twice, first in line 1; remove one of the two");
  CHECK(refusalOf(parseYaml, "a: 1\n: 2\n") == "2: a key is empty; name it");
  CHECK(refusalOf(parseYaml, "a: 1\n\"\": 2\n") == "2: a key is empty; name it");
  CHECK(refusalOf(parseYaml, "a: {'': 2}\n") == "1: a key is empty; name it");
  CHECK(refusalOf(parseXml, "<a>\n<K>1</K>\n<D>1</D>\n<K>1</K>\n</a>") ==
        "4: 'K' is given twice, first in line 2; remove one of the two");
  CHECK(parseXml("<a>\n<l><_>1</_>\n<_>2</_></l></a>").find({"l"})->numbers() ==
        std::vector<double>{1, 2});
}

TEST_CASE("two names of one thing are refused, as one of them would be passed over") {
  const Node tree = parseYaml("K: 1\nb: 2\ncamera_matrix: 3\n");
  CHECK(tree.find({"K"})->number() == 1);
  CHECK(refusalOf(
            [&](std::string_view) {
              (void)tree.find({"camera_matrix", "K"});
            },
            "") == "3: 'camera_matrix' means the same as 'K' in line 1; remove one of the two");
}

TEST_CASE("lines are right after comments and empty lines within brackets") {
  const Node tree = parseYaml("a: [1,\n  # two follows\n\n  2,\n  x]\nb:\n\n  - 1\n  - y\n");
  CHECK(refusalOf([&](std::string_view) { (void)tree.find({"a"})->numbers(); }, "") ==
        "5: 'x' is no finite number; correct it");
  CHECK(refusalOf([&](std::string_view) { (void)tree.find({"b"})->numbers(); }, "") ==
        "9: 'y' is no finite number; correct it");
}

TEST_CASE("XML of elements and values") {
  const Node tree = parseXml(
      "<?xml version=\"1.0\"?>\n<!-- made by hand -->\n<opencv_storage>\n"
      "<K type_id=\"opencv-matrix\">\n  <rows>1</rows><data>\n 1. 2.\n 3.</data></K>\n"
      "<!-- width --><width>640</width><none/>\n</opencv_storage>\n");
  CHECK(tree.find({"K"})->find({"data"})->numbers() == std::vector<double>{1, 2, 3});
  CHECK(tree.find({"K"})->line == 4);
  CHECK(tree.find({"width"})->number() == 640);
  CHECK(tree.find({"none"})->text.empty());
  CHECK(refusalOf(parseXml, "<a>\n<b>1</c></a>") == "2: <b> is not closed here");
  CHECK(refusalOf(parseXml, "<a><b>1</b>") == "1: <a> is not closed; restore the file");
  CHECK(refusalOf(parseXml, "<a") == "1: ends before '>'; restore it");
  CHECK(refusalOf(parseXml, "words") == "1: has no element; this is no calibration");
  CHECK_THAT(refusalOf(parseXml, "<a>text<b>1</b></a>"), Catch::Contains("text beside elements"));
  std::string deep;
  for (int i = 0; i < 40; ++i) deep += "<a>";
  CHECK_THAT(refusalOf(parseXml, deep), Catch::Contains("too deeply"));
}
