// SPDX-License-Identifier: BSD-3-Clause
#include "bloom.hpp"

#include <catch2/catch.hpp>

using namespace tolman::town;

namespace {

constexpr int kSide = 201;
constexpr std::size_t kMiddle = kSide * (kSide / 2) + kSide / 2;

std::vector<float> spot(float radiance) {
  std::vector<float> image(kSide * kSide, 0.25F);
  image[kMiddle] = radiance;
  return image;
}

double total(const std::vector<float>& image) {
  double sum = 0;
  for (const float value : image) sum += static_cast<double>(value);
  return sum;
}

}  // namespace

TEST_CASE("below saturation nothing blooms") {
  std::vector<float> image = spot(0.9F);
  addBloom(image, kSide, kSide, 1, 0.5F, 1);
  CHECK(image == spot(0.9F));
}

TEST_CASE("the share of the excess goes to the pixels around, less with distance") {
  std::vector<float> image = spot(51);
  addBloom(image, kSide, kSide, 1, 0.1F, 1);
  CHECK(total(image) - total(spot(51)) == Approx(0.1 * 50).epsilon(0.01));
  CHECK(image[kMiddle + 2] > image[kMiddle + 6]);
  CHECK(image[kMiddle + 6] > image[kMiddle + 60]);
  CHECK(image[kMiddle + 60] > 0.25F);
  CHECK(image[kMiddle + 90] == 0.25F);
}

TEST_CASE("halos shrink with the image") {
  std::vector<float> image = spot(51);
  addBloom(image, kSide, kSide, 1, 0.1F, 0.25);
  CHECK(image[kMiddle + 15] > 0.25F);
  CHECK(image[kMiddle + 25] == 0.25F);
}
