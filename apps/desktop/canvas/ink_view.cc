#include "desktop/canvas/ink_view.h"

#include <QImage>
#include <QRegion>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "desktop/canvas/dab_rows.h"
#include "desktop/canvas/ink_worker.h"

namespace felt::desktop {
namespace {

/// A new stroke must appear in the very next frame. Painting therefore waits for the worker for at
/// most kPatience; the worker usually needs only a fraction of this time.
constexpr std::chrono::microseconds kPatience{2000};

/// Maximum number of strokes of one edit that InkView itself paints if the worker is late.
constexpr std::size_t kMaxFresh = 8;
constexpr int kMaxFreshSegments = 400;

/// Maximum number of planes. Old planes are kept to return to an earlier view, and to fill missing
/// tiles.
constexpr std::size_t kMaxPlanes = 6;

/// If the view is farther than kFarthestPx from the first view of a plane, a new plane begins.
constexpr double kFarthestPx = 1e9;

constexpr double kHairPx = 1.0;

QRect device_rect(const QRect& part, double dpr) {
  const QRectF r(part.x() * dpr, part.y() * dpr, part.width() * dpr, part.height() * dpr);
  return r.toAlignedRect();
}

QRect widget_rect(const QRect& device, double dpr) {
  return QRectF(device.x() / dpr, device.y() / dpr, device.width() / dpr, device.height() / dpr)
      .toAlignedRect();
}

QTransform transform_of(const View& view) {
  const Vec o = view.to_px({0, 0}), x = view.to_px({1, 0}), y = view.to_px({0, 1});
  return {x.x - o.x, x.y - o.y, y.x - o.x, y.y - o.y, o.x, o.y};
}

}  // namespace

struct InkView::State {
  struct Tile {
    TilePtr picture;
    std::uint64_t order = 0;
  };
  struct Plane {
    PlaneSpec spec;
    std::uint64_t style = 0;
    std::map<TilePlace, Tile> tiles;
  };
  /// A stroke that the tiles may not contain yet.
  struct Fresh {
    std::uint64_t order = 0;
    StrokeId id;
    StrokePtr stroke;
    LayerId layer;
    double opacity = 1.0;  // of the layer and its group
    bool multiplies = false;
  };
  /// How the strokes of a layer look.
  struct Look {
    double opacity = 0.0;  // of the layer and its group; 0 if one of them is hidden
    bool multiplies = false;
  };
  static Look look_of(const LayerState& layer) {
    if (!is_visible(layer)) return {};
    const LayerGroup* group = layer.group.get();
    const auto is_multiply = [](BlendMode mode) { return mode == BlendMode::kMultiply; };
    return {layer.opacity * (group ? group->opacity : 1.0),
            is_multiply(layer.blend) || (group && is_multiply(group->blend))};
  }

  explicit State(std::function<void()> on_news) : worker(std::move(on_news)) {}

  [[nodiscard]] Plane* current() { return planes.empty() ? nullptr : &planes.back(); }
  void choose_plane();
  void choose_over();
  void drop_over();
  void ask();
  [[nodiscard]] PlaneRect plane_rect(const QRect& device) const {
    return {device.left() + left, device.top() + top, device.right() + 1 + left,
            device.bottom() + 1 + top};
  }
  /// Returns the part of the plane that the widget shows.
  [[nodiscard]] PlaneRect seen() const {
    return plane_rect(QRect(0, 0, static_cast<int>(std::ceil(view.size().width() * dpr)),
                            static_cast<int>(std::ceil(view.size().height() * dpr))));
  }
  [[nodiscard]] QRect on_widget(const PlaneRect& px) const;
  void copy_tiles(QPainter& painter, const Plane& plane, const QRect& device, QRegion& missing);
  void paint_others(QPainter& painter, const QRegion& missing);
  void paint_fresh(QPainter& painter, Plane& plane, const QRect& device);
  void cover(QImage& ink, QPoint at);
  [[nodiscard]] double covered(const Plane& plane, const View& from) const;

  CanvasView view;
  double dpr = 1.0;
  Grain grain;
  bool is_outline = false;
  std::uint64_t style = 0;  // counts changes of grain and outline mode
  std::uint64_t last_plane = 0;
  std::vector<Plane> planes;       // the last one is current
  std::optional<LayerId> new_ink;  // the layer of new ink, if other layers cover it
  std::optional<Plane> over;       // the plane of these layers, in the view of the current plane
  std::int64_t left = 0, top = 0;  // corner of the widget, in pixels of the plane
  std::map<LayerId, Look> looks;
  Rgba paper{255, 255, 255, 255};
  std::vector<Fresh> fresh;
  TilePainter strokes;
  bool is_previewing = false;
  std::uint64_t opened = 0;  // number of the order that set the document
  InkWorker worker;          // last, so that its thread ends first
};

/// Selects the plane of the present scale, angle and style, or makes a new one.
void InkView::State::choose_plane() {
  const View now = DeviceView{view, dpr, {}}.as_view();
  const auto is_same = [&](const Plane& plane) {
    const View& v = plane.spec.view;
    const Vec at = v.to_px(now.origin_mm);
    return plane.style == style && v.px_per_mm == now.px_per_mm && v.turn == now.turn &&
           v.is_mirrored == now.is_mirrored && std::fabs(at.x) < kFarthestPx &&
           std::fabs(at.y) < kFarthestPx;
  };
  const auto found = std::find_if(planes.begin(), planes.end(), is_same);
  if (found != planes.end()) {
    std::rotate(found, found + 1, planes.end());
  } else {
    const InkStyle look{grain, is_outline ? kHairPx * std::max(1.0, dpr) : 0.0, paper};
    planes.push_back({{++last_plane, now, look}, style, {}});
    if (planes.size() > kMaxPlanes) {
      // Drops the plane whose tiles cover the smallest share of the view. Therefore the last
      // complete picture is kept if the user zooms faster than tiles are made.
      const auto smallest = std::min_element(
          planes.begin(), planes.end() - 1,
          [&](const Plane& a, const Plane& b) { return covered(a, now) < covered(b, now); });
      worker.forget(smallest->spec.id);
      planes.erase(smallest);
    }
  }
  const Vec at = planes.back().spec.view.to_px(now.origin_mm);
  left = std::llround(at.x);
  top = std::llround(at.y);
}

void InkView::State::drop_over() {
  if (over) worker.forget(over->spec.id);
  over.reset();
}

void InkView::State::choose_over() {
  const Plane& plane = planes.back();
  if (over && over->spec.above == new_ink && over->style == style &&
      over->spec.view == plane.spec.view) {
    return;
  }
  drop_over();
  if (!new_ink) return;
  over = Plane{{++last_plane, plane.spec.view, plane.spec.style, new_ink}, style, {}};
}

void InkView::State::ask() {
  choose_plane();
  choose_over();
  worker.look(planes.back().spec, seen(), over ? std::optional(over->spec) : std::nullopt);
}

QRect InkView::State::on_widget(const PlaneRect& px) const {
  const QRect device(static_cast<int>(px.x0 - left), static_cast<int>(px.y0 - top),
                     static_cast<int>(px.x1 - px.x0), static_cast<int>(px.y1 - px.y0));
  return widget_rect(device, dpr);
}

InkView::InkView(QObject* parent)
    : QObject(parent), state_(std::make_unique<State>([this] {
        QMetaObject::invokeMethod(this, &InkView::take_news, Qt::QueuedConnection);
      })) {}

InkView::~InkView() = default;

void InkView::set_document(const Document& document) {
  State& s = *state_;
  s.fresh.clear();
  s.looks.clear();
  for (const Layer& l : document.layers()) s.looks[l.id] = State::look_of(l.state());
  for (State::Plane& plane : s.planes) plane.tiles.clear();
  if (s.over) s.over->tiles.clear();
  s.is_previewing = false;
  s.opened = s.worker.open(document);
  Q_EMIT changed(QRect({0, 0}, s.view.size().toSize()));
}

void InkView::apply(const Edit& edit) {
  State& s = *state_;
  s.is_previewing = false;
  const std::uint64_t order = s.worker.apply(edit);
  for (const LayerChange& c : edit.layers) {
    if (c.after) s.looks[c.id] = State::look_of(*c.after);
  }
  if (!edit.layers.empty() && s.over) {  // the layers above may have changed
    s.drop_over();
    s.ask();
  }
  const auto is_changed = [&edit](const State::Fresh& fresh) {
    return std::any_of(edit.changes.begin(), edit.changes.end(),
                       [&fresh](const StrokeChange& c) { return c.id == fresh.id; });
  };
  if (!s.fresh.empty()) {
    s.fresh.erase(std::remove_if(s.fresh.begin(), s.fresh.end(), is_changed), s.fresh.end());
  }
  if (!edit.layers.empty() || edit.changes.size() > kMaxFresh || s.planes.empty()) return;
  const PlaneSpec& plane = s.planes.back().spec;
  for (const StrokeChange& c : edit.changes) {
    const State::Look look = s.looks[c.after_place.layer];
    if (c.before || !(look.opacity > 0.0)) continue;
    if (c.after->segment_count() > kMaxFreshSegments) continue;
    s.fresh.push_back({order, c.id, c.after, c.after_place.layer, look.opacity, look.multiplies});
    const Rect px = plane.view.area_px(c.after->bounds()).inflated(2.0);
    const auto whole = [](double x) { return std::llround(std::clamp(x, -2e9, 2e9)); };
    Q_EMIT changed(
        s.on_widget(PlaneRect{whole(px.x0), whole(px.y0), whole(px.x1), whole(px.y1)}.intersected(
            {s.left, s.top, s.left + 65536, s.top + 65536})));
  }
}

void InkView::show(const std::optional<Edit>& preview) {
  State& s = *state_;
  if (!preview && !s.is_previewing) return;
  s.is_previewing = preview.has_value();
  s.worker.show(preview);
}

void InkView::set_view(const CanvasView& view, double dpr) {
  State& s = *state_;
  s.view = view;
  s.dpr = dpr > 0.0 ? dpr : 1.0;
  s.ask();
}

void InkView::set_grain(const Grain& grain) {
  if (grain == state_->grain) return;
  state_->grain = grain;
  ++state_->style;
  state_->ask();
}

void InkView::set_paper(Rgba paper) {
  if (paper.a < 255) paper = {255, 255, 255, 255};
  if (paper == state_->paper) return;
  state_->paper = paper;
  ++state_->style;
  if (!state_->planes.empty()) state_->ask();
}

void InkView::set_outline_mode(bool on) {
  if (std::exchange(state_->is_outline, on) == on) return;
  ++state_->style;
  state_->ask();
}

void InkView::draw_below(std::optional<LayerId> layer) {
  if (std::exchange(state_->new_ink, layer) == layer || state_->planes.empty()) return;
  state_->ask();
}

void InkView::cover(QImage& ink, QPoint at) {
  state_->cover(ink, at);
}

QTransform InkView::transform() const {
  if (state_->planes.empty()) return state_->view.transform();
  QTransform from = transform_of(state_->planes.back().spec.view);
  const double dpr = state_->dpr;
  return from *
         QTransform::fromTranslate(-static_cast<double>(state_->left),
                                   -static_cast<double>(state_->top)) *
         QTransform::fromScale(1.0 / dpr, 1.0 / dpr);
}

bool InkView::is_up_to_date() const {
  return state_->worker.stage() >= InkWorker::Stage::kComplete;
}

int InkView::missing_tiles() const {
  const State& s = *state_;
  if (s.planes.empty()) return 0;
  const TileRange range = TileRange::of(s.seen());
  int missing = 0;
  for (std::int64_t y = range.first.y; y <= range.last.y; ++y) {
    for (std::int64_t x = range.first.x; x <= range.last.x; ++x) {
      missing += s.planes.back().tiles.count({y, x}) == 0 ? 1 : 0;
    }
  }
  return missing;
}

void InkView::finish() {
  state_->worker.wait(InkWorker::Stage::kComplete);
  take_news();
}

/// Accepts the worker's tiles and emits the parts of the widget that they change.
void InkView::take_news() {
  State& s = *state_;
  const PlaneRect seen = s.seen();
  for (TileNews& news : s.worker.take_news()) {
    if (s.over && news.plane == s.over->spec.id) {
      take_over(news);
      continue;
    }
    const auto plane =
        std::find_if(s.planes.begin(), s.planes.end(),
                     [&news](const State::Plane& p) { return p.spec.id == news.plane; });
    if (plane == s.planes.end()) continue;
    if (!news.is_there) {
      plane->tiles.erase(news.place);
      continue;
    }
    if (news.order < s.opened) continue;
    plane->tiles[news.place] = {std::move(news.picture), news.order};
    if (&*plane != s.current()) continue;
    const PlaneRect tile = rect_of(news.place);
    const PlaneRect part = PlaneRect{tile.x0 + news.changed.x0, tile.y0 + news.changed.y0,
                                     tile.x0 + news.changed.x1, tile.y0 + news.changed.y1}
                               .intersected(seen);
    if (!part.empty()) Q_EMIT changed(s.on_widget(part));
  }
  const std::uint64_t repaired = s.worker.repaired_order();
  const auto is_old = [&](const State::Fresh& f) { return f.order <= repaired; };
  if (!s.fresh.empty()) {
    s.fresh.erase(std::remove_if(s.fresh.begin(), s.fresh.end(), is_old), s.fresh.end());
  }
}

/// Accepts a tile of the layers that cover new ink.
void InkView::take_over(TileNews& news) {
  State& s = *state_;
  if (!news.is_there) {
    s.over->tiles.erase(news.place);
    return;
  }
  if (news.order < s.opened) return;
  const bool is_first = s.over->tiles.count(news.place) == 0;
  s.over->tiles[news.place] = {std::move(news.picture), news.order};
  // New ink may already have been painted without this tile above it, so the area is painted again.
  const PlaneRect part = rect_of(news.place).intersected(s.seen());
  if (is_first && !part.empty()) Q_EMIT changed(s.on_widget(part));
}

/// Waits at most kPatience for the worker and then copies the tiles of the current plane. Fills
/// missing tiles from the plane that covers most of the view. Paints new strokes over tiles that
/// are older than these strokes.
void InkView::paint(QPainter& painter, const QRect& part) {
  State& s = *state_;
  if (s.planes.empty()) return;
  if (s.worker.stage() == InkWorker::Stage::kBusy) {
    s.worker.wait(InkWorker::Stage::kRepaired, kPatience);
  }
  take_news();
  const QRect device = device_rect(part, s.dpr);
  painter.save();
  painter.setClipRect(part, Qt::IntersectClip);
  painter.scale(1.0 / s.dpr, 1.0 / s.dpr);  // the following code uses device pixels
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  QRegion missing;
  s.copy_tiles(painter, s.planes.back(), device, missing);
  if (!missing.isEmpty()) s.paint_others(painter, missing);
  if (!s.fresh.empty()) s.paint_fresh(painter, s.planes.back(), device);
  painter.restore();
}

void InkView::State::copy_tiles(QPainter& painter, const Plane& plane, const QRect& device,
                                QRegion& missing) {
  const PlaneRect wanted = plane_rect(device);
  if (wanted.empty()) return;
  const TileRange range = TileRange::of(wanted);
  for (std::int64_t y = range.first.y; y <= range.last.y; ++y) {
    for (std::int64_t x = range.first.x; x <= range.last.x; ++x) {
      const PlaneRect tile = rect_of({y, x}), both = tile.intersected(wanted);
      const QRect to(static_cast<int>(both.x0 - left), static_cast<int>(both.y0 - top),
                     static_cast<int>(both.x1 - both.x0), static_cast<int>(both.y1 - both.y0));
      const auto found = plane.tiles.find({y, x});
      if (found == plane.tiles.end()) {
        missing += to;
      } else if (found->second.picture) {
        const QImage image(found->second.picture->bytes.data(), kTileSide, kTileSide, 4 * kTileSide,
                           QImage::Format_ARGB32_Premultiplied);
        painter.drawImage(to.topLeft(), image,
                          QRect(static_cast<int>(both.x0 - tile.x0),
                                static_cast<int>(both.y0 - tile.y0), to.width(), to.height()));
      }
    }
  }
}

/// Returns the approximate share of a view that the tiles of another plane can show, 0..1.
double InkView::State::covered(const Plane& plane, const View& from) const {
  const double width = view.size().width() * dpr, height = view.size().height() * dpr;
  const Rect seen = plane.spec.view.area_px(from.area_mm({0, 0}, {width, height}));
  double area = 0.0;
  for (const auto& [place, tile] : plane.tiles) {
    const PlaneRect r = rect_of(place);
    const double w =
        std::min(seen.x1, static_cast<double>(r.x1)) - std::max(seen.x0, static_cast<double>(r.x0));
    const double h =
        std::min(seen.y1, static_cast<double>(r.y1)) - std::max(seen.y0, static_cast<double>(r.y0));
    if (w > 0.0 && h > 0.0) area += w * h;
  }
  return area / (seen.width() * seen.height());
}

/// Fills missing tiles with those of another plane, scaled and turned.
void InkView::State::paint_others(QPainter& painter, const QRegion& missing) {
  const View& here = planes.back().spec.view;
  const View seen = here.from({static_cast<double>(left), static_cast<double>(top)});
  const Plane* best = nullptr;
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
    const double share = covered(planes[i], seen);
    if (share < largest || share <= 0.0) continue;
    largest = share;
    best = &planes[i];
  }
  if (!best) return;
  painter.save();
  painter.setClipRegion(missing, Qt::IntersectClip);
  painter.setTransform(transform_of(best->spec.view).inverted() * transform_of(seen), true);
  for (const auto& [place, tile] : best->tiles) {
    if (!tile.picture) continue;
    const PlaneRect r = rect_of(place);
    const QImage image(tile.picture->bytes.data(), kTileSide, kTileSide, 4 * kTileSide,
                       QImage::Format_ARGB32_Premultiplied);
    painter.drawImage(QPointF(static_cast<double>(r.x0), static_cast<double>(r.y0)), image);
  }
  painter.restore();
}

/// Paints new strokes over the tiles that do not contain them yet.
void InkView::State::paint_fresh(QPainter& painter, Plane& plane, const QRect& device) {
  const View seen = plane.spec.view.from({static_cast<double>(left), static_cast<double>(top)});
  for (const Fresh& f : fresh) {
    const Rect px = seen.area_px(f.stroke->bounds()).inflated(2.0);
    const QRect box =
        QRectF(QPointF(px.x0, px.y0), QPointF(px.x1, px.y1)).toAlignedRect().intersected(device);
    if (box.isEmpty()) continue;
    const PlaneRect wanted = plane_rect(box);
    const TileRange range = TileRange::of(wanted);
    QRegion stale;
    for (std::int64_t y = range.first.y; y <= range.last.y; ++y) {
      for (std::int64_t x = range.first.x; x <= range.last.x; ++x) {
        const auto found = plane.tiles.find({y, x});
        if (found != plane.tiles.end() && found->second.order >= f.order) continue;
        const PlaneRect both = rect_of({y, x}).intersected(wanted);
        stale += QRect(static_cast<int>(both.x0 - left), static_cast<int>(both.y0 - top),
                       static_cast<int>(both.x1 - both.x0), static_cast<int>(both.y1 - both.y0));
      }
    }
    if (stale.isEmpty()) continue;
    QImage image(box.size(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const Pixels pixels{image.bits(), image.width(), image.height(), image.bytesPerLine(),
                        PixelOrder::kBgra};
    strokes.draw(*f.stroke, seen.from({static_cast<double>(box.x()), static_cast<double>(box.y())}),
                 pixels.rect(), plane.spec.style, pixels);
    if (f.layer == new_ink) cover(image, box.topLeft());
    painter.save();
    painter.setClipRegion(stale, Qt::IntersectClip);
    painter.setOpacity(f.opacity);
    if (f.multiplies) painter.setCompositionMode(QPainter::CompositionMode_Multiply);
    painter.drawImage(box.topLeft(), image);
    painter.restore();
  }
}

void InkView::State::cover(QImage& ink, QPoint at) {
  if (!over) return;
  QPainter painter(&ink);
  painter.setCompositionMode(QPainter::CompositionMode_SourceAtop);
  painter.translate(-at);
  QRegion missing;
  copy_tiles(painter, *over, QRect(at, ink.size()), missing);
}

}  // namespace felt::desktop
