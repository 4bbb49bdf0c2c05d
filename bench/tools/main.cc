// Times every tool per sample, on a sketch of 10^6 segments (README.md).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/session/session.h"
#include "random_page.h"

namespace felt::bench {
namespace {

struct Arguments {
  int strokes = 100'000;
  int gestures = 40;
  bool json = false;
  std::string only;
};

std::int64_t cpu_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
}

using Times = std::vector<double>;  // us

template <class Work>
double timed_us(Work work) {
  const std::int64_t start_ns = cpu_ns();
  work();
  return 1e-3 * static_cast<double>(cpu_ns() - start_ns);
}

class Table {
 public:
  explicit Table(bool json) : json_(json) {
    if (json_) return;
    std::printf("thread CPU, us\n%-34s %8s %8s %8s %8s %9s\n", "", "calls", "p50", "p99", "p99.9",
                "max");
  }
  void add(const std::string& what, Times us) const {
    if (us.empty()) return;
    std::sort(us.begin(), us.end());
    const auto part = [&us](double p) {
      return us[static_cast<std::size_t>(p * static_cast<double>(us.size() - 1))];
    };
    std::printf(json_ ? "{\"what\":\"%s\",\"calls\":%zu,\"p50_us\":%.2f,\"p99_us\":%.2f,"
                        "\"p999_us\":%.2f,\"max_us\":%.2f}\n"
                      : "%-34s %8zu %8.2f %8.2f %8.2f %9.2f\n",
                what.c_str(), us.size(), part(0.5), part(0.99), part(0.999), us.back());
    std::fflush(stdout);
  }

 private:
  bool json_;
};

void index_rows(Page& page, Document& document, const Table& table) {
  StrokeIndex index;
  Times build = {timed_us([&] { index = StrokeIndex(document); })};
  table.add("index: build", std::move(build));
  Times near, area, edits, documents;
  std::size_t found = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Point place{page.uniform(0, page.side_mm()), page.uniform(0, page.side_mm())};
    near.push_back(timed_us([&] { found += index.nearest(place, 8.0) ? 1 : 0; }));
    if (i % 10 != 0) continue;
    const Rect box = Rect{place.x, place.y, place.x, place.y}.inflated(5.0);
    area.push_back(timed_us([&] { found += index.strokes_in(box).size(); }));
  }
  const std::vector<StrokeId> ids = document.layers()[0].strokes;
  for (int i = 0; i < 20'000; ++i) {
    const std::size_t k =
        static_cast<std::size_t>(page.uniform(0, 1) * 0.999999 * static_cast<double>(ids.size()));
    const StrokePtr before = document.find(ids[k]);
    if (!before) continue;
    const StrokePlace place{{1}, k};
    const Edit edit{"Edit", {{ids[k], before, page.scribble(), place, place}}};
    documents.push_back(timed_us([&] { (void)document.apply(edit); }));
    edits.push_back(timed_us([&] { index.update(edit, document); }));
  }
  table.add("index: nearest within 8 mm", std::move(near));
  table.add("index: strokes in 10 x 10 mm", std::move(area));
  table.add("index: a stroke redrawn elsewhere", std::move(edits));
  table.add("document: the same edit", std::move(documents));
  if (found == 0) std::printf("nothing was found\n");
}

/// Sends pen samples to a session and times them.
class Hand {
 public:
  /// `now_ns` is the shared clock, so that the time also increases from hand to hand.
  Hand(Session& session, std::int64_t& now_ns) : session_(session), now_ns_(now_ns) {}

  Times samples, commits, forces, draws;

  void to(Point at, double z) {
    PenSample sample;
    sample.time_ns = now_ns_ += 1'000'000;
    sample.position = {at.x, at.y, z};
    if (z < 0.0) sample.pressure = 0.5;
    const std::uint64_t edits = session_.edit_count();
    bool good = true;
    const double us = timed_us([&] { good = session_.sample(sample).has_value(); });
    if (!good) std::printf("a sample was refused\n");
    (session_.edit_count() == edits ? samples : commits).push_back(us);
    if (++count_ % 4 != 0) return;
    forces.push_back(timed_us([&] { (void)session_.force(); }));
    draws.push_back(timed_us([&] { session_.draw(overlay_); }));
  }
  /// Makes one gesture: hover, touch, move along an arc, lift.
  void gesture(Point start, double angle, double bend, int length) {
    Point at = start + -8.0 * Vec{std::cos(angle), std::sin(angle)};
    const auto step = [&] { at = at + 0.1 * Vec{std::cos(angle), std::sin(angle)}; };
    for (int i = 0; i < 80; ++i, step()) to(at, 4.0 - 0.05 * i);
    for (int i = 0; i < length; ++i, angle += bend, step()) to(at, -1.0);
    for (int i = 0; i < 60; ++i, step()) to(at, 0.1 * i);
  }

 private:
  Session& session_;
  Overlay overlay_;
  std::int64_t& now_ns_;
  int count_ = 0;
};

void choose(Session& session, std::string_view id) {
  (void)session.apply({0, SelectTool{std::string(id)}});
}

void tool_rows(Page& page, Session& session, const std::string& id, std::int64_t& now_ns,
               const Arguments& args, const Table& table) {
  Hand hand(session, now_ns);
  const std::vector<StrokeId> ids = session.document().layers()[0].strokes;
  for (int i = 0; i < args.gestures; ++i) {
    StrokePtr stroke;
    while (!stroke) {
      const double k = page.uniform(0, static_cast<double>(ids.size()) - 1.0);
      stroke = session.document().find(ids[static_cast<std::size_t>(k)]);
    }
    Point start = stroke->position(page.uniform(0, stroke->segment_count()));
    const Tool* selects = session.first_tool(ToolKind::kSelects);
    if (session.tool().info().kind == ToolKind::kTransforms && selects) {
      // Selects the points to transform with a circle of radius 15 mm around the position.
      const std::string lasso(selects->info().id);
      choose(session, lasso);
      (void)session.apply({0, SetOption{lasso + ".take", std::string("points")}});
      Hand other(session, now_ns);
      other.gesture(start + Vec{0, -15}, 0.0, 0.1 / 15.0, 940);
      choose(session, id);
      start = start + Vec{6, 4};  // not on the dot in the middle, which would move alone
    }
    const double bend = page.uniform(-0.02, 0.02);
    hand.gesture(start, page.uniform(0, 6.28), bend, i % 4 == 0 ? 1000 : 250);
  }
  table.add(id + ": sample", std::move(hand.samples));
  table.add(id + ": sample that commits", std::move(hand.commits));
  table.add(id + ": force()", std::move(hand.forces));
  table.add(id + ": draw()", std::move(hand.draws));
}

void run(const Arguments& args) {
  const Table table(args.json);
  Page page(args.strokes);
  Document document = page.take();
  if (args.only.empty() || args.only == "index") index_rows(page, document, table);
  SessionOptions options;
  options.device = {.max_force_n = 3.3, .continuous_force_n = 0.0, .max_stiffness_n_per_m = 0.0};
  options.document = std::move(document);
  Session session(make_tools(), std::move(options));
  std::int64_t now_ns = 0;
  for (const auto& tool : session.tools()) {
    const std::string id(tool->info().id);
    if (!args.only.empty() && args.only != id) continue;
    choose(session, id);
    tool_rows(page, session, id, now_ns, args, table);
  }
}

int usage() {
  std::fprintf(stderr,
               "usage: bench_tools [--strokes N] [--gestures N] [--only TOOL|index] [--json]\n");
  return 2;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  felt::bench::Arguments args;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--json") {
      args.json = true;
    } else if (word == "--strokes" && has_value) {
      args.strokes = std::max(std::atoi(argv[++i]), 1);
    } else if (word == "--gestures" && has_value) {
      args.gestures = std::max(std::atoi(argv[++i]), 1);
    } else if (word == "--only" && has_value) {
      args.only = argv[++i];
    } else {
      return felt::bench::usage();
    }
  }
  felt::bench::run(args);
  return 0;
}
