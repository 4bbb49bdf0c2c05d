// What an edit of a drawing with fills costs a whole session, from pen samples to the edit in the
// document: the gesture, the map of the fills, and the fills that follow.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/check.h"
#include "felt/base/random.h"
#include "felt/document/edit_builder.h"
#include "felt/fill/document_map.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/screen_of_strokes.h"

namespace felt {
namespace {

constexpr std::size_t kFills = 100;
constexpr double kGapMm = 1.0;
/// A display shows a frame every 16 samples of a pen that is sampled at 1 kHz.
constexpr int kSamplesPerFrame = 16, kFrames = 12;

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Returns a screen of strokes in which kFills areas are filled.
Document filled_screen(int strokes) {
  std::vector<StrokePtr> lines;
  for (Stroke& s : testing::screen_of_strokes(strokes)) {
    lines.push_back(std::make_shared<const Stroke>(std::move(s)));
  }
  Document document = document_of(lines);
  DocumentMap map(DocumentMap::Of::kAllStrokes);
  EditBuilder builder(document);
  FillMap& areas = *map.after(document, {}, {});
  Random random(3);
  std::size_t added = 0;
  for (int i = 0; i < 2000 && added < kFills; ++i) {
    const Point p{random.between(0.0, 480.0), random.between(0.0, 270.0)};
    const auto loop = areas.map(kGapMm).loop_around(p);
    if (!loop) continue;
    FoundFill found = areas.fill_of(*loop, kGapMm, {200, 60, 30, 255});
    builder.add_fill({1}, std::make_shared<const Fill>(std::move(found.fill)));
    ++added;
  }
  FELT_CHECK(document.apply(std::move(builder).build("Fill")).has_value());
  return document;
}

/// A session whose pen makes gestures, and the times of its edits and frames.
class Gestures {
 public:
  explicit Gestures(const Document& document) {
    SessionOptions options;
    options.document = document;
    session_ = std::make_unique<Session>(make_tools(), std::move(options));
  }

  template <class Command>
  void must(Command what) {
    FELT_CHECK(session_->apply({now_ns_ += 1'000'000, std::move(what)}).has_value());
  }
  /// Drags the pen from one point to another, asks for a preview with fills in each frame, and
  /// lifts the pen.
  void drag(const char* tool, Point from, Point to) {
    must(SelectStrokes{SelectStrokes::What::kNone});
    must(SelectTool{tool});
    now_ns_ += 1'000'000'000;
    pen(from, 5.0);
    for (int i = 1; i <= kFrames * kSamplesPerFrame; ++i) {
      pen(lerp(from, to, static_cast<double>(i) / (kFrames * kSamplesPerFrame)), -1.0);
      if (i % kSamplesPerFrame == 0) show_frame();
    }
    for (int i = 0; i < 100; ++i) pen(to, 5.0);
  }
  [[nodiscard]] const Session& session() const { return *session_; }
  [[nodiscard]] std::vector<double>& commits() { return commits_ms_; }
  [[nodiscard]] std::vector<double>& frames() { return frames_ms_; }

 private:
  void pen(Point p, double z) {
    const std::uint64_t before = session_->edit_count();
    const double start = cpu_ms();
    must(PenEvent{{p.x, p.y, z}, {}, 0});
    if (session_->edit_count() != before) commits_ms_.push_back(cpu_ms() - start);
  }
  void show_frame() {
    const double start = cpu_ms();
    benchmark::DoNotOptimize(session_->preview_with_fills());
    if (session_->preview()) frames_ms_.push_back(cpu_ms() - start);
  }

  std::int64_t now_ns_ = 0;
  std::unique_ptr<Session> session_;
  std::vector<double> commits_ms_, frames_ms_;
};

/// Returns the number of fills that differ.
double changed_fills(const Document& before, const Document& after) {
  double changed = 0.0;
  for (const FillId id : before.layers().front().fills) {
    const FillPtr now = after.find_fill(id);
    if (!now || *now != *before.find_fill(id)) ++changed;
  }
  return changed;
}

void report(benchmark::State& state, const char* name, std::vector<double>& times_ms) {
  if (times_ms.empty()) return;
  std::sort(times_ms.begin(), times_ms.end());
  state.counters[std::string(name) + "_median_ms"] = times_ms[times_ms.size() / 2];
  state.counters[std::string(name) + "_max_ms"] = times_ms.back();
}

/// Measures gestures on lines that bound fills. The arguments are the number of strokes and the
/// tool: pull, eraser, or transform, which moves one line.
void SessionFillEdit(benchmark::State& state) {
  const char* const tool =
      std::array{"pull", "eraser", "transform"}.at(static_cast<std::size_t>(state.range(1)));
  state.SetLabel(tool);
  const Document document = filled_screen(static_cast<int>(state.range(0)));
  Gestures gestures(document);
  const std::vector<FillId> fills(document.layers().front().fills.begin(),
                                  document.layers().front().fills.end());
  std::size_t next = 0;
  double followed = 0.0;
  for (auto _ : state) {
    const Document before = gestures.session().document();
    FillPtr fill;
    for (std::size_t i = 0; i < fills.size() && !fill; ++i) {
      fill = before.find_fill(fills[next = (next + 7) % fills.size()]);
    }
    if (!fill) break;  // all were opened and removed
    const Point on_line = fill->loops.front().points.front();
    gestures.drag(tool, on_line, on_line + Vec{3.0, 2.0});
    followed += changed_fills(before, gestures.session().document());
  }
  state.counters["fills"] = static_cast<double>(fills.size());
  state.counters["followed"] = followed / static_cast<double>(state.iterations());
  report(state, "commit", gestures.commits());
  report(state, "frame", gestures.frames());
}
BENCHMARK(SessionFillEdit)
    ->ArgNames({"strokes", "tool"})
    ->ArgsProduct({{1'000}, {0, 1, 2}})
    ->Iterations(24)
    ->Unit(benchmark::kMillisecond);

/// Moves all strokes and fills by a command.
void SessionMoveAll(benchmark::State& state) {
  const Document document = filled_screen(static_cast<int>(state.range(0)));
  Gestures gestures(document);
  gestures.must(SelectStrokes{SelectStrokes::What::kAll});
  double by_mm = 1.0;
  for (auto _ : state) {
    gestures.must(MoveEvent{{by_mm, 0.0}});
    by_mm = -by_mm;
  }
}
BENCHMARK(SessionMoveAll)->Arg(1'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace felt
