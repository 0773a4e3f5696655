// SPDX-License-Identifier: BSD-3-Clause
#include "app/parameter_text.hpp"

#include <catch2/catch.hpp>

using namespace tolman;

namespace {

host::LoadedPlugin toyPlugin() {
  host::LoadedPlugin plugin;
  plugin.manifest.id = "toy";
  plugin.manifest.role = Role::Cells;
  plugin.manifest.version = "1.0";
  plugin.manifest.summary = "A toy.";
  ParameterInfo count;
  count.name = "count";
  count.type = ParameterType::Integer;
  count.default_value = std::int64_t{3};
  count.min = 1;
  count.unit = "px";
  count.doc = "How many.";
  ParameterInfo colour;
  colour.name = "colour";
  colour.type = ParameterType::Choice;
  colour.default_value = std::string("red");
  colour.choices = {"red", "green"};
  colour.doc = "Which.";
  ParameterInfo path;
  path.name = "path";
  path.type = ParameterType::Path;
  path.required = true;
  path.doc = "Where.";
  plugin.schema = {count, colour, path};
  return plugin;
}

}  // namespace

TEST_CASE("parameters as text") {
  CHECK(app::parametersText(toyPlugin()) ==
        "toy 1.0 (cells): A toy.\n"
        "  count                      integer       default 3 px  [>= 1]\n"
        "      How many.\n"
        "  colour                     choice        default \"red\"  [red, green]\n"
        "      Which.\n"
        "  path                       path          required\n"
        "      Where.\n"
        "In a configuration:\n"
        "  cells: {plugin: toy, path: ...}\n"
        "  Parameters are keys beside `plugin`, and so are the keys of every stage: name,\n"
        "  on_failure (stop, skip, restart) and isolation (none, process).\n");
}

TEST_CASE("parameters as a reference page") {
  CHECK(app::parametersMarkdown(toyPlugin()) ==
        "## `toy` (cells)\n\nA toy.\n\n"
        "| parameter | type | default | unit | range | meaning |\n|---|---|---|---|---|---|\n"
        "| `count` | integer | 3 | px | >= 1 | How many. |\n"
        "| `colour` | choice | \"red\" |  | red, green | Which. |\n"
        "| `path` | path | required |  |  | Where. |\n");
}

TEST_CASE("parameters as JSON") {
  const auto json = app::parametersJson(toyPlugin());
  CHECK(json["parameters"].size() == 3);
  CHECK(json["parameters"][0]["min"] == 1);
  CHECK_FALSE(json["parameters"][0].contains("max"));
  CHECK(json["parameters"][1]["choices"][1] == "green");
  CHECK(json["parameters"][2]["required"] == true);
}
