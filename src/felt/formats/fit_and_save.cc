#include "felt/formats/fit_and_save.h"

#include "felt/formats/drawing_writer.h"
#include "felt/io/drawing_builder.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt {

Result<Stroke> fit_stroke(std::span<const InkSample> samples, const InkFitOptions& options) {
  InkFitter fitter(options);
  fitter.begin();
  for (const InkSample& sample : samples) fitter.push(sample);
  fitter.end();
  fitter.refine();
  return fitter.stroke();
}

Result<void> save_strokes(const std::string& path, std::span<const Stroke> strokes,
                          double margin_mm) {
  const Result<FileFormat> format = format_of_path(path);
  if (!format) return tl::unexpected(format.error());
  DrawingBuilder builder;
  const std::size_t layer = builder.add_layer({"Ink"});
  Rect ink;
  for (const Stroke& stroke : strokes) {
    builder.add(layer, stroke);
    ink.extend(stroke.bounds());
  }
  WriteOptions options;
  if (!strokes.empty()) options.area = ink.inflated(margin_mm);
  return write_drawing(path, std::move(builder).build(), *format, options);
}

}  // namespace felt
