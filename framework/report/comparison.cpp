// SPDX-License-Identifier: BSD-3-Clause
#include "report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "report/svg.hpp"

namespace tolman::report {
namespace {

constexpr double kHeight = 480;
constexpr double kTitle = 28;
constexpr double kGap = 12;

struct Drawing {
  double width = 0;
  double height = 0;
  std::string body;  ///< what stands between <svg ...> and </svg>
};

/// Takes one of our own pictures apart; their view boxes begin at the origin.
std::optional<Drawing> parse(const std::string& svg) {
  const std::size_t box = svg.find("viewBox=\"0 0 ");
  const std::size_t begin = svg.find('>', box);
  const std::size_t end = svg.rfind("</svg>");
  if (box == std::string::npos || begin == std::string::npos || end == std::string::npos) {
    return std::nullopt;
  }
  Drawing drawing;
  const int read =
      std::sscanf(svg.c_str() + box, "viewBox=\"0 0 %lf %lf\"", &drawing.width, &drawing.height);
  if (read != 2 || !(drawing.width > 0) || !(drawing.height > 0)) return std::nullopt;
  drawing.body = svg.substr(begin + 1, end - begin - 1);
  return drawing;
}

}  // namespace

std::optional<std::string> sideBySide(const std::vector<RunPage>& runs, std::string_view file) {
  std::string panels;
  double x = 0;
  int count = 0;
  for (const RunPage& run : runs) {
    const auto figure = std::ranges::find(run.figures, file, &Figure::file);
    if (figure == run.figures.end()) continue;
    const std::optional<Drawing> drawing = parse(figure->svg);
    if (!drawing) continue;
    const double width = drawing->width * kHeight / drawing->height;
    const char letter = static_cast<char>('A' + count % 26);
    panels += fmt::format(
        "<text x=\"{:.1f}\" y=\"20\" font-size=\"16\"><tspan font-weight=\"bold\">{}</tspan> "
        "{}</text>\n<svg x=\"{:.1f}\" y=\"{:.0f}\" width=\"{:.1f}\" height=\"{:.0f}\" "
        "viewBox=\"0 0 {:g} {:g}\">{}</svg>\n",
        x + kGap, letter, escaped(run.directory), x, kTitle, width, kHeight, drawing->width,
        drawing->height, drawing->body);
    x += width + kGap;
    ++count;
  }
  if (count < 2) return std::nullopt;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
      x, kHeight + kTitle, panels);
}

}  // namespace tolman::report
