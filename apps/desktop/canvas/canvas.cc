#include "desktop/canvas/canvas.h"

#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <cmath>

#include "desktop/canvas/canvas_setting_keys.h"
#include "desktop/canvas/canvas_shown.h"
#include "desktop/engine/settings.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/session/session_medium.h"
#include "felt/tools/guide_picture.h"

namespace felt::desktop {
namespace {

constexpr int kPlaceMs = 40;     // time between two `place_changed`
constexpr double kDearMs = 1.0;  // if a refresh and its paint take less, the next refresh need not
                                 // wait
constexpr double kMaxPaceMs = 33;
constexpr int kLongSegments = 400;  // a stroke with more segments is not in the tiles immediately
constexpr int kDryMs = 8;
constexpr int kSizeMs = 1200;  // shows the ring of a changed size for this time

/// Returns a cross with an open middle, dark with a light rim: visible on any paper, and precise.
QCursor make_pen_cursor() {
  constexpr int kSize = 19, kMiddle = kSize / 2, kOpen = 3;
  QPixmap picture(kSize, kSize);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  for (const auto& [color, width] :
       {std::pair{QColor(255, 255, 255, 200), 3}, {QColor(20, 20, 24), 1}}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
    for (const QPoint way : {QPoint(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      painter.drawLine(QPoint(kMiddle, kMiddle) + way * kOpen,
                       QPoint(kMiddle, kMiddle) + way * (kMiddle - 1));
    }
  }
  painter.end();
  return QCursor(picture, kMiddle, kMiddle);
}

/// Enlarges a region to whole device pixels. Pixels that its edge cuts would otherwise not be
/// repainted.
QRegion whole_pixels(const QRegion& region, double dpr) {
  if (std::abs(dpr - std::round(dpr)) < 1e-6) return region;
  QRegion wider;
  for (const QRect& part : region) wider += part.adjusted(-1, -1, 1, 1);
  return wider;
}

}  // namespace

Canvas::Canvas(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      shown_(std::make_unique<Shown>()),
      pen_cursor_(make_pen_cursor()) {
  setAccessibleName(tr("Drawing area"));
  setAccessibleDescription(tr("The area to draw on"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setContextMenuPolicy(Qt::PreventContextMenu);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setMinimumSize(200, 150);
  setCursor(pen_cursor_);
  shown_->place.setSingleShot(true);
  shown_->place.setInterval(kPlaceMs);
  connect(&shown_->place, &QTimer::timeout, this, &Canvas::place_changed);
  shown_->size_ring.setSingleShot(true);
  shown_->size_ring.setInterval(kSizeMs);
  connect(&shown_->size_ring, &QTimer::timeout, this, &Canvas::refresh_soon);
  pace_.setSingleShot(true);
  pace_.setTimerType(Qt::PreciseTimer);
  connect(&pace_, &QTimer::timeout, this, &Canvas::flush);
  clock_.start();
  take_document();
  listen();
  take_layers();
  take_look();
  take_grain();
}

Canvas::~Canvas() = default;

void Canvas::listen() {
  connect(&studio_, &Studio::edited, this, &Canvas::on_edit);
  connect(&studio_, &Studio::opened, this, [this] {
    take_document();
    take_layers();
    take_grain();
    fit_page();
  });
  connect(&studio_, &Studio::shown, this, [this] {
    take_view_of_layers();
    refresh_soon();
  });
  connect(&studio_, &Studio::page_changed, this, [this] {
    take_look();
    if (keeps_page_fitted_) fit_page();
    lay_out();
  });
  connect(&studio_, &Studio::layer_changed, this, &Canvas::take_layers);
  connect(&studio_, &Studio::tool_changed, this, &Canvas::hint_changed);
  connect(&studio_, &Studio::elsewhere_changed, this, &Canvas::hint_changed);
  connect(&studio_, &Studio::option_changed, this, [this](const QString& id) {
    if (id == QLatin1String(kSurfaceOptionId) || id.endsWith(QLatin1String(".medium")))
      take_grain();
    if (id.endsWith(QLatin1String(".mode"))) Q_EMIT hint_changed();
    show_size(id);
  });
  connect(&studio_, &Studio::materials_changed, this, &Canvas::take_grain);
  connect(&Settings::the(), &Settings::changed, this, [this](const QString& key) {
    if (!key.startsWith(QLatin1String("canvas/"))) return;
    take_grain();
    refresh_soon();
  });
  connect(&ink_, &InkView::changed, this, &Canvas::on_ink);
}

// --- The view

void Canvas::take_view(const CanvasView& view) {
  const QSizeF size = view_.size();
  view_ = view;
  view_.set_size(size);
  lay_out();
  Q_EMIT view_changed();
}

void Canvas::set_view(const CanvasView& view) {
  keeps_page_fitted_ = false;
  take_view(view);
}

void Canvas::fit_page() {
  keeps_page_fitted_ = true;
  CanvasView view = view_;
  view.fit(studio_.page().area());
  take_view(view);
}

void Canvas::fit_selection() {
  const Rect box = studio_.session().selection().bounds(studio_.session().document());
  if (box.empty()) return fit_page();
  CanvasView view = view_;
  view.fit(box);
  set_view(view);
}

void Canvas::fit_ink() {
  Rect all;
  const Document& document = studio_.session().seen();
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) all.extend(document.find(id)->bounds());
    for (const FillId id : layer.fills) all.extend(fill_bounds(*document.find_fill(id)));
  }
  if (all.empty()) return fit_page();
  CanvasView view = view_;
  view.fit(all);
  set_view(view);
}

double Canvas::zoom() const {
  return view_.px_per_mm() * 25.4 / logicalDpiX();
}

void Canvas::set_zoom(double zoom) {
  CanvasView view = view_;
  view.zoom(zoom / this->zoom(), anchor());
  set_view(view);
}

QPointF Canvas::anchor() const {
  if (underMouse()) return mapFromGlobal(QCursor::pos());
  return {0.5 * width(), 0.5 * height()};
}

void Canvas::set_notes(const Overlay& notes) {
  shown_->notes = notes;
  refresh_soon();
}

void Canvas::set_onion(const std::optional<Document>& onion) {
  Shown& s = *shown_;
  if (onion && !s.onion) {
    s.onion = std::make_unique<InkView>();
    s.onion->set_view(view_, devicePixelRatioF());
    s.onion->set_paper(studio_.page().paper);
    take_grain();
    connect(s.onion.get(), &InkView::changed, this, &Canvas::on_ink);
  }
  if (onion) {
    s.onion->set_document(*onion);
  } else {
    s.onion.reset();
  }
  update();
}

void Canvas::center_on(Point at) {
  CanvasView view = view_;
  view.center_on(at);
  set_view(view);
}

void Canvas::set_outline_mode(bool on) {
  ink_.set_outline_mode(on);
  shown_->wet.set_outline_mode(on);
  update();
}

/// Computes the positions of everything again and repaints the whole widget. Called if the view or
/// the size changed.
void Canvas::lay_out() {
  dpr_ = devicePixelRatioF();
  ink_.set_view(view_, dpr_);
  if (shown_->onion) shown_->onion->set_view(view_, dpr_);
  const DeviceView view{view_, dpr_, ink_.transform().map(QPointF(0, 0)) - view_.to_px({0, 0})};
  shown_->wet.set_view(view);
  shown_->bands.set_view(view);
  refresh_soon();
  update();
}

/// Shows the document as it is now, without the layers that are out of view.
void Canvas::take_document() {
  shown_->out_of_view = studio_.session().out_of_view();
  ink_.set_document(studio_.session().seen());
}

/// Returns false if the same layers as before are out of view.
bool Canvas::take_view_of_layers() {
  if (shown_->out_of_view == studio_.session().out_of_view()) return false;
  take_document();
  take_layers();
  update();
  return true;
}

/// Tells the ink view to put new ink below the ink of the layers above the current one.
void Canvas::take_layers() {
  const Session& session = studio_.session();
  const auto& layers = session.seen().layers();
  const auto use = std::find_if(layers.begin(), layers.end(),
                                [&](const Layer& l) { return l.id == session.layer(); });
  const bool is_covered =
      use != layers.end() && std::any_of(use + 1, layers.end(), [](auto& l) {
        return l.visible && !(l.strokes.empty() && l.fills.empty() && !l.picture);
      });
  ink_.draw_below(is_covered ? std::optional(session.layer()) : std::nullopt);
}

void Canvas::take_look() {
  shown_->desk.set_page(studio_.page());
  ink_.set_paper(studio_.page().paper);
  if (shown_->onion) shown_->onion->set_paper(studio_.page().paper);
  shown_->desk.set_palette(palette());
  shown_->look = MarkLook(shown_->desk.paper());
  update();
}

void Canvas::take_grain() {
  const bool on = Settings::the().flag(canvas_keys::kGrain, canvas_keys::kGrainDefault);
  const Session& session = studio_.session();
  const Grain grain = on ? Grain(surface_grain(session.surface()), session.materials())
                         : Grain::solid(session.materials());
  ink_.set_grain(grain);
  if (shown_->onion) shown_->onion->set_grain(grain);
  shown_->wet.set_grain(grain, drawing_medium(session));
  update();
}

// --- Changes of the studio

void Canvas::refresh_soon() {
  is_stale_ = true;
  if (!pace_.isActive()) flush();
}

void Canvas::flush() {
  pace_.stop();
  if (!is_stale_) return;
  const double begin_ms = static_cast<double>(clock_.nsecsElapsed()) * 1e-6;
  refresh();
  const double cost_ms = static_cast<double>(clock_.nsecsElapsed()) * 1e-6 - begin_ms + paint_ms_;
  // Waits between two pictures, so that the pen's samples are read even if painting is slow.
  if (studio_.loop().thread() && cost_ms > kDearMs) {
    pace_.start(static_cast<int>(std::min(2.0 * cost_ms, kMaxPaceMs)));
  }
}

void Canvas::refresh() {
  is_stale_ = false;
  Shown& s = *shown_;
  const Session& session = studio_.session();
  ink_.show(session.preview_with_fills());
  session.draw(s.overlay);
  // The user of a mouse or tablet does not feel the force of the simulated stylus.
  if (session.device().has_force() && studio_.loop().device().hand()) {
    session.draw_guide_spring(s.overlay);
  }
  // Removes the size ring, because the line itself shows its width.
  if (in_contact(studio_.pen().sample)) s.size_ring.stop();
  if (s.size_ring.isActive()) add_size_ring();
  QRegion dirty(s.bands.update(s.overlay.spans));
  dirty += s.wet.update(s.overlay);
  list_marks();
  add_difference(s.marks, s.next, dirty);
  s.marks.swap(s.next);
  if (!pressure_seen_ && tablet_in_hand_ && in_contact(studio_.pen().sample)) {
    pressure_seen_ = true;
    take_status();
  }
  if (s.shows_first_minute != shows_first_minute()) {
    s.shows_first_minute = !s.shows_first_minute;
    take_status();
    Q_EMIT first_hints_changed();
  }
  if (!dirty.isEmpty()) update(whole_pixels(dirty, dpr_));
  if (!s.place.isActive()) s.place.start();
}

namespace {

/// Adds the contours of pictures that are felt.
void add_contours(Overlay& overlay, const UseEdges& edges) {
  for (const std::vector<Point>& contour : edges.contours) {
    overlay.outlines.push_back({.points = contour, .role = Overlay::Role::kTick});
  }
}

}  // namespace

void Canvas::list_marks() {
  Shown& s = *shown_;
  s.next.clear();
  const Session& session = studio_.session();
  s.guides.clear();
  const std::optional<Edit>& preview = session.preview_with_fills();
  add_guide_pictures(s.guides, session.document(), preview ? &*preview : nullptr,
                     studio_.page().area());
  add_contours(s.guides, session.edges());
  list_overlay(s.guides, view_, font(), s.next);
  list_overlay(s.notes, view_, font(), s.next);
  list_overlay(s.overlay, view_, font(), s.next);
  const PenState& pen = studio_.pen();
  if (pen_visible_ && pen.is_known) list_pen(pen_mark(pen), s.next);
}

void Canvas::on_edit(const Edit& edit) {
  Shown& s = *shown_;
  if (!take_view_of_layers()) ink_.apply(studio_.session().seen_edit(edit));
  take_layers();
  // The document now contains the strokes of the wet ink. If one of them is so long that the tiles
  // will not show it immediately, the wet ink stays visible as drying ink.
  const auto is_long = [](const StrokeChange& change) {
    return change.after && change.after->segment_count() > kLongSegments;
  };
  if (s.wet.is_empty() || std::none_of(edit.changes.begin(), edit.changes.end(), is_long)) return;
  s.wet.dry();
  let_dry();
}

void Canvas::let_dry() {
  if (!shown_->wet.is_drying()) return;
  if (ink_.is_up_to_date()) {
    update(shown_->wet.release());
  } else {
    QTimer::singleShot(kDryMs, this, &Canvas::let_dry);
  }
}

void Canvas::on_ink(const QRect& part) {
  const QRegion dirty = QRegion(part) - painting_;
  if (!dirty.isEmpty()) update(whole_pixels(dirty, dpr_));
}

}  // namespace felt::desktop
