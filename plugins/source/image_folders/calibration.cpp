// SPDX-License-Identifier: BSD-3-Clause
#include "calibration.hpp"

#include <cmath>
#include <map>
#include <string>

#include "projection.hpp"
#include "text_file.hpp"

namespace tolman::image_folders {

namespace {

using source_parameters::Projection;

/// A matrix and its line number.
struct Entry {
  Projection P = Projection::Zero();
  int line = 0;

  Pinhole pinhole() const { return source_parameters::pinholeOf(P); }
  Eigen::Vector3d offset() const { return source_parameters::offsetOf(P); }
};

std::string matrixName(int camera) { return {'P', static_cast<char>('0' + camera)}; }

/// Parses "P0: a b c ..."; false after an error.
bool parseMatrix(const std::filesystem::path& file, const TextLine& line, Entry& entry,
                 Inspection& inspection) {
  const auto fields = splitFields(line.text);
  if (fields.size() != 13) {
    inspection.error(file, line.number,
                     "has " + std::to_string(fields.size() - 1) +
                         " numbers; a projection matrix has 12, row by row");
    return false;
  }
  for (int i = 0; i < 12; ++i) {
    const std::string_view field = fields[static_cast<std::size_t>(i) + 1];
    const std::optional<double> number = parseNumber(field);
    if (!number) {
      inspection.error(file, line.number,
                       inQuotes(field) + " " + std::string(numberProblem(field)) + "; correct it");
      return false;
    }
    entry.P(i / 4, i % 4) = *number;
  }
  entry.line = line.number;
  return true;
}

/// The matrices by name; a matrix with an error is listed with line 0.
std::map<std::string, Entry> readMatrices(const std::filesystem::path& file,
                                          Inspection& inspection) {
  std::map<std::string, Entry> matrices;
  for (const TextLine& line : readLines(file, inspection)) {
    const std::size_t colon = line.text.find(':');
    if (colon == std::string::npos) {
      inspection.error(file, line.number, "is not of the form 'P0: 12 numbers'; correct it");
      continue;
    }
    const std::string name = line.text.substr(0, colon);
    if (name.size() != 2 || name[0] != 'P') continue;  // other calibration, such as "Tr"
    if (matrices.contains(name)) {
      inspection.error(file, line.number, name + " is given twice; remove one of the two lines");
      continue;
    }
    Entry entry;
    const bool good = parseMatrix(file, line, entry, inspection);
    matrices[name] = good ? entry : Entry{};
  }
  return matrices;
}

/// Whether P is K [I | t] without skew, with positive focal lengths and a camera on the same robot.
bool checkPinhole(const std::filesystem::path& file, const Entry& entry, Inspection& inspection) {
  const Projection& P = entry.P;
  if (P(0, 0) <= 0 || P(1, 1) <= 0) {
    inspection.error(file, entry.line,
                     "focal lengths are " + fixed(P(0, 0), 3) + " and " + fixed(P(1, 1), 3) +
                         " px; they must be positive");
    return false;
  }
  const bool rectified =
      P(0, 1) == 0 && P(1, 0) == 0 && P(2, 0) == 0 && P(2, 1) == 0 && P(2, 2) == 1;
  if (!rectified) {
    inspection.error(file, entry.line,
                     "is not the matrix of a rectified camera (fx 0 cx a 0 fy cy b 0 0 1 c); "
                     "rectify the images and give their matrix");
    return false;
  }
  constexpr double kFarthest = 1000;                                    // m
  const bool near = (entry.offset().array().abs() <= kFarthest).all();  // false for NaN as well
  if (!near) {
    inspection.error(file, entry.line,
                     "puts the camera more than 1000 m away from camera 0; the fourth numbers of "
                     "its rows are in px m");
  }
  return near;
}

/// Whether both cameras have the same pinhole and the right one is on the positive x axis.
bool checkPair(const std::filesystem::path& file, const Entry& left, const Entry& right,
               Inspection& inspection) {
  constexpr double kSameFocal = 1e-3;  // px
  constexpr double kMin = 1e-3;        // m
  constexpr double kMax = 5;           // m
  const Eigen::Vector3d t = left.offset() - right.offset();
  const std::string baseline = "baseline is " + fixed(t.x(), 4) + " m";
  std::string problem;
  if (!(left.P.leftCols<3>() - right.P.leftCols<3>()).isZero(kSameFocal)) {
    problem = "the two cameras have different focal lengths or centres; rectify the images";
  } else if (std::abs(t.x()) < kMin) {
    problem = baseline + ": both cameras are at one place; give -fx * baseline as the fourth " +
              "number of the right camera's matrix, or set mono: true";
  } else if (t.x() < 0) {
    problem = baseline + ": the right camera is left of the left one; swap the two image " +
              "folders, or change the sign of the fourth number";
  } else if (t.x() > kMax) {
    problem = baseline + ", more than 5 m; the fourth number must be -fx * baseline, in px m";
  } else if (!source_parameters::isBeside(t)) {
    problem = "the right camera is " + fixed(t.y(), 4) + " m below and " + fixed(t.z(), 4) +
              " m before the left one; rectify the images";
  }
  if (!problem.empty()) inspection.error(file, right.line, problem);
  return problem.empty();
}

}  // namespace

std::optional<Calibration> readKittiCalibration(const std::filesystem::path& file, int left,
                                                bool stereo, Inspection& inspection) {
  const std::size_t errors_before = inspection.findings().size();
  std::map<std::string, Entry> matrices = readMatrices(file, inspection);
  const bool file_is_good = inspection.findings().size() == errors_before;
  bool good = file_is_good;
  for (int camera = left; camera <= left + (stereo ? 1 : 0); ++camera) {
    const std::string name = matrixName(camera);
    const auto found = matrices.find(name);
    if (found == matrices.end() && file_is_good) {
      inspection.error(
          file, "has no " + name + "; add it" + (camera > left ? ", or set mono: true" : ""));
    }
    good = found != matrices.end() && found->second.line > 0 &&
           checkPinhole(file, found->second, inspection) && good;
  }
  if (!good) return std::nullopt;
  const Entry& first = matrices[matrixName(left)];
  Calibration calibration{first.pinhole(), 0, first.offset()};
  if (stereo) {
    const Entry& second = matrices[matrixName(left + 1)];
    if (!checkPair(file, first, second, inspection)) return std::nullopt;
    calibration.baseline = (first.offset() - second.offset()).x();
  }
  return calibration;
}

}  // namespace tolman::image_folders
