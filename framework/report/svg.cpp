// SPDX-License-Identifier: BSD-3-Clause
#include "report/svg.hpp"

#include <cairo-pdf.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "base/must.hpp"
#include "config/text.hpp"

namespace tolman::report {

namespace {

std::uint32_t colourOf(double value) {
  static constexpr std::array<int, 9> kAnchors = {0x440154, 0x472c7a, 0x3b518b, 0x2c718e, 0x21908d,
                                                  0x27ad81, 0x5cc863, 0xaadc32, 0xfde725};
  const double place =
      std::clamp(std::isfinite(value) ? value : 0, 0.0, 1.0) * (kAnchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kAnchors.size() - 2);
  const double part = place - static_cast<double>(below);
  long colour = 0;
  for (const int shift : {16, 8, 0}) {
    const auto channel = [&](std::size_t i) { return kAnchors.at(i) >> shift & 0xff; };
    colour = colour << 8 | std::lround((1 - part) * channel(below) + part * channel(below + 1));
  }
  return static_cast<std::uint32_t>(colour);
}

std::string listOf(const std::vector<Eigen::Vector2d>& points) {
  std::string list;
  for (const auto& p : points) list += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
  return list;
}

/// Without points that look like the one before: a long run has hundreds of them in a pixel.
std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& points) {
  constexpr double kVisible = 0.2;  // px
  std::vector<Eigen::Vector2d> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_end = i + 1 == points.size();
    if (kept.empty() || is_end || (points[i] - kept.back()).norm() > kVisible) {
      kept.push_back(points[i]);
    }
  }
  return kept;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe = config::printable(text);
  for (const auto& [character, entity] : {std::pair("&", "&amp;"), std::pair("<", "&lt;"),
                                          std::pair(">", "&gt;"), std::pair("\"", "&quot;")}) {
    boost::replace_all(safe, character, entity);
  }
  return safe;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view colour,
               double thickness) {
  body_ += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
      "stroke-width=\"{:g}\"/>\n",
      from.x(), from.y(), to.x(), to.y(), colour, thickness);
}

void Svg::polyline(const std::vector<Eigen::Vector2d>& points, std::string_view colour,
                   double thickness) {
  body_ += fmt::format(
      "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" stroke-linejoin=\"round\" "
      "points=\"{}\"/>\n",
      colour, thickness, listOf(thinned(points)));
}

void Svg::area(const std::vector<Eigen::Vector2d>& border, std::string_view fill, double opacity) {
  body_ += fmt::format("<polygon fill=\"{}\" fill-opacity=\"{:g}\" points=\"{}\"/>\n", fill,
                       opacity, listOf(border));
}

void Svg::circle(const Eigen::Vector2d& centre, double radius, std::string_view fill,
                 std::string_view stroke) {
  body_ +=
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\" stroke=\"{}\"/>\n",
                  centre.x(), centre.y(), radius, fill, stroke);
}

void Svg::rectangle(const Eigen::Vector2d& corner, const Eigen::Vector2d& size,
                    std::string_view fill, std::string_view stroke) {
  body_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" "
      "stroke=\"{}\"/>\n",
      corner.x(), corner.y(), size.x(), size.y(), fill, stroke);
}

void Svg::image(const Eigen::Vector2d& corner, const Eigen::Vector2d& size, std::string_view url) {
  body_ += fmt::format(
      "<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
      "preserveAspectRatio=\"none\" "
      "image-rendering=\"optimizeSpeed\" href=\"{}\"/>\n",
      corner.x(), corner.y(), size.x(), size.y(), url);
}

void Svg::text(const Eigen::Vector2d& at, std::string_view text, const TextStyle& style) {
  const char* anchor = style.anchor == TextAnchor::Start    ? "start"
                       : style.anchor == TextAnchor::Middle ? "middle"
                                                            : "end";
  const std::string turn = style.turned_deg == 0
                               ? ""
                               : fmt::format(" transform=\"rotate({:g} {:.1f} {:.1f})\"",
                                             style.turned_deg, at.x(), at.y());
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{:g}\"{}{}>{}</text>\n",
      at.x(), at.y(), anchor, style.size, style.bold ? " font-weight=\"bold\"" : "", turn,
      escaped(text));
}

std::string Svg::take() const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
             "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"{2}\"/>\n",
             width_, height_, kPaper) +
         body_ + "</svg>\n";
}

std::string rateColour(double value) { return fmt::format("#{:06x}", colourOf(value)); }

Pixels ratePixels(const Eigen::MatrixXd& rates, double most) {
  constexpr double kLevels = 32;  // few colours make the file small
  const auto pixel = [&](double rate) {
    if (std::isnan(rate)) return 0U;
    return 0xff000000 | colourOf(std::round(kLevels * rate / std::max(most, 1e-12)) / kLevels);
  };
  return rates.transpose().colwise().reverse().unaryExpr(pixel);
}

void colourBar(Svg& svg, const Eigen::Vector2d& middle, std::string_view low,
               std::string_view high) {
  constexpr int kSteps = 24;
  const Eigen::Vector2d cell(4, 9);
  const double left = middle.x() - kSteps * cell.x() / 2;
  for (int i = 0; i < kSteps; ++i) {
    svg.rectangle({left + i * cell.x(), middle.y() - cell.y() / 2}, cell,
                  rateColour(i / (kSteps - 1.0)));
  }
  svg.text({left - 6, middle.y() + 4}, low, {TextAnchor::End, 11});
  svg.text({left + kSteps * cell.x() + 6, middle.y() + 4}, high, {TextAnchor::Start, 11});
}

namespace {

constexpr double kLargestSide = 16384;  // px; 1 GiB of pixels

struct Release {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(GError* error) const { g_error_free(error); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

[[noreturn]] void refuse(const char* reason) {
  throw Refused{Status::failed(std::string("a figure cannot be drawn: ") + reason)};
}

void check(bool is_done, GError* error) {
  const Owned<GError> owned(error);
  if (!is_done) refuse(owned ? owned->message : "unknown reason");
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned size) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

/// The file of an SVG with `zoom` pixels or points per unit.
std::string drawn(const std::string& svg, double zoom, bool as_pdf) {
  GError* error = nullptr;
  const auto* data = reinterpret_cast<const guint8*>(svg.data());
  const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(data, svg.size(), &error));
  check(handle != nullptr, error);
  RsvgRectangle whole{0, 0, 0, 0};
  const bool sized =
      rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &whole.width, &whole.height) != 0;
  const auto fits = [&](double side) { return zoom * side >= 1 && zoom * side <= kLargestSide; };
  if (!sized || !fits(whole.width) || !fits(whole.height)) refuse("its size is unfit");
  std::string bytes;
  const auto pixels = [&](double side) { return static_cast<int>(std::lround(zoom * side)); };
  const Owned<cairo_surface_t> surface(
      as_pdf ? cairo_pdf_surface_create_for_stream(append, &bytes, zoom * whole.width,
                                                   zoom * whole.height)
             : cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(whole.width),
                                          pixels(whole.height)));
  // An empty date is left out of the file.
  if (as_pdf) cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  {
    const Owned<cairo_t> context(cairo_create(surface.get()));
    cairo_scale(context.get(), zoom, zoom);
    const bool is_done =
        rsvg_handle_render_document(handle.get(), context.get(), &whole, &error) != 0;
    check(is_done, error);
  }
  const cairo_status_t written =
      as_pdf ? CAIRO_STATUS_SUCCESS
             : cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  check(written == CAIRO_STATUS_SUCCESS, nullptr);
  cairo_surface_finish(surface.get());
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    refuse(cairo_status_to_string(cairo_surface_status(surface.get())));
  }
  return bytes;
}

}  // namespace

Result<std::string> pngOf(const std::string& svg, double zoom) {
  return resultOf([&] { return drawn(svg, zoom, false); });
}

Result<std::string> pdfOf(const std::string& svg, double points) {
  return resultOf([&] { return drawn(svg, points, true); });
}

std::string pngUrl(Pixels pixels) {
  const Owned<cairo_surface_t> surface(cairo_image_surface_create_for_data(
      reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_ARGB32,
      static_cast<int>(pixels.cols()), static_cast<int>(pixels.rows()),
      static_cast<int>(4 * pixels.cols())));
  std::string bytes;
  cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  const std::unique_ptr<gchar, decltype(&g_free)> text(
      g_base64_encode(reinterpret_cast<const guchar*>(bytes.data()), bytes.size()), g_free);
  return std::string("data:image/png;base64,") + text.get();
}

}  // namespace tolman::report
