#include "desktop/canvas/film_view.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QThreadPool>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

constexpr int kFilmRoomPx = 16;  // around the page
constexpr int kTickMs = 1000 / (2 * FilmView::kFramesPerSecond);

QImage as_qimage(const Image& image) {
  return QImage(image.bytes().data(), image.width(), image.height(), 4 * image.width(),
                QImage::Format_RGBA8888_Premultiplied)
      .convertToFormat(QImage::Format_RGB32);  // a copy, fast to paint
}

}  // namespace

/// What the thread and the view share.
struct FilmView::Work {
  std::atomic<bool> is_cancelled{false};
  mutable std::mutex mutex;
  std::vector<QImage> ready;  // in the order of the pictures
  QString error;

  void make(std::vector<FilmKey> keys, const PageOptions& page);
  void fail_with(const Error& why) {
    const std::lock_guard lock(mutex);
    error = text_of(why);
  }
};

void FilmView::Work::make(std::vector<FilmKey> keys, const PageOptions& page) {
  KeyFilm film;
  for (FilmKey& key : keys) {
    if (is_cancelled) return;
    if (const Result<void> added = film.add(std::move(key)); !added) {
      return fail_with(added.error());
    }
  }
  for (std::size_t i = 0; i < film.size() && !is_cancelled; ++i) {
    const Result<Image> image = render_page(film.picture(i).document, page, PictureChoice::kMarked);
    if (!image) return fail_with(image.error());
    const std::lock_guard lock(mutex);
    ready.push_back(as_qimage(*image));
  }
}

FilmView::FilmView(Canvas& canvas) : QWidget(&canvas), canvas_(canvas) {
  setAccessibleName(tr("Film of the key drawings"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_AcceptTouchEvents);
  hide();
  canvas.installEventFilter(this);
  tick_.setTimerType(Qt::PreciseTimer);
  tick_.setInterval(kTickMs);
  connect(&tick_, &QTimer::timeout, this, &FilmView::advance);
  Studio& studio = canvas.studio();
  connect(&studio, &Studio::edited, this, &FilmView::stop);
  connect(&studio, &Studio::opened, this, &FilmView::stop);
  connect(&studio, &Studio::shown, this, [this, &studio] {
    if (is_playing() && in_contact(studio.pen().sample)) stop();
  });
}

FilmView::~FilmView() {
  if (work_) work_->is_cancelled = true;
}

void FilmView::play(std::vector<FilmKey> keys) {
  stop();
  pictures_.clear();
  std::size_t count = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const KeyTiming& timing = keys[k].timing;
    pictures_.insert(pictures_.end(), std::size_t(timing.hold), count++);
    if (k + 1 == keys.size()) break;
    for (int i = 0; i < timing.between; ++i) pictures_.push_back(count++);
  }
  const Page& shown = keys.front().drawing.page;
  const Rect area = shown.area();
  const QSizeF room =
      QSizeF(canvas_.size() - QSize(2 * kFilmRoomPx, 2 * kFilmRoomPx)) * devicePixelRatioF();
  double px_per_mm = std::min(room.width() / area.width(), room.height() / area.height());
  const double bytes = 4.0 * double(count) * area.width() * area.height() * px_per_mm * px_per_mm;
  px_per_mm *= std::min(1.0, std::sqrt(kMaxBytes / bytes));
  PageOptions page;
  page.dpi = kMmPerInch * std::max(px_per_mm, 0.01);
  page.area = area;
  page.paper = shown.paper;
  if (page.paper.a < 255) page.paper = {255, 255, 255, 255};
  work_ = std::make_shared<Work>();
  frame_ = 0;
  steps_ = 0;
  clock_.start();
  tick_.start();
  setGeometry(canvas_.rect());
  show();
  raise();
  setFocus();
  QThreadPool::globalInstance()->start(
      [work = work_, keys = std::move(keys), page] { work->make(keys, page); });
}

void FilmView::stop() {
  if (!work_) return;
  work_->is_cancelled = true;
  QString why;
  {
    const std::lock_guard lock(work_->mutex);
    why = work_->error;
  }
  work_.reset();
  tick_.stop();
  hide();
  canvas_.setFocus();
  Q_EMIT stopped(why);
}

std::size_t FilmView::ready() const {
  if (!work_) return 0;
  const std::lock_guard lock(work_->mutex);
  return work_->ready.size();
}

/// Goes on to the frame of the present time, or to the last one before it whose picture is ready.
void FilmView::advance() {
  const std::size_t ready_now = ready();
  {
    const std::lock_guard lock(work_->mutex);
    if (!work_->error.isEmpty()) return QTimer::singleShot(0, this, &FilmView::stop);
  }
  const std::int64_t due = clock_.elapsed() * kFramesPerSecond / 1000;
  const std::size_t before = frame_;
  while (steps_ < due) {
    ++steps_;
    const std::size_t next = (frame_ + 1) % pictures_.size();
    if (pictures_[next] < ready_now) frame_ = next;
  }
  if (frame_ != before || before == 0) update();
}

void FilmView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Dark));
  if (!work_) return;
  QImage picture;
  {
    const std::lock_guard lock(work_->mutex);
    if (pictures_[frame_] < work_->ready.size()) picture = work_->ready[pictures_[frame_]];
  }
  if (picture.isNull()) return;
  const QSizeF room = size() - QSize(2 * kFilmRoomPx, 2 * kFilmRoomPx);
  const QSizeF shown = QSizeF(picture.size()).scaled(room, Qt::KeepAspectRatio);
  const QRectF place(QPointF(0.5 * (width() - shown.width()), 0.5 * (height() - shown.height())),
                     shown);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place, picture);
}

bool FilmView::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::ShortcutOverride:  // keys do not reach the tools
      event->accept();
      return true;
    case QEvent::KeyPress:
      if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) stop();
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
      event->accept();
      stop();
      return true;
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::Wheel:
      event->accept();
      return true;
    default:
      return QWidget::event(event);
  }
}

bool FilmView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &canvas_ && event->type() == QEvent::Resize) setGeometry(canvas_.rect());
  return QWidget::eventFilter(watched, event);
}

}  // namespace felt::desktop
