// SPDX-License-Identifier: BSD-3-Clause
#include "video_maker.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "tolman/image_cv.hpp"

namespace tolman::video {

cv::Mat flatPicture(int index, int width, int height) {
  return {height, width, CV_8UC1, cv::Scalar(10 + 4 * index)};
}

int numberOf(const Image& image) {
  if (image.empty()) return -1;
  return static_cast<int>(std::lround((cv::mean(asMat(image))[0] - 10) / 4));
}

void writeVideo(const std::filesystem::path& file, const std::string& codec, double rate,
                const std::vector<cv::Mat>& pictures) {
  const int code = cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]);
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, code, rate, pictures.front().size());
  REQUIRE(writer.isOpened());
  for (const cv::Mat& picture : pictures) {
    cv::Mat colour = picture;
    if (picture.channels() == 1) cv::cvtColor(picture, colour, cv::COLOR_GRAY2BGR);
    writer.write(colour);
  }
}

void writeFlatVideo(const std::filesystem::path& file, int count, double rate,
                    const std::string& codec) {
  std::vector<cv::Mat> pictures;
  for (int i = 0; i < count; ++i) pictures.push_back(flatPicture(i));
  writeVideo(file, codec, rate, pictures);
}

void cutFile(const std::filesystem::path& file, double part) {
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  std::filesystem::resize_file(file, static_cast<std::uintmax_t>(size * part));
}

namespace {

ParameterValues withPath(const std::filesystem::path& path, ParameterValues values) {
  values["path"] = path.string();
  return values;
}

}  // namespace

Played::Played(const std::filesystem::path& path, ParameterValues values)
    : context(withPath(path, std::move(values))) {
  Status status = source.configure(context);
  if (status.isOk()) status = source.info(info);
  while (status.isOk()) {
    Frame frame;
    status = source.next(frame);
    if (status.isOk()) frames.push_back(frame);
  }
  if (status.code() != StatusCode::EndOfStream) message = status.message();
  const std::string folder = path.parent_path().string();
  for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
    message.erase(at, folder.size() + 1);
  }
}

std::vector<int> Played::numbers() const {
  std::vector<int> numbers;
  for (const Frame& frame : frames) numbers.push_back(numberOf(frame.left));
  return numbers;
}

std::vector<std::int64_t> Played::stamps() const {
  std::vector<std::int64_t> stamps;
  for (const Frame& frame : frames) stamps.push_back(frame.stamp_ns);
  return stamps;
}

}  // namespace tolman::video
