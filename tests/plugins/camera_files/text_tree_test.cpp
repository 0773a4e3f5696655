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
  CHECK(tree.find({"rows"})->line == 10);
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
