// SPDX-License-Identifier: BSD-3-Clause
// camera.txt of TUM's monocular sets and of DSO: "[MODEL] fx fy cx cy coefficients" in the first
// line, width and height of the images in the second. Later lines state how that program would
// rectify, which is the host's work here.
#include "base/text_file.hpp"
#include "calibration_cameras.hpp"

namespace tolman::camera_files {
namespace {

using text_encoding::TextLine;

/// The word before the numbers; empty if there is none.
std::string_view wordOf(const TextLine& line) {
  const std::string_view first = text_encoding::splitFields(line.text).front();
  return text_encoding::parseNumber(first) ? "" : first;
}

/// The numbers behind wordOf().
std::vector<double> numbersOf(const TextLine& line) {
  std::vector<double> numbers;
  std::vector<std::string_view> fields = text_encoding::splitFields(line.text);
  if (!wordOf(line).empty()) fields.erase(fields.begin());
  for (const std::string_view field : fields) numbers.push_back(numberOf(field, line.number));
  return numbers;
}

/// Without a word it is that of a field of view, as the sets have it.
std::string_view modelOf(const TextLine& line) {
  const std::string_view word = wordOf(line);
  return word.empty() ? "FOV" : word;
}

bool isModel(std::string_view name) {
  return name == "FOV" || name == "Pinhole" || name == "RadTan" || name == "EquiDistant" ||
         name == "KannalaBrandt";
}

/// Shares of the image's size become pixels; its left edge is at -0.5.
Pinhole inPixels(const std::vector<double>& k, int width, int height) {
  if (!(k[2] < 1 && k[3] < 1)) return {k[0], k[1], k[2], k[3]};
  return {k[0] * width, k[1] * height, k[2] * width - 0.5, k[3] * height - 0.5};
}

void setModel(std::string_view model, std::span<const double> coefficients, int line,
              RawCamera& camera) {
  Status status;
  if (model == "RadTan" || model == "EquiDistant" || model == "KannalaBrandt") {
    status = source_parameters::setLens(model == "RadTan" ? "radtan" : "equidistant", coefficients,
                                        camera);
  } else if (model == "FOV" && !coefficients.empty() && coefficients[0] != 0) {
    const std::optional<RadiusByAngle> lens = roundLens("fov", coefficients);
    if (!lens) throw FileError(line, "needs one angle w of the field of view, above 0; correct it");
    status = setRoundLens(*lens, camera);
  }
  if (!status.isOk()) throw FileError(line, status.message());
}

}  // namespace

bool isLineCalibration(std::string_view text) {
  const std::vector<TextLine> lines = text_encoding::contentLines(text.substr(0, 4096));
  if (lines.size() < 2 || !isModel(modelOf(lines[0]))) return false;
  const std::size_t fields = text_encoding::splitFields(lines[0].text).size();
  return fields >= 5 && fields <= 9 && text_encoding::splitFields(lines[1].text).size() == 2;
}

FileCameras lineCameras(std::string_view text) {
  const std::vector<TextLine> lines = text_encoding::contentLines(text);
  const std::string_view model = modelOf(lines[0]);
  const std::vector<double> k = numbersOf(lines[0]);
  const std::vector<double> size = numbersOf(lines[1]);
  if (k.size() < 4) throw FileError(lines[0].number, "needs fx fy cx cy; complete it");
  FileCamera found;
  found.line = lines[0].number;
  RawCamera& camera = found.camera;
  camera.width = sizeOf(size[0], lines[1].number);
  camera.height = sizeOf(size[1], lines[1].number);
  camera.pinhole = inPixels(k, camera.width, camera.height);
  setModel(model, std::span(k).subspan(4), lines[0].number, camera);
  FileCameras all;
  all.cameras.push_back(found);
  return all;
}

}  // namespace tolman::camera_files
