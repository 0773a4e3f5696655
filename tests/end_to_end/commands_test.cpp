// SPDX-License-Identifier: BSD-3-Clause
// The other commands than `run`, on the command line.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "end_to_end/fixture_plugins.hpp"
#include "end_to_end/record_rows.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;

TEST_CASE("help teaches, and wrong usage ends with exit code 2") {
  const Finished help = tolman::test::tolman({"--help"});
  CHECK(help.exit_code == 0);
  for (const char* part :
       {"run", "check", "plugins", "dataset", "eval", "export", "Examples:", "Exit codes:"}) {
    CHECK(contains(help.out, part));
  }
  const Finished plan = tolman::test::tolman({"plan", "--help"});
  CHECK(contains(plan.out, "tolman plan runs/demo"));
  CHECK_FALSE(contains(plan.out, "tolman run"));
  CHECK(contains(plan.out, "Exit codes:"));
  CHECK(tolman::test::tolman({}).exit_code == 2);
  CHECK(tolman::test::tolman({"fly"}).exit_code == 2);
  CHECK(tolman::test::tolman({"run"}).exit_code == 2);
  CHECK(contains(tolman::test::tolman({"--version"}).out, "tolman 0.1.0"));
  const std::string folder =
      kFixturePlugins + "steady";  // the option takes one folder, not the rest
  CHECK(tolman::test::tolman({"check", "--plugin-path", folder, "demo"}).exit_code == 0);
  const auto words = [](const std::vector<std::string>& arguments) {
    const Finished finished = tolman::test::tolman(arguments);
    CHECK(finished.exit_code == 2);
    return finished.err;
  };
  CHECK(contains(words({"check", "--plugin-path", "no/such/folder", "demo"}),
                 "does not exist: no/such/folder"));
  CHECK(words({"rnu", "demo"}) == "'rnu' is no command; did you mean 'run'?\n");
  CHECK(words({"plugins", "lst"}) == "'lst' is no command; did you mean 'list'?\n");
  CHECK(contains(words({"launch"}), "'launch' is no command; it is one of: run, check, plugins"));
}

TEST_CASE("plugins list shows all of ours, and broken ones with their refusal") {
  const Finished list = tolman::test::tolman({"plugins", "list"});
  CHECK(list.exit_code == 0);
  for (const char* id : {"kitti", "images", "feature_stereo", "view_sequences", "view_templates",
                         "bayesian_attractor", "experience_map", "progress"}) {
    CHECK(contains(list.out, id));
  }
  const Finished broken =
      tolman::test::tolman({"plugins", "list", "--plugin-path", kFixturePlugins + "bad_json",
                            "--plugin-path", kFixturePlugins + "wrong_major"});
  CHECK(broken.exit_code == 0);
  CHECK(contains(broken.out, "refused: plugin/bad-manifest"));
  CHECK(contains(broken.out, "refused: plugin/sdk-major"));
}

TEST_CASE("plugins describe shows parameters as text, Markdown and JSON") {
  const std::vector<std::string> base = {"plugins", "describe", "steady", "--plugin-path",
                                         kFixturePlugins + "steady"};
  const auto with = [&](const char* flag) {
    auto words = base;
    words.emplace_back(flag);
    return tolman::test::tolman(words).out;
  };
  CHECK(tolman::test::tolman(base).out ==
        "steady 0.1.0 (odometry): Straight ahead, for tests.\n"
        "  speed                      real          default 10.0 m/s  [-50 to 50]\n"
        "      Speed straight ahead.\n"
        "In a configuration:\n"
        "  odometry: {plugin: steady}\n"
        "  Parameters are keys beside `plugin`, and so are the keys of every stage: name,\n"
        "  on_failure (stop, skip, restart) and isolation (none, process).\n");
  CHECK(contains(with("--markdown"), "| `speed` | real | 10.0 | m/s | -50 to 50 |"));
  CHECK(nlohmann::json::parse(with("--json"))["parameters"][0]["max"] == 50);
  const Finished unknown = tolman::test::tolman({"plugins", "describe", "expirience_map"});
  CHECK(unknown.exit_code == 4);
  CHECK(contains(unknown.err, "did you mean 'experience_map'?"));
}

TEST_CASE("plugins doctor goes step by step") {
  const auto doctor = [](const std::string& name) {
    return tolman::test::tolman(
        {"plugins", "doctor", kFixturePlugins + name + "/tolman_odometry_" + name + ".so"});
  };
  const Finished sound = doctor("steady");
  CHECK(sound.exit_code == 0);
  CHECK(contains(sound.out, "ok       load "));
  CHECK(contains(sound.out, "ok       life-unused "));
  const Finished symbol = doctor("missing_symbol");
  CHECK(symbol.exit_code == 4);
  CHECK(contains(symbol.out, "ok       manifest "));
  CHECK(contains(symbol.out, "[plugin/load-failed]"));
}

TEST_CASE("check --explain tells every value's origin") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const Finished explained =
      tolman::test::tolman({"check", config.string(), "--explain", "--set", "seed=9",
                            "--plugin-path", kFixturePlugins + "steady"});
  INFO(explained.err);
  REQUIRE(explained.exit_code == 0);
  CHECK(contains(explained.out, "--set seed=9"));
  CHECK(contains(explained.out, "tiny.yaml:3:"));
  CHECK(contains(explained.out, "default"));
}

TEST_CASE("a shipped configuration is found by its name, from any folder") {
  const TemporaryFolder folder;
  const std::string program = tolmanProgram().string();
  for (const char* name : {"demo", "configs/demo.yaml"}) {
    const std::string line = "cd '" + folder.path().string() + "' && '" + program + "' check ";
    const Finished finished = run({"sh", "-c", line + name});
    INFO(finished.err);
    CHECK(finished.exit_code == 0);
  }
  CHECK(tolman::test::tolman({"check", "no_such_demo"}).exit_code == 3);
}

TEST_CASE("dataset check tells what is there and what is wrong, all at once") {
  TemporaryFolder folder;
  const auto sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 4);
  const Finished sound = tolman::test::tolman({"dataset", "check", sequence.string()});
  INFO(sound.out << sound.err);
  CHECK(sound.exit_code == 0);
  CHECK(contains(sound.out, "4 frames decode"));
  CHECK(contains(sound.out, "0.5"));  // the baseline in metres
  std::filesystem::remove(sequence / "image_1/000002.png");
  std::filesystem::resize_file(sequence / "times.txt", 4);
  const Finished broken = tolman::test::tolman({"dataset", "check", sequence.string()});
  CHECK(broken.exit_code == 5);
  CHECK(contains(broken.out + broken.err, "000002.png: has no partner"));
  CHECK(contains(broken.out + broken.err, "times.txt"));
  const Finished none = tolman::test::tolman({"dataset", "check", folder.path().string()});
  CHECK(none.exit_code == 5);
  CHECK(contains(none.err, "its layout is not known; name its source with --source"));
}

TEST_CASE("focal lengths that hardly fit each other are a warning of dataset check and run") {
  TemporaryFolder folder;
  const auto sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 4);
  const auto config = writeTinyConfig(folder.path(), sequence);
  const auto warnings = [&](const char* name) {
    const Finished check = tolman::test::tolman({"dataset", "check", sequence.string()});
    const Finished run = tolman::test::tolman(tinyRun(config, folder.path() / name));
    INFO(check.out << run.err);
    CHECK(check.exit_code == 0);
    CHECK(run.exit_code == 0);
    const std::string text = "the focal lengths are 100 px horizontally";
    return std::pair(contains(check.out, text), contains(run.err, text));
  };
  CHECK(warnings("square") == std::pair(false, false));
  std::ofstream(sequence / "calib.txt") << "P0: 100 0 80 0 0 200 30 0 0 0 1 0\n"
                                        << "P1: 100 0 80 -50 0 200 30 0 0 0 1 0\n";
  CHECK(warnings("oblong") == std::pair(true, true));
}

TEST_CASE("dataset check sees the part and size of the images that a run would use") {
  TemporaryFolder folder;
  const auto sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 4);
  const auto check = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"dataset", "check", sequence.string()};
    words.insert(words.end(), more.begin(), more.end());
    return tolman::test::tolman(words);
  };
  const Finished whole = check({"--set", "step=2"});
  CHECK(contains(whole.out, "2 frames decode"));
  const Finished cut = check(
      {"--set", "images.crop=[16, 4, 128, 48]", "--set", "images.scale=0.75", "--set", "step=2"});
  INFO(cut.out << cut.err);
  CHECK(cut.exit_code == 0);
  CHECK(contains(cut.out, "128x48"));
  CHECK(contains(cut.out, "2 frames decode"));
  const Finished outside = check({"--set", "images.crop=[100, 0, 100, 60]"});
  CHECK(outside.exit_code == 5);
  CHECK(
      contains(outside.err, "images.crop is not inside of the images; the images have 160x60 px"));
  const Finished unknown = check({"--set", "images.size=0.5"});
  CHECK(unknown.exit_code == 3);
  CHECK(contains(unknown.err, "images.size"));
}

TEST_CASE("eval gives the published figures of two systems on KITTI 00", "[data]") {
  const auto data = dataOrSkip("evo_reference");
  if (!data) return;
  const auto score = [&](const char* estimate) {
    const Finished finished =
        tolman::test::tolman({"eval", (*data / "kitti_00_ground_truth.txt").string(),
                              (*data / estimate).string(), "--align", "se3", "--json"});
    REQUIRE(finished.exit_code == 0);
    return nlohmann::json::parse(finished.out)["ate"]["rmse_m"].get<double>();
  };
  CHECK(score("kitti_00_orb_slam2_stereo.txt") == Approx(1.303).margin(0.0005));
  CHECK(score("kitti_00_sptam.txt") == Approx(3.738).margin(0.0005));
}

TEST_CASE("report of runs that were made and moved; of what is none, one clear error") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 6);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  for (const char* name : {"one", "two"}) {
    REQUIRE(tolman::test::tolman(tinyRun(config, folder.path() / name)).exit_code == 0);
  }
  const auto both = folder.path() / "both";
  const Finished finished =
      tolman::test::tolman({"report", (folder.path() / "one").string(),
                            (folder.path() / "two").string(), "--out", both.string()});
  INFO(finished.err);
  CHECK(finished.exit_code == 0);
  CHECK(contains(finished.out, (both / "report.html").string()));
  CHECK(contains(readText(both / "figures" / "two" / "map.svg"), "<svg"));
  CHECK(contains(readText(both / "figures" / "two" / "map.png"), "PNG"));
  const Finished none = tolman::test::tolman({"report", folder.path().string()});
  CHECK(none.exit_code == 5);
  CHECK(contains(none.err, "run.sqlite"));
  const auto half = folder.path() / "half";  // the second run is none: nothing is written
  CHECK(tolman::test::tolman({"report", (folder.path() / "one").string(),
                              (folder.path() / "nowhere").string(), "--out", half.string()})
            .exit_code == 5);
  CHECK_FALSE(std::filesystem::exists(half));
}

TEST_CASE("a run of one frame is one without motion, with its own sentence") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 1);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const auto out = folder.path() / "run";
  const Finished finished = tolman::test::tolman(tinyRun(config, out));
  INFO(finished.err);
  CHECK(finished.exit_code == 6);
  CHECK(contains(finished.out, "tracking  0 of 1 frames"));
  CHECK(contains(finished.out, "no motion in the whole run: it has one frame"));
  CHECK_FALSE(contains(finished.out, "ATE"));
  const auto json = readJson(out / "run.json");
  CHECK(json["status"] == "finished");
  CHECK(contains(json["message"], "it has one frame"));
}

TEST_CASE("plan leads from experience to experience, or to a place") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 60);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const auto out = folder.path() / "run";
  REQUIRE(tolman::test::tolman(tinyRun(config, out)).exit_code == 0);
  const Finished route =
      tolman::test::tolman({"plan", out.string(), "--from", "0", "--to", "0,1000", "--json"});
  INFO(route.err);
  REQUIRE(route.exit_code == 0);
  const auto plan = nlohmann::json::parse(route.out);
  CHECK(plan["rows"].front()["experience"] == 0);
  CHECK(plan["unit"] == "m");
  // Straight ahead at 10 m/s: way and time follow from the last place.
  CHECK(plan["metres"].get<double>() ==
        Approx(plan["rows"].back()["forward_m"].get<double>()).epsilon(1e-3));
  CHECK(plan["seconds"].get<double>() == Approx(plan["metres"].get<double>() / 10).epsilon(1e-3));
  const auto& end = plan["rows"].back();
  CHECK(plan["to"]["experience"] == end["experience"]);
  CHECK(plan["to"]["away_m"].get<double>() ==
        Approx(1000 - end["forward_m"].get<double>()).epsilon(1e-3));
  const Finished read =
      tolman::test::tolman({"plan", out.string(), "--from", "0", "--to", "0,1000"});
  CHECK(contains(read.out,
                 fmt::format("0,1000 is {:.1f} m from experience {}, the nearest\n",
                             plan["to"]["away_m"].get<double>(), end["experience"].get<int>())));
  CHECK_FALSE(contains(read.out, "\n0 is "));
  const Finished here =
      tolman::test::tolman({"plan", out.string(), "--from", "here", "--to", "0,0,0", "--json"});
  REQUIRE(here.exit_code == 0);
  CHECK(here.err.empty());
  const auto back = nlohmann::json::parse(here.out);
  CHECK(back["from"]["experience"] == end["experience"]);
  CHECK(back["to"]["experience"] == 0);
  CHECK(back["rows"].back()["up_m"].get<double>() == Approx(0).margin(1e-9));
  const Finished nowhere =
      tolman::test::tolman({"plan", out.string(), "--from", "0", "--to", "somewhere"});
  CHECK(nowhere.exit_code == 2);
  CHECK(contains(nowhere.err, "'somewhere' is not a place"));
  for (const char* far : {"1e300,1e300", "0,-1e10", "nan,0", "0,inf", "1,2,3,4", "1,2,"}) {
    const Finished finished =
        tolman::test::tolman({"plan", out.string(), "--from", far, "--to", "0"});
    CHECK(finished.exit_code == 2);
    CHECK(contains(finished.err, std::string("'") + far + "' is not a place"));
    CHECK(contains(finished.err, "at most 1e9"));
  }
}

TEST_CASE("an option with names lists them") {
  const Finished align = tolman::test::tolman({"eval", "a", "b", "--align", "foo"});
  CHECK(align.exit_code == 2);
  CHECK(contains(align.err, "--align: 'foo' is not one of none, origin, yaw, se2, se3, sim3\n"));
  const Finished motion = tolman::test::tolman({"init", "a", "--motion", "Boat"});
  CHECK(motion.exit_code == 2);
  CHECK(contains(motion.err, "--motion: 'Boat' is not one of car, hand, toy\n"));
}

TEST_CASE("export of what is no run is one clear error") {
  TemporaryFolder folder;
  const Finished finished = tolman::test::tolman({"export", folder.path().string()});
  CHECK(finished.exit_code == 5);
  CHECK(contains(finished.err, folder.path().string()));
}

TEST_CASE("docs/reference/plugins.md is up to date (scripts/generate-reference)") {
  const std::string page = readText(inSource("docs/reference/plugins.md"));
  for (const char* id : {"kitti", "images", "feature_stereo", "view_sequences", "view_templates",
                         "bayesian_attractor", "experience_map", "progress"}) {
    INFO(id);
    CHECK(contains(page, tolman::test::tolman({"plugins", "describe", id, "--markdown"}).out));
  }
}

TEST_CASE("explain lists loops and near misses, and a frame with both views") {
  TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 12);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const auto out = folder.path() / "run";
  REQUIRE(tolman::test::tolman(tinyRun(config, out)).exit_code == 0);
  const Finished list = tolman::test::tolman({"explain", out.string(), "--json"});
  INFO(list.err);
  REQUIRE(list.exit_code == 0);
  CHECK(nlohmann::json::parse(list.out)["loops"].is_array());
  const Finished frame = tolman::test::tolman({"explain", out.string(), "--frame", "11"});
  CHECK(frame.exit_code == 0);
  CHECK(frame.out.starts_with("Frame 11 closes no loop, and none was near. Place recognition "));
  const bool drawn = contains(frame.out, (out / "figures/loop-11.png").string());
  CHECK(drawn == std::filesystem::exists(out / "figures/loop-11.png"));
  CHECK(tolman::test::tolman({"explain", out.string(), "--frame", "12"}).exit_code == 2);
  CHECK(tolman::test::tolman({"explain", out.string(), "--loop", "99"}).exit_code == 2);
}
