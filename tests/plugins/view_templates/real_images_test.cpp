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

TEST_CASE("KITTI 06 forwards, then backwards: the way back is familiar") {
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

TEST_CASE("a corridor walked twice: most matches across the laps are true") {
  const auto folder = tolman::test::dataOrSkip("places_two_laps");
  if (!folder) return;
  std::set<std::pair<std::int64_t, std::int64_t>> truth;
  std::ifstream pairs(*folder / "true_pairs.csv");
  std::string line;
  std::getline(pairs, line);
  for (std::int64_t query = 0, match = 0; pairs >> query && pairs.ignore() && pairs >> match;) {
    truth.insert({query, match});
  }
  // The threshold was fitted to these very images: this guards against a change, it proves nothing.
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {{"columns", std::int64_t{32}},
                             {"rows", std::int64_t{24}},
                             {"crop_x_min", 0.0},
                             {"crop_x_max", 1.0},
                             {"crop_y_min", 0.0},
                             {"crop_y_max", 1.0},
                             {"patch_radius", std::int64_t{4}},
                             {"normalisation", 0.0},
                             {"threshold", 0.09}})
              .isOk());
  std::vector<std::int64_t> made_at;
  int hits = 0;
  int misses = 0;
  std::int64_t frame = 0;
  for (const Image& image : imagesIn(*folder / "images")) {
    const PlaceObservation seen = observe(plugin, image, frame);
    if (seen.recognition == Recognition::Novel) made_at.push_back(frame);
    const std::int64_t match = made_at[static_cast<std::size_t>(seen.template_id)];
    if (seen.recognition == Recognition::Familiar && frame - match > 20) {
      (truth.count({frame, match}) != 0 ? hits : misses) += 1;
    }
    ++frame;
  }
  WARN("corridor: " << made_at.size() << " templates, " << hits << " true and " << misses
                    << " false matches across laps");
  CHECK(hits >= 5);
  CHECK(hits > 2 * misses);
}
