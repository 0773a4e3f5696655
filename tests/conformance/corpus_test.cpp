// SPDX-License-Identifier: BSD-3-Clause
// Each broken fixture plugin, the check that fails, and its message.
#include "conformance/validation.hpp"

using namespace tolman::test;

namespace {

struct Broken {
  const char* library;
  const char* id;
  const char* check;
  const char* message;  ///< part of the finding
  const char* severity = "error";
};

/// Runs that one check; it must fail with the message and a remedy.
void expectFound(const Broken& broken) {
  INFO(broken.library << ", " << broken.id << ", " << broken.check);
  const Validation found =
      validate(fixtureLibrary(broken.library),
               {"--id", broken.id, "--check", broken.check, "--timeout", "20"});
  INFO(found.reports.dump(1));
  CHECK(found.exit_code == 4);
  const auto check = found.check(broken.check);
  REQUIRE(check.is_object());
  CHECK(check["result"] == broken.severity);
  CHECK(contains(found.messages(), broken.message));
  REQUIRE_FALSE(check["findings"].empty());
  CHECK_FALSE(check["findings"].front()["remedy"].get<std::string>().empty());
}

void expectAllFound(const std::vector<Broken>& corpus) {
  for (const Broken& broken : corpus) expectFound(broken);
}

}  // namespace

TEST_CASE("incompatible libraries are refused with the id of the refusal") {
  expectAllFound({
      {"wrong_major", "wrong_major", "manifest", "[plugin/sdk-major]"},
      {"newer_minor", "newer_minor", "manifest", "[plugin/sdk-minor]"},
      {"avx2", "steady", "manifest", "[plugin/fingerprint]"},
      {"entry_missing", "entry_missing", "load", "[plugin/entry-missing]"},
      {"missing_symbol", "missing_symbol", "load", "[plugin/load-failed]"},
      {"returns_null", "returns_null", "life-unused", "created no object"},
  });
  for (const auto& [library, says] : {std::pair("no_manifest", "[plugin/no-manifest]"),
                                      std::pair("bad_json", "[plugin/bad-manifest]")}) {
    const Validation found = validate(fixtureLibrary(library), {});
    CHECK(found.exit_code == 4);
    CHECK(contains(found.messages(), says));
  }
}

TEST_CASE("incomplete declarations are found") {
  expectAllFound({
      {"undeclared", "no_doc", "schema", "parameter 'gain' has no doc"},
      {"undeclared", "no_range", "schema", "parameter 'gain' has no range", "warning"},
      {"undeclared", "reserved_name", "load", "a name that is reserved for the host"},
      {"undeclared", "default_outside", "load", "has a default outside of its range"},
      {"undeclared", "declared_twice", "load", "is declared twice"},
      {"undeclared", "no_summary", "manifest", "there is no summary"},
      {"undeclared", "no_version", "manifest", "'newest' is not a version"},
  });
}

TEST_CASE("a plugin that throws or fails is reported with call and frame") {
  expectAllFound({
      {"misbehaving", "throws_in_constructor", "life-unused", "construct: threw: constructor"},
      {"misbehaving", "throws_in_configure", "life-unused", "configure: threw: configure gives"},
      {"misbehaving", "fails_in_configure", "answers", "exclude each other"},
      {"misbehaving", "throws_in_track", "answers", "track, frame 3: threw: track gives up"},
      {"misbehaving", "throws_an_integer", "answers",
       "frame 3: threw something that is not a std::"},
      {"misbehaving", "throws_in_destructor", "life-unused", "destroy: threw: destructor gives up"},
      {"misbehaving", "throws_in_finish", "life-unused", "finish: threw: finish gives up"},
  });
}

TEST_CASE("a crash is reported with signal and call") {
  expectAllFound({
      {"process_faults", "segfault", "answers",
       "died of SIGSEGV (Segmentation fault) in 'frame 3'"},
      {"process_faults", "abort_", "answers", "died of SIGABRT (Aborted) in 'frame 3'"},
      {"process_faults", "terminate", "answers", "died of SIGABRT"},
      {"process_faults", "divide_by_zero", "answers", "died of SIGFPE"},
      {"process_faults", "recurse_forever", "answers", "died of SIGSEGV"},
      {"process_faults", "exit_", "answers", "exited with code 0 in 'frame 3'"},
      {"process_faults", "eat_memory", "answers", "threw: std::bad_alloc"},
  });
}

TEST_CASE("a plugin that hangs is killed after the timeout") {
  const Validation found =
      validate(fixtureLibrary("process_faults"),
               {"--id", "loop_forever", "--check", "answers", "--timeout", "1"});
  CHECK(found.exit_code == 4);
  CHECK(contains(found.messages(), "did not return within 1 s, in 'frame 3'"));
}

TEST_CASE("invalid answers are found") {
  expectAllFound({
      {"misbehaving", "returns_nan", "answers", "frame 3: the answer has NaN"},
      {"misbehaving", "goes_back_in_time", "answers", "copy `stamp_ns` from the input"},
      {"misbehaving", "answers_another_frame", "answers", "answered for frame 2"},
      {"misbehaving", "revises_the_future", "answers", "revised frame 7"},
      {"answer_faults", "scaled_rotation", "answers",
       "frame 3: the rotation of 'T_previous_current'"},
      {"answer_faults", "skew_covariance", "answers", "frame 3: 'covariance' is not symmetric"},
      {"answer_faults", "negative_variance", "answers", "'covariance' has a negative variance"},
      {"answer_faults", "wrong_dt", "answers", "'dt' is 2 s, the stamps say 0.1 s"},
      {"answer_faults", "future_points", "answers", "points of frame 4"},
      {"answer_faults", "mirror", "answers", "the rotation of 'T_previous_current'"},
      {"answer_faults", "huge_speed", "answers", "'v' is larger than a record takes"},
      {"answer_faults", "negative_tracked", "answers", "'tracked' is -9"},
      {"answer_faults", "finishes_the_future", "answers", "revised frame 999999"},
      {"role_faults", "array_renamed", "answers", "array 'b' was not there before"},
      {"answer_faults", "moves_at_once", "answers", "frame 0 has no motion"},
      {"role_faults", "skips_template_ids", "answers", "made template 2; ids are 0, 1, 2"},
      {"role_faults", "none_with_id", "answers", "None has template_id -1"},
      {"role_faults", "unknown_template", "answers", "which was never made"},
      {"role_faults", "stays_elsewhere", "answers", "stays at experience 0, but was at 1"},
      {"role_faults", "unknown_frame", "answers", "a frame that was never given must be"},
      {"role_faults", "counts_more", "answers", "the graph has 0 links, the last update 3"},
      {"role_faults", "more_loops", "answers", "the graph has 0 loop links, the last update 1"},
      {"role_faults", "placed_elsewhere", "answers", "graph: is 5 m and 0 rad from the pose by"},
      {"role_faults", "told_elsewhere", "answers", "rad from the pose by the update"},
      {"role_faults", "moved_at_the_end", "answers",
       "is 5 m and 0 rad from the pose by graph() of experience 2, which was made there"},
      {"role_faults", "watches_null_graph", "answers", "died of SIGSEGV"},
  });
}

TEST_CASE("violations of the order of calls are found") {
  expectAllFound({
      {"answer_faults", "destructor_needs_configure", "life-unused", "died of SIGSEGV"},
      {"answer_faults", "finish_needs_frames", "life-unused", "nothing to finish"},
      {"answer_faults", "works_once", "life-again", "after finish and reset: "},
  });
}

TEST_CASE("legal input without an answer is found") {
  expectAllFound({
      {"answer_faults", "fails_on_empty", "frames-empty", "some frames without images: odometry"},
      {"answer_faults", "crashes_on_empty", "frames-empty", "died of SIGSEGV"},
      {"answer_faults", "counts_on_frames", "frames-dropped", "threw: a frame is missing"},
  });
}

TEST_CASE("legal parameters that fail are found and printed") {
  expectAllFound({
      {"answer_faults", "fails_when_fast", "parameters-random", "of seed 1 (--set speed="},
  });
}

TEST_CASE("results that are not reproducible are found") {
  expectAllFound({
      {"answer_faults", "address", "deterministic",
       "a second instance differs at frame 1: 'T_previous"},
      {"answer_faults", "wall_clock", "deterministic", "a second instance differs at frame 1"},
      {"answer_faults", "reset_forgets", "reset", "after finish() and reset() differs at frame 1"},
      {"role_faults", "remembers_drive", "reset",
       "a run after reset() during another drive differs at frame 0: 'score'"},
      {"answer_faults", "shared_state", "deterministic",
       "an instance that alternates with another differs"},
      {"answer_faults", "thread_local_state", "threads",
       "a run with calls from several threads differs"},
      {"answer_faults", "thread_count", "threads",
       "a run with 4 threads instead of 1 differs at frame 1"},
      {"answer_faults", "ignores_stride", "padded-rows", "a run with padded image rows differs"},
  });
}

TEST_CASE("incomplete saved state is found") {
  expectAllFound({
      {"role_faults", "loads_nothing", "state",
       "after save and load: place (loads_nothing), observe, frame 8"},
      {"role_faults", "forgets_late", "state",
       "saved before frame 32, answers after load() differ at frame 32: 'score'"},
  });
}

TEST_CASE("a plugin that adds to a map that must stay as it is is found") {
  expectAllFound({{"role_faults", "learns", "localise",
                   "made a template, although the map must stay as it is"}});
}

TEST_CASE("side effects on the process are found") {
  expectAllFound({
      {"process_faults", "write_to_stdout", "globals", "wrote to stdout or stderr: 'frame 3 is"},
      {"process_faults", "write_to_stderr", "globals", "wrote to stdout or stderr: 'hm"},
      {"process_faults", "change_locale", "globals",
       "locale of C was changed; the host restored it"},
      {"process_faults", "install_handler", "globals", "handler of signal 15"},
      {"process_faults", "change_rounding", "globals", "rounding mode"},
      {"process_faults", "flush_denormals", "globals", "floating point control (denormals, traps)"},
      {"process_faults", "change_folder", "globals", "working directory"},
      {"process_faults", "set_variable", "globals", "OMP_NUM_THREADS"},
      {"process_faults", "leak_thread", "leaks",
       "left a thread running: 1 more with each instance"},
      {"process_faults", "run_on", "leaks", "a thread still runs after finish()"},
      {"process_faults", "leak_file", "leaks", "left a file open: /dev/null"},
  });
}

TEST_CASE("sources with a wrong end are found") {
  const auto caught = [](const char* id, const char* check, const char* says) {
    INFO(id);
    const Validation found = validate(fixtureLibrary("role_faults"),
                                      {"--id", id, "--check", check, "--set", "path=/nowhere"});
    INFO(found.reports.dump(1));
    CHECK(found.exit_code == 4);
    CHECK(contains(found.messages(), says));
  };
  caught("promises_more", "source-end", "info() announced 9 frames, but next() gave 5");
  caught("fails_after_end", "source-end", "after the end it returns");
}
