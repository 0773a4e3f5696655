// SPDX-License-Identifier: BSD-3-Clause
#include "report/raster.hpp"

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

namespace tolman::report {
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

Status failure(const char* reason) {
  return Status::failed(std::string("a figure cannot be drawn: ") + reason);
}

Status failure(GError* error) {
  const Owned<GError> owned(error);
  return failure(owned ? owned->message : "unknown reason");
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned size) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

/// The PNG file of a surface; empty if it cannot be encoded.
std::string encoded(cairo_surface_t* surface) {
  std::string bytes;
  if (cairo_surface_write_to_png_stream(surface, append, &bytes) != CAIRO_STATUS_SUCCESS) return "";
  return bytes;
}

struct Drawing {
  Owned<RsvgHandle> handle;
  double width = 0;  ///< units of the SVG
  double height = 0;
};

/// Failed if the text is not SVG, or if a side with `zoom` pixels per unit is too large.
Result<Drawing> drawingOf(const std::string& svg, double zoom) {
  GError* error = nullptr;
  const auto* data = reinterpret_cast<const guint8*>(svg.data());
  Drawing drawing{Owned<RsvgHandle>(rsvg_handle_new_from_data(data, svg.size(), &error))};
  if (!drawing.handle) return failure(error);
  const bool sized = rsvg_handle_get_intrinsic_size_in_pixels(drawing.handle.get(), &drawing.width,
                                                              &drawing.height) != 0;
  const auto fits = [&](double side) { return zoom * side >= 1 && zoom * side <= kLargestSide; };
  if (!sized || !fits(drawing.width) || !fits(drawing.height)) {
    return failure("its size is unfit");
  }
  return drawing;
}

Status draw(const Drawing& drawing, cairo_surface_t* surface, double zoom) {
  GError* error = nullptr;
  const Owned<cairo_t> context(cairo_create(surface));
  cairo_scale(context.get(), zoom, zoom);
  const RsvgRectangle whole{0, 0, drawing.width, drawing.height};
  if (rsvg_handle_render_document(drawing.handle.get(), context.get(), &whole, &error) == 0) {
    return failure(error);
  }
  return Status::ok();
}

}  // namespace

Result<std::string> pngOf(const std::string& svg, double zoom) {
  const auto drawing = drawingOf(svg, zoom);
  if (!drawing.isOk()) return drawing.status();
  const auto pixels = [&](double side) { return static_cast<int>(std::lround(zoom * side)); };
  const Owned<cairo_surface_t> surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, pixels(drawing.value().width), pixels(drawing.value().height)));
  if (Status drawn = draw(drawing.value(), surface.get(), zoom); !drawn.isOk()) return drawn;
  std::string bytes = encoded(surface.get());
  if (bytes.empty()) return Status::failed("a figure cannot be written as PNG");
  return bytes;
}

Result<std::string> pdfOf(const std::string& svg, double points) {
  const auto drawing = drawingOf(svg, points);
  if (!drawing.isOk()) return drawing.status();
  std::string bytes;
  const Owned<cairo_surface_t> surface(cairo_pdf_surface_create_for_stream(
      append, &bytes, points * drawing.value().width, points * drawing.value().height));
  // An empty date is left out of the file.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  if (Status drawn = draw(drawing.value(), surface.get(), points); !drawn.isOk()) return drawn;
  cairo_surface_finish(surface.get());
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return failure(cairo_status_to_string(cairo_surface_status(surface.get())));
  }
  return bytes;
}

std::string pngUrl(Pixels pixels) {
  const Owned<cairo_surface_t> surface(cairo_image_surface_create_for_data(
      reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_ARGB32,
      static_cast<int>(pixels.cols()), static_cast<int>(pixels.rows()),
      static_cast<int>(4 * pixels.cols())));
  const std::string bytes = encoded(surface.get());
  const std::unique_ptr<gchar, decltype(&g_free)> text(
      g_base64_encode(reinterpret_cast<const guchar*>(bytes.data()), bytes.size()), g_free);
  return std::string("data:image/png;base64,") + text.get();
}

}  // namespace tolman::report
