// SPDX-License-Identifier: BSD-3-Clause
#include "path_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "wide.hpp"

namespace tolman::view_sequences {
namespace {

constexpr int kLargestStep = 3;  // views; a robot that moves faster is penalised

/// best[i] = min(best[i], before[i] + cost)
TOLMAN_WIDE void takeSmaller(float* best, const float* before, float cost, std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) {
    const float value = before[i] + cost;
    best[i] = value < best[i] ? value : best[i];
  }
}

TOLMAN_WIDE void addRemembered(float* evidence, const float* z, const float* best, float memory,
                               float offset, std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) evidence[i] = z[i] + offset + memory * best[i];
}

}  // namespace

void PathEvidence::add(std::int64_t predecessor) {
  const auto view = static_cast<std::int64_t>(evidence_.size());
  if (predecessor != view - 1 || predecessor < 0) {
    starts_.push_back(view);
    if (predecessor >= 0) links_.push_back({predecessor, view});
  }
  evidence_.push_back(0);
}

void PathEvidence::join(std::int64_t from, std::int64_t to) { links_.push_back({from, to}); }

void PathEvidence::stepWithinSequences(double advance) {
  const auto views = static_cast<std::int64_t>(evidence_.size());
  best_.assign(evidence_.size(), 0);
  for (int k = 0; k <= kLargestStep; ++k) {
    const auto cost = static_cast<float>(settings_.penalty * std::abs(k - advance));
    for (std::size_t s = 0; s < starts_.size(); ++s) {
      const std::int64_t start = starts_[s];
      const std::int64_t end = s + 1 < starts_.size() ? starts_[s + 1] : views;
      takeSmaller(best_.data() + start + k, evidence_.data() + start, cost,
                  std::max<std::int64_t>(0, end - start - k));
    }
  }
}

void PathEvidence::step(std::span<const float> standardised, double advance,
                        std::int64_t candidates) {
  stepWithinSequences(advance);
  const auto cost = static_cast<float>(settings_.penalty * std::abs(1 - advance));
  for (const Link& link : links_) {
    if (link.from >= candidates) continue;
    takeSmaller(&best_[static_cast<std::size_t>(link.to)],
                &evidence_[static_cast<std::size_t>(link.from)], cost, 1);
  }
  addRemembered(evidence_.data(), standardised.data(), best_.data(),
                static_cast<float>(settings_.memory), static_cast<float>(settings_.offset),
                static_cast<std::int64_t>(evidence_.size()));
}

void PathEvidence::correct(std::int64_t view, float change) {
  evidence_[static_cast<std::size_t>(view)] += change;
}

void PathEvidence::forget() { std::ranges::fill(evidence_, 0.0F); }

void PathEvidence::save(StateWriter& writer) const {
  writer.putAll<float>(evidence_);
  writer.put(static_cast<std::uint64_t>(starts_.size()));
  writer.putAll<std::int64_t>(starts_);
  writer.put(static_cast<std::uint64_t>(links_.size()));
  for (const Link& link : links_) {
    writer.put(link.from);
    writer.put(link.to);
  }
}

bool PathEvidence::load(StateReader& reader, std::int64_t views) {
  *this = PathEvidence(settings_);
  const auto isView = [&](std::int64_t i) { return i >= 0 && i < views; };
  if (static_cast<std::uint64_t>(views) > reader.remaining() / sizeof(float)) return false;
  evidence_.resize(static_cast<std::size_t>(views));
  reader.getAll<float>(evidence_);
  const auto starts = reader.get<std::uint64_t>();
  if (starts > reader.remaining() / sizeof(std::int64_t)) return false;
  starts_.resize(starts);
  reader.getAll<std::int64_t>(starts_);
  const auto links = reader.get<std::uint64_t>();
  if (links > reader.remaining() / sizeof(Link)) return false;
  for (std::uint64_t i = 0; i < links; ++i) {
    const auto from = reader.get<std::int64_t>();
    links_.push_back({from, reader.get<std::int64_t>()});
  }
  const bool sound = std::ranges::all_of(evidence_, [](float e) { return std::isfinite(e); }) &&
                     std::ranges::all_of(starts_, isView) &&
                     std::ranges::adjacent_find(starts_, std::greater_equal{}) == starts_.end() &&
                     std::ranges::all_of(links_, [&](const Link& link) {
                       return isView(link.from) && isView(link.to);
                     });
  return sound && (views == 0 || (!starts_.empty() && starts_.front() == 0));
}

}  // namespace tolman::view_sequences
