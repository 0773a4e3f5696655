// SPDX-License-Identifier: BSD-3-Clause
#include "report/raster.hpp"

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

Status failure(GError* error) {
  const Owned<GError> owned(error);
  return Status::failed(std::string("a figure cannot be drawn as PNG: ") +
                        (owned ? owned->message : "unknown reason"));
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned size) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

/// Empty where it cannot be encoded.
std::string encoded(cairo_surface_t* surface) {
  std::string bytes;
  if (cairo_surface_write_to_png_stream(surface, append, &bytes) != CAIRO_STATUS_SUCCESS) return "";
  return bytes;
}

}  // namespace

Result<std::string> pngOf(const std::string& svg, double zoom) {
  GError* error = nullptr;
  const auto* data = reinterpret_cast<const guint8*>(svg.data());
  const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(data, svg.size(), &error));
  if (!handle) return failure(error);
  double width = 0;
  double height = 0;
  const bool sized = rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) != 0;
  if (!sized || !(zoom * width >= 1 && zoom * width <= kLargestSide) ||
      !(zoom * height >= 1 && zoom * height <= kLargestSide)) {
    return Status::failed("a figure cannot be drawn as PNG: its size is unfit");
  }
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(zoom * width)),
                                 static_cast<int>(std::lround(zoom * height))));
  const Owned<cairo_t> context(cairo_create(surface.get()));
  cairo_scale(context.get(), zoom, zoom);
  const RsvgRectangle whole{0, 0, width, height};
  if (rsvg_handle_render_document(handle.get(), context.get(), &whole, &error) == 0) {
    return failure(error);
  }
  std::string bytes = encoded(surface.get());
  if (bytes.empty()) return Status::failed("a figure cannot be written as PNG");
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
