// SPDX-License-Identifier: BSD-3-Clause
#include "inspection.hpp"

#include <algorithm>
#include <utility>

namespace tolman::image_folders {

void Inspection::error(const std::filesystem::path& file, std::string message) {
  add(file.string(), file.string(), std::move(message));
}

void Inspection::error(const std::filesystem::path& file, int line, std::string message) {
  add(file.string(), file.string() + ":" + std::to_string(line), std::move(message));
}

void Inspection::error(const std::string& message) {
  const std::size_t end = std::min(message.find(": "), message.size());
  const std::string where = message.substr(0, end);
  add(where, where, message.substr(std::min(end + 2, message.size())));
}

void Inspection::warning(const std::filesystem::path& file, std::string message) {
  findings_.push_back({Finding::Severity::Warning, file.string(), std::move(message)});
}

void Inspection::warning(const std::filesystem::path& file, int line, std::string message) {
  warning(file.string() + ":" + std::to_string(line), std::move(message));
}

void Inspection::add(const std::string& file, std::string where, std::string message) {
  constexpr int kMaxErrors = 20;
  const int errors = ++errors_of_file_[file];
  if (errors > kMaxErrors + 1) return;
  if (errors == kMaxErrors + 1) {
    where = file;
    message = "has more problems; they are not listed";
  }
  findings_.push_back({Finding::Severity::Error, std::move(where), std::move(message)});
}

Status Inspection::status() const {
  const auto isError = [](const Finding& finding) {
    return finding.severity == Finding::Severity::Error;
  };
  const auto first = std::find_if(findings_.begin(), findings_.end(), isError);
  if (first == findings_.end()) return Status::ok();
  std::string message = first->where + ": " + first->message;
  const auto more = std::count_if(first + 1, findings_.end(), isError);
  if (more > 0) {
    message += " (and " + std::to_string(more) + (more == 1 ? " more problem" : " more problems") +
               "; `tolman dataset check` lists all)";
  }
  return Status::invalidInput(message);
}

}  // namespace tolman::image_folders
