// SPDX-License-Identifier: BSD-3-Clause
// Sanity on real images: a street driven forwards and backwards, a corridor walked twice.
#include <catch2/catch.hpp>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "harness.hpp"
#include "support/data.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

std::vector<Image> imagesIn(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path());
  std::vector<Image> images;
  for (const auto& file : files) {
    images.push_back(asImage(cv::imread(file.string(), cv::IMREAD_GRAYSCALE)));
  }
  return images;
}

}  // namespace

TEST_CASE("KITTI 06 forwards, then backwards: the way back is familiar", "[data]") {
  const auto folder = tolman::test::dataOrSkip("kitti_clips/06/image_0");
  if (!folder) return;
  const std::vector<Image> images = imagesIn(*folder);
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {}).isOk());
  std::vector<std::int64_t> there;
  for (const Image& image : images) there.push_back(observe(plugin, image).template_id);
  const std::int64_t templates = *std::max_element(there.begin(), there.end()) + 1;
  std::size_t same = 0;
  for (std::size_t i = images.size(); i-- > 0;) {
    const PlaceObservation seen = observe(plugin, images[i]);
    CHECK(seen.recognition == Recognition::Familiar);
    // A view matches the nearest template, which may have been made later than on the way there.
    same += std::abs(seen.template_id - there[i]) <= 1 ? 1 : 0;
    CHECK(std::abs(seen.relative_yaw) < 0.15);
  }
  WARN("KITTI 06 clip: " << templates << " templates of " << images.size() << " frames, " << same
                         << " recognised within one template on the way back");
  CHECK(templates > 3);
  CHECK(templates < 51);
  CHECK(same >= 48);
}

namespace {

using Pairs = std::set<std::pair<std::int64_t, std::int64_t>>;

Pairs truePairs(const std::filesystem::path& file) {
  Pairs truth;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  for (std::int64_t query = 0, match = 0; stream >> query && stream.ignore() && stream >> match;) {
    truth.insert({query, match});
  }
  return truth;
}

struct Score {
  double precision = 1;  ///< of the claims over more than 20 images
  double recall = 0;     ///< of the queries that have a true pair
};

Score scoreOf(const std::vector<Image>& images, const Pairs& truth, ParameterValues parameters) {
  ViewTemplates plugin;
  parameters.try_emplace("crop", std::vector<double>{0, 1, 0, 1});
  REQUIRE(configure(plugin, parameters).isOk());
  std::set<std::int64_t> queries;
  for (const auto& pair : truth) queries.insert(pair.first);
  std::vector<std::int64_t> made_at;
  int right = 0;
  int claims = 0;
  std::int64_t frame = 0;
  for (const Image& image : images) {
    const PlaceObservation seen = observe(plugin, image, frame);
    if (seen.recognition == Recognition::Novel) made_at.push_back(frame);
    const std::int64_t match = made_at[static_cast<std::size_t>(seen.template_id)];
    if (seen.recognition == Recognition::Familiar && frame - match > 20) {
      ++claims;
      right += truth.count({frame, match}) != 0 ? 1 : 0;
    }
    ++frame;
  }
  return {claims > 0 ? static_cast<double>(right) / claims : 1.0,
          static_cast<double>(right) / static_cast<double>(queries.size())};
}

}  // namespace

// `tolman bench places --figure` draws whole curves. The floors stand well below them.
TEST_CASE("a corridor walked twice: gradients recognise half of it without an error, grey a part",
          "[data]") {
  const auto folder = tolman::test::dataOrSkip("places_two_laps");
  if (!folder) return;
  const Pairs truth = truePairs(*folder / "true_pairs.csv");
  const std::vector<Image> images = imagesIn(*folder / "images");
  const ParameterValues gradients = {{"cells", std::string("gradients")},
                                     {"columns", std::int64_t{16}},
                                     {"rows", std::int64_t{12}},
                                     {"shift", std::int64_t{3}},
                                     {"vertical_shift", std::int64_t{1}}};
  const auto at = [&](ParameterValues parameters, double threshold) {
    parameters["threshold"] = threshold;
    const Score score = scoreOf(images, truth, parameters);
    WARN("corridor, threshold " << threshold << ": precision " << score.precision << ", recall "
                                << score.recall);
    return score;
  };
  const Score careful = at(gradients, 0.13);
  CHECK(careful.precision >= 0.95);
  CHECK(careful.recall >= 0.4);
  const Score bold = at(gradients, 0.16);
  CHECK(bold.precision >= 0.7);
  CHECK(bold.recall >= 0.6);
  const Score grey = at({}, 0.07);
  CHECK(grey.precision >= 0.7);
  CHECK(grey.recall >= 0.3);
}
