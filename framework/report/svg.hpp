// SPDX-License-Identifier: BSD-3-Clause
// Writes a picture of lines, shapes, text and pixels as SVG. Coordinates are pixels, x right, y
// down. Colours of rates are viridis (S. van der Walt and N. Smith, 2015), interpolated between
// nine of its colours: perceptually uniform, also with colour blindness.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::report {

// The palette of Okabe and Ito (2008), distinguishable with colour blindness.
inline constexpr const char* kGrey = "#999999";
inline constexpr const char* kOrange = "#E69F00";
inline constexpr const char* kBlue = "#0072B2";
inline constexpr const char* kGreen = "#009E73";
inline constexpr const char* kVermilion = "#D55E00";
inline constexpr const char* kPurple = "#CC79A7";

/// Of the lines of a figure, in their order.
inline constexpr std::array kLineColours = {kBlue, kVermilion, kGreen, kOrange, kPurple, kGrey};
constexpr const char* lineColour(std::size_t i) { return kLineColours[i % kLineColours.size()]; }

inline constexpr const char* kPaper = "white";
inline constexpr const char* kFrameLine = "#444444";
inline constexpr const char* kGridLine = "#e6e6e6";
inline constexpr const char* kFaintLine = "#bbbbbb";
inline constexpr const char* kPaleBlue = "#cfe3f1";

/// With entities for the special characters of XML, and U+FFFD for what cannot be printed.
std::string escaped(std::string_view text);

enum class TextAnchor : std::uint8_t { Start, Middle, End };

struct TextStyle {
  TextAnchor anchor = TextAnchor::Start;
  double size = 12;
  double turned_deg = 0;
  bool bold = false;
};

class Svg {
 public:
  Svg(double width, double height);
  double width() const { return width_; }
  double height() const { return height_; }
  void extendTo(double height) { height_ = std::max(height_, height); }

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view colour,
            double thickness = 1);
  void polyline(const std::vector<Eigen::Vector2d>& points, std::string_view colour,
                double thickness = 1.5);
  /// The inside of a closed line.
  void area(const std::vector<Eigen::Vector2d>& border, std::string_view fill, double opacity);
  void circle(const Eigen::Vector2d& centre, double radius, std::string_view fill,
              std::string_view stroke = "none");
  void rectangle(const Eigen::Vector2d& corner, const Eigen::Vector2d& size, std::string_view fill,
                 std::string_view stroke = "none");
  /// Draws a picture; `url` is from pngUrl().
  void image(const Eigen::Vector2d& corner, const Eigen::Vector2d& size, std::string_view url);
  void text(const Eigen::Vector2d& at, std::string_view text, const TextStyle& style = {});

  std::string take() const;

 private:
  double width_;
  double height_;
  std::string body_;
};

/// "#rrggbb" for a value in [0, 1]; values outside are clamped.
std::string rateColour(double value);

/// 0xaarrggbb, row by row from the top.
using Pixels = Eigen::Matrix<std::uint32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// The colours of rates (right, up): yellow for `most`; NaN is transparent.
Pixels ratePixels(const Eigen::MatrixXd& rates, double most);

/// The colours from 0 to 1 as a bar between two labels, centred at `middle`.
void colourBar(Svg& svg, const Eigen::Vector2d& middle, std::string_view low,
               std::string_view high);

// Figures and pixels as PNG, figures as PDF, with librsvg and cairo.

/// A PNG file with `zoom` pixels per unit. Failed if the text is not SVG, or too large.
Result<std::string> pngOf(const std::string& svg, double zoom = 2);

/// The bytes of a PDF file of one page, with `points` (1/72 inch) per unit of the SVG: lines and
/// text, no pixels. It has no date, so that the same figure gives the same bytes.
Result<std::string> pdfOf(const std::string& svg, double points = 0.7);

/// The URL of a picture within an SVG: "data:image/png;base64,...".
std::string pngUrl(Pixels pixels);

}  // namespace tolman::report
