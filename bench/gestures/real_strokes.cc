#include "real_strokes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "felt/base/constants.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/gather/testing/labelled_drawing.h"
#include "felt/geometry/rect.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/io/xopp/xopp_import.h"
#include "felt/session/session.h"

namespace felt::bench {
namespace {

constexpr std::int64_t kUnknownStepNs = 8'000'000;
constexpr double kLineMm = 180.0, kGapMm = 2.0;

Rect box_of(const std::vector<InkSample>& stroke) {
  Rect box;
  for (const InkSample& s : stroke) box.extend(s.position);
  return box;
}

/// Places strokes one after the other, in lines.
class Setter {
 public:
  void put(std::vector<InkSample>& stroke) {
    const Rect box = box_of(stroke);
    if (at_.x > 10.0 && at_.x + box.width() > kLineMm) {
      at_ = {10.0, at_.y + height_ + kGapMm};
      height_ = 0.0;
    }
    const Vec by = at_ - Point{box.x0, box.y0};
    for (InkSample& s : stroke) s.position += by;
    at_.x += box.width() + kGapMm;
    height_ = std::max(height_, box.height());
  }

 private:
  Point at_{10.0, 10.0};
  double height_ = 0.0;
};

/// Turns the strokes of a page into the events of a session.
class Drawer {
 public:
  Drawer() {
    apply(UseDevice{find_stylus_preset("touch")->capabilities});
    for (const char* id : {"pencil.scratch_out", "pencil.double_loop", "pencil.shapes"}) {
      apply(SetOption{id, true});
    }
  }
  /// Draws a stroke and returns the line that held the pen on the way.
  std::optional<StrokeId> draw(const std::vector<InkSample>& stroke) {
    std::optional<StrokeId> held;
    hover(stroke.front().position);
    const std::int64_t start_ns = now_ns_ + 1'000'000;
    for (const InkSample& s : stroke) {
      now_ns_ = std::max(now_ns_, start_ns + s.time_ns.value_or(0));
      apply(PenEvent{{s.position.x, s.position.y, -0.1}, s.pressure.value_or(0.5), 0});
      if (session_.retraced()) held = session_.retraced();
    }
    for (int i = 0; i < 8; ++i) hover(stroke.back().position);
    return held;
  }
  [[nodiscard]] const Session& session() const { return session_; }

 private:
  void hover(Point p) {
    now_ns_ += kUnknownStepNs;
    apply(PenEvent{{p.x, p.y, 6.0}, {}, 0});
  }
  void apply(decltype(Event::what) what) {
    if (!session_.apply({now_ns_, std::move(what)})) std::abort();
  }

  Session session_{make_tools(), {}};
  std::int64_t now_ns_ = 0;
};

/// Returns samples of a stroke without times, 8 ms apart.
std::vector<InkSample> samples_of(const Stroke& line) {
  constexpr int kSamplesInSegment = 4;
  std::vector<InkSample> stroke;
  for (int k = 0; k <= kSamplesInSegment * line.segment_count(); ++k) {
    InkSample s;
    s.position = line.position(static_cast<double>(k) / kSamplesInSegment);
    s.time_ns = k * kUnknownStepNs;
    stroke.push_back(s);
  }
  return stroke;
}

std::vector<std::vector<InkSample>> strokes_of(const Document& document) {
  std::vector<std::vector<InkSample>> strokes;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) strokes.push_back(samples_of(*document.find(id)));
  }
  return strokes;
}

/// Gives the label to the strokes that have none.
void label_new(const Document& document, std::uint32_t label,
               std::map<StrokeId, std::uint32_t>& labels) {
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) labels.emplace(id, label);
  }
}

bool offers(const OfferView& offer, OfferKind kind) {
  return std::any_of(offer.rows.begin(), offer.rows.end(),
                     [kind](const OfferRow& row) { return row.kind == kind; });
}

}  // namespace

Result<std::vector<RealPage>> read_pen_strokes(const std::string& path, double mm_per_unit,
                                               Placing placing) {
  std::ifstream file(path);
  if (!file) return fail(ErrorCode::kNotFound, path + ": cannot open");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  LineReader reader(read_text(text));
  LineBatch batch;
  NdjsonParser parser;
  RawStroke raw;
  std::vector<RealPage> pages;
  Setter setter;
  while (reader.fill(batch, 1'000'000).value()) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (!parser.raw_stroke(batch.line(i), raw) || raw.samples.empty()) continue;
      const std::string name = raw.id.substr(0, raw.id.rfind('#'));
      if (pages.empty() || pages.back().name != name) {
        pages.push_back({name, {}});
        setter = {};
      }
      std::vector<InkSample> stroke = raw.samples;
      std::int64_t unknown_ns = 0;
      for (InkSample& s : stroke) {
        s.position = {mm_per_unit * s.position.x, mm_per_unit * s.position.y};
        if (!s.time_ns) s.time_ns = unknown_ns += kUnknownStepNs;
      }
      if (placing == Placing::kInLines) setter.put(stroke);
      pages.back().strokes.push_back(std::move(stroke));
    }
  }
  return pages;
}

Result<std::vector<RealPage>> read_drawings(const std::string& folder, double diagonal_mm) {
  const Result<std::vector<LabelledDrawing>> drawings = read_scap_folder(folder);
  if (!drawings) return tl::unexpected(drawings.error());
  std::vector<RealPage> pages;
  for (const LabelledDrawing& drawing : *drawings) {
    const double scale = diagonal_mm / drawing.diagonal();
    RealPage page{drawing.name, {}};
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
      std::vector<InkSample> stroke;
      for (const Point p : drawing.lines[i]) {
        InkSample s;
        s.position = {scale * p.x, scale * p.y};
        s.time_ns = static_cast<std::int64_t>(stroke.size()) * kUnknownStepNs;
        stroke.push_back(s);
      }
      if (stroke.empty()) continue;
      page.strokes.push_back(std::move(stroke));
      page.labels.push_back(drawing.labels[i]);
    }
    pages.push_back(std::move(page));
  }
  return pages;
}

Result<std::vector<RealPage>> read_notes(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".xopp") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<RealPage> pages;
  for (const std::string& path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const Result<Imported> notes = import_xopp(bytes);
    if (!notes) return fail(ErrorCode::kInvalidData, path + ": " + notes.error().message);
    pages.push_back({path, strokes_of(notes->drawing.document)});
  }
  return pages;
}

std::string PageVariant::name() const {
  return fmt::format("{}{} degrees, x {}", is_mirrored ? "mirrored, " : "", turn_deg, scale);
}

std::vector<PageVariant> page_variants() {
  std::vector<PageVariant> variants;
  for (const bool is_mirrored : {false, true}) {
    for (const double turn_deg : {0.0, -20.0, 20.0}) {
      for (const double scale : {1.0, 0.35, 0.7, 1.4, 2.0}) {
        variants.push_back({is_mirrored, turn_deg, scale});
      }
    }
  }
  variants.erase(variants.begin());  // the page itself
  return variants;
}

std::vector<RealPage> varied(const std::vector<RealPage>& pages, const PageVariant& variant) {
  const double turn = variant.turn_deg * kTau / 360.0;
  const Vec u = variant.scale * Vec{std::cos(turn), std::sin(turn)};
  const Vec v = perp(u);
  std::vector<RealPage> changed = pages;
  for (RealPage& page : changed) {
    Rect before, after;
    for (std::vector<InkSample>& stroke : page.strokes) {
      for (InkSample& s : stroke) {
        before.extend(s.position);
        const double x = variant.is_mirrored ? -s.position.x : s.position.x;
        s.position = Point{} + x * u + s.position.y * v;
        after.extend(s.position);
      }
    }
    const Vec back{before.x0 - after.x0, before.y0 - after.y0};
    for (std::vector<InkSample>& stroke : page.strokes) {
      for (InkSample& s : stroke) s.position += back;
    }
  }
  return changed;
}

FalseOffers& FalseOffers::operator+=(const FalseOffers& other) noexcept {
  strokes += other.strokes;
  scratch_outs += other.scratch_outs;
  double_loops += other.double_loops;
  accepted_shapes += other.accepted_shapes;
  rests += other.rests;
  holds += other.holds;
  retraced += other.retraced;
  return *this;
}

FalseOffers draw_pages(const std::vector<RealPage>& pages, bool each) {
  FalseOffers all;
  for (const RealPage& page : pages) {
    Drawer drawer;
    std::map<StrokeId, std::uint32_t> labels;
    for (std::size_t i = 0; i < page.strokes.size(); ++i) {
      const std::optional<StrokeId> held = drawer.draw(page.strokes[i]);
      ++all.strokes;
      if (held) {
        const bool is_meant = !page.labels.empty() && labels[*held] == page.labels[i];
        ++(is_meant ? all.retraced : all.holds);
        if (each && !is_meant) fmt::print("  {}#{}: held to {}\n", page.name, i, held->value);
      }
      if (!page.labels.empty()) label_new(drawer.session().document(), page.labels[i], labels);
      const std::optional<OfferView> offer = drawer.session().offered();
      if (!offer) continue;
      const bool scratches = offers(*offer, OfferKind::kDelete);
      const bool circles = offers(*offer, OfferKind::kSelect);
      const bool is_accepted = offer->rows[offer->chosen].kind != OfferKind::kInk;
      all.scratch_outs += scratches;
      all.double_loops += circles;
      all.accepted_shapes += is_accepted;
      all.rests += !scratches && !circles;
      if (each) {
        fmt::print("  {}#{}: {}{}\n", page.name, i,
                   kOfferKinds[static_cast<std::size_t>(offer->rows.front().kind)],
                   is_accepted ? ", accepted" : "");
      }
    }
  }
  return all;
}

}  // namespace felt::bench
