// SPDX-License-Identifier: BSD-3-Clause
// Place recognition by histograms of oriented gradients (Dalal and Triggs, CVPR 2005). A view is
// described by the directions of edges in each field of the image, which depend little on lighting.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tolman/plugin.hpp>
#include <vector>

namespace {

using Descriptor = std::vector<float>;

class HogPlaces : public tolman::Place {
 public:
  struct Parameters {
    int columns = 10;
    int rows = 4;
    int orientations = 9;
    double threshold = 0.02;
    static constexpr auto declaration() {
      return tolman::parameters(
          tolman::parameter("columns", &Parameters::columns)
              .range(1, 100)
              .unit("fields")
              .doc("Fields of the image from left to right."),
          tolman::parameter("rows", &Parameters::rows)
              .range(1, 100)
              .unit("fields")
              .doc("Fields of the image from top to bottom."),
          tolman::parameter("orientations", &Parameters::orientations)
              .range(2, 36)
              .doc("Bins of the half circle of edge directions."),
          tolman::parameter("threshold", &Parameters::threshold)
              .range(0, 1)
              .doc("Largest distance of a match: 1 minus the cosine of two descriptors."));
    }
  };

  tolman::Status configure(const tolman::Context& context) override {
    const auto bound = tolman::bindParameters<Parameters>(context.parameters);
    if (!bound.isOk()) return bound.status();
    parameters_ = bound.value();
    return reset();
  }

  tolman::Status reset() override {
    templates_.clear();
    return tolman::Status::ok();
  }

  tolman::Status observe(const tolman::Frame& frame, const tolman::Motion*,
                         tolman::PlaceObservation& observation) override {
    observation.frame = frame.frame;
    observation.stamp_ns = frame.stamp_ns;
    if (frame.left.empty()) return tolman::Status::ok();  // no image, no place
    Descriptor view = describe(frame.left);
    std::size_t nearest = 0;
    double best = 2;
    for (std::size_t i = 0; i < templates_.size(); ++i) {
      const double distance =
          1 - std::inner_product(view.begin(), view.end(), templates_[i].begin(), 0.0);
      if (distance < best) {
        best = distance;
        nearest = i;
      }
    }
    const bool familiar = best <= parameters_.threshold;
    observation.recognition = familiar ? tolman::Recognition::Familiar : tolman::Recognition::Novel;
    observation.template_id = static_cast<std::int64_t>(familiar ? nearest : templates_.size());
    observation.score = familiar ? best : 0;
    if (!familiar) templates_.push_back(std::move(view));
    return tolman::Status::ok();
  }

 private:
  static float grey(const tolman::Image& image, int column, int row) {
    if (image.format() == tolman::PixelFormat::Gray8) return image.row(row)[column];
    const std::uint8_t* const bgr = image.row(row) + 3 * column;
    return 0.114F * bgr[0] + 0.587F * bgr[1] + 0.299F * bgr[2];
  }

  /// The gradient of each pixel is added to the direction histogram of its field, shared between
  /// the two nearest bins.
  Descriptor describe(const tolman::Image& image) const {
    const int bins = parameters_.orientations;
    Descriptor votes(static_cast<std::size_t>(parameters_.columns * parameters_.rows * bins));
    for (int r = 1; r + 1 < image.height(); ++r) {
      for (int c = 1; c + 1 < image.width(); ++c) {
        const float dx = grey(image, c + 1, r) - grey(image, c - 1, r);
        const float dy = grey(image, c, r + 1) - grey(image, c, r - 1);
        const double half_circle = std::atan2(dy, dx) / std::numbers::pi;  // without the sign
        const double place = tolman::wrapPeriod(half_circle * bins, bins);
        const int bin = static_cast<int>(place);
        const auto share = static_cast<float>(place - bin);
        const int field = r * parameters_.rows / image.height() * parameters_.columns +
                          c * parameters_.columns / image.width();
        float* const histogram = votes.data() + field * bins;
        const float weight = std::hypot(dx, dy);
        histogram[bin] += (1 - share) * weight;
        histogram[(bin + 1) % bins] += share * weight;
      }
    }
    normalise(votes, static_cast<std::size_t>(bins));
    return votes;
  }

  /// Normalises each field to length 1, clips it at 0.2 (as in the paper, against single strong
  /// edges), and normalises the whole to length 1.
  static void normalise(Descriptor& votes, std::size_t bins) {
    const auto scale = [&](std::size_t first, std::size_t count, float floor) {
      float squares = floor;
      for (std::size_t i = first; i < first + count; ++i) squares += votes[i] * votes[i];
      for (std::size_t i = first; i < first + count; ++i) votes[i] /= std::sqrt(squares);
    };
    for (std::size_t field = 0; field < votes.size(); field += bins) scale(field, bins, 1);
    for (float& vote : votes) vote = std::min(vote, 0.2F);
    scale(0, votes.size(), 1e-6F);
  }

  Parameters parameters_;
  std::vector<Descriptor> templates_;
};

}  // namespace

TOLMAN_PLUGIN(hog_places, HogPlaces, "0.1.0",
              "Place recognition by histograms of oriented gradients.");
