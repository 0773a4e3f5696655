// SPDX-License-Identifier: BSD-3-Clause
#include "seqslam.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "line_search.hpp"

namespace tolman::seqslam {
namespace {

/// R_window: views around a view by whose differences its own is normalised; as published.
constexpr int kContrastWindow = 10;

constexpr std::string_view kMagic = "TLMSEQSL";
constexpr std::uint64_t kStateVersion = 2;
constexpr std::int64_t kMaxImages = std::int64_t{1} << 40;  // a larger number is damage

}  // namespace

Status SeqSlam::configure(const Context& context) {
  Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  if (context.rig.width == 0) {
    context.log.warning("the source has no images, so no place will be recognised");
  }
  parameters_ = std::move(bound).value();
  return reset();
}

Status SeqSlam::reset() {
  const Parameters& p = parameters_;
  search_.emplace(LineSettings{.images = p.sequence, .same_place = p.same_place});
  images_ = 0;
  views_.clear();
  image_of_view_.clear();
  columns_.clear();
  return Status::ok();
}

Status SeqSlam::observe(const Frame& frame, const Motion* /*motion*/,
                        PlaceObservation& observation) {
  observation.frame = frame.frame;
  observation.stamp_ns = frame.stamp_ns;
  if (frame.left.empty()) return Status::ok();
  const PatchView view =
      patchView(frame.left, {.columns = parameters_.columns, .rows = parameters_.rows});
  if (std::ranges::count(view, 0) == std::ssize(view)) return Status::ok();
  compare(view);
  const auto best = search_->best(columns_, candidates());
  observation.score = quotientOf(best);
  if (best) {
    Candidate& candidate = observation.candidates.emplace_back();
    candidate.template_id = best->end;
    candidate.score = observation.score;
    candidate.limit = parameters_.quotient;
  }
  if (best && observation.score <= parameters_.quotient) {
    observation.recognition = Recognition::Familiar;
    observation.template_id = best->end;
  } else {
    observation.recognition = Recognition::Novel;
    observation.template_id = views();
    views_.insert(views_.end(), view.begin(), view.end());
    image_of_view_.push_back(images_);
  }
  ++images_;
  return Status::ok();
}

/// Adds the column of differences of a view.
void SeqSlam::compare(const PatchView& view) {
  std::vector<float> differences;
  for (std::size_t at = 0; at < views_.size(); at += viewSize()) {
    differences.push_back(differenceOf(view, std::span(views_).subspan(at, viewSize())));
  }
  columns_.push_back(enhancedContrast(differences, kContrastWindow));
  if (columns_.size() > static_cast<std::size_t>(parameters_.sequence)) columns_.pop_front();
}

/// Number of views that are not recent.
std::int64_t SeqSlam::candidates() const {
  const auto end = std::ranges::lower_bound(image_of_view_, images_ - parameters_.recent);
  return end - image_of_view_.begin();
}

/// Quotient of the best score and its rival. Enhanced differences may be negative, so their least
/// possible value is subtracted first.
double SeqSlam::quotientOf(const std::optional<BestLine>& best) const {
  if (!best) return 1;
  const double least = -std::sqrt(static_cast<double>(kContrastWindow));
  const double rival = best->rival - least;
  return rival > 0 ? std::clamp((best->score - least) / rival, 0.0, 1.0) : 1;
}

/// The parameters that the stored state depends on.
std::vector<double> SeqSlam::storedParameters() const {
  const Parameters& p = parameters_;
  return {static_cast<double>(p.columns), static_cast<double>(p.rows),
          static_cast<double>(p.sequence)};
}

Status SeqSlam::save(std::ostream& stream) const {
  StateWriter writer;
  writer.putAll<double>(storedParameters());
  writer.put(images_);
  writer.put(static_cast<std::uint64_t>(views()));
  writer.putAll<std::int64_t>(image_of_view_);
  writer.putAll<std::int8_t>(views_);
  writer.put(static_cast<std::uint64_t>(columns_.size()));
  for (const std::vector<float>& column : columns_) {
    writer.put(static_cast<std::uint64_t>(column.size()));
    writer.putAll<float>(column);
  }
  return writer.write(stream, kMagic, kStateVersion);
}

Status SeqSlam::load(std::istream& stream) {
  if (Status status = reset(); !status.isOk()) return status;
  Result<StateReader> opened = StateReader::open(stream, kMagic, kStateVersion);
  if (!opened.isOk()) return opened.status();
  StateReader& reader = opened.value();
  std::vector<double> saved(storedParameters().size());
  reader.getAll<double>(saved);
  if (saved != storedParameters()) {
    return Status::invalidInput("the saved views were made with other columns, rows or sequence");
  }
  const bool sound = loadViews(reader) && loadColumns(reader);
  if (!sound || !reader.complete()) {
    static_cast<void>(reset());
    return Status::invalidInput("the saved state is damaged");
  }
  return Status::ok();
}

/// False for a damaged state.
bool SeqSlam::loadViews(StateReader& reader) {
  images_ = reader.get<std::int64_t>();
  const auto count = reader.get<std::uint64_t>();
  if (count > reader.remaining() / (viewSize() + sizeof(std::int64_t))) return false;
  image_of_view_.resize(count);
  reader.getAll<std::int64_t>(image_of_view_);
  views_.resize(count * viewSize());
  reader.getAll<std::int8_t>(views_);
  const auto isImage = [&](std::int64_t image) { return image >= 0 && image < images_; };
  return images_ >= 0 && images_ < kMaxImages && std::ranges::all_of(image_of_view_, isImage) &&
         std::ranges::adjacent_find(image_of_view_, std::greater_equal{}) == image_of_view_.end();
}

/// False for a damaged state.
bool SeqSlam::loadColumns(StateReader& reader) {
  const auto count = reader.get<std::uint64_t>();
  if (count > static_cast<std::uint64_t>(parameters_.sequence)) return false;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto size = reader.get<std::uint64_t>();
    if (size > static_cast<std::uint64_t>(views()) || size > reader.remaining() / sizeof(float)) {
      return false;
    }
    std::vector<float>& column = columns_.emplace_back(size);
    reader.getAll<float>(column);
    if (!std::ranges::all_of(column, [](float value) { return std::isfinite(value); })) {
      return false;
    }
  }
  return true;
}

}  // namespace tolman::seqslam
