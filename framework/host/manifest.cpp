// SPDX-License-Identifier: BSD-3-Clause
#include "host/manifest.hpp"

#include <elf.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/text_file.hpp"
#include "config/text.hpp"

namespace tolman::host {

namespace {

/// The bytes of a file, cut to the parts that are read: every offset is checked against its size.
class BoundedFile {
 public:
  explicit BoundedFile(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return;  // a pipe would block
    stream_.open(file, std::ios::binary);
    size_ = std::filesystem::file_size(file, error);
  }
  bool readable() const { return stream_.is_open(); }

  std::optional<std::string> read(std::uint64_t offset, std::uint64_t length) {
    constexpr std::uint64_t kLongest = 1U << 20U;  // bytes; a manifest has about 1 KiB per plugin
    if (length > kLongest || offset > size_ || length > size_ - offset) return std::nullopt;
    std::string bytes(length, '\0');
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(offset));
    stream_.read(bytes.data(), static_cast<std::streamsize>(length));
    if (!stream_) return std::nullopt;
    return bytes;
  }

  template <class T>
  std::optional<T> object(std::uint64_t offset) {
    const auto bytes = read(offset, sizeof(T));
    if (!bytes) return std::nullopt;
    T value;
    std::memcpy(&value, bytes->data(), sizeof(T));
    return value;
  }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

bool isForThisMachine(const Elf64_Ehdr& header) {
  return header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_ident[EI_DATA] == ELFDATA2LSB &&
         header.e_machine == EM_X86_64 && header.e_type == ET_DYN;
}

}  // namespace

std::string readElfSection(const std::filesystem::path& file, std::string_view name) {
  BoundedFile elf(file);
  const std::string path = file.string();
  const Refusal truncated{"plugin/truncated", path + " is shorter than its section table requires",
                          "the file is damaged: build or copy it again"};
  if (!elf.readable()) {
    throw Refusal{"plugin/unreadable", path + " cannot be read",
                  "check that the file exists, and its permissions"};
  }
  const auto magic = elf.read(0, SELFMAG);
  if (!magic || *magic != std::string_view(ELFMAG, SELFMAG)) {
    throw Refusal{"plugin/not-elf", path + " is not an ELF file",
                  "name a shared library that was built with tolman_add_plugin()"};
  }
  const auto header = elf.object<Elf64_Ehdr>(0);
  if (!header) throw truncated;
  if (!isForThisMachine(*header)) {
    throw Refusal{"plugin/wrong-machine", path + " is not an x86-64 shared library",
                  "build it for this machine, as a shared library, with tolman_add_plugin()"};
  }
  const auto sectionAt = [&](std::uint64_t i) {
    return elf.object<Elf64_Shdr>(header->e_shoff + i * sizeof(Elf64_Shdr));
  };
  const auto names_section = sectionAt(header->e_shstrndx);
  if (!names_section) throw truncated;
  const auto names = elf.read(names_section->sh_offset, names_section->sh_size);
  if (!names) throw truncated;
  for (std::uint64_t i = 0; i < header->e_shnum; ++i) {
    const auto section = sectionAt(i);
    if (!section) throw truncated;
    if (section->sh_name >= names->size()) continue;
    if (std::string_view(names->c_str() + section->sh_name) != name) continue;
    const auto bytes = elf.read(section->sh_offset, section->sh_size);
    if (!bytes) throw truncated;
    return *bytes;
  }
  throw Refusal{"plugin/no-manifest", path + " has no section " + std::string(name),
                "register the class with TOLMAN_PLUGIN in plugin.cpp, and do not strip sections"};
}

namespace {

template <class T>
T number(std::string_view text, const char* what, int base) {
  T value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size() || std::cmp_less(value, 0)) {
    throw std::runtime_error("'" + std::string(text) + "' is not a " + what);
  }
  return value;
}

bool isIdentifier(const std::string& id) {
  return !id.empty() && std::ranges::all_of(id, [](unsigned char c) {
    return c == '_' || (c < 128 && std::isalnum(c) != 0);
  });
}

Manifest fromJson(const nlohmann::json& json, const std::filesystem::path& file) {
  const auto text = [&](const char* key) {
    return config::printable(json.at(key).get<std::string>(), "?");
  };
  Manifest manifest;
  manifest.file = file;
  manifest.id = text("id");
  if (!isIdentifier(manifest.id)) {
    throw std::runtime_error("'" + manifest.id + "' is not an identifier");
  }
  manifest.programs = config::printable(json.value("programs", ""), "?");
  const bool is_plugin = manifest.programs.empty();
  if (is_plugin) {
    const auto role = config::valueNamed<Role>(text("role"));
    if (!role) throw std::runtime_error("'" + text("role") + "' is not a role");
    manifest.role = *role;
  }
  manifest.version = text("version");
  const std::string sdk = text("sdk");
  const auto dot = sdk.find('.');
  const auto part = [&](std::size_t begin, std::size_t size) {
    return number<int>(std::string_view(sdk).substr(begin, size), "number", 10);
  };
  manifest.sdk_major = part(0, dot);
  manifest.sdk_minor = dot == std::string::npos ? 0 : part(dot + 1, std::string::npos);
  manifest.fingerprint = text("fingerprint");
  manifest.opencv = text("opencv");
  if (is_plugin) manifest.schema_hash = number<std::uint64_t>(text("schema"), "hash", 16);
  manifest.summary = text("summary");
  std::istringstream extras(json.value("extras", ""));  // since SDK 0.2
  for (std::string name; std::getline(extras, name, ',');) manifest.extras.push_back(name);
  return manifest;
}

}  // namespace

Manifest parseManifest(const std::string& text, const std::filesystem::path& file) {
  try {
    return fromJson(nlohmann::json::parse(text), file);
  } catch (const std::exception& error) {
    throw Refusal{"plugin/bad-manifest",
                  file.string() + ": the manifest is not valid: " + error.what(),
                  "let TOLMAN_PLUGIN write the manifest; do not write it by hand"};
  }
}

std::vector<Manifest> readManifests(const std::filesystem::path& file) {
  const std::string bytes = readElfSection(file, "tolman_manifest");
  std::vector<Manifest> manifests;
  for (std::size_t begin = 0; begin < bytes.size();) {  // texts are separated by zeros
    const std::string text = bytes.c_str() + begin;
    begin += text.size() + 1;
    if (text.empty()) continue;
    // Absolute: a bare file name would make the dynamic linker search its own path.
    manifests.push_back(parseManifest(text, std::filesystem::absolute(file)));
  }
  if (manifests.empty()) {
    throw Refusal{"plugin/no-manifest", file.string() + ": the manifest section is empty",
                  "register the class with TOLMAN_PLUGIN in plugin.cpp"};
  }
  return manifests;
}

Manifest readManifest(const std::filesystem::path& file, const std::string& id) {
  for (Manifest& manifest : readManifests(file)) {
    if (manifest.id == id) return std::move(manifest);
  }
  throw Refusal{"plugin/not-found", file.string() + " has no plugin '" + id + "'",
                "`tolman plugins doctor FILE` shows what it has"};
}

namespace fs = std::filesystem;

namespace {

/// The plugin folders of the tree that the executable lies in: <prefix>/bin/tolman.
std::vector<fs::path> treeOf(const fs::path& executable) {
  const fs::path prefix = executable.parent_path().parent_path();
  if (fs::exists(prefix / "CMakeCache.txt")) return {prefix / "plugins"};
  std::vector<fs::path> folders;
  for (const char* library_folder : {"lib", "lib/x86_64-linux-gnu", "lib64"}) {
    const fs::path folder = prefix / library_folder / "tolman/plugins";
    if (fs::is_directory(folder)) folders.push_back(folder);
  }
  return folders;
}

std::vector<fs::path> librariesIn(const fs::path& place) {
  std::error_code error;
  if (fs::is_regular_file(place, error)) return {place};
  std::vector<fs::path> files;
  for (fs::directory_iterator it(place, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".so") files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> searchPath(const std::vector<std::string>& command_line,
                                 const char* environment, const fs::path& executable) {
  std::vector<fs::path> path(command_line.begin(), command_line.end());
  std::istringstream list(environment != nullptr ? environment : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) path.emplace_back(folder);
  }
  const auto tree = treeOf(executable);
  path.insert(path.end(), tree.begin(), tree.end());
  return path;
}

Catalogue::Catalogue(std::vector<fs::path> search_path) : search_path_(std::move(search_path)) {
  std::set<fs::path>
      seen;  // the search path may contain a folder twice, also as two different paths
  for (const fs::path& place : search_path_) {
    for (const fs::path& file : librariesIn(place)) {
      std::error_code error;
      const fs::path real = fs::weakly_canonical(file, error);
      if (seen.insert(error ? file : real).second) addLibrary(file);
    }
  }
}

void Catalogue::addLibrary(const fs::path& file) {
  try {
    for (Manifest& manifest : readManifests(file)) {
      (manifest.programs.empty() ? manifests_ : interpreters_).push_back(std::move(manifest));
    }
  } catch (const Refusal& refusal) {
    broken_.push_back({file, refusal});
  }
}

Manifest Catalogue::find(const std::string& id, Role role) const {
  if (fs::path(id).has_extension()) throw notFound(id, role);  // the file of a program, not an id
  Manifest manifest = findLibrary(id, role);
  if (manifest.role == role) return manifest;
  throw Refusal{"plugin/wrong-role",
                "plugin '" + id + "' (" + manifest.file.string() + ") has the role " +
                    std::string(enumName(manifest.role)) + ", not " + std::string(enumName(role)),
                "`tolman plugins list` shows the plugins of each role"};
}

const Manifest* Catalogue::interpreter(const std::string& id) const {
  const auto found = std::ranges::find(interpreters_, id, &Manifest::id);
  return found == interpreters_.end() ? nullptr : &*found;
}

Manifest Catalogue::program(const fs::path& file) const {
  const std::string suffix = file.extension().string();
  const auto found = std::ranges::find(interpreters_, suffix, &Manifest::programs);
  if (found == interpreters_.end()) {
    throw Refusal{"plugin/not-found",
                  file.string() + ": no plugin on the search path runs '" + suffix + "' files",
                  "`tolman plugins list` shows what is there; the plugin may be in a package of "
                  "its own, or have been left out of the build for want of a library"};
  }
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw Refusal{"plugin/not-found", file.string() + ": there is no such file",
                  "correct the path; it is relative to the configuration that says it"};
  }
  Manifest manifest = *found;
  manifest.program = fs::absolute(file);
  return manifest;
}

Manifest Catalogue::find(const std::string& id) const {
  if (const fs::path file = id; file.has_extension()) return program(file);
  return findLibrary(id, std::nullopt);
}

/// `role` is for the message where there is none.
Manifest Catalogue::findLibrary(const std::string& id, std::optional<Role> role) const {
  const auto is_wanted = [&](const Manifest& manifest) { return manifest.id == id; };
  const auto first = std::find_if(manifests_.begin(), manifests_.end(), is_wanted);
  if (first == manifests_.end()) throw notFound(id, role);
  const auto second = std::find_if(first + 1, manifests_.end(), is_wanted);
  if (second != manifests_.end() && second->file.parent_path() == first->file.parent_path()) {
    throw Refusal{"plugin/ambiguous",
                  "plugin '" + id + "' is in both " + first->file.string() + " and " +
                      second->file.filename().string(),
                  "remove one of the two files, or give the wanted one with --plugin-path FILE"};
  }
  return *first;
}

Refusal Catalogue::notFound(const std::string& id, std::optional<Role> role) const {
  std::string kind = role ? std::string(enumName(*role)) + " plugin" : "plugin";
  std::string message = "no " + kind + " '" + id + "' in";
  for (const fs::path& place : search_path_) message += " " + place.string();
  if (search_path_.empty()) message += " any folder: the search path is empty";
  for (const BrokenLibrary& library : broken_) {
    if (library.file.stem().string().find(id) == std::string::npos) continue;
    message += "\n    " + library.file.string() +
               " may be it, but cannot be used: " + library.refusal.text();
  }
  std::vector<std::string> known;
  for (const Manifest& manifest : manifests_) {
    if (!role || manifest.role == *role) known.push_back(manifest.id);
  }
  for (const Manifest& manifest : interpreters_) {
    if (manifest.id == id) {
      return {"plugin/not-found", "'" + id + "' is no plugin itself, it runs one that a file holds",
              "give the file of the plugin in place of '" + id +
                  "', or use it in a configuration with the parameter 'file'"};
    }
    known.push_back(manifest.id);
  }
  const std::optional<std::string> nearest = config::nearestName(id, known);
  return {"plugin/not-found", message,
          (nearest ? "did you mean '" + *nearest + "'? " : std::string()) +
              "`tolman plugins list` shows the plugins found; --plugin-path adds a folder"};
}

}  // namespace tolman::host
