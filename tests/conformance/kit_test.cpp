// SPDX-License-Identifier: BSD-3-Clause
// `tolman plugins validate` from the command line.
#include "conformance/validation.hpp"

using namespace tolman::test;

TEST_CASE("a correct plugin of any role conforms at every level") {
  for (const auto& [library, id] :
       {std::pair("steady", "steady"), std::pair("role_faults", "keeper"),
        std::pair("role_faults", "single_experience")}) {
    const Validation found = validate(fixtureLibrary(library), {"--id", id});
    INFO(found.reports.dump(1));
    CHECK(found.exit_code == 0);
    CHECK(found.reports[0]["conforms"] == true);
    CHECK(found.reports[0]["errors"] == 0);
    CHECK(found.reports[0]["warnings"] == 0);
  }
}

TEST_CASE("after a crash the kit runs the remaining checks and exits with code 4") {
  const Validation found =
      validate(fixtureLibrary("process_faults"), {"--id", "segfault", "--level", "1"});
  CHECK(found.exit_code == 4);
  CHECK(found.check("answers")["result"] == "error");
  CHECK(found.check("life-unused")["result"] == "ok");
  CHECK(found.check("rig-kinds").is_object());  // the last check
}

TEST_CASE("the kit stops after three timeouts") {
  const Validation found =
      validate(fixtureLibrary("process_faults"), {"--id", "loop_forever", "--timeout", "1"});
  CHECK(found.exit_code == 4);
  CHECK(found.reports[0]["errors"] == 3);
}

TEST_CASE("a level includes the checks of lower levels") {
  const auto levels = [](const char* level) {
    int highest = 0;
    const Validation found = validate(fixtureLibrary("steady"), {"--level", level});
    for (const auto& check : found.reports[0]["checks"]) {
      highest = std::max(highest, check["level"].get<int>());
    }
    return highest;
  };
  CHECK(levels("1") == 1);
  CHECK(levels("2") == 2);
}

TEST_CASE("a warning counts at level 3 only") {
  const std::string library = fixtureLibrary("undeclared");
  CHECK(validate(library, {"--id", "no_range", "--check", "schema"}).exit_code == 4);
  CHECK(validate(library, {"--id", "no_range", "--check", "schema", "--level", "2"}).exit_code ==
        0);
}

TEST_CASE("a check without its required data is skipped and names the missing --set") {
  const std::string library = fixtureLibrary("role_faults");
  const Validation found =
      validate(library, {"--id", "ignores_path", "--check", "answers", "--check", "schema"});
  CHECK(found.exit_code == 0);
  CHECK(found.check("answers")["result"] == "skip");
  CHECK(contains(found.messages(), "give --set path=..."));
  const Validation given =
      validate(library, {"--id", "ignores_path", "--check", "answers", "--set", "path=/tmp"});
  CHECK(given.check("answers")["result"] == "ok");
}

TEST_CASE("a live source is not asked for the same images twice") {
  const std::string library = fixtureLibrary("live_pictures");
  const Validation live = validate(library, {"--id", "live_pictures"});
  INFO(live.reports.dump(1));
  CHECK(live.exit_code == 0);
  for (const char* check : {"deterministic", "reset", "life-again", "threads"}) {
    CHECK(live.check(check)["result"] == "skip");
  }
  CHECK(contains(live.messages(), "live images do not come twice"));
  const Validation silent = validate(library, {"--id", "once_only"});
  CHECK(silent.exit_code == 4);
  CHECK(silent.check("life-again")["result"] == "error");
  CHECK(silent.check("deterministic")["result"] == "error");
}

TEST_CASE("the seed determines the draws") {
  const auto draw = [](const char* seed) {
    return validate(fixtureLibrary("answer_faults"),
                    {"--id", "fails_when_fast", "--check", "parameters-random", "--seed", seed})
        .messages();
  };
  const std::string first = draw("5");
  CHECK(contains(first, "of seed 5 (--set speed="));
  CHECK(draw("5") == first);
  CHECK(draw("6") != first);
}

TEST_CASE("--set is checked like a configuration") {
  const Validation found =
      validate(fixtureLibrary("steady"), {"--set", "speed=500", "--set", "sped=1"});
  CHECK(found.exit_code == 3);
  CHECK(contains(found.messages(), "500 is out of range: -50 ... 50 m/s"));
  CHECK(contains(found.messages(), "did you mean 'speed'?"));
}

TEST_CASE("all plugins of a library are validated, or that of --id") {
  const std::string library = fixtureLibrary("undeclared");
  CHECK(validate(library, {"--check", "manifest"}).reports.size() == 7);
  const Validation unknown = validate(library, {"--id", "nobody"});
  CHECK(unknown.exit_code == 4);
  CHECK(contains(unknown.messages(), "has no plugin 'nobody'"));
}

TEST_CASE("as text: one line per check, remedies, and a summary") {
  const Finished finished =
      tolman::test::tolman({"plugins", "validate", fixtureLibrary("undeclared"), "--id", "no_doc",
                            "--check", "schema", "--check", "load"});
  CHECK(finished.exit_code == 4);
  CHECK(contains(finished.out, "ok       load                opens with all symbols resolved"));
  CHECK(contains(finished.out, "error    schema "));
  CHECK(contains(finished.out, "         remedy: describe it in one sentence: .doc()"));
  CHECK(contains(finished.out, "no_doc: does not conform at level 3: 1 ok, 0 warnings, 1 errors"));
  CHECK(contains(finished.out, "seed 1"));
}

TEST_CASE("illegal options are usage errors") {
  const std::string library = fixtureLibrary("steady");
  CHECK(tolman::test::tolman({"plugins", "validate", library, "--level", "4"}).exit_code == 2);
  CHECK(tolman::test::tolman({"plugins", "validate", library, "--check", "nice"}).exit_code == 2);
  CHECK(validate("/nowhere/x.so", {}).exit_code == 4);
}
