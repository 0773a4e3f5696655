// SPDX-License-Identifier: BSD-3-Clause
// The corpus: each broken plugin, the check that catches it, and what it says.
#include "conformance/validation.hpp"

using namespace tolman::test;

namespace {

struct Broken {
  const char* library;
  const char* id;
  const char* check;
  const char* says;  ///< part of the finding
  const char* severity = "error";
};

/// Makes that one check; the plugin fails it with those words and a remedy.
void expectCaught(const Broken& broken) {
  INFO(broken.library << ", " << broken.id << ", " << broken.check);
  const Validation found =
      validate(fixtureLibrary(broken.library),
               {"--id", broken.id, "--check", broken.check, "--timeout", "20"});
  INFO(found.reports.dump(1));
  CHECK(found.exit_code == 4);
  const auto check = found.check(broken.check);
  REQUIRE(check.is_object());
  CHECK(check["result"] == broken.severity);
  CHECK(contains(found.messages(), broken.says));
  REQUIRE_FALSE(check["findings"].empty());
  CHECK_FALSE(check["findings"].front()["remedy"].get<std::string>().empty());
}

void expectAllCaught(const std::vector<Broken>& corpus) {
  for (const Broken& broken : corpus) expectCaught(broken);
}

}  // namespace

TEST_CASE("libraries that are no plugins of this host are refused with their id") {
  expectAllCaught({
      {"wrong_major", "wrong_major", "manifest", "[plugin/sdk-major]"},
      {"newer_minor", "newer_minor", "manifest", "[plugin/sdk-minor]"},
      {"avx2", "steady", "manifest", "[plugin/fingerprint]"},
      {"entry_missing", "entry_missing", "load", "[plugin/entry-missing]"},
      {"missing_symbol", "missing_symbol", "load", "[plugin/load-failed]"},
      {"returns_null", "returns_null", "life-unused", "created nothing"},
  });
  for (const auto& [library, says] : {std::pair("no_manifest", "[plugin/no-manifest]"),
                                      std::pair("bad_json", "[plugin/bad-manifest]")}) {
    const Validation found = validate(fixtureLibrary(library), {});
    CHECK(found.exit_code == 4);
    CHECK(contains(found.messages(), says));
  }
}

TEST_CASE("careless declarations are found") {
  expectAllCaught({
      {"undeclared", "no_doc", "schema", "parameter 'gain' has no doc"},
      {"undeclared", "no_range", "schema", "parameter 'gain' has no range", "warning"},
      {"undeclared", "reserved_name", "schema", "a name that belongs to the host"},
      {"undeclared", "default_outside", "schema", "has a default outside of its range"},
      {"undeclared", "declared_twice", "schema", "is declared twice"},
      {"undeclared", "no_summary", "manifest", "there is no summary"},
      {"undeclared", "no_version", "manifest", "'newest' is no version"},
  });
}

TEST_CASE("a plugin that throws or breaks off is reported by call and frame") {
  expectAllCaught({
      {"misbehaving", "throws_in_constructor", "life-unused", "construct: threw: constructor"},
      {"misbehaving", "throws_in_configure", "life-unused", "configure: threw: configure gives"},
      {"misbehaving", "fails_in_configure", "answers", "exclude each other"},
      {"misbehaving", "throws_in_track", "answers", "track, frame 3: threw: track gives up"},
      {"misbehaving", "throws_an_integer", "answers", "frame 3: threw something that is no std::"},
      {"misbehaving", "throws_in_destructor", "life-unused", "destroy: threw: destructor gives up"},
      {"misbehaving", "throws_in_finish", "life-no-frames", "finish: threw: finish gives up"},
  });
}

TEST_CASE("a plugin that dies is reported by signal and step") {
  expectAllCaught({
      {"guests", "segfault", "answers", "died of SIGSEGV (Segmentation fault) in 'frame 3'"},
      {"guests", "abort_", "answers", "died of SIGABRT (Aborted) in 'frame 3'"},
      {"guests", "terminate", "answers", "died of SIGABRT"},
      {"guests", "divide_by_zero", "answers", "died of SIGFPE"},
      {"guests", "recurse_forever", "answers", "died of SIGSEGV"},
      {"guests", "exit_", "answers", "ended the process itself (exit code 0) in 'frame 3'"},
      {"guests", "eat_memory", "answers", "threw: std::bad_alloc"},
  });
}

TEST_CASE("a plugin that hangs is ended at its deadline") {
  const Validation found = validate(
      fixtureLibrary("guests"), {"--id", "loop_forever", "--check", "answers", "--timeout", "1"});
  CHECK(found.exit_code == 4);
  CHECK(contains(found.messages(), "did not return within 1 s, in 'frame 3'"));
}

TEST_CASE("answers that cannot be true are found") {
  expectAllCaught({
      {"misbehaving", "returns_nan", "answers", "frame 3: the answer has NaN"},
      {"misbehaving", "goes_back_in_time", "answers", "copy `stamp_ns` from the input"},
      {"misbehaving", "answers_another_frame", "answers", "answered for frame 2"},
      {"misbehaving", "revises_the_future", "answers", "revised frame 7"},
      {"untrue", "scaled_rotation", "answers", "frame 3: the rotation of 'T_previous_current'"},
      {"untrue", "skew_covariance", "answers", "frame 3: the covariance is not symmetric"},
      {"untrue", "negative_variance", "answers", "the covariance has a negative variance"},
      {"untrue", "wrong_dt", "answers", "dt is 1.000000 s, the stamps say 0.100000 s"},
      {"untrue", "future_points", "answers", "points of frame 4"},
      {"untrue", "moves_at_once", "answers", "frame 0 has no motion"},
      {"strangers", "skips_template_ids", "answers", "made template 2; ids are dense"},
      {"strangers", "none_with_id", "answers", "None has template_id -1"},
      {"strangers", "knows_the_unseen", "answers", "which was never made"},
      {"strangers", "wanders", "answers", "stays at experience 0, but was at 1"},
      {"strangers", "finds_the_unseen", "answers", "a frame that never came must be"},
      {"strangers", "counts_more", "answers", "counts other experiences or links than graph()"},
      {"strangers", "watches_null_graph", "answers", "died of SIGSEGV"},
  });
}

TEST_CASE("lives that are not lived as written are found") {
  expectAllCaught({
      {"untrue", "destructor_needs_configure", "life-unused", "died of SIGSEGV"},
      {"untrue", "finish_needs_frames", "life-no-frames", "nothing to finish"},
      {"untrue", "works_once", "life-again", "after finish and reset: "},
  });
}

TEST_CASE("input that is legal and not answered is found, and what illegal input breaks") {
  expectAllCaught({
      {"untrue", "fails_on_empty", "frames-empty", "some frames without images: odometry"},
      {"untrue", "crashes_on_empty", "frames-empty", "died of SIGSEGV"},
      {"untrue", "needs_two_eyes", "one-eye", "died of SIGSEGV"},
      {"untrue", "counts_on_frames", "frames-dropped", "threw: a frame is missing"},
  });
}

TEST_CASE("parameters that are legal and do not work are found with their draw") {
  expectAllCaught({
      {"untrue", "hates_fast", "parameters-random", "of seed 1 (--set speed="},
      {"untrue", "takes_any_type", "parameters-types", "takes parameter 'speed' of a wrong type"},
  });
}

TEST_CASE("results that do not repeat are found") {
  expectAllCaught({
      {"untrue", "address", "deterministic", "a second instance differs at frame 1: 'T_previous"},
      {"untrue", "wall_clock", "deterministic", "a second instance differs at frame 1"},
      {"untrue", "reset_forgets", "reset", "after finish() and reset() differs at frame 1"},
      {"untrue", "shared_state", "interleaved", "an instance beside another differs"},
      {"untrue", "thread_local_state", "migration", "a run that changes its thread differs"},
      {"untrue", "thread_count", "threads", "a run with 4 threads instead of 1 differs at frame 1"},
      {"untrue", "ignores_stride", "padded-rows", "a run with padded image rows differs"},
  });
}

TEST_CASE("saved state that is not the whole state, or is believed when damaged, is found") {
  expectAllCaught({
      {"strangers", "loads_nothing", "state",
       "after save and load: place (loads_nothing), observe, frame 20"},
      {"strangers", "believes_damage", "state-damaged", "takes a damaged state: nothing at all"},
      {"strangers", "crashes_on_damage", "state-damaged", "died of SIGABRT (Aborted) in 'load' of"},
      {"strangers", "keeps_half_loaded", "state-damaged",
       "recognised template 1, which was never made"},
  });
}

TEST_CASE("guests who disturb the process are found") {
  expectAllCaught({
      {"guests", "write_to_stdout", "globals", "wrote to stdout: 'frame 3 is a fine frame"},
      {"guests", "write_to_stderr", "globals", "wrote to stderr: 'hm", "warning"},
      {"guests", "change_locale", "globals", "locale of C: 'C' became "},
      {"guests", "install_handler", "globals", "handler of signal 15"},
      {"guests", "change_rounding", "globals", "rounding mode"},
      {"guests", "flush_denormals", "globals", "floating point control (denormals, traps)"},
      {"guests", "change_folder", "globals", "working directory"},
      {"guests", "set_variable", "globals", "OMP_NUM_THREADS"},
      {"guests", "draw_globally", "globals", "rand() or srand()"},
      {"guests", "change_umask", "globals", "umask"},
      {"guests", "leak_thread", "leftovers", "left a thread behind: 1 more after each life"},
      {"guests", "run_on", "leftovers", "a thread runs on after finish()"},
      {"guests", "leak_file", "leftovers", "left a file open: /dev/null"},
      {"guests", "leak_memory", "memory", "KiB on the heap", "warning"},
  });
}

TEST_CASE("sources that end wrongly or see what is not there are found") {
  const auto caught = [](const char* id, const char* check, const char* says) {
    INFO(id);
    const Validation found = validate(fixtureLibrary("strangers"),
                                      {"--id", id, "--check", check, "--set", "path=/nowhere"});
    INFO(found.reports.dump(1));
    CHECK(found.exit_code == 4);
    CHECK(contains(found.messages(), says));
  };
  caught("never_there", "missing-data", "takes a path where there is nothing");
  caught("promises_more", "source-end", "info() promised 9 frames, 5 came");
  caught("begins_anew", "source-end", "after the end it gives");
}
