#include "hullgen/drawing/svg_pdf.h"

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>

#include <memory>

#include "base/errors.h"

namespace icebow {
namespace {

constexpr double points_per_pixel = 72.0 / 96.0;

template <class T, class Free>
std::unique_ptr<T, Free> owned(T* thing, Free free) {
  return {thing, free};
}

[[noreturn]] void fail(const std::string& path, GError* error) {
  const std::string words = error ? error->message : "the drawing cannot be read";
  if (error) g_error_free(error);
  throw RuntimeError(path + ": " + words);
}

}  // namespace

std::string why_no_pdf() {
  return "";
}

void write_pdf(const std::string& path, const std::string& svg, const std::string& title) {
  GError* error = nullptr;
  const auto drawing =
      owned(rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error),
            g_object_unref);
  if (!drawing) fail(path, error);
  RsvgRectangle page{0.0, 0.0, 0.0, 0.0};
  if (!rsvg_handle_get_intrinsic_size_in_pixels(drawing.get(), &page.width, &page.height))
    fail(path, nullptr);
  const auto surface = owned(
      cairo_pdf_surface_create(path.c_str(), points_per_pixel * page.width, points_per_pixel * page.height),
      cairo_surface_destroy);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  const auto pen = owned(cairo_create(surface.get()), cairo_destroy);
  cairo_scale(pen.get(), points_per_pixel, points_per_pixel);
  if (!rsvg_handle_render_document(drawing.get(), pen.get(), &page, &error)) fail(path, error);
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) throw RuntimeError(path + ": " + cairo_status_to_string(status));
}

// For plugin_function().
extern "C" void icebow_write_pdf(const std::string& path, const std::string& svg, const std::string& title) {
  write_pdf(path, svg, title);
}

}  // namespace icebow
