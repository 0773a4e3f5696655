// SPDX-License-Identifier: BSD-3-Clause
// Local view cells (Milford and Wyeth 2008; Ball et al. 2013): each novel view becomes a template,
// each familiar one activates its template. Scores are mean absolute differences of cells in [0,
// 1].
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "matcher.hpp"
#include "template_bank.hpp"
#include "tolman/plugin.hpp"
#include "view_maker.hpp"

namespace tolman::view_templates {

class ViewTemplates final : public Place,
                            public ArraySource,
                            public ArrayDescriptions,
                            public Localiser {
 public:
  /// The defaults of grey cells are those of the program Hybrid-NeuroSLAM for KITTI.
  struct Parameters {
    int columns = 60;
    int rows = 10;
    CellKind cells = CellKind::Grey;
    // 100-1150 and 50-300 px of KITTI's 1241x376 images, as fractions: any image size works.
    std::vector<double> crop = {100.0 / 1241, 1150.0 / 1241, 50.0 / 376, 300.0 / 376};
    double threshold = 0.085;
    int shift = 5;
    int step = 1;
    int vertical_shift = 0;
    double normalisation = 0.4;
    int patch_radius = 0;
    bool panoramic = false;
    double field_of_view = 81.6;  // deg; KITTI's
    int landmarks = 0;

    static constexpr auto declaration() {
      using P = Parameters;
      return parameters(
          parameter("columns", &P::columns).range(1, 512).unit("cells").doc("Template width."),
          parameter("rows", &P::rows).range(1, 512).unit("cells").doc("Template height."),
          parameter("cells", &P::cells)
              .doc("Content of a cell: grey (mean grey level) or gradients (strength of edges in 8 "
                   "directions)."),
          parameter("crop", &P::crop)
              .range(0, 1)
              .doc("[left, right, upper, lower] edge of the part of the image that is used, as "
                   "fractions of width and height; [0, 1, 0, 1] is the full image."),
          parameter("threshold", &P::threshold)
              .range(0, 1)
              .doc("Largest mean absolute difference between a view and its template."),
          parameter("shift", &P::shift)
              .range(0, 255)
              .unit("cells")
              .doc("Largest horizontal shift that is tried to either side."),
          parameter("step", &P::step)
              .range(1, 64)
              .unit("cells")
              .doc("Step between the shifts that are tried."),
          parameter("vertical_shift", &P::vertical_shift)
              .range(0, 255)
              .unit("cells")
              .doc("Largest vertical shift that is tried; for cameras that pitch."),
          parameter("normalisation", &P::normalisation)
              .range(0, 1)
              .doc("Mean that every view is scaled to; 0 turns it off."),
          parameter("patch_radius", &P::patch_radius)
              .range(0, 32)
              .unit("cells")
              .doc("Half width of the windows of patch normalisation; 0 turns it off."),
          parameter("panoramic", &P::panoramic)
              .doc("The images cover 360 degrees: all cyclic shifts are tried."),
          parameter("field_of_view", &P::field_of_view)
              .range(1, 179)
              .unit("deg")
              .doc("Horizontal field of view of the whole image, for cameras without calibration."),
          parameter("landmarks", &P::landmarks)
              .range(0, 5000)
              .doc("Corners of a stereo pair that a template keeps to verify matches and measure "
                   "poses, on which one in 25, 6 to 20, must agree; 0 turns this off. Templates "
                   "with too few "
                   "corners are matched by appearance alone."));
    }
  };

  Status configure(const Context& context) override;
  Status reset() override;
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation) override;

  /// "view.current" and "view.template" (that of the last observation), rows x columns in [0, 1];
  /// with gradients, one such block for each direction, one below the other.
  void arrays(std::vector<NamedArray>& arrays) const override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

 private:
  int storedRows() const { return parameters_.rows * layersOf(parameters_.cells); }
  bool recognise(const Frame& frame, PlaceObservation& observation);
  double relativeYaw(const TemplateMatch& match, int image_width) const;
  std::vector<double> templateParameters() const;

  Parameters parameters_;
  bool localises_ = false;
  CameraRig rig_;
  std::unique_ptr<ViewMaker> maker_;
  std::unique_ptr<Matcher> matcher_;
  std::unique_ptr<TemplateBank> bank_;
  std::unique_ptr<LandmarkMemory> landmarks_;  ///< null without landmarks
  LocalView view_;
  std::int64_t last_template_ = -1;
};

}  // namespace tolman::view_templates
