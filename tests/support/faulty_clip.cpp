// SPDX-License-Identifier: BSD-3-Clause
#include "support/faulty_clip.hpp"

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace tolman::test {
namespace {

namespace fs = std::filesystem;
using Images = std::vector<cv::Mat>;

std::string fileName(std::size_t index) {
  char name[16];
  std::snprintf(name, sizeof(name), "%06d.png", static_cast<int>(index));
  return name;
}

/// Changes each affected image of both cameras.
template <class Change>
auto each(Change change) {
  return [change](StereoClip& clip, int first, int last) {
    for (int i = first; i <= last; ++i) {
      for (Images* images : {&clip.left, &clip.right}) {
        cv::Mat& image = (*images)[static_cast<std::size_t>(i)];
        image = image.clone();
        change(image, i);
      }
    }
  };
}

/// Replaces each affected right image by a function of the clip and the index.
template <class Make>
auto right(Make make) {
  return [make](StereoClip& clip, int first, int last) {
    const StereoClip original = clip;
    for (int i = first; i <= last; ++i) {
      clip.right[static_cast<std::size_t>(i)] = make(original, static_cast<std::size_t>(i));
    }
  };
}

void freeze(Images& images, int first, int last) {
  for (int i = first; i <= last; ++i) {
    images[static_cast<std::size_t>(i)] = images[static_cast<std::size_t>(first - 1)];
  }
}

cv::Mat lowered(const cv::Mat& image, double pixels) {
  const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, 0, 0, 1, pixels);
  cv::Mat low;
  cv::warpAffine(image, low, shift, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return low;
}

/// A dark side of a lorry that moves through the view from right to left.
void lorry(cv::Mat& image, int index) {
  const int left = image.cols * (30 - index) / 20;
  const cv::Rect side(left, image.rows / 10, image.cols * 3 / 4, image.rows * 8 / 10);
  cv::Mat view = image(side & cv::Rect({}, image.size()));
  for (int r = 0; r < view.rows; ++r) {
    const double ripple = 8 * ((r / 9) % 2);
    view.row(r).setTo(60 + ripple);
  }
}

void noise(cv::Mat& image, int index) {
  cv::RNG random(static_cast<std::uint64_t>(index) * 977 + image.at<unsigned char>(50, 50));
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
}

}  // namespace

StereoClip readClip(const fs::path& folder, int frames) {
  StereoClip clip;
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
    const auto read = [&](const char* camera) {
      return cv::imread((folder / camera / fileName(i)).string(), cv::IMREAD_GRAYSCALE);
    };
    clip.left.push_back(read("image_0"));
    clip.right.push_back(read("image_1"));
  }
  return clip;
}

void writeClip(const StereoClip& clip, const fs::path& original, const fs::path& folder) {
  for (const auto& [camera, images] :
       {std::pair{"image_0", &clip.left}, std::pair{"image_1", &clip.right}}) {
    fs::create_directories(folder / camera);
    for (std::size_t i = 0; i < images->size(); ++i) {
      cv::imwrite((folder / camera / fileName(i)).string(), (*images)[i],
                  {cv::IMWRITE_PNG_COMPRESSION, 1});
    }
  }
  for (const char* file : {"calib.txt", "times.txt", "poses.txt"}) {
    if (fs::exists(original / file)) fs::copy_file(original / file, folder / file);
  }
}

std::vector<CameraFault> cameraFaults() {
  return {
      {"none", [](StereoClip&, int, int) {}},
      {"both frozen",
       [](StereoClip& clip, int first, int last) {
         freeze(clip.left, first, last);
         freeze(clip.right, first, last);
       }},
      {"right frozen",
       [](StereoClip& clip, int first, int last) { freeze(clip.right, first, last); }},
      {"right late", right([](const StereoClip& c, std::size_t i) { return c.right[i - 1]; })},
      {"right equals left", right([](const StereoClip& c, std::size_t i) { return c.left[i]; })},
      {"right low",
       right([](const StereoClip& c, std::size_t i) { return lowered(c.right[i], 3); })},
      {"right covered",
       right([](const StereoClip& c, std::size_t i) { return cv::Mat(0 * c.right[i]); })},
      {"exchanged",
       [](StereoClip& clip, int first, int last) {
         for (int i = first; i <= last; ++i) {
           std::swap(clip.left[static_cast<std::size_t>(i)],
                     clip.right[static_cast<std::size_t>(i)]);
         }
       }},
      {"black", each([](cv::Mat& image, int) { image.setTo(0); })},
      {"noise", each(noise)},
      {"blurred", each([](cv::Mat& image, int) { cv::GaussianBlur(image, image, {}, 8); })},
      {"dark", each([](cv::Mat& image, int) { image *= 0.15; })},
      {"bright", each([](cv::Mat& image, int) { image *= 1.7; })},
      {"lorry", each(lorry)},
  };
}

}  // namespace tolman::test
