// SPDX-License-Identifier: BSD-3-Clause
#include "host/manifest.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "config/text.hpp"
#include "host/elf_section.hpp"

namespace tolman::host {
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

/// The text without control characters, which a terminal would execute.
std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
  return text;
}

Role roleNamed(const std::string& name) {
  if (const auto role = config::valueNamed<Role>(name)) return *role;
  throw std::runtime_error("'" + name + "' is not a role");
}

void checkIdentifier(const std::string& id) {
  const bool plain = !id.empty() && id.find_first_not_of(
                                        "abcdefghijklmnopqrstuvwxyz"
                                        "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                        "0123456789_") == std::string::npos;
  if (!plain) throw std::runtime_error("'" + id + "' is not an identifier");
}

Manifest fromJson(const nlohmann::json& json, const std::filesystem::path& file) {
  const auto text = [&](const char* key) { return printable(json.at(key).get<std::string>()); };
  Manifest manifest;
  manifest.file = file;
  manifest.id = text("id");
  checkIdentifier(manifest.id);
  manifest.programs = printable(json.value("programs", ""));
  const bool is_plugin = manifest.programs.empty();
  if (is_plugin) manifest.role = roleNamed(text("role"));
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

OrRefusal<Manifest> parseManifest(const std::string& text, const std::filesystem::path& file) {
  try {
    return fromJson(nlohmann::json::parse(text), file);
  } catch (const std::exception& error) {
    return Refusal{"plugin/bad-manifest",
                   file.string() + ": the manifest is not valid: " + error.what(),
                   "let TOLMAN_PLUGIN write the manifest; do not write it by hand"};
  }
}

OrRefusal<std::vector<Manifest>> readManifests(const std::filesystem::path& file) {
  auto section = readElfSection(file, "tolman_manifest");
  if (auto* refusal = std::get_if<Refusal>(&section)) return *refusal;
  const std::string& bytes = std::get<std::string>(section);

  std::vector<Manifest> manifests;
  for (std::size_t begin = 0; begin < bytes.size();) {  // texts are separated by zeros
    const std::string text = bytes.c_str() + begin;
    begin += text.size() + 1;
    if (text.empty()) continue;
    // Absolute: a bare file name would make the dynamic linker search its own path.
    auto manifest = parseManifest(text, std::filesystem::absolute(file));
    if (auto* refusal = std::get_if<Refusal>(&manifest)) return *refusal;
    manifests.push_back(std::get<Manifest>(manifest));
  }
  if (manifests.empty()) {
    return Refusal{"plugin/no-manifest", file.string() + ": the manifest section is empty",
                   "register the class with TOLMAN_PLUGIN in plugin.cpp"};
  }
  return manifests;
}

OrRefusal<Manifest> readManifest(const std::filesystem::path& file, const std::string& id) {
  auto read = readManifests(file);
  if (const auto* refusal = std::get_if<Refusal>(&read)) return *refusal;
  for (Manifest& manifest : std::get<std::vector<Manifest>>(read)) {
    if (manifest.id == id) return std::move(manifest);
  }
  return Refusal{"plugin/not-found", file.string() + " has no plugin '" + id + "'",
                 "`tolman plugins doctor FILE` shows what it has"};
}

}  // namespace tolman::host
