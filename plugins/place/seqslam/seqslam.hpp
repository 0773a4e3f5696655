// SPDX-License-Identifier: BSD-3-Clause
// SeqSLAM (Milford and Wyeth, ICRA 2012): a place is recognised if the last images are much more
// similar to stored ones along one line of constant speed than along any other. Only past images
// are used: the answer is the place of the newest image. The score is the quotient of the score of
// the best line and that of its best rival, 0 to 1.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "line_search.hpp"
#include "patch_view.hpp"
#include "tolman/plugin.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::seqslam {

class SeqSlam final : public Place, public StateKeeper {
 public:
  /// Where nothing else is said the default is as published.
  struct Parameters {
    int columns = 64;
    int rows = 32;
    int sequence = 10;
    int same_place = 5;     // views; chosen, not tuned
    int recent = 20;        // images; chosen, not tuned
    double quotient = 0.7;  // chosen, not tuned; README.md

    static constexpr auto declaration() {
      using P = Parameters;
      return parameters(
          parameter("columns", &P::columns)
              .range(1, 1024)
              .unit("px")
              .doc("Width that images are reduced to."),
          parameter("rows", &P::rows)
              .range(1, 1024)
              .unit("px")
              .doc("Height that images are reduced to."),
          parameter("sequence", &P::sequence)
              .range(2, 1000)
              .unit("images")
              .doc("d_s: length of the sequence that is searched for."),
          parameter("same_place", &P::same_place)
              .range(0, 1000)
              .unit("views")
              .doc("Views up to this number from the best one show the same place and are no "
                   "rivals."),
          parameter("recent", &P::recent)
              .range(0, 1000000)
              .unit("images")
              .doc("Views that were stored within this number of the last images are not "
                   "recognised."),
          parameter("quotient", &P::quotient)
              .range(0, 1)
              .doc("A view is familiar if the score of the best line is at most this share of that "
                   "of "
                   "its best rival; with 1 every view is."));
    }
  };

  Status configure(const Context& context) override;
  Status reset() override;
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation) override;

  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

 private:
  std::int64_t views() const { return static_cast<std::int64_t>(image_of_view_.size()); }
  std::size_t viewSize() const {
    return static_cast<std::size_t>(parameters_.columns) *
           static_cast<std::size_t>(parameters_.rows);
  }
  void compare(const PatchView& view);
  std::int64_t candidates() const;
  double quotientOf(const std::optional<BestLine>& best) const;
  std::vector<double> storedParameters() const;
  bool loadViews(StateReader& reader);
  bool loadColumns(StateReader& reader);

  Parameters parameters_;
  std::optional<LineSearch> search_;
  std::int64_t images_ = 0;                  ///< number of images so far
  std::vector<std::int8_t> views_;           ///< all stored ones
  std::vector<std::int64_t> image_of_view_;  ///< number of the image of each view
  std::deque<std::vector<float>> columns_;   ///< of the last images, at most `sequence`
};

}  // namespace tolman::seqslam
