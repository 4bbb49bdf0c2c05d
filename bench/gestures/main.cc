// Measures the gestures of the pencil: how often real strokes count as gestures, and how often
// the gestures that simulated people mean are found (README.md).
//   bench_gestures [--strokes FILE.ndjson] [--mm-per-unit U] [--drawings FOLDER] [--notes FOLDER]
//                  [--variants yes] [--people N] [--seed N] [--each yes]
// With --variants yes, also draws each page of real strokes mirrored, turned and scaled.
// With --each yes, prints each false gesture, and each intended one that is not found.
// Exits with 1 if a bar is missed: at most 1 false gesture in 10,000 strokes, none in the variants,
// at least 95 % found.
#include <fmt/core.h>

#include <cstdlib>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meant_strokes.h"
#include "real_strokes.h"

namespace felt::bench {
namespace {

constexpr double kMaxFalse = 1e-4, kMinFound = 0.95;

struct Options {
  std::string strokes, drawings, notes;
  double mm_per_unit = 25.4 / 96.0;
  std::size_t people = 40;
  std::uint64_t seed = 1;
  bool variants = false;
  bool each = false;
};

std::optional<Options> options_of(int argc, char** argv) {
  Options options;
  if (argc % 2 == 0) return std::nullopt;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (name == "--strokes") {
      options.strokes = value;
    } else if (name == "--drawings") {
      options.drawings = value;
    } else if (name == "--notes") {
      options.notes = value;
    } else if (name == "--mm-per-unit") {
      options.mm_per_unit = std::strtod(value.c_str(), nullptr);
    } else if (name == "--people") {
      options.people = std::strtoull(value.c_str(), nullptr, 10);
    } else if (name == "--seed") {
      options.seed = std::strtoull(value.c_str(), nullptr, 10);
    } else if (name == "--variants") {
      options.variants = value == "yes";
    } else if (name == "--each") {
      options.each = value == "yes";
    } else {
      return std::nullopt;
    }
  }
  if (!(options.mm_per_unit > 0.0)) return std::nullopt;
  return options;
}

void print(const char* name, const FalseOffers& f) {
  fmt::print("{:<34} {:>7} {:>11} {:>11} {:>12} {:>6} {:>6} {:>8}\n", name, f.strokes,
             f.scratch_outs, f.double_loops, f.accepted_shapes, f.rests, f.holds, f.retraced);
}

/// The real strokes that count.
std::vector<RealPage> pages_of(const char* name, const Result<std::vector<RealPage>>& pages) {
  if (!pages) {
    fmt::print(stderr, "bench_gestures: {}: {}\n", name, pages.error().message);
    std::exit(1);
  }
  return *pages;
}

/// Draws the pages with these names.
class RealStrokes {
 public:
  explicit RealStrokes(const Options& options) : options_(options) {
    fmt::print("{:<34} {:>7} {:>11} {:>11} {:>12} {:>6} {:>6} {:>8}\n", "real strokes", "n",
               "scratch-out", "double loop", "shape accepted", "rests", "held", "retraced");
  }
  /// Draws pages that count, and remembers them for the variants.
  void add(const char* name, std::vector<RealPage> pages) {
    all_ += show(name, pages);
    pages_.insert(pages_.end(), std::make_move_iterator(pages.begin()),
                  std::make_move_iterator(pages.end()));
  }
  /// Draws pages and prints what was offered.
  FalseOffers show(const char* name, const std::vector<RealPage>& pages) const {
    const FalseOffers f = draw_pages(pages, options_.each);
    print(name, f);
    return f;
  }
  /// Draws all pages that count in each variant.
  [[nodiscard]] FalseOffers show_variants() const {
    FalseOffers sum;
    for (const PageVariant& variant : page_variants()) {
      sum += show(variant.name().c_str(), varied(pages_, variant));
    }
    return sum;
  }
  [[nodiscard]] const FalseOffers& all() const noexcept { return all_; }

 private:
  const Options& options_;
  std::vector<RealPage> pages_;
  FalseOffers all_;
};

/// Returns true if the bar is met. Without strokes, nothing is printed.
bool check_real(const Options& options) {
  if (options.strokes.empty() && options.drawings.empty() && options.notes.empty()) return true;
  RealStrokes real(options);
  if (!options.drawings.empty()) {
    real.add("drawings, 180 mm", pages_of("drawings", read_drawings(options.drawings, 180.0)));
    real.show("the same, 90 mm", pages_of("drawings", read_drawings(options.drawings, 90.0)));
  }
  if (!options.strokes.empty()) {
    const auto read = [&](Placing placing) {
      return pages_of("strokes", read_pen_strokes(options.strokes, options.mm_per_unit, placing));
    };
    real.add("pen strokes, in lines", read(Placing::kInLines));
    real.show("pen strokes, piled up (not counted)", read(Placing::kPiled));
  }
  if (!options.notes.empty())
    real.add("notes (.xopp)", pages_of("notes", read_notes(options.notes)));
  const FalseOffers& all = real.all();
  fmt::print("false gestures: {} of {} strokes\n\n", all.wrong(), all.strokes);
  const bool is_met =
      static_cast<double>(all.wrong()) <= kMaxFalse * static_cast<double>(all.strokes);
  if (!options.variants) return is_met;
  const FalseOffers varied = real.show_variants();
  fmt::print("false gestures: {} of {} variants of these strokes\n\n", varied.wrong(),
             varied.strokes);
  return is_met && varied.wrong() == 0;
}

bool check_meant(const Options& options) {
  fmt::print("{:<12} {:>6} {:>9} {:>9}   ({} people, seed {}, three sizes)\n", "meant", "n",
             "found", "first", options.people, options.seed);
  std::size_t drawn = 0, found = 0;
  bool is_met = true;
  for (const MeantStrokes& m : draw_meant(options.people, options.seed, options.each)) {
    const double n = static_cast<double>(m.drawn);
    const double share = n > 0.0 ? static_cast<double>(m.offered) / n : 0.0;
    fmt::print("{:<12} {:>6} {:>7.1f} % {:>7.1f} %\n",
               kOfferKinds[static_cast<std::size_t>(m.kind)], m.drawn, 100.0 * share,
               100.0 * static_cast<double>(m.first) / n);
    drawn += m.drawn;
    found += m.offered;
    is_met = is_met && share >= kMinFound;
  }
  fmt::print("found: {} of {}, {:.1f} %\n", found, drawn,
             100.0 * static_cast<double>(found) / static_cast<double>(drawn));
  return is_met;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  const auto options = felt::bench::options_of(argc, argv);
  if (!options || options->people == 0) {
    fmt::print(
        stderr,
        "usage: bench_gestures [--strokes FILE.ndjson] [--mm-per-unit U] [--drawings FOLDER]\n"
        "                      [--notes FOLDER] [--variants yes] [--people N] [--seed N]\n"
        "                      [--each yes]\n");
    return 2;
  }
  const bool is_real_met = felt::bench::check_real(*options);
  const bool is_meant_met = felt::bench::check_meant(*options);
  return is_real_met && is_meant_met ? 0 : 1;
}
