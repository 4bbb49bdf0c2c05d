#include "desktop/devices/calibration_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "felt/rt/abandon.h"

namespace felt::desktop {
namespace {

constexpr int kLookMs = 20;
constexpr double kGoodMm = 2.0;  // the user does not feel an error of at most kGoodMm at a corner
constexpr QSize kPicturePx{240, 180};
constexpr int kPictureMargin = 26;
constexpr double kCornerPx = 7, kNextPx = 11, kPenPx = 4;

}  // namespace

CalibrationDialog::CalibrationDialog(std::unique_ptr<PenDevice> device, Point middle,
                                     QWidget* parent)
    : QDialog(parent),
      device_(std::move(device)),
      old_(device_->device().plane()),
      usual_(*PlaneCalibration::from(device_->device().default_plane().rows(), {})),
      reach_(reach_of(usual_, device_->info().capabilities)),
      middle_(middle),
      picture_(new QLabel(this)),
      words_(new QLabel(this)),
      where_(new QLabel(this)) {
  setWindowTitle(tr("Drawing plane of %1").arg(device_->info().label));
  picture_->setAccessibleName(tr("The corner to touch"));
  for (QLabel* label : {words_, where_}) label->setWordWrap(true);
  words_->setMinimumWidth(40 * fontMetrics().averageCharWidth());
  auto* buttons = new QDialogButtonBox(this);
  take_ = buttons->addButton(tr("&Use this position"), QDialogButtonBox::ActionRole);
  again_ = buttons->addButton(tr("&Start again"), QDialogButtonBox::ActionRole);
  keep_ = buttons->addButton(tr("&Keep"), QDialogButtonBox::AcceptRole);
  buttons->addButton(QDialogButtonBox::Cancel);
  connect(take_, &QPushButton::clicked, this, &CalibrationDialog::take);
  connect(again_, &QPushButton::clicked, this, &CalibrationDialog::start_again);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* text = new QVBoxLayout;
  text->addWidget(words_);
  text->addWidget(where_);
  text->addStretch(1);
  auto* row = new QHBoxLayout;
  row->addWidget(picture_, 0, Qt::AlignTop);
  row->addLayout(text, 1);
  auto* rows = new QVBoxLayout(this);
  rows->addLayout(row);
  rows->addWidget(buttons);
  take_->setEnabled(false);
  for (auto* button : {take_, again_, keep_}) button->setAutoDefault(true);
  if (LoopHost* host = device_->device().loop_host()) {
    ServoOptions options;
    options.period_ns = device_->device().capabilities().period_ns;
    options.limits = limits_for(device_->device().capabilities());
    servo_ = std::make_unique<Servo>(device_->device(), options);  // the servo is never armed and
                                                                   // so sends no force
    loop_ = std::make_unique<RealtimeThread>(*servo_, RealtimeOptions{.lock_memory = false}, host);
    static_cast<void>(loop_->start());  // if this fails, the dialog reports that no samples arrive
  }
  clock_.start();
  connect(&timer_, &QTimer::timeout, this, &CalibrationDialog::look);
  timer_.start(kLookMs);
  start_again();
}

CalibrationDialog::~CalibrationDialog() {
  take_device();
}

std::unique_ptr<PenDevice> CalibrationDialog::take_device() {
  timer_.stop();
  if (loop_ && !loop_->stop()) {  // the device is unresponsive, but its call may still return at
                                  // any time
    abandon(std::move(loop_), std::move(servo_), std::move(device_));
    return nullptr;
  }
  loop_.reset();
  servo_.reset();
  if (device_) device_->device().stop();
  return std::move(device_);
}

void CalibrationDialog::run(Studio& studio, QWidget* parent) {
  const Rect page = studio.page().area();
  Result<std::unique_ptr<PenDevice>> mouse =
      open_pen_device(QString::fromLatin1(kPenDeviceDefault), page);
  if (!mouse) return;
  std::unique_ptr<PenDevice> used = studio.loop().use_device(*std::move(mouse));
  if (!used) return;  // the device is unresponsive; the studio has reported it
  const QString label = used->info().label;
  CalibrationDialog dialog(std::move(used), {0.5 * (page.x0 + page.x1), 0.5 * (page.y0 + page.y1)},
                           parent);
  const bool is_kept = dialog.exec() == QDialog::Accepted && dialog.found();
  std::unique_ptr<PenDevice> device = dialog.take_device();
  if (!device) {
    Q_EMIT studio.refused(HapticLoop::unresponsive_text(label));
    return;
  }
  const PenDeviceInfo& info = device->info();
  Result<DeviceProfile> profile = profile_of(info.id);
  if (is_kept && profile) {
    forget_planes_of_another(*profile, info.serial.toStdString());
    profile->plane = dialog.found()->calibration;
    profile->area = dialog.area();
    device->set_profile(*profile);
  }
  const Result<void> kept = !profile  ? tl::unexpected(profile.error())
                            : is_kept ? keep_profile(*profile)
                                      : Result<void>{};
  studio.loop().use_device(std::move(device));
  if (!kept) Q_EMIT studio.refused(QString::fromStdString(kept.error().message));
}

std::optional<DrawingArea> CalibrationDialog::area() const {
  if (corners_.size() != kCorners) return std::nullopt;
  const Vec3 across = corners_[1] - corners_[0], down = corners_[2] - corners_[0];
  return DrawingArea{corners_[0] + 0.5 * (across + down), norm(across), norm(down)};
}

std::uint32_t CalibrationDialog::read() {
  std::optional<PenSample> sample;
  if (servo_) {
    const TickReport& tick = servo_->latest();
    servo_->heartbeat(loop_->now_ns());
    if (tick.sample_ok) sample = tick.sample;
  } else if (const auto read = device_->device().read(clock_.nsecsElapsed())) {
    sample = *read;
  }
  place_.reset();
  if (sample && is_finite(sample->position)) place_ = old_.to_device(sample->position);
  // If the device senses only two axes, its pen is always in the plane; the height that it reports
  // only tells whether the pen is lifted. Therefore the height is set to 0.
  if (place_ && device_->device().capabilities().sensed_axes == 2) place_->z = 0.0;
  const std::uint32_t before = std::exchange(buttons_, sample ? sample->buttons : 0);
  return buttons_ & ~before;
}

void CalibrationDialog::look() {
  if ((read() & 1u) != 0) take();
  report();
  draw();
}

void CalibrationDialog::take() {
  read();  // reads the present position, because that of the last look() may be outdated
  if (!place_ || corners_.size() == kCorners) return;
  corners_.push_back(*place_);
  if (corners_.size() == kCorners) {
    const double width = norm(corners_[1] - corners_[0]), height = norm(corners_[2] - corners_[0]);
    const auto touches = corner_touches(corners_[0], corners_[1], corners_[2],
                                        middle_ - Vec{0.5 * width, 0.5 * height});
    if (Result<PlaneFit> fit = fit_plane(touches)) {
      found_ = *fit;
    } else {
      corners_.clear();
      words_->setText(
          tr("This is not a usable drawing area: %1. Start again with the upper left corner.")
              .arg(QString::fromStdString(fit.error().message)));
      draw();
      return;
    }
  }
  draw();
  static const std::array<const char*, kCorners + 1> kWords{
      QT_TR_NOOP("Hold the tip of the pen on the upper left corner of your drawing area."),
      QT_TR_NOOP("Now hold it on the upper right corner."),
      QT_TR_NOOP("Now hold it on the lower left corner."), ""};
  if (!found_) {
    words_->setText(tr(kWords[corners_.size()]));
    return;
  }
  const QString size = tr("The drawing area is %L1 mm wide and %L2 mm high.")
                           .arg(norm(corners_[1] - corners_[0]), 0, 'f', 0)
                           .arg(norm(corners_[2] - corners_[0]), 0, 'f', 0);
  const QString fit =
      found_->worst_mm <= kGoodMm
          ? tr("Its corners agree to within %L1 mm.").arg(found_->worst_mm, 0, 'f', 1)
          : tr("The corner is not square: it is off by %L1 mm. Start again for a better result.")
                .arg(found_->worst_mm, 0, 'f', 1);
  words_->setText(size + QLatin1Char(' ') + fit);
}

void CalibrationDialog::start_again() {
  corners_.clear();
  found_.reset();
  words_->setText(tr("Hold the tip of the pen on the upper left corner of your drawing area."));
  draw();
  report();
}

void CalibrationDialog::report() {
  const bool could_take = take_->isEnabled();
  take_->setEnabled(place_.has_value() && corners_.size() < kCorners);
  again_->setEnabled(!corners_.empty());
  keep_->setEnabled(found_.has_value());
  // Space and Enter must always trigger the next step, because one hand holds the pen.
  if (take_->isEnabled() && !could_take) take_->setFocus();
  if (keep_->isEnabled() && could_take && !take_->isEnabled()) keep_->setFocus();
  if (!place_) {
    where_->setText(tr("The device does not answer. Check its cable and power."));
    return;
  }
  const Vec3& p = *place_;
  const QString place = tr("The pen is at %L1, %L2, %L3 mm.")
                            .arg(p.x, 0, 'f', 1)
                            .arg(p.y, 0, 'f', 1)
                            .arg(p.z, 0, 'f', 1);
  if (!found_) {
    where_->setText(place);
    return;
  }
  where_->setText(tr("The pen is %L1 mm above the drawing plane.")
                      .arg(found_->calibration.to_page(p).z, 0, 'f', 1));
}

/// Returns a point as the user sees it. Before the plane is known, uses the device's default
/// plane.
QPointF CalibrationDialog::in_picture(const Vec3& device_mm) const {
  const bool is_known = found_.has_value();
  const std::optional<DrawingArea> touched = area();
  const PlaneCalibration& plane = is_known ? found_->calibration : usual_;
  const DrawingArea& shown = is_known && touched ? *touched : reach_;
  const Vec3 off = plane.to_page(device_mm) - plane.to_page(shown.middle_mm);
  const double width = kPicturePx.width() - 2.0 * kPictureMargin;
  const double height = kPicturePx.height() - 2.0 * kPictureMargin;
  const double px_per_mm =
      std::min(width / std::max(1.0, shown.width_mm), height / std::max(1.0, shown.height_mm));
  return QPointF(0.5 * kPicturePx.width(), 0.5 * kPicturePx.height()) +
         px_per_mm * QPointF(off.x, off.y);
}

void CalibrationDialog::draw() {
  const qreal dpr = devicePixelRatioF();
  QPixmap pixmap(kPicturePx * dpr);
  pixmap.setDevicePixelRatio(dpr);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor line = palette().color(QPalette::WindowText),
               highlight = palette().color(QPalette::Highlight);
  // The rectangle is the touched area once it is known, otherwise the reach of the device.
  QRectF page(0, 0, kPicturePx.width() - 2.0 * kPictureMargin,
              kPicturePx.height() - 2.0 * kPictureMargin);
  page.moveCenter(QPointF(0.5 * kPicturePx.width(), 0.5 * kPicturePx.height()));
  if (found_ && area()) {
    page = QRectF(in_picture(corners_[0]),
                  QPointF(in_picture(corners_[1]).x(), in_picture(corners_[2]).y()));
  }
  painter.setPen(QPen(line, 1.2, found_ ? Qt::SolidLine : Qt::DashLine));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRect(page);
  const std::array<QPointF, kCorners> wanted{page.topLeft(), page.topRight(), page.bottomLeft()};
  for (std::size_t i = 0; i < kCorners; ++i) {
    const bool is_known = i < corners_.size(), is_next = i == corners_.size();
    const double radius = is_next ? kNextPx : kCornerPx;
    const QPointF at = is_known && found_ ? in_picture(corners_[i]) : wanted[i];
    painter.setBrush(is_known ? line : palette().color(QPalette::Base));
    painter.setPen(QPen(is_next ? highlight : line, is_next ? 3 : 1.2));
    painter.drawEllipse(at, radius, radius);
    if (is_known) continue;
    painter.setPen(line);
    painter.drawText(QRectF(at - QPointF(10, 10), QSizeF(20, 20)), Qt::AlignCenter,
                     QString::number(i + 1));
  }
  if (place_) {
    const QRectF all(QPointF(kPenPx, kPenPx), kPicturePx - QSizeF(2 * kPenPx, 2 * kPenPx));
    const QPointF raw = in_picture(*place_);
    const QPointF at(std::clamp(raw.x(), all.left(), all.right()),
                     std::clamp(raw.y(), all.top(), all.bottom()));
    painter.setPen(QPen(highlight, 1.6));
    painter.drawLine(at, at + QPointF(11, -15));  // the pen, with its tip at the reported position
    painter.setBrush(highlight);
    painter.drawEllipse(at, kPenPx, kPenPx);
  }
  picture_->setPixmap(pixmap);
}

}  // namespace felt::desktop
