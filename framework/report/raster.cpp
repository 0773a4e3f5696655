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
  std::string bytes;
  const cairo_status_t written = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  if (written != CAIRO_STATUS_SUCCESS) {
    return Status::failed(std::string("a figure cannot be written as PNG: ") +
                          cairo_status_to_string(written));
  }
  return bytes;
}

}  // namespace tolman::report
