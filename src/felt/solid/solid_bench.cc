#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "felt/solid/body_edits.h"
#include "felt/solid/inflate.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt {
namespace {

/// Returns a drawing of one closed stroke of 500 segments: a wavy outline of about 120 mm.
/// `mirror`: the outline mirrors itself.
Document outline_of_500(bool mirror) {
  constexpr int kSegments = 500;
  Random random(5);
  std::vector<std::pair<double, double>> waves;
  for (int k = 2; k < 12; ++k) {
    waves.emplace_back(random.between(0.0, 10.0) / k, mirror ? 0.0 : random.between(0.0, 6.0));
  }
  std::vector<Point> at;
  for (int i = 0; i < kSegments; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kSegments;
    double r = 50.0;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      r += waves[k].first * std::cos(static_cast<double>(k + 2) * a + waves[k].second);
    }
    at.push_back({100.0 + r * std::cos(a), 100.0 + r * std::sin(a)});
  }
  testing::SolidDrawing drawing;
  drawing.add(testing::stroke_of(testing::smooth_ring(at), true));
  return std::move(drawing.document);
}

/// Measures the inflation of one outline of 500 segments, from the strokes to the checked body. The
/// arguments are the number of triangles and whether the outline mirrors itself. The goal for 5,000
/// triangles is 150 ms.
void inflate_an_outline(benchmark::State& state) {
  const Document document = outline_of_500(state.range(1) != 0);
  const InflateOptions options{.triangles = static_cast<int>(state.range(0))};
  std::size_t triangles = 0;
  for (auto _ : state) {
    const Result<InflatedDrawing> result = inflate(document, options);
    if (!result) return state.SkipWithError(result.error().message.c_str());
    triangles = triangle_count(result->solid);
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(inflate_an_outline)
    ->Args({5000, 0})
    ->Args({5000, 1})
    ->Args({50'000, 0})
    ->Unit(benchmark::kMillisecond);

/// A stroke across the middle of the outline, or a closed line on it with a profile.
BodyEdit edit_of(BodyEditKind kind) {
  BodyEdit edit{.kind = kind, .width_mm = kind == BodyEditKind::kPaint ? 2.0 : 30.0};
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 50.0 - 1.0, a = std::numbers::pi * t;
    if (kind == BodyEditKind::kExtrude) {
      edit.path_mm.push_back({100.0 + 8.0 * std::cos(a), -100.0 + 8.0 * std::sin(a), 0.0});
      edit.profile_mm.push_back({100.0 + 8.0 * t, -100.0, 40.0 + 30.0 * (1.0 - t * t)});
    } else {
      edit.path_mm.push_back({100.0 + 90.0 * t, -100.0 + 5.0 * std::sin(3.0 * a), 0.0});
    }
  }
  return edit;
}

/// Measures one edit of a body (BodyEditKind) of about 5,000 triangles, from the inflated body to
/// the checked one.
void edit_a_body(benchmark::State& state) {
  const Result<InflatedDrawing> inflated = inflate(outline_of_500(false), {.triangles = 5000});
  if (!inflated) return state.SkipWithError(inflated.error().message.c_str());
  const std::vector<BodyEdit> edits{edit_of(static_cast<BodyEditKind>(state.range(0)))};
  for (auto _ : state) {
    const EditedSolid edited = apply_body_edits(inflated->solid, edits);
    if (!edited.refusals[0].empty()) return state.SkipWithError(edited.refusals[0].c_str());
  }
  state.SetLabel(std::string(body_edit_kind_name(edits[0].kind)));
}
BENCHMARK(edit_a_body)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

/// How the cuts of cut_a_body() lie.
enum class Cuts : std::uint8_t {
  kAround,  ///< around the body, each takes off another piece of its rim
  kEqual,   ///< all the same
};

std::vector<BodyEdit> cuts_of(std::int64_t count, Cuts cuts) {
  std::vector<BodyEdit> edits;
  for (std::int64_t i = 0; i < count; ++i) {
    const double turns =
        cuts == Cuts::kEqual ? 0.0 : static_cast<double>(i) / static_cast<double>(count);
    const double a = 2.0 * std::numbers::pi * turns;
    const Vec3 along{-std::sin(a), std::cos(a), 0.0};
    const Vec3 middle{100.0 + 47.5 * along.y, -100.0 - 47.5 * along.x, 0.0};
    edits.push_back(
        {.kind = BodyEditKind::kCut, .path_mm = {middle + 25.0 * along, middle - 25.0 * along}});
  }
  return edits;
}

/// Measures a number of cuts of a disc of 100 mm, from the inflated body to the checked one.
void cut_a_body(benchmark::State& state) {
  testing::SolidDrawing drawing;
  drawing.circle({100.0, 100.0}, 50.0);
  const Result<InflatedDrawing> inflated = inflate(drawing.document, {.triangles = 5000});
  if (!inflated) return state.SkipWithError(inflated.error().message.c_str());
  const std::vector<BodyEdit> edits = cuts_of(state.range(0), static_cast<Cuts>(state.range(1)));
  std::size_t triangles = 0;
  for (auto _ : state) {
    const EditedSolid edited = apply_body_edits(inflated->solid, edits);
    for (const std::string& refusal : edited.refusals) {
      if (!refusal.empty()) return state.SkipWithError(refusal.c_str());
    }
    triangles = triangle_count(edited.solid);
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(cut_a_body)->ArgsProduct({{1, 2, 10, 100}, {0, 1}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
