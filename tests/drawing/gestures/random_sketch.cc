#include "tests/drawing/gestures/random_sketch.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <span>

#include "felt/base/check.h"
#include "felt/devices/simulated/samples/drawings.h"
#include "felt/document/edit_builder.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::gestures {
namespace {

constexpr double kPageMm = 120.0;
constexpr std::size_t kMaxRealStrokes = 400;
constexpr std::size_t kBatchBytes = std::size_t{1} << 20;

std::optional<Stroke> fitted(std::span<const InkSample> samples) {
  InkFitter fitter{InkFitOptions{}};
  fitter.begin();
  for (const InkSample& sample : samples) fitter.push(sample);
  fitter.end();
  Result<Stroke> stroke = fitter.stroke();
  if (!stroke) return std::nullopt;
  return *std::move(stroke);
}

/// Returns ink as the simulated hand would draw it.
StrokeData hand_ink(Dice& dice) {
  const std::vector<Gesture> gestures = random_gestures(dice.seed(), 1);
  WritingHand hand({.seed = dice.seed()});
  std::vector<InkSample> samples;
  for (const HandSample& s : hand.draw(gestures.front())) {
    samples.push_back({s.position, s.pressure, s.time_ns});
  }
  const std::optional<Stroke> ink = fitted(samples);
  FELT_CHECK(ink.has_value());
  return ink->data();
}

StrokeData of_points(std::vector<Point> points, bool closed, JointKind joint, double width_mm) {
  const std::size_t n = points.size() / 3;
  StrokeData data;
  data.points = std::move(points);
  data.closed = closed;
  data.joints.assign(closed ? n : n - 1, joint);
  data.widths = {{0.0, width_mm}, {static_cast<double>(n), width_mm}};
  return data;
}

/// Returns a ring of 1, 2 or 4 segments.
StrokeData ring(Dice& dice) {
  const double r = dice.over_decades(0.3, 30.0), w = dice.over_decades(kMinWidthMm, 4.0);
  const Point c{dice.between(0.0, kPageMm), dice.between(0.0, kPageMm)};
  const auto at = [&](double x, double y) { return c + r * Vec{x, y}; };
  switch (dice.pick(3)) {
    case 0:
      return of_points({at(0, 1), at(2, -1), at(-2, -1), at(0, 1)}, true, JointKind::kCorner, w);
    case 1:
      return of_points(
          {at(1, 0), at(1, 1.3), at(-1, 1.3), at(-1, 0), at(-1, -1.3), at(1, -1.3), at(1, 0)}, true,
          JointKind::kSmooth, w);
    default:
      break;
  }
  constexpr double k = 0.5522847498;
  return of_points({at(1, 0), at(1, k), at(k, 1), at(0, 1), at(-k, 1), at(-1, k), at(-1, 0),
                    at(-1, -k), at(-k, -1), at(0, -1), at(k, -1), at(1, -k), at(1, 0)},
                   true, JointKind::kSmooth, w);
}

/// Returns straight pieces with corners between them: a zigzag, a single line or a dot.
StrokeData polygon(Dice& dice) {
  const int n = dice.pick(1, 12);
  const double step_mm = dice.over_decades(kMinSegmentMm, 40.0);
  std::vector<Point> points{{dice.between(0.0, kPageMm), dice.between(0.0, kPageMm)}};
  for (int i = 0; i < n; ++i) {
    const Point a = points.back(), b = a + step_mm * dice.direction();
    points.insert(points.end(), {lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b});
  }
  return of_points(std::move(points), false, JointKind::kCorner, dice.over_decades(0.05, 6.0));
}

/// Returns a smooth line of many small segments, as it may be after many edits.
StrokeData chain(Dice& dice) {
  const int n = dice.pick(2, 40);
  const double length_mm = dice.over_decades(0.1, 5.0);
  Point at{dice.between(0.0, kPageMm), dice.between(0.0, kPageMm)};
  double angle = dice.between(0.0, 6.0);
  std::vector<Point> points{at};
  for (int i = 0; i < n; ++i) {
    const Vec out{std::cos(angle), std::sin(angle)};
    angle += dice.between(-0.9, 0.9);
    const Vec in{std::cos(angle), std::sin(angle)};
    points.push_back(at + length_mm / 3.0 * out);
    at = at + length_mm * normalized(out + in);
    points.insert(points.end(), {at - length_mm / 3.0 * in, at});
  }
  return of_points(std::move(points), false, JointKind::kSmooth, dice.over_decades(0.05, 6.0));
}

StrokeData random_data(Dice& dice, const std::vector<Stroke>& real) {
  if (!real.empty() && dice.chance(0.7)) return dice.any(real).data();
  switch (dice.pick(6)) {
    case 0:
      return ring(dice);
    case 1:
      return polygon(dice);
    case 2:
      return chain(dice);
    case 3:
      return hand_ink(dice);
    default:
      return testing::RandomStroke(dice.seed()).make();
  }
}

/// Position and scale of the whole drawing.
struct Placement {
  double scale = 1.0;
  Vec offset;
};

Placement random_placement(Dice& dice) {
  Placement placement;
  if (dice.chance(0.1)) placement.scale = dice.over_decades(0.02, 50.0);
  if (dice.chance(0.1)) placement.offset = dice.over_decades(1e2, 1e8) * dice.direction();
  return placement;
}

std::vector<StrokePtr> random_strokes(Dice& dice, const std::vector<Stroke>& real) {
  const Placement placement = random_placement(dice);
  std::vector<StrokePtr> strokes;
  for (int k = dice.pick(0, 10); k >= 0; --k) {
    StrokeData data = random_data(dice, real);
    for (Point& p : data.points) {
      p = {placement.scale * p.x + placement.offset.x, placement.scale * p.y + placement.offset.y};
    }
    if (data.closed) data.points.back() = data.points.front();
    // create() fails if the stroke is too short after scaling or too coarse far from the origin.
    Result<Stroke> stroke = Stroke::create(std::move(data));
    if (stroke) strokes.push_back(std::make_shared<const Stroke>(*std::move(stroke)));
  }
  return strokes;
}

void apply(Document& document, const Edit& edit) {
  const Result<void> done = document.apply(edit);
  FELT_CHECK(done.has_value());
}

void add_layers(Dice& dice, Document& document) {
  for (int k = dice.pick(0, 3); k > 0; --k) {
    const LayerId id = document.new_layer_id();
    Edit edit{"Layer", {}, {}};
    edit.layers.push_back({id, std::nullopt,
                           LayerState{"layer", dice.chance(0.75), dice.chance(0.25)}, 0,
                           document.layers().size()});
    apply(document, edit);
  }
}

}  // namespace

Document random_document(Dice& dice, const std::vector<Stroke>& real) {
  Document document;
  if (dice.chance(0.4)) add_layers(dice, document);
  for (StrokePtr& stroke : random_strokes(dice, real)) {
    EditBuilder builder(document);
    builder.add(dice.any(document.layers()).id, std::move(stroke));
    apply(document, std::move(builder).build("Draw"));
  }
  return document;
}

Result<std::vector<Stroke>> read_strokes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return fail(ErrorCode::kIo, path + ": cannot be read");
  LineReader reader([&in](std::span<char> into) -> Result<std::size_t> {
    in.read(into.data(), static_cast<std::streamsize>(into.size()));
    return static_cast<std::size_t>(in.gcount());
  });
  std::vector<Stroke> strokes;
  NdjsonParser parser;
  LineBatch batch;
  SketchRecord record;
  RawStroke raw;
  while (strokes.size() < kMaxRealStrokes && reader.fill(batch, kBatchBytes).value_or(false)) {
    for (std::size_t i = 0; i < batch.size() && strokes.size() < kMaxRealStrokes; ++i) {
      if (parser.sketch_stroke(batch.line(i), record)) {
        Result<Stroke> stroke = Stroke::create(std::move(record.data));
        if (stroke) strokes.push_back(*std::move(stroke));
        continue;
      }
      if (!parser.raw_stroke(batch.line(i), raw) || raw.samples.empty()) continue;
      Rect box;
      for (const InkSample& s : raw.samples) box.extend(s.position);
      const double size = std::max({box.width(), box.height(), 1e-9});
      const double scale = 10.0 * static_cast<double>(1 + strokes.size() % 8) / size;
      for (InkSample& s : raw.samples) {
        s.position = Point{} + scale * (s.position - Point{box.x0, box.y0});
      }
      if (std::optional<Stroke> ink = fitted(raw.samples)) strokes.push_back(*std::move(ink));
    }
  }
  if (strokes.empty()) return fail(ErrorCode::kInvalidData, path + ": holds no stroke");
  return strokes;
}

}  // namespace felt::gestures
