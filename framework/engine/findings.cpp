// SPDX-License-Identifier: BSD-3-Clause
#include "engine/findings.hpp"

#include <fmt/format.h>

#include <cctype>
#include <iterator>
#include <utility>

namespace tolman::engine {
namespace {

std::string textOf(const Finding& finding) {
  std::string text = finding.where + (finding.where.empty() ? "" : ": ") + finding.message;
  return finding.remedy.empty() ? text : text + "; " + finding.remedy;
}

}  // namespace

std::string withoutNumbers(const std::string& text) {
  std::string kept;
  for (const char c : text) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!is_digit) kept += c;
    if (is_digit && !kept.ends_with('#')) kept += '#';
  }
  return kept;
}

LogLevel Findings::Kind::level() const {
  return first.severity == Finding::Severity::Note ? LogLevel::Info : LogLevel::Warning;
}

std::string Findings::Kind::text() const {
  const std::int64_t more = count - printed - (printed == 0 ? 1 : 0);
  if (printed > 0) return fmt::format("{} more as this one: {}", more, textOf(first));
  return textOf(first) + (more > 0 ? fmt::format(" (and {} more)", more) : "");
}

void Findings::add(const std::string& stage, Finding finding) {
  const std::lock_guard lock(mutex_);
  const std::string key = fmt::format("{}\n{}\n{}\n{}", stage, enumName(finding.severity),
                                      enumName(finding.kind), withoutNumbers(finding.message));
  const auto [kind, is_new] = index_.try_emplace(key, kinds_.size());
  untaken_.push_back({std::move(finding), -1, stage});
  if (is_new) kinds_.push_back({untaken_.back(), 0, 0});
  ++kinds_[kind->second].count;
}

Status Findings::judge(const Status& status, std::int64_t frame) {
  const std::lock_guard lock(mutex_);
  for (; addressed_ < untaken_.size(); ++addressed_) untaken_[addressed_].frame = frame;
  const std::size_t begin = std::exchange(judged_, kinds_.size());
  if (policy_ == config::FindingPolicy::Continue && status.isOk()) return status;
  std::int64_t errors = 0;
  const Kind* first = nullptr;
  for (std::size_t i = begin; i < kinds_.size(); ++i) {
    Kind& kind = kinds_[i];
    if (kind.first.severity != Finding::Severity::Error) continue;
    if (first == nullptr) first = &kind;
    errors += kind.count;
    kind.printed = kind.count;  // by the failure that follows
  }
  if (first == nullptr || !status.isOk()) return status;
  const std::string more =
      errors > 1 ? fmt::format(" (and {} more; `tolman dataset check` lists all)", errors - 1) : "";
  return Status::invalidInput(textOf(first->first) + more +
                              "; to go on without what is wrong, set on_findings: continue");
}

std::vector<Findings::Kind> Findings::takeKinds(bool are_new) {
  const std::lock_guard lock(mutex_);
  std::vector<Kind> taken;
  for (Kind& kind : kinds_) {
    if (kind.printed == kind.count || (are_new && kind.printed > 0)) continue;
    taken.push_back(kind);
    kind.printed = kind.count;
  }
  return taken;
}

std::vector<record::RecordedFinding> Findings::take(bool at_end) {
  const std::lock_guard lock(mutex_);
  const auto end =
      untaken_.begin() + static_cast<std::ptrdiff_t>(at_end ? untaken_.size() : addressed_);
  std::vector<record::RecordedFinding> taken(std::make_move_iterator(untaken_.begin()),
                                             std::make_move_iterator(end));
  untaken_.erase(untaken_.begin(), end);
  addressed_ = 0;
  return taken;
}

}  // namespace tolman::engine
