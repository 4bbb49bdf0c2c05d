#include "random_page.h"

#include <cmath>
#include <utility>

#include "felt/base/check.h"
#include "felt/document/edit_builder.h"

namespace felt::bench {

Page::Page(int strokes) : side_mm_(8.0 * std::sqrt(strokes)) {
  EditBuilder builder(document_);
  for (int i = 0; i < strokes; ++i) builder.add({1}, scribble());
  FELT_CHECK(document_.apply(std::move(builder).build("Scribble")).has_value());
}

StrokePtr Page::scribble() {
  StrokeData data;
  Point at{uniform(0, side_mm_), uniform(0, side_mm_)};
  double angle = uniform(0, 6.28);
  const int size = static_cast<int>(uniform(8, 13));
  data.points.push_back(at);
  for (int i = 0; i < size; ++i) {
    const double reach = uniform(0.5, 1.5);
    const Vec out{std::cos(angle), std::sin(angle)};
    angle += uniform(-1.0, 1.0);
    const Vec in{std::cos(angle), std::sin(angle)};
    const Point end = at + 1.5 * reach * (out + in);
    data.points.insert(data.points.end(), {at + reach * out, end + -reach * in, end});
    at = end;
  }
  data.joints.assign(static_cast<std::size_t>(size - 1), JointKind::kSmooth);
  data.widths = {{0.0, 0.4}, {0.5 * size, 0.8}, {static_cast<double>(size), 0.4}};
  Result<Stroke> stroke = Stroke::create(std::move(data));
  FELT_CHECK(stroke.has_value());
  return std::make_shared<const Stroke>(*std::move(stroke));
}

}  // namespace felt::bench
