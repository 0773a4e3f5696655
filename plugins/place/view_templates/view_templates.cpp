// SPDX-License-Identifier: BSD-3-Clause
#include "view_templates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "matcher.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_templates {
namespace {

constexpr std::string_view kMagic = "TLMVIEWS";
constexpr std::uint64_t kStateVersion = 3;

LocalViewSettings viewSettings(const ViewTemplates::Parameters& p) {
  return {p.columns, p.rows,          p.crop[0],      p.crop[1], p.crop[2],
          p.crop[3], p.normalisation, p.patch_radius, p.cells};
}

Status check(const ViewTemplates::Parameters& p) {
  if (p.crop.size() != 4 || p.crop[0] >= p.crop[1] || p.crop[2] >= p.crop[3]) {
    return Status::invalidParameter(
        "the crop is empty: give [left, right, upper, lower] with left < right and upper < lower");
  }
  if (!p.panoramic && 2 * p.shift >= p.columns) {
    return Status::invalidParameter(
        "a shift of " + std::to_string(p.shift) + " cells to both sides leaves none of " +
        std::to_string(p.columns) + " columns to compare; lower `shift`");
  }
  if (2 * p.vertical_shift >= p.rows) {
    return Status::invalidParameter("a vertical shift of " + std::to_string(p.vertical_shift) +
                                    " cells up and down leaves none of " + std::to_string(p.rows) +
                                    " rows to compare; lower `vertical_shift`");
  }
  return Status::ok();
}

}  // namespace

Status ViewTemplates::configure(const Context& context) {
  Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  if (context.rig.width == 0) {
    context.log.warning("the source has no images, so no place will be recognised");
  }
  parameters_ = std::move(bound).value();
  if (Status status = check(parameters_); !status.isOk()) return status;
  rig_ = context.rig;
  localises_ = context.localise;
  if (Status status = reset(); !status.isOk()) return status;
  if (landmarks_ && !landmarks_->hasStereo()) {
    context.log.warning(
        "landmarks need a calibrated stereo pair; views are recognised by appearance alone: set "
        "landmarks to 0 and lower the threshold");
  }
  return rig_.width > 0 ? maker_->checkSize(rig_.width, rig_.height) : Status::ok();
}

Status ViewTemplates::reset() {
  const Parameters& p = parameters_;
  maker_ = std::make_unique<ViewMaker>(viewSettings(p));
  matcher_ = std::make_unique<Matcher>(
      MatchSettings{p.shift, p.step, p.threshold, p.panoramic, p.vertical_shift, layersOf(p.cells)},
      p.columns, p.rows);
  bank_ = std::make_unique<TemplateBank>(p.columns, storedRows());
  landmarks_.reset();
  if (p.landmarks > 0) {
    landmarks_ =
        std::make_unique<LandmarkMemory>(rig_, p.landmarks, landmarks::leastAgreeing(p.landmarks));
  }
  view_ = LocalView{};
  last_template_ = -1;
  return Status::ok();
}

Status ViewTemplates::observe(const Frame& frame, const Motion* /*motion*/,
                              PlaceObservation& observation) {
  observation.frame = frame.frame;
  observation.stamp_ns = frame.stamp_ns;
  if (frame.left.empty()) return Status::ok();
  if (Status status = maker_->make(frame.left, view_); !status.isOk()) return status;
  if (landmarks_) landmarks_->beginFrame();

  if (!recognise(frame, observation) && !localises_) {
    observation.recognition = Recognition::Novel;
    observation.template_id = bank_->add(view_);
    if (landmarks_) landmarks_->add(frame);
  }
  last_template_ = observation.template_id;
  return Status::ok();
}

/// False for a novel view.
bool ViewTemplates::recognise(const Frame& frame, PlaceObservation& observation) {
  const TemplateMatch match = matcher_->nearest(view_, *bank_);
  observation.score = match.distance;
  if (match.id < 0) return false;
  Candidate& best = observation.candidates.emplace_back();
  best.template_id = match.id;
  best.score = match.distance;
  best.limit = parameters_.threshold;
  if (match.distance > parameters_.threshold) return false;
  if (landmarks_ && landmarks_->hasEnough(match.id)) {
    landmarks::Agreement agreement;
    const auto measured = landmarks_->locate(frame, match.id, agreement);
    best.agreeing = agreement.agreeing;
    best.compared = agreement.compared;
    best.needed = agreement.needed;
    if (!measured) return false;  // another place of similar appearance
    observation.has_relative_pose = true;
    observation.T_template_current = measured->T_template_current;
    observation.covariance = measured->covariance;
  }
  observation.recognition = Recognition::Familiar;
  observation.template_id = match.id;
  observation.relative_yaw = observation.has_relative_pose
                                 ? toPlanar(observation.T_template_current).theta
                                 : relativeYaw(match, frame.left.width());
  return true;
}

double ViewTemplates::relativeYaw(const TemplateMatch& match, int image_width) const {
  const Parameters& p = parameters_;
  if (p.panoramic) return yawOfPanoramicShift(match.moved_right, p.columns);
  const double fov = p.field_of_view * std::numbers::pi / 180;
  const double focal = rig_.calibrated ? rig_.pinhole.fx : focalOfFieldOfView(fov, image_width);
  return yawOfPinholeShift(match.moved_right * view_.cell_width_px, focal);
}

void ViewTemplates::arrays(std::vector<NamedArray>& arrays) const {
  const std::vector<int> shape = {storedRows(), parameters_.columns};
  std::vector<float> current(bank_->cellsPerTemplate());
  std::vector<float> stored(bank_->cellsPerTemplate());
  std::copy(view_.cells.begin(), view_.cells.end(), current.begin());
  if (last_template_ >= 0) {
    const auto cells = bank_->cells(last_template_);
    std::transform(cells.begin(), cells.end(), stored.begin(),
                   [](FixedCell cell) { return static_cast<float>(cell) / kOne; });
  }
  arrays.push_back({"view.current", shape, std::move(current)});
  arrays.push_back({"view.template", shape, std::move(stored)});
}

/// The parameters that stored templates depend on: they cannot be used with other values.
std::vector<double> ViewTemplates::templateParameters() const {
  const Parameters& p = parameters_;
  return {static_cast<double>(p.columns),
          static_cast<double>(p.rows),
          p.crop[0],
          p.crop[1],
          p.crop[2],
          p.crop[3],
          p.normalisation,
          static_cast<double>(p.patch_radius),
          static_cast<double>(p.cells),
          static_cast<double>(p.landmarks)};
}

Status ViewTemplates::describe(std::vector<ArrayInfo>& arrays) const {
  for (const char* name : {"view.current", "view.template"}) {
    ArrayInfo view;
    view.name = name;
    view.doc = std::string(name) == "view.current" ? "cells of the current view"
                                                   : "cells of the template of the last answer";
    view.axes.resize(2);
    view.axes[0].name = "row";
    view.axes[1].name = "column";
    arrays.push_back(std::move(view));
  }
  return Status::ok();
}

Status ViewTemplates::save(std::ostream& stream) const {
  StateWriter writer;
  writer.putAll<double>(templateParameters());
  writer.put(last_template_);
  writer.put(bank_->size());
  writer.putAll(bank_->allMeans());
  writer.putAll(bank_->allCells());
  if (landmarks_) landmarks_->save(writer);
  return writer.write(stream, kMagic, kStateVersion);
}

Status ViewTemplates::load(std::istream& stream) {
  if (Status status = reset(); !status.isOk()) return status;
  Result<StateReader> opened = StateReader::open(stream, kMagic, kStateVersion);
  if (!opened.isOk()) return opened.status();
  StateReader& reader = opened.value();
  std::vector<double> saved_parameters(templateParameters().size());
  reader.getAll<double>(saved_parameters);
  if (saved_parameters != templateParameters()) {
    return Status::invalidInput(
        "the saved templates were made with other parameters (columns, rows, cells, crop, "
        "normalisation, patch, landmarks)");
  }
  const auto last = reader.get<std::int64_t>();
  const auto count = reader.get<std::uint64_t>();
  const std::size_t bytes_each = sizeof(double) + bank_->cellsPerTemplate() * sizeof(FixedCell);
  if (count > reader.remaining() / bytes_each || last >= static_cast<std::int64_t>(count)) {
    return Status::invalidInput("the saved state is damaged: wrong number of templates");
  }
  std::vector<double> means(count);
  std::vector<FixedCell> cells(count * bank_->cellsPerTemplate());
  reader.getAll<double>(means);
  reader.getAll<FixedCell>(cells);
  const bool sound = !landmarks_ || (landmarks_->load(reader) && landmarks_->size() == count);
  if (!sound || !reader.complete()) {
    static_cast<void>(reset());
    return Status::invalidInput("the saved state is damaged: wrong length");
  }
  bank_->restore(std::move(cells), std::move(means));
  last_template_ = last;
  return Status::ok();
}

}  // namespace tolman::view_templates
