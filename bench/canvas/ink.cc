#include "ink.h"

#include <cmath>
#include <utility>
#include <vector>

#include "felt/base/check.h"
#include "felt/devices/simulated/samples/sample_sets.h"
#include "felt/document/edit_builder.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::bench {
namespace {

StrokePtr made(StrokeData data) {
  Result<Stroke> stroke = Stroke::create(std::move(data));
  return stroke ? std::make_shared<const Stroke>(*std::move(stroke)) : nullptr;
}

/// Returns one page of strokes: all sample sets, one below the other, with the first at (0, 0).
std::vector<StrokePtr> page_of_samples() {
  std::vector<StrokePtr> all;
  double top = 0.0;
  InkFitter fitter{InkFitOptions{}};
  for (const SampleSet& set : make_sample_sets()) {
    std::vector<StrokePtr> strokes;
    Rect area;
    for (const RecordedStroke& recorded : set.strokes) {
      fitter.begin();
      for (const HandSample& s : recorded.samples) {
        fitter.push({s.position, s.pressure, s.time_ns});
      }
      fitter.end();
      fitter.refine();
      strokes.push_back(std::make_shared<const Stroke>(fitter.stroke().value()));
      area.extend(strokes.back()->bounds());
    }
    for (const StrokePtr& stroke : strokes) {
      all.push_back(Ink::moved(*stroke, {-area.x0, top - area.y0}));
    }
    top += area.height() + 5.0;
  }
  return all;
}

}  // namespace

Ink::Ink(std::size_t strokes) {
  Rect size;
  const std::vector<StrokePtr> area = page_of_samples();
  for (const StrokePtr& stroke : area) size.extend(stroke->bounds());
  const double pages = std::ceil(static_cast<double>(strokes) / static_cast<double>(area.size()));
  const double columns =
      std::max(1.0, std::round(std::sqrt(pages * size.height() / size.width() * 16.0 / 9.0)));
  lay(strokes, [&](double n) {
    return Vec{std::fmod(n, columns) * (size.width() + 5.0),
               std::floor(n / columns) * (size.height() + 5.0)};
  });
}

Ink::Ink(std::size_t strokes, const Rect& page) {
  lay(strokes, [&](double) {
    return Vec{uniform(page.x0 - 100.0, page.x1 - 70.0), uniform(page.y0 - 250.0, page.y1 - 50.0)};
  });
}

/// Adds copies of the page of samples until the document has `strokes` strokes. Copy n is moved by
/// place(n).
void Ink::lay(std::size_t strokes, const std::function<Vec(double area)>& place) {
  const std::vector<StrokePtr> area = page_of_samples();
  EditBuilder builder(document_);
  Vec by;
  for (std::size_t i = 0; i < strokes; ++i) {
    if (i % area.size() == 0) by = place(static_cast<double>(i / area.size()));
    const StrokePtr stroke = moved(*area[i % area.size()], by);
    area_.extend(stroke->bounds());
    builder.add({1}, stroke);
  }
  FELT_CHECK(document_.apply(std::move(builder).build("Draw")).has_value());
}

StrokeId Ink::any() {
  const auto& strokes = document_.layers()[0].strokes;
  const double k = uniform(0.0, 1.0) * static_cast<double>(strokes.size());
  return strokes[std::min(static_cast<std::size_t>(k), strokes.size() - 1)];
}

StrokePtr Ink::moved(const Stroke& stroke, Vec by) {
  StrokeData data = stroke.data();
  for (Point& p : data.points) p = p + by;
  if (data.closed) data.points.back() = data.points.front();
  StrokePtr result = made(std::move(data));
  FELT_CHECK(result != nullptr);
  return result;
}

StrokePtr Ink::pulled(const Stroke& stroke, int joint, Vec by) {
  StrokeData data = stroke.data();
  const auto at = static_cast<std::size_t>(3 * (joint % (stroke.segment_count() + 1)));
  if (data.closed && (at == 0 || at + 1 == data.points.size())) return nullptr;
  for (std::size_t k = at == 0 ? 0 : at - 1; k <= at + 1 && k < data.points.size(); ++k) {
    data.points[k] = data.points[k] + by;
  }
  return made(std::move(data));
}

}  // namespace felt::bench
