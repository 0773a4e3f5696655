// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/job_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "record/atomic_file.hpp"

namespace tolman::experiment {
namespace {

namespace fs = std::filesystem;

/// The text as one word of a shell.
std::string shellWord(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string shellWords(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shellWord(word);
  return line;
}

class JobFiles {
 public:
  JobFiles(fs::path sweep, std::string name, const std::vector<PlannedRun>& runs,
           const std::vector<std::string>& command)
      : sweep_(std::move(sweep)), name_(std::move(name)), command_(shellWords(command)) {
    for (const PlannedRun& run : runs) {
      const auto is_to_do = [&](const std::string& folder) {
        return !folder.empty() &&
               std::ranges::find(runs, folder, &PlannedRun::folder) != runs.end();
      };
      const bool waits = is_to_do(run.front_end_folder) || is_to_do(run.answers_folder);
      (waits ? second_ : first_).push_back(run);
    }
  }

  void slurm() {
    for (int list : {1, 2}) write(fmt::format("runs-{}.txt", list), folders(listed(list)));
    write("array.sh",
          fmt::format("#!/bin/sh\n# One task of a Slurm array: the run in line SLURM_ARRAY_TASK_ID "
                      "of the list.\n"
                      "folder=$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" \"$1\")\n"
                      "exec {} \"$folder\"\n",
                      command_));
    std::string submit =
        "#!/bin/sh\n# Submits the runs and ends; options are passed on to sbatch, such as\n"
        "#   sh submit.sh --time=10 --cpus-per-task=2\n"
        "# `tolman sweep status` reads what became of them.\nset -e\n"
        "here=$(cd \"$(dirname \"$0\")\" && pwd)\nafter=\n";
    for (int list : {1, 2}) {
      if (listed(list).empty()) continue;
      submit += fmt::format(
          "id=$(sbatch --parsable --job-name={} --array=1-{} --output=/dev/null $after \"$@\" "
          "\"$here/array.sh\" \"$here/runs-{}.txt\")\n"
          "echo \"$id\"\nafter=--dependency=afterany:${{id%%;*}}\n",
          shellWord(name_), listed(list).size(), list);
    }
    write("submit.sh", submit);
  }

  void parallel() {
    for (int list : {1, 2}) {
      std::string text;
      for (const PlannedRun& run : listed(list)) {
        text += command_ + " " + shellWord((sweep_ / run.folder).string()) + "\n";
      }
      write(fmt::format("commands-{}.txt", list), text);
    }
  }

  void snakemake() {
    std::string text =
        "# Runs of the sweep: snakemake --cores 4 --keep-going\n"
        "import os\nHERE = workflow.basedir\nTAKES = {\n";
    for (const auto* list : {&first_, &second_}) {
      for (const PlannedRun& run : *list) {
        const std::string answers = list == &first_                ? ""
                                    : run.front_end_folder.empty() ? run.answers_folder
                                                                   : run.front_end_folder;
        text += fmt::format("    \"{}\": \"{}\",\n", run.folder, answers);
      }
    }
    // A failed run counts as ended: runs that wait for its answers then run their own front end.
    text += fmt::format(
        "}}\n\nrule all:\n    input: [f\"{{HERE}}/{{run}}/ended\" for run in TAKES]\n"
        "    params: here=HERE\n"
        "    shell: r\"\"\"test -z \"$(find {{params.here:q}} -maxdepth 2 -name outcome.json "
        "-exec grep -l '\"state\": \"failed\"' {{{{}}}} +)\" "
        "|| {{{{ echo 'some runs have failed: tolman sweep status' >&2; exit 1; }}}}\"\"\"\n\n"
        "rule point:\n"
        "    input: lambda w: [f\"{{HERE}}/{{TAKES[w.run]}}/ended\"] if TAKES[w.run] else []\n"
        "    output: touch(HERE + \"/{{run}}/ended\")\n"
        "    params: folder=lambda w: f\"{{HERE}}/{{w.run}}\"\n"
        "    shell: r\"\"\"{} {{params.folder:q}} || test -e "
        "{{params.folder:q}}/outcome.json\"\"\"\n",
        command_);
    for (const auto* list : {&first_, &second_}) {
      for (const PlannedRun& run : *list) {
        std::error_code ignored;
        fs::remove(sweep_ / run.folder / "ended", ignored);  // of an earlier attempt
      }
    }
    write("Snakefile", text);
  }

  Result<std::vector<fs::path>> result() const {
    if (!status_.isOk()) return status_;
    return written_;
  }

 private:
  const std::vector<PlannedRun>& listed(int list) const { return list == 1 ? first_ : second_; }

  std::string folders(const std::vector<PlannedRun>& runs) const {
    std::string text;
    for (const PlannedRun& run : runs) text += (sweep_ / run.folder).string() + "\n";
    return text;
  }

  void write(const std::string& file, const std::string& text) {
    if (!status_.isOk()) return;
    status_ = record::writeAtomically(sweep_ / file, text);
    written_.push_back(sweep_ / file);
  }

  fs::path sweep_;
  std::string name_;
  std::string command_;
  std::vector<PlannedRun> first_;
  std::vector<PlannedRun> second_;
  std::vector<fs::path> written_;
  Status status_;
};

}  // namespace

Result<std::vector<fs::path>> writeJobFiles(const fs::path& sweep, const std::string& name,
                                            const std::vector<PlannedRun>& runs,
                                            const std::vector<std::string>& command,
                                            const std::string& kind) {
  JobFiles files(sweep, name, runs, command);
  if (kind == "slurm") files.slurm();
  if (kind == "parallel") files.parallel();
  if (kind == "snakemake") files.snakemake();
  return files.result();
}

std::vector<std::string> jobFileNames(const std::string& kind) {
  if (kind == "slurm") return {"runs-1.txt", "runs-2.txt", "array.sh", "submit.sh"};
  if (kind == "parallel") return {"commands-1.txt", "commands-2.txt"};
  if (kind == "snakemake") return {"Snakefile"};
  return {};
}

}  // namespace tolman::experiment
