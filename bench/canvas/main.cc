// Times an edit, a preview, a pan and a cold page on screen, with 10^5 strokes (README.md).
#include <QApplication>
#include <QImage>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "desktop/canvas/ink_tile_store.h"
#include "desktop/canvas/ink_view.h"
#include "felt/document/edit_builder.h"
#include "felt/material/relief.h"
#include "ink.h"
#include "table.h"

namespace felt::bench {
namespace {

using desktop::CanvasView;
using desktop::InkTileStore;
using desktop::InkView;
using desktop::TileNews;

constexpr QSize kWindow(1920, 1080);
constexpr double kScreenPxPerMm = 96.0 / 25.4;  // life size

struct Arguments {
  std::size_t strokes = 100'000;
  int edits = 300;
  bool json = false;
  bool only_media = false;
};

double resident_mib() {
  std::ifstream statm("/proc/self/statm");
  double size = 0, resident = 0;
  statm >> size >> resident;
  return resident * 4096.0 / (1 << 20);
}

CanvasView view_at(Point place, double px_per_mm) {
  CanvasView view;
  view.set_size(kWindow);
  view.set_scale(px_per_mm);
  view.center_on(place);
  return view;
}

/// Makes edits of random strokes, each with the position that it changes.
class Edits {
 public:
  explicit Edits(Ink& ink) : ink_(ink) {}

  struct One {
    Edit edit;
    Point place;
  };
  One add() {
    const StrokePtr like = any();
    EditBuilder builder(ink_.document());
    builder.add({1}, Ink::moved(*like, {ink_.uniform(-3, 3), ink_.uniform(-3, 3)}));
    return {std::move(builder).build("Draw"), like->position(0.0)};
  }
  One erase() {
    const StrokeId id = ink_.any();
    EditBuilder builder(ink_.document());
    builder.remove(id);
    const Point place = ink_.document().find(id)->position(0.0);
    return {std::move(builder).build("Erase"), place};
  }
  One pull(double mm) {
    for (;;) {
      const StrokeId id = ink_.any();
      const StrokePtr before = ink_.document().find(id);
      const int joint = static_cast<int>(ink_.uniform(0, before->segment_count() + 1));
      const StrokePtr after = Ink::pulled(*before, joint, {mm, 0.5 * mm});
      if (!after) continue;
      EditBuilder builder(ink_.document());
      builder.replace(id, after);
      return {std::move(builder).build("Pull"), after->position(joint)};
    }
  }

 private:
  StrokePtr any() { return ink_.document().find(ink_.any()); }
  Ink& ink_;
};

/// An InkTileStore that shows a window's view. The benchmark calls its work directly, without
/// threads.
class Window {
 public:
  explicit Window(const Document& document) { fixture_.open(document); }

  void look(Point place) {
    fixture_.forget(plane_);
    const double w = kWindow.width(), h = kWindow.height();
    const View view{{place.x - 0.5 * w / kScreenPxPerMm, place.y - 0.5 * h / kScreenPxPerMm},
                    kScreenPxPerMm};
    fixture_.look({++plane_, view, {}}, {0, 0, kWindow.width(), kWindow.height()});
    while (fixture_.plan() != InkTileStore::Need::kNone) work();
  }
  /// Calls `what` and repairs the tiles that it changed. Returns the CPU time in us.
  template <class What>
  double time(What what) {
    const double start = thread_cpu_us();
    what(fixture_);
    while (fixture_.plan() == InkTileStore::Need::kRepair) work();
    return thread_cpu_us() - start;
  }

 private:
  void work() {
    news_.clear();
    fixture_.work(
        0, [] { return false; }, news_);
  }
  InkTileStore fixture_;
  std::uint64_t plane_ = 0;
  std::vector<TileNews> news_;
};

void edit_rows(const std::string& title, Ink& ink, int count, const Table& table) {
  table.heading("CPU of the worker, us: " + title);
  Window window(ink.document());
  Edits edits(ink);
  std::vector<double> add, pull, erase, back, first, sample;
  const auto run = [&](const Edits::One& one, std::vector<double>& times) {
    window.look(one.place);
    times.push_back(window.time([&](InkTileStore& fixture) { fixture.apply(one.edit); }));
    back.push_back(window.time([&](InkTileStore& fixture) { fixture.apply(one.edit.inverse()); }));
  };
  for (int i = 0; i < count; ++i) {
    run(edits.add(), add);
    run(edits.erase(), erase);
    run(edits.pull(ink.uniform(-5, 5)), pull);
  }
  for (int i = 0; i < count / 6; ++i) {
    const Edits::One one = edits.pull(0.1);
    window.look(one.place);
    const StrokeChange& c = one.edit.changes[0];
    const int joint = static_cast<int>(ink.uniform(0, c.before->segment_count() + 1));
    for (int k = 1; k <= 40; ++k) {
      Edit shown = one.edit;
      const StrokePtr after = Ink::pulled(*c.before, joint, {0.2 * k, 0.1 * k});
      if (!after) break;
      shown.changes[0].after = after;
      const double us = window.time([&](InkTileStore& fixture) { fixture.show(shown); });
      (k == 1 ? first : sample).push_back(us);
    }
    window.time([](InkTileStore& fixture) { fixture.show(std::nullopt); });
  }
  table.times("edit: add", std::move(add));
  table.times("edit: pull", std::move(pull));
  table.times("edit: erase", std::move(erase));
  table.times("edit: any of these, undone", std::move(back));
  table.times("preview: first sample of a pull", std::move(first));
  table.times("preview: each further one", std::move(sample));
}

void screen_rows(Ink& ink, const Arguments& args, const Table& table) {
  table.heading("CPU of all threads, us: from an edit until the window has copied it");
  InkView view;
  view.set_document(ink.document());
  Edits edits(ink);
  QImage screen(kWindow, QImage::Format_RGB32);
  screen.fill(Qt::white);
  std::vector<QRect> changed;
  QObject::connect(&view, &InkView::changed, [&](const QRect& part) { changed.push_back(part); });
  std::vector<double> cpu, wall;
  for (int i = 0; i < args.edits; ++i) {
    const Edits::One one = i % 3 == 0   ? edits.add()
                           : i % 3 == 1 ? edits.erase()
                                        : edits.pull(ink.uniform(-5, 5));
    view.set_view(view_at(one.place, kScreenPxPerMm), 1.0);
    view.finish();
    // Waits until the tiles around the view are painted, because they do not belong to the edit.
    for (double busy = 1e9; busy > 200.0;) {
      const double start = process_cpu_us();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      busy = process_cpu_us() - start;
    }
    changed.clear();
    const double cpu_start = process_cpu_us(), start = wall_us();
    view.apply(one.edit);
    view.finish();
    QPainter painter(&screen);
    for (const QRect& part : changed) view.paint(painter, part);
    cpu.push_back(process_cpu_us() - cpu_start);
    wall.push_back(wall_us() - start);
    view.apply(one.edit.inverse());
  }
  table.times("edit on screen: CPU", std::move(cpu));
  table.times("edit on screen: wall clock", std::move(wall));
}

void pan_rows(Ink& ink, const Table& table) {
  table.heading("CPU of the window's thread, us: a frame of 1920 x 1080 while panning");
  const Rect all = ink.area();
  for (const double px_per_frame : {8.0, 40.0}) {
    InkView ink_view;
    ink_view.set_document(ink.document());
    CanvasView view = view_at({0.3 * (all.x0 + all.x1), 0.5 * (all.y0 + all.y1)}, kScreenPxPerMm);
    ink_view.set_view(view, 1.0);
    ink_view.finish();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    QImage screen(kWindow, QImage::Format_RGB32);
    std::vector<double> us;
    int waited = 0;
    const double start = wall_us();
    for (int frame = 0; frame < 240; ++frame) {
      const double before = thread_cpu_us();
      view.pan({-px_per_frame, -0.25 * px_per_frame});
      ink_view.set_view(view, 1.0);
      screen.fill(Qt::white);
      QPainter painter(&screen);
      ink_view.paint(painter, screen.rect());
      painter.end();
      us.push_back(thread_cpu_us() - before);
      if (ink_view.missing_tiles() > 0) ++waited;
      QCoreApplication::processEvents();
      const double next = start + (frame + 1) * 1e6 / 60.0;
      if (next > wall_us()) {
        std::this_thread::sleep_for(std::chrono::microseconds(static_cast<int>(next - wall_us())));
      }
    }
    const double fps = 240e6 / (wall_us() - start);
    const std::string name =
        "pan: " + std::to_string(static_cast<int>(px_per_frame * 60)) + " px/s";
    double sum = 0;
    for (const double u : us) sum += u;
    table.times(name, us);
    table.number(name + ", frames with a tile missing", waited, "of 240");
    table.number(name + ", frames a second, paced to 60", fps, "1/s");
    table.number(name + ", frames a second of CPU", 240e6 / sum, "1/s");
  }
}

/// Adds the rows for a cold page: a window full of strokes with no tile painted yet.
void page_row(const std::string& what, const Ink& ink, const CanvasView& at, const Table& table) {
  std::vector<double> wall, cpu;
  for (int i = 0; i < 7; ++i) {
    InkView view;
    view.set_document(ink.document());
    view.finish();  // so that the view has processed the document
    const double start = wall_us(), cpu_start = process_cpu_us();
    view.set_view(at, 1.0);
    view.finish();
    wall.push_back(wall_us() - start);
    cpu.push_back(process_cpu_us() - cpu_start);
  }
  table.times(what + ": wall clock", std::move(wall));
  table.times(what + ": CPU of all threads", std::move(cpu));
}

void page_rows(const Ink& dense, const CanvasView& on_dense, const Table& table) {
  table.heading("us: a page that is not cached, 10,000 strokes in the window");
  const Ink ink(10'000);
  CanvasView on_all = view_at({0, 0}, 1.0);
  on_all.fit(ink.area(), 0.0);
  page_row("cold page, seen from afar", ink, on_all, table);
  page_row("cold page, page over page", dense, on_dense, table);
}

/// Returns the CPU time of painting a cold page.
double cold_page_cpu_ms(const Ink& ink, const CanvasView& at, const Grain& grain) {
  InkView view;
  view.set_grain(grain);
  view.set_document(ink.document());
  view.finish();
  const double start = process_cpu_us();
  view.set_view(at, 1.0);
  view.finish();
  return 1e-3 * (process_cpu_us() - start);
}

/// Adds a row per medium: the cold page in that medium on rough paper, with its dust, hairs and
/// rims, relative to plain ink. The two are timed alternately, so that both see the same load of
/// the machine, and the minimum of each counts.
void media_rows(const Ink& ink, const CanvasView& at, const Table& table) {
  constexpr int kTurns = 15;
  table.heading("the same dense page, with the look of media");
  const HeightField* relief = surface_grain(*find_surface("rough-paper"));
  double min_plain = std::numeric_limits<double>::infinity();
  for (const Medium& medium : media()) {
    if (!medium.draws) continue;
    Materials materials = Materials::built_in();
    Medium as_pencil = medium;  // the medium of the strokes
    as_pencil.id = "pencil";
    materials.put(as_pencil);
    const Grain grain(relief, materials);
    double plain = std::numeric_limits<double>::infinity(), with_grain = plain;
    for (int turn = 0; turn < kTurns; ++turn) {
      plain = std::min(plain, cold_page_cpu_ms(ink, at, Grain()));
      with_grain = std::min(with_grain, cold_page_cpu_ms(ink, at, grain));
    }
    min_plain = std::min(min_plain, plain);
    table.number(medium.id + ", of plain ink", with_grain / plain, "times");
  }
  table.number("plain ink, CPU", min_plain, "ms");
}

double memory_of_view(const Ink& ink) {
  const Rect all = ink.area();
  const double before = resident_mib();
  InkView view;
  view.set_document(ink.document());
  view.set_view(view_at({0.5 * (all.x0 + all.x1), 0.5 * (all.y0 + all.y1)}, kScreenPxPerMm), 1.0);
  view.finish();
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  return resident_mib() - before;
}

/// Adds all rows that are measured with `args.strokes` strokes open.
void sketch_rows(const Arguments& args, const Table& table) {
  const double start = wall_us();
  Ink ink(args.strokes);
  const Rect all = ink.area();
  const double a4 = all.width() * all.height() / (297.0 * 210.0);
  table.number("strokes", static_cast<double>(ink.document().stroke_count()), "");
  table.number("strokes per A4 page", static_cast<double>(args.strokes) / a4, "");
  table.number("time to make them", 1e-6 * (wall_us() - start), "s");
  table.number("memory of a view, with its tiles", memory_of_view(ink), "MiB");
  edit_rows("edits and samples of previews", ink, args.edits, table);
  screen_rows(ink, args, table);
  pan_rows(ink, table);
}

int run(const Arguments& args) {
  const Table table(args.json);
  if (!args.only_media) sketch_rows(args, table);
  const Rect page{0, 0, kWindow.width() / kScreenPxPerMm, kWindow.height() / kScreenPxPerMm};
  Ink dense(10'000, page);
  const CanvasView on_dense = view_at({0.5 * page.x1, 0.5 * page.y1}, kScreenPxPerMm);
  if (!args.only_media) page_rows(dense, on_dense, table);
  media_rows(dense, on_dense, table);
  if (args.only_media) return 0;
  edit_rows("the same with 10,000 strokes in one window", dense, args.edits / 4, table);
  return 0;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  if (!std::getenv("QT_QPA_PLATFORM")) setenv("QT_QPA_PLATFORM", "offscreen", 1);
  const QApplication application(argc, argv);
  felt::bench::Arguments args;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--json") {
      args.json = true;
    } else if (word == "--media") {
      args.only_media = true;
    } else if (word == "--strokes" && has_value) {
      args.strokes = static_cast<std::size_t>(std::max(std::atoi(argv[++i]), 100));
    } else if (word == "--edits" && has_value) {
      args.edits = std::max(std::atoi(argv[++i]), 6);
    } else {
      std::fprintf(stderr, "usage: bench_canvas [--strokes N] [--edits N] [--media] [--json]\n");
      return 2;
    }
  }
  return felt::bench::run(args);
}
