// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "support/data.hpp"
#include "support/paths.hpp"

namespace tolman::test {

Process::Process(const std::vector<std::string>& command, const std::filesystem::path& folder)
    : folder_(folder) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const std::string out = (folder_ / "out").string();
  const std::string err = (folder_ / "err").string();
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ > 0) return;
  ::dup2(::open("/dev/null", O_RDONLY | O_CLOEXEC), 0);
  ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
  ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

void Process::signal(int number) const { ::kill(pid_, number); }

Finished Process::wait() {
  int state = 0;
  ::waitpid(pid_, &state, 0);
  Finished finished;
  finished.exit_code = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  finished.out = readText(folder_ / "out");
  finished.err = readText(folder_ / "err");
  return finished;
}

Finished run(const std::vector<std::string>& command) {
  const TemporaryFolder folder;
  return Process(command, folder.path()).wait();
}

std::filesystem::path tolmanProgram() { return inBuild("bin/tolman"); }

Finished tolman(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), tolmanProgram().string());
  return run(arguments);
}

std::string readText(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

nlohmann::json readJson(const std::filesystem::path& file) {
  return nlohmann::json::parse(readText(file));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace tolman::test
