// SPDX-License-Identifier: BSD-3-Clause
#include "app/path_kind.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

#include "app/program.hpp"
#include "record/output_places.hpp"
#include "record/regular_file.hpp"
#include "record/run_files.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using std::string_view_literals::operator""sv;

std::string endingOf(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool isImageName(const fs::path& file) {
  constexpr std::array kEndings = {".png"sv, ".jpg"sv, ".jpeg"sv, ".pgm"sv, ".tif"sv, ".tiff"sv};
  return std::ranges::find(kEndings, endingOf(file)) != kEndings.end();
}

bool isBagName(const fs::path& file) {
  constexpr std::array kEndings = {".bag"sv, ".db3"sv, ".mcap"sv};
  return std::ranges::find(kEndings, endingOf(file)) != kEndings.end();
}

bool holdsOneOf(const fs::path& folder, const std::vector<const char*>& names) {
  std::error_code ignored;
  return std::ranges::any_of(names,
                             [&](const char* name) { return fs::exists(folder / name, ignored); });
}

PathKind kindOfFolder(const fs::path& folder) {
  if (record::holdsRecordedRun(folder)) return PathKind::Run;
  if (holdsOneOf(folder, {"points.txt", "rerun.sh"})) return PathKind::Sweep;
  if (holdsOneOf(folder, {"point.json"})) return PathKind::Point;
  if (holdsOneOf(folder,
                 {"image_0", "image_2", "image_00", "mav0", "cam0", "rgb.txt", "odometry.g2o"})) {
    return PathKind::Recording;
  }
  std::error_code failure;
  PathKind kind = PathKind::EmptyFolder;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (isBagName(entry->path())) return PathKind::Bag;
    if (isImageName(entry->path())) return PathKind::ImageFolder;
    kind = PathKind::Folder;
  }
  return failure ? PathKind::Unknown : kind;
}

bool hasKey(const std::string& text, const std::string& key) {
  return text.starts_with(key + ":") || text.find("\n" + key + ":") != std::string::npos;
}

/// Whether the first line that is no comment has 8 or 12 numbers.
bool isTrajectory(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::size_t count = 0;
    for (double value = 0; fields >> value;) ++count;
    return fields.eof() && (count == 8 || count == 12);
  }
  return false;
}

PathKind kindOfText(const fs::path& file, const std::string& text) {
  const std::string ending = endingOf(file);
  if (ending == ".yaml" || ending == ".yml") {
    if (hasKey(text, "base")) return PathKind::SweepFile;
    const bool is_configuration = hasKey(text, "source") || hasKey(text, "extends");
    return is_configuration ? PathKind::Configuration : PathKind::Unknown;
  }
  const std::string first = text.substr(0, text.find('\n'));
  if (first.find(",alignment,truth_sha256,results_sha256") != std::string::npos) {
    return PathKind::Table;
  }
  return isTrajectory(text) ? PathKind::Trajectory : PathKind::Unknown;
}

PathKind kindOfFile(const fs::path& file) {
  constexpr std::size_t kLook = 64 * 1024;
  std::ifstream stream = record::openRegular(file);
  std::string text(kLook, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(kLook));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  if (text.starts_with("\x7f"
                       "ELF"))
    return PathKind::PluginLibrary;
  if (text.starts_with("#ROSBAG") || text.starts_with("\x89MCAP")) return PathKind::Bag;
  if (text.starts_with("SQLite format 3")) {
    return isBagName(file)                   ? PathKind::Bag
           : file.filename() == "run.sqlite" ? PathKind::Record
                                             : PathKind::Unknown;
  }
  if (text.starts_with("PK") && endingOf(file) == ".npz") return PathKind::Arrays;
  if (text.starts_with("\x89HDF") && endingOf(file) == ".nwb") return PathKind::Neurodata;
  if (text.starts_with("\x89PNG") || text.starts_with("\xff\xd8\xff")) return PathKind::Image;
  return text.find('\0') == std::string::npos ? kindOfText(file, text) : PathKind::Unknown;
}

/// What it is, and which commands take it.
struct Words {
  std::string is;
  std::string takers;
};

Words wordsOf(const fs::path& path, PathKind kind) {
  switch (kind) {
    case PathKind::Run:
      return {"a run directory",
              "`tolman view`, `report`, `export`, `plan`, `compare` and `rerun` take one"};
    case PathKind::Sweep:
      return {"the folder of a sweep",
              "`tolman compare` and `tolman sweep status`, `collect` and `archive` take one"};
    case PathKind::Point:
      return {"the folder of one run of a sweep",
              "its run directory is " + (path / "run").string() +
                  ", and `tolman sweep point` takes the folder"};
    case PathKind::Recording:
      return {"the folder of a recording",
              "`tolman init` takes one and writes a configuration for it, and `tolman dataset "
              "check` one with --source"};
    case PathKind::ImageFolder:
      return {"a folder of images",
              "`tolman init` takes one and writes a configuration for it, and `tolman dataset "
              "check --source images` one"};
    case PathKind::Image:
      return {"an image", "`tolman init` takes the folder of the images"};
    case PathKind::Bag:
      return {"a bag of ROS",
              "`tolman init` takes one and writes a configuration for it, and `tolman dataset "
              "check --source ros_bag` one"};
    case PathKind::Configuration:
      return {"a configuration", "`tolman run`, `check`, `bench` and `dataset render` take one"};
    case PathKind::SweepFile:
      return {"the file of a sweep", "`tolman sweep` takes one"};
    case PathKind::PluginLibrary:
      return {"a shared library",
              "`tolman plugins doctor` and `plugins validate` take one with plugins"};
    case PathKind::Trajectory:
      return {"a trajectory", "`tolman eval` compares two"};
    case PathKind::Table:
      return {"a table of `tolman sweep collect`", "`tolman compare` takes one"};
    case PathKind::Arrays:
      return {"a file of arrays", "numpy.load() of Python reads one"};
    case PathKind::Neurodata:
      return {"a file of Neurodata Without Borders", "pynwb of Python reads one"};
    case PathKind::Record:
      return {"the record of a run",
              "give its run directory, " + record::truePath(path).parent_path().string()};
    case PathKind::EmptyFolder:
      return {"an empty folder", "check the path"};
    case PathKind::Folder:
      return {"a folder, of no kind that Tolman knows", "check the path"};
    case PathKind::Missing:
    case PathKind::Unknown:
      break;
  }
  return {"something else", "check the path"};
}

}  // namespace

PathKind kindOf(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) return PathKind::Missing;
  if (fs::is_directory(status)) return kindOfFolder(path);
  return fs::is_regular_file(status) ? kindOfFile(path) : PathKind::Unknown;
}

std::string wrongKindText(const fs::path& path, PathKind kind, const std::string& wanted) {
  const Words words = wordsOf(path, kind);
  return path.string() + ": is " + words.is + ", not " + wanted + "; " + words.takers;
}

void requireKind(const fs::path& path, const std::vector<PathKind>& accepted,
                 const std::string& wanted, ExitCode code) {
  const PathKind kind = kindOf(path);
  if (kind == PathKind::Missing || kind == PathKind::Unknown) return;
  if (std::ranges::find(accepted, kind) != accepted.end()) return;
  throw Ended{code, wrongKindText(path, kind, wanted)};
}

void requireRecording(const fs::path& path, const std::string& source) {
  if (source != "kitti" || path.empty()) return;
  requireKind(path, {PathKind::Recording, PathKind::Folder}, "a sequence of KITTI",
              ExitCode::Dataset);
}

void requireRun(const fs::path& path, const std::vector<PathKind>& also) {
  std::vector<PathKind> accepted = also;
  // A run directory without run.sqlite and run.json is a folder; RunReader says what is missing.
  accepted.insert(accepted.end(), {PathKind::Run, PathKind::Folder});
  requireKind(path, accepted, "a run directory", ExitCode::Dataset);
}

}  // namespace tolman::app
