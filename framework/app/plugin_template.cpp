// SPDX-License-Identifier: BSD-3-Clause
#include "app/plugin_template.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "record/atomic_file.hpp"
#include "tolman/version.hpp"

namespace tolman::app {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestName = 40;
constexpr const char* kSuffix = ".in";
/// Other files of a repository, and Python's None, True and False.
constexpr std::array<std::string_view, 5> kTakenNames = {"plugin", "test_context", "none", "true",
                                                         "false"};

bool isSmall(char c) { return c >= 'a' && c <= 'z'; }
bool isLegal(char c) { return isSmall(c) || (c >= '0' && c <= '9') || c == '_'; }

Result<std::string> readFile(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream) return text.str();
  return Status::failed(file.string() + ": the template cannot be read; install the SDK again");
}

/// The placeholders' values. `about`: a summary line, an empty line, and the description.
std::map<std::string, std::string> valuesOf(const NewPlugin& plugin, const std::string& about) {
  const std::size_t line = std::min(about.find('\n'), about.size());
  const std::size_t rest = std::min(about.find_first_not_of('\n', line), about.size());
  const std::size_t end = about.find_last_not_of('\n') + 1;
  return {{"NAME", plugin.name},
          {"CLASS", className(plugin.name)},
          {"ROLE", std::string(enumName(plugin.role))},
          {"SDK_VERSION", TOLMAN_SDK_VERSION},
          {"SUMMARY", about.substr(0, line)},
          {"ABOUT", about.substr(rest, std::max(end, rest) - rest)}};
}

/// Copies one folder of templates, filled in; adds the files to `written`.
Status copyFilled(const fs::path& from, const fs::path& to,
                  const std::map<std::string, std::string>& values,
                  std::vector<fs::path>& written) {
  std::error_code error;
  for (fs::recursive_directory_iterator it(from, error), end; !error && it != end;
       it.increment(error)) {
    if (!it->is_regular_file() || it->path().extension() != kSuffix) continue;
    const auto text = readFile(it->path());
    if (!text.isOk()) return text.status();
    const std::string place = fs::relative(it->path(), from).replace_extension().string();
    const fs::path relative = fillIn(place, values);
    std::error_code ignored;  // the write below fails with a better message
    fs::create_directories((to / relative).parent_path(), ignored);
    const Status status =
        record::writeAtomically(to / relative, fillIn(text.value(), values), record::Sync::No);
    if (!status.isOk()) return status;
    written.push_back(relative);
  }
  if (!error) return Status::ok();
  return Status::failed(from.string() + ": " + error.message() + "; install the SDK again");
}

/// Whether `folder` may be filled: absent, or an empty folder.
Status checkFree(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return Status::ok();
  if (fs::is_directory(folder, error) && fs::is_empty(folder, error) && !error) return Status::ok();
  return Status::failed(folder.string() +
                        ": is there already and not an empty folder; name another one, or remove "
                        "it");
}

/// Makes the folder; the failure names it, and the remedy.
Status makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0) {
    error.assign(errno, std::generic_category());
  }
  if (!error) return Status::ok();
  return Status::failed(folder.string() + ": the plugin's folder cannot be written (" +
                        error.message() +
                        "); name another one: tolman plugins new ROLE NAME FOLDER");
}

}  // namespace

std::optional<std::string> objectionTo(const std::string& name) {
  const bool legal = !name.empty() && isSmall(name.front()) && name.back() != '_' &&
                     std::all_of(name.begin(), name.end(), isLegal) &&
                     name.find("__") == std::string::npos && name.size() <= kLongestName;
  if (!legal) {
    return fmt::format(
        "'{}' cannot be the name of a plugin: it takes small letters, digits and single "
        "underscores, begins with a letter and has {} of them at most, as my_places",
        name, kLongestName);
  }
  if (std::ranges::find(kTakenNames, name) != kTakenNames.end()) {
    return "'" + name + "' has another meaning in the repository; try 'my_" + name + "'";
  }
  return std::nullopt;
}

std::string className(const std::string& id) {
  std::string name;
  bool begins_word = true;
  for (const char c : id) {
    if (c != '_') {
      name += begins_word ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    begins_word = c == '_';
  }
  return name;
}

Result<fs::path> templateFolder(const fs::path& executable) {
  const fs::path folder = executable.parent_path().parent_path() / "share/tolman/template";
  std::error_code error;
  if (fs::is_directory(folder / "shared", error)) return folder;
  return Status::failed(folder.string() +
                        ": the templates are not there; install the SDK (Debian: "
                        "libtolman-sdk-dev) beside this program");
}

std::optional<fs::path> unusualPrefix(const fs::path& executable) {
  const fs::path prefix = executable.parent_path().parent_path();
  if (prefix == "/usr" || prefix == "/usr/local") return std::nullopt;
  return prefix;
}

std::string fillIn(const std::string& text, const std::map<std::string, std::string>& values) {
  std::string filled;
  std::size_t done = 0;
  for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at)) {
    const std::size_t end = text.find('@', at + 1);
    if (end == std::string::npos) break;
    const auto value = values.find(text.substr(at + 1, end - at - 1));
    if (value == values.end()) {
      at = end;  // this sign may begin a placeholder
      continue;
    }
    filled.append(text, done, at - done).append(value->second);
    at = done = end + 1;
  }
  return filled.append(text, done);
}

Result<std::vector<fs::path>> writeNewPlugin(const fs::path& templates, const NewPlugin& plugin) {
  if (Status status = checkFree(plugin.folder); !status.isOk()) return status;
  const fs::path of_role = templates / enumName(plugin.role);
  const auto about = readFile(of_role / "about.md");
  if (!about.isOk()) return about.status();
  if (Status status = makeFolder(plugin.folder); !status.isOk()) return status;
  const auto values = valuesOf(plugin, about.value());
  std::vector<fs::path> written;
  std::vector<fs::path> folders = {templates / "shared", of_role};
  if (plugin.python) folders = {templates / "python" / enumName(plugin.role)};
  for (const fs::path& from : folders) {
    if (Status status = copyFilled(from, plugin.folder, values, written); !status.isOk()) {
      return status;
    }
  }
  std::sort(written.begin(), written.end());
  return written;
}

}  // namespace tolman::app
