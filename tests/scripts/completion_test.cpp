// SPDX-License-Identifier: BSD-3-Clause
// Completion in the shells. Reported as skipped for a shell that is not installed.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

#include "end_to_end/process.hpp"
#include "end_to_end/terminal.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

using Words = std::set<std::string>;

std::string shared(const std::string& file) { return inBuild("help/" + file); }
std::string bashScript() { return shared("bash-completion/completions/tolman"); }
std::string fishScript() { return shared("fish/vendor_completions.d/tolman.fish"); }

bool hasShell(const std::string& shell) {
  if (run({shell, "-c", "true"}).exit_code == 0) return true;
  std::cout << "SKIPPED: " << shell << " is not installed\n";
  return false;
}

/// A folder with what completion may find, in which the shells run.
struct Desk {
  TemporaryFolder folder;
  Desk() {
    fs::create_directories(folder.path() / "drives");
    for (const char* name : {"mine.yaml", "mine.so", "truth.txt"}) {
      std::ofstream(folder.path() / name) << "\n";
    }
  }
  /// A shell command that runs there, with `tolman` on the path.
  std::vector<std::string> command(const std::vector<std::string>& words) const {
    std::vector<std::string> all = {
        "env", "-C", folder.path().string(),
        "PATH=" + tolmanProgram().parent_path().string() + ":/usr/local/bin:/usr/bin:/bin",
        "HOME=" + folder.path().string()};
    all.insert(all.end(), words.begin(), words.end());
    return all;
  }
};

/// What bash offers for the last of these words, split as readline does (also at '=').
Words bashOffers(const Desk& desk, std::vector<std::string> words) {
  std::string script = "source '" + bashScript() + "'\nCOMP_WORDS=(tolman";
  for (const std::string& word : words) script += " '" + word + "'";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size()) +
            "\n_tolman\nprintf '%s\\n' \"${COMPREPLY[@]}\"";
  const Finished finished = run(desk.command({"bash", "-uc", script}));
  CAPTURE(words, finished.out, finished.err);
  CHECK(finished.err.empty());
  Words offers;
  std::istringstream lines(finished.out);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) offers.insert(line);
  }
  return offers;
}

/// What fish offers at the end of this line, without the texts beside it.
Words fishOffers(const Desk& desk, const std::string& line) {
  const Finished finished = run(desk.command(
      {"fish", "--no-config", "-c", "source '" + fishScript() + "'; complete -C '" + line + "'"}));
  CAPTURE(line, finished.err);
  CHECK(finished.err.empty());
  Words offers;
  std::istringstream lines(finished.out);
  for (std::string offer; std::getline(lines, offer);) {
    offers.insert(offer.substr(0, offer.find('\t')));
  }
  return offers;
}

bool hasAll(const Words& offers, const Words& wanted) {
  return std::includes(offers.begin(), offers.end(), wanted.begin(), wanted.end());
}

/// A shell on a terminal that has loaded the completion.
void ready(Terminal& terminal, const std::string& setup) {
  terminal.type(setup + "; echo rea''dy\n");
  REQUIRE(terminal.waitFor("ready"));
}

}  // namespace

TEST_CASE("bash completes commands, options and their values") {
  const Desk desk;
  CHECK(hasAll(bashOffers(desk, {""}), {"run", "check", "plugins", "help", "version"}));
  CHECK(bashOffers(desk, {"r"}) == Words{"report", "rerun", "run"});
  CHECK(bashOffers(desk, {"plugins", "d"}) == Words{"describe", "doctor"});
  CHECK(bashOffers(desk, {"help", "plugins", "d"}) == Words{"describe", "doctor"});
  CHECK(bashOffers(desk, {"run", "--re"}) == Words{"--resume"});
  CHECK(hasAll(bashOffers(desk, {"run", "-"}), {"--set", "--view", "--help", "--plugin-path"}));
  CHECK(bashOffers(desk, {"eval", "--align", "se"}) == Words{"se2", "se3"});
  CHECK(bashOffers(desk, {"eval", "--align", "=", "si"}) == Words{"sim3"});
  CHECK(bashOffers(desk, {"eval", "--align", "="}) == Words{"none", "se2", "se3", "sim3"});
  CHECK(bashOffers(desk, {"plugins", "new", "o"}) == Words{"odometry", "observer"});
  CHECK(bashOffers(desk, {"plugins", "validate", "--level", ""}) == Words{"1", "2", "3"});
  CHECK(bashOffers(desk, {"run-stage", ""}).empty());  // hidden
}

TEST_CASE("bash completes configurations, files, folders and plugins") {
  const Desk desk;
  const Words configurations = bashOffers(desk, {"run", ""});
  CHECK(hasAll(configurations, {"demo", "town/district", "mine.yaml", "drives"}));
  CHECK(configurations.count("truth.txt") == 0);
  CHECK(bashOffers(desk, {"check", "--set", "a", "=", "b", "mi"}) == Words{"mine.yaml"});
  CHECK(bashOffers(desk, {"run", "--set", "source.path", "=", "dr"}) == Words{"drives"});
  CHECK(bashOffers(desk, {"run", "--out", ""}) == Words{"drives"});
  CHECK(bashOffers(desk, {"view", ""}) == Words{"drives"});
  CHECK(bashOffers(desk, {"eval", "truth.txt", "t"}) == Words{"truth.txt"});
  CHECK(bashOffers(desk, {"eval", "a", "b", ""}).empty());
  CHECK(bashOffers(desk, {"report", "a", "b", ""}) == Words{"drives"});  // as many as wanted
  CHECK(bashOffers(desk, {"plugins", "doctor", ""}) ==
        Words{"drives", "mine.so", "mine.yaml", "truth.txt"});
  CHECK(hasAll(bashOffers(desk, {"plugins", "describe", ""}), {"kitti", "view_templates"}));
  CHECK(bashOffers(desk, {"dataset", "check", "--source", "to"}) == Words{"town"});
  CHECK(bashOffers(desk, {"run", "--viewer", "ki"}).empty());  // it is no observer
  CHECK(bashOffers(desk, {"run", "--seed", ""}).empty());
}

TEST_CASE("the key of completion works in bash itself") {
  const Desk desk;
  Terminal terminal(desk.command({"bash", "--norc", "-i"}));
  ready(terminal, "PS1='> '; source '" + bashScript() + "'");
  terminal.type("tolman eval --align=si\t");
  CHECK(terminal.waitFor("--align=sim3 "));
  terminal.type(
      "\x15"
      "tolman run mi\t");  // ^U: a new line
  CHECK(terminal.waitFor("tolman run mine.yaml "));
  terminal.type(
      "\x15"
      "exit\n");
  CHECK(terminal.finish() == 0);
}

TEST_CASE("zsh completes the same, with texts") {
  if (!hasShell("zsh")) return;
  const Desk desk;
  Terminal terminal(desk.command({"zsh", "-f", "-i"}));
  ready(terminal, "PS1='> '; fpath=('" + shared("zsh/vendor-completions") +
                      "' $fpath); autoload -Uz compinit; compinit -u -D");
  terminal.type("tolman plugins d\t");
  CHECK(terminal.waitFor("describe"));
  CHECK(terminal.waitFor("-- Parameters of plugins"));
  terminal.type(
      "\x15"
      "tolman eval --align=si\t");
  CHECK(terminal.waitFor("m3"));
  terminal.type(
      "\x15"
      "tolman run --res\t");
  CHECK(terminal.waitFor("ume"));
  terminal.type(
      "\x15"
      "tolman run m\t");
  CHECK(terminal.waitFor("mine.yaml"));
  terminal.type(
      "\x15"
      "tolman plugins describe view_t\t");
  CHECK(terminal.waitFor("emplates"));
  terminal.type(
      "\x15"
      "tolman dataset check --source to\t");
  CHECK(terminal.waitFor("wn"));
  terminal.type(
      "\x15"
      "exit\n");
  CHECK(terminal.finish() == 0);
  CHECK_FALSE(contains(terminal.output(), "_tolman"));  // an error would name its function
}

TEST_CASE("fish completes the same") {
  if (!hasShell("fish")) return;
  const Desk desk;
  CHECK(fishOffers(desk, "tolman r") == Words{"report", "rerun", "run"});
  CHECK(fishOffers(desk, "tolman help plugins d") == Words{"describe", "doctor"});
  CHECK(fishOffers(desk, "tolman run --re") == Words{"--resume"});
  CHECK(fishOffers(desk, "tolman eval --align se") == Words{"se2", "se3"});
  CHECK(fishOffers(desk, "tolman eval --align=si") == Words{"--align=sim3"});
  CHECK(fishOffers(desk, "tolman plugins new o") == Words{"odometry", "observer"});
  CHECK(hasAll(fishOffers(desk, "tolman run "), {"demo", "town/district", "mine.yaml"}));
  CHECK(fishOffers(desk, "tolman run --out dr") == Words{"drives/"});
  CHECK(fishOffers(desk, "tolman report a b ") == Words{"drives/"});
  CHECK(fishOffers(desk, "tolman dataset check --source to") == Words{"town"});
  CHECK(hasAll(fishOffers(desk, "tolman plugins describe "), {"kitti", "view_templates"}));
  CHECK(fishOffers(desk, "tolman run --seed ").empty());
}
