#include "desktop/canvas/match_view.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <algorithm>
#include <utility>

#include "felt/motion/key_layers.h"
#include "felt/motion/stroke_shape.h"

namespace felt::desktop {
namespace {

constexpr double kReachPx = 20.0;  // from the pen to the line that it means
constexpr double kDragPx = 6.0;    // a shorter way is a click
constexpr double kCirclePx = 5.0;
const QColor kMatchColor(0, 114, 178), kGivenColor(213, 94, 0);

Point middle_of(const Stroke& stroke) {
  return shape_of(stroke).points[kShapePoints / 2];
}

/// Returns the next key drawing, or an empty id.
LayerId next_key(const Document& document, LayerId key) {
  const std::vector<LayerId> keys = key_layers(document);
  const auto here = std::find(keys.begin(), keys.end(), key);
  return here == keys.end() || here + 1 == keys.end() ? LayerId{} : *(here + 1);
}

bool shares_stroke(const KeyPair& a, const KeyPair& b) {
  return (a.from && a.from == b.from) || (a.to && a.to == b.to);
}

}  // namespace

MatchView::MatchView(Canvas& canvas) : QWidget(&canvas), canvas_(canvas) {
  setAccessibleName(tr("Matches of two key drawings"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_NoSystemBackground);
  setMouseTracking(true);
  setCursor(Qt::PointingHandCursor);
  hide();
  canvas.installEventFilter(this);
  const auto refresh = [this] {
    if (isHidden()) return;
    if (!read_keys()) return stop();
    update();
  };
  Studio& studio = canvas.studio();
  connect(&studio, &Studio::edited, this, refresh);
  connect(&studio, &Studio::layer_changed, this, refresh);
  connect(&studio, &Studio::opened, this, &MatchView::stop);
  connect(&canvas, &Canvas::view_changed, this, qOverload<>(&QWidget::update));
}

bool MatchView::start() {
  canvas_.studio().finish_gesture();
  if (!read_keys()) return false;
  pressed_.reset();
  setGeometry(canvas_.rect());
  show();
  raise();
  setFocus();
  return true;
}

void MatchView::stop() {
  if (isHidden()) return;
  hide();
  canvas_.setFocus();
  Q_EMIT stopped();
}

std::vector<KeyPair> MatchView::pairs() const {
  const Layer* layer = canvas_.studio().session().document().layer(key_);
  return timing_or_default(layer ? layer->timing : nullptr).pairs;
}

bool MatchView::read_keys() {
  const Studio& studio = canvas_.studio();
  const Document& document = studio.session().document();
  key_ = studio.session().layer();
  const LayerId next = next_key(document, key_);
  shown_.clear();
  is_stale_ = true;
  if (!next) return false;
  from_ = key_strokes(key_drawing(document, key_, studio.page()).document);
  to_ = key_strokes(key_drawing(document, next, studio.page()).document);
  return true;
}

const std::vector<MatchView::Shown>& MatchView::shown() {
  if (std::exchange(is_stale_, false)) find_matches();
  return shown_;
}

void MatchView::find_matches() {
  ++searches_;
  const std::vector<GivenPair> given = given_pairs({.pairs = pairs()}, from_, to_);
  const auto show = [this](const auto& from, const auto& to, bool is_given) {
    Shown shown{{}, {}, is_given};
    if (from) shown.from = middle_of(*from_.strokes[*from]);
    if (to) shown.to = middle_of(*to_.strokes[*to]);
    shown_.push_back(shown);
  };
  if (std::max(from_.strokes.size(), to_.strokes.size()) > kMaxShown) {
    for (const GivenPair& pair : given) show(pair.from, pair.to, true);
    return;
  }
  const Result<Correspondence> found = match_strokes(from_.strokes, to_.strokes, given);
  if (!found) return;
  for (const StrokeMatch& match : found->matches) show(match.from, match.to, match.is_given);
}

void MatchView::press(QPointF at) {
  pressed_ = pen_ = at;
  update();
}

void MatchView::move(QPointF at) {
  if (!pressed_) return;
  pen_ = at;
  update();
}

void MatchView::release(QPointF at) {
  if (!pressed_) return;
  const QPointF start = *std::exchange(pressed_, std::nullopt);
  update();
  const CanvasView& view = canvas_.view();
  const double reach_mm = kReachPx / view.px_per_mm();
  const Point a = view.to_mm(start), b = view.to_mm(at);
  if (QLineF(start, at).length() < kDragPx) return toggle_at(a, reach_mm);
  auto pair = pair_by_line(from_.strokes, to_.strokes, a, b, reach_mm);
  if (!pair) pair = pair_by_line(from_.strokes, to_.strokes, b, a, reach_mm);
  if (pair) correct({from_.ids[*pair->from], to_.ids[*pair->to]});
}

void MatchView::correct(const KeyPair& pair) {
  std::vector<KeyPair> all = pairs();
  std::erase_if(all, [&pair](const KeyPair& other) { return shares_stroke(pair, other); });
  all.push_back(pair);
  send(std::move(all));
}

void MatchView::toggle_at(Point at, double reach_mm) {
  KeyPair pair;
  if (const auto here = pair_by_line(from_.strokes, from_.strokes, at, at, reach_mm)) {
    pair.from = from_.ids[*here->from];
  } else if (const auto there = pair_by_line(to_.strokes, to_.strokes, at, at, reach_mm)) {
    pair.to = to_.ids[*there->from];
  } else {
    return;
  }
  std::vector<KeyPair> all = pairs();
  const std::size_t erased =
      std::erase_if(all, [&pair](const KeyPair& other) { return shares_stroke(pair, other); });
  if (erased == 0) all.push_back(pair);
  send(std::move(all));
}

void MatchView::send(std::vector<KeyPair> pairs) {
  canvas_.studio().apply(TimingEvent{.layers = {key_}, .pairs = std::move(pairs)});
}

void MatchView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const CanvasView& view = canvas_.view();
  for (const Shown& match : shown()) {
    painter.setPen(QPen(match.is_given ? kGivenColor : kMatchColor, match.is_given ? 2.5 : 1.2));
    if (match.from && match.to) {
      painter.drawLine(view.to_px(*match.from), view.to_px(*match.to));
    } else {
      painter.drawEllipse(view.to_px(match.from ? *match.from : *match.to), kCirclePx, kCirclePx);
    }
  }
  if (pressed_) {
    painter.setPen(QPen(kGivenColor, 2.0, Qt::DashLine));
    painter.drawLine(*pressed_, pen_);
  }
  const QString hint =
      tr("Drag from a line to the line that it becomes in the next key drawing. "
         "Click a line without a partner. Esc ends.");
  const QRectF room = QRectF(rect()).adjusted(12, 8, -12, -8);
  QRectF box = painter.boundingRect(room, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, hint);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::ToolTipBase));
  painter.drawRoundedRect(box.adjusted(-8, -4, 8, 4), 4, 4);
  painter.setPen(palette().color(QPalette::ToolTipText));
  painter.drawText(box, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, hint);
}

bool MatchView::event(QEvent* event) {
  const auto handle = [this](QEvent::Type type, QPointF at) {
    if (type == QEvent::MouseButtonPress || type == QEvent::TabletPress) press(at);
    if (type == QEvent::MouseMove || type == QEvent::TabletMove) move(at);
    if (type == QEvent::MouseButtonRelease || type == QEvent::TabletRelease) release(at);
  };
  switch (event->type()) {
    case QEvent::KeyPress:
      if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) break;
      stop();
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
      event->accept();
      handle(event->type(), static_cast<QMouseEvent*>(event)->position());
      return true;
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
      event->accept();
      handle(event->type(), static_cast<QTabletEvent*>(event)->position());
      return true;
    case QEvent::MouseButtonDblClick:
      event->accept();
      return true;
    default:
      break;
  }
  return QWidget::event(event);
}

bool MatchView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &canvas_ && event->type() == QEvent::Resize) setGeometry(canvas_.rect());
  return QWidget::eventFilter(watched, event);
}

}  // namespace felt::desktop
