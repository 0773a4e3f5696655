// SPDX-License-Identifier: BSD-3-Clause
// The expected message for each kind of error in a configuration. They are part of the interface: a
// change here changes what users read.
#include <catch2/catch.hpp>

#include "config/toy_system.hpp"

namespace tolman {
namespace {

std::string complaints(const std::string& file, const std::vector<std::string>& overrides = {}) {
  return test::checkSystem("broken/" + file, overrides, {{"HOME", "/home/ada"}}).complaints();
}

}  // namespace

TEST_CASE("The configuration that the broken ones extend is valid") {
  CHECK(test::checkSystem("whole.yaml").complaints() == "");
}

TEST_CASE("Misspelt keys are refused with the nearest known name, at every level") {
  CHECK(complaints("typos.yaml") ==
        "broken/typos.yaml:2:1: piepline: unknown key; did you mean 'pipeline'? (keys: name, "
        "seed, threads, on_findings, continue, localise, source, odometry, place, cells, map, "
        "observers, "
        "pipeline, "
        "evaluation, "
        "record, isolation, checks, rectification, images, extends)\n"
        "broken/typos.yaml:3:12: pipeline.mod: unknown key; did you mean 'mode'? (keys: mode, "
        "queue, input_policy, speed)\n"
        "broken/typos.yaml:5:3: odometry.activ_points: unknown parameter; did you mean "
        "'active_points'? (parameters of plugin toy_odometry: active_points, scale, pyramid, "
        "solver)\n"
        "broken/typos.yaml:7:28: observers.0.prot: unknown parameter; did you mean 'port'? "
        "(parameters of plugin toy_observer: port)\n");
}

TEST_CASE("A duplicate key is refused with the position of the first") {
  CHECK(complaints("duplicates.yaml") ==
        "broken/duplicates.yaml:6:3: odometry.active_points: given twice; first at "
        "broken/duplicates.yaml:4:3\n"
        "broken/duplicates.yaml:7:1: seed: given twice; first at broken/duplicates.yaml:2:1\n");
}

TEST_CASE("Wrong types are refused with the expected type") {
  CHECK(complaints("types.yaml") ==
        "broken/types.yaml:2:7: seed: expects an integer, not 'many'\n"
        "broken/types.yaml:4:9: source.path: expects a path, not a list\n"
        "broken/types.yaml:5:10: source.first: expects an integer, not '1.5'\n"
        "broken/types.yaml:6:9: source.loop: expects true or false, not 'yes'; write true\n"
        "broken/types.yaml:8:18: odometry.active_points: expects an integer, not a text; remove "
        "the quotes\n"
        "broken/types.yaml:9:10: odometry.scale: expects a number, not 'abc'\n"
        "broken/types.yaml:10:12: odometry.pyramid: expects a list of numbers such as [1, 2.5], "
        "not '3'\n"
        "broken/types.yaml:11:3: odometry.solver: expects a text, not nothing\n"
        "broken/types.yaml:12:3: odometry.nothing: unknown parameter (parameters of plugin "
        "toy_odometry: active_points, scale, pyramid, solver)\n"
        "broken/types.yaml:13:6: map: expects a map such as {plugin: ...}, not 'experience_map'\n");
}

TEST_CASE("Ambiguous YAML is refused: octal, hexadecimal, on, NaN, infinity") {
  CHECK(complaints("traps.yaml") ==
        "broken/traps.yaml:2:7: seed: expects an integer, not '010'; write it without leading "
        "zeros\n"
        "broken/traps.yaml:3:10: threads: expects an integer, not '0x10'\n"
        "broken/traps.yaml:4:19: pipeline.queue: expects an integer, not '1e1'; write 10\n"
        "broken/traps.yaml:4:31: pipeline.speed: expects a finite number, not '.nan'\n"
        "broken/traps.yaml:5:16: source.loop: expects true or false, not 'on'; write true\n"
        "broken/traps.yaml:5:27: source.first: expects an integer, not '1_000'\n"
        "broken/traps.yaml:6:19: odometry.scale: expects a finite number, not '-.inf'\n"
        "broken/traps.yaml:6:39: odometry.pyramid.1: expects a finite number, not 'nan'\n");
}

TEST_CASE("Values out of range show the range with its unit; bad choices show the choices") {
  CHECK(complaints("ranges.yaml") ==
        "broken/ranges.yaml:2:10: threads: -1 is out of range: 0 ... 1024\n"
        "broken/ranges.yaml:3:18: pipeline.mode: expects one of lossless, realtime, not 'realtim'; "
        "did you mean 'realtime'?\n"
        "broken/ranges.yaml:3:34: pipeline.queue: 0 is out of range: 1 ... 1024 frames\n"
        "broken/ranges.yaml:4:17: source.order: expects one of forward, backward, pingpong, not "
        "'sideways'\n"
        "broken/ranges.yaml:4:34: source.first: -3 is out of range: 0 ... 1000000\n"
        "broken/ranges.yaml:5:27: odometry.active_points: 9 is out of range: 50 ... 20000 points\n"
        "broken/ranges.yaml:5:37: odometry.scale: 100 is out of range: 0.5 ... 8 pixels\n"
        "broken/ranges.yaml:5:55: odometry.pyramid.1: 99 is out of range: 0 ... 16\n"
        "broken/ranges.yaml:6:25: evaluation.alignment: expects one of auto, se3, se2, sim3, none, "
        "not 'se4'; did you mean 'se3'?\n");
}

TEST_CASE("Missing and malformed stages are refused with a remedy") {
  CHECK(complaints("stages.yaml") ==
        "broken/stages.yaml:1:1: odomtry: unknown key; did you mean 'odometry'? (keys: name, "
        "seed, threads, on_findings, continue, localise, source, odometry, place, cells, map, "
        "observers, "
        "pipeline, "
        "evaluation, "
        "record, isolation, checks, rectification, images, extends)\n"
        "broken/stages.yaml:1:1: source: the stage is missing; add 'source: {plugin: ...}' "
        "('tolman plugins list' shows the plugins)\n"
        "broken/stages.yaml:1:1: cells: the stage is missing; add 'cells: {plugin: ...}' ('tolman "
        "plugins list' shows the plugins)\n"
        "broken/stages.yaml:2:11: odometry.plugin: is missing: Id of the plugin.\n"
        "broken/stages.yaml:2:32: odometry.plugni: unknown key; did you mean 'plugin'? (keys: "
        "plugin, name, on_failure, isolation)\n"
        "broken/stages.yaml:3:39: place.isolation: expects one of none, process, not 'porcess'; "
        "did you mean 'process'?\n"
        "broken/stages.yaml:4:6: map: expects a map such as {plugin: ...}, not a list\n"
        "broken/stages.yaml:7:5: observers.1: has the same name 'toy_observer' as observers.0; set "
        "another 'name'\n"
        "broken/stages.yaml:8:34: observers.2.name: use letters, digits, '_' and '-': it becomes "
        "the name of a folder\n"
        "broken/stages.yaml:9:5: observers.3: expects a map such as {plugin: ...}, not "
        "'progress'\n");
}

TEST_CASE("Circular extends is reported once, with the chain of files") {
  CHECK(complaints("circle_a.yaml") ==
        "broken/circle_c.yaml:1:10: extends: circular: broken/circle_b.yaml -> "
        "broken/circle_c.yaml -> broken/circle_b.yaml\n");
}

TEST_CASE("A missing file is reported at the `extends` that names it") {
  CHECK(complaints("missing_base.yaml") ==
        "broken/missing_base.yaml:1:7: seed: expects an integer, not 'x'\n"
        "broken/missing_base.yaml:2:11: extends: broken/nowhere.yaml: no such file\n"
        "broken/missing_base.yaml:2:25: extends: broken/layers: no such file\n");
  CHECK(complaints("no_such.yaml") == "broken/no_such.yaml: no such file\n");
  CHECK(complaints("../broken") == "broken/../broken: not a regular file\n");
}

TEST_CASE("Illegal environment variables are refused with file and remedy") {
  CHECK(test::checkSystem("broken/variables.yaml", {}, {{"PORT", ""}}).complaints() ==
        "broken/variables.yaml:2:7: name: the environment variable TOLMAN_TEST_UNSET is not set; "
        "set it or write ${TOLMAN_TEST_UNSET:-default}\n"
        "broken/variables.yaml:3:16: source.path: '${' without '}'\n"
        "broken/variables.yaml:4:20: odometry.solver: '${9LIVES}' is not a variable; write ${NAME} "
        "or ${NAME:-default}, and $${ for the characters themselves\n"
        "broken/variables.yaml:6:34: observers.0.port: expects an integer, not 'many'\n");
}

TEST_CASE("A file that is not a configuration gives one problem") {
  const auto [file, expected] = GENERATE(table<const char*, const char*>({
      {"empty.yaml", "broken/empty.yaml: the file is empty\n"},
      {"comment.yaml", "broken/comment.yaml: the file is empty\n"},
      {"list.yaml", "broken/list.yaml:1:1: a configuration is a map of keys, not a list\n"},
      {"tab.yaml",
       "broken/tab.yaml:2:8: cannot read this YAML: illegal map value; indent with spaces, not "
       "tabs\n"},
      {"bare_variable.yaml",
       "broken/bare_variable.yaml:1:32: cannot read this YAML: a '{' has no '}'; put quotes around "
       "a value with ${...}\n"},
      {"bracket.yaml", "broken/bracket.yaml:2:36: cannot read this YAML: illegal flow end\n"},
      {"quote.yaml",
       "broken/quote.yaml:1:1: cannot read this YAML: a quote after this is never closed\n"},
      {"merge_key.yaml",
       "broken/merge_key.yaml:3:3: cannot read this YAML: merge keys '<<' are not supported; use "
       "'extends'\n"},
      {"tag.yaml",
       "broken/tag.yaml:1:7: cannot read this YAML: the tag 'tag:yaml.org,2002:str' is not "
       "supported; remove it\n"},
      {"two_documents.yaml",
       "broken/two_documents.yaml:2:1: cannot read this YAML: a second document starts here; one "
       "per file\n"},
      {"alias.yaml",
       "broken/alias.yaml:3:8: cannot read this YAML: aliases are not supported; write the value "
       "again, or use 'extends'\n"},
  }));
  CHECK(complaints(file) == expected);
}

TEST_CASE("Problems of all files and of the command line are reported together") {
  CHECK(complaints("syntax_above.yaml", {"threads=all", "pipeline.mode=lossles"}) ==
        "broken/syntax_above.yaml:2:7: seed: expects an integer, not 'x'\n"
        "broken/syntax_below.yaml:2:5: cannot read this YAML: a '{' has no '}'\n"
        "--set pipeline.mode=lossles: pipeline.mode: expects one of lossless, realtime, not "
        "'lossles'; did you mean 'lossless'?\n"
        "--set threads=all: threads: expects an integer, not 'all'\n");
}

}  // namespace tolman
