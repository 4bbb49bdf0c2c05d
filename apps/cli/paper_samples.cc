#include "paper_samples.h"

#include <memory>
#include <utility>

#include "demo_scripts.h"
#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::cli {

Result<std::vector<std::vector<InkSample>>> cat_samples() {
  std::vector<std::vector<InkSample>> strokes;
  LineReader reader(read_text(sample_cat()));
  LineBatch batch;
  NdjsonParser parser;
  for (Result<bool> more = reader.fill(batch, 1 << 16); more && *more;
       more = reader.fill(batch, 1 << 16)) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      RawStroke raw;
      const Result<NdjsonKind> kind = parser.raw_stroke(batch.line(i), raw);
      if (!kind) return tl::unexpected(kind.error());
      if (*kind != NdjsonKind::kHeader) strokes.push_back(std::move(raw.samples));
    }
  }
  return strokes;
}

Result<std::vector<StrokePtr>> cat_fitted_by(FitScheme scheme, int shared_samples) {
  const Result<std::vector<std::vector<InkSample>>> samples = cat_samples();
  if (!samples) return tl::unexpected(samples.error());
  InkFitOptions options;
  options.scheme = scheme;
  options.shared_samples = shared_samples;
  InkFitter fitter(options);
  std::vector<StrokePtr> strokes;
  for (const std::vector<InkSample>& pen : *samples) {
    fitter.begin();
    for (const InkSample& sample : pen) fitter.push(sample);
    fitter.end();
    fitter.refine();
    Result<Stroke> stroke = fitter.stroke();
    if (!stroke) return tl::unexpected(stroke.error());
    strokes.push_back(std::make_shared<const Stroke>(*std::move(stroke)));
  }
  return strokes;
}

}  // namespace felt::cli
