#include "ink.h"

#include <fstream>
#include <iterator>
#include <memory>
#include <utility>

#include "felt/devices/simulated/samples/sample_sets.h"
#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::bench {
namespace {

/// Fits the raw pen strokes in `text` and adds them to `strokes`.
Result<void> add_fitted(const std::string& text, double mm_per_unit,
                        std::vector<StrokePtr>& strokes) {
  LineReader lines(read_text(text));
  NdjsonParser parser;
  InkFitter fitter{InkFitOptions{}};
  LineBatch batch;
  RawStroke raw;
  for (;;) {
    const Result<bool> more = lines.fill(batch, 1 << 20);
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const Result<NdjsonKind> kind = parser.raw_stroke(batch.line(i), raw);
      if (!kind) return tl::unexpected(kind.error());
      if (*kind != NdjsonKind::kStroke || raw.samples.empty()) continue;
      fitter.begin();
      for (InkSample sample : raw.samples) {
        sample.position = Point{} + mm_per_unit * (sample.position - Point{});
        fitter.push(sample);
      }
      fitter.end();
      fitter.refine();
      if (Result<Stroke> stroke = fitter.stroke()) {
        strokes.push_back(std::make_shared<const Stroke>(*std::move(stroke)));
      }
    }
  }
}

}  // namespace

Result<std::vector<StrokePtr>> fitted_file(const std::string& path, double mm_per_unit) {
  std::ifstream file(path);
  if (!file) return fail(ErrorCode::kNotFound, path + ": cannot open");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<StrokePtr> strokes;
  if (Result<void> read = add_fitted(text, mm_per_unit, strokes); !read) {
    return fail(read.error().code, path + ": " + read.error().message);
  }
  return strokes;
}

std::vector<StrokePtr> fitted_samples() {
  std::vector<StrokePtr> strokes;
  for (const SampleSet& set : make_sample_sets()) (void)add_fitted(to_ndjson(set), 1.0, strokes);
  return strokes;
}

}  // namespace felt::bench
