#include "desktop/window/status_line.h"

#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLocale>
#include <QUrl>
#include <cmath>
#include <utility>

#include "desktop/engine/device_words.h"
#include "desktop/window/reading_speech.h"

namespace felt::desktop {
namespace {

constexpr int kRefusedMs = 6000;

QString percent(double part) {
  return QStringLiteral("%1\u202f%").arg(std::lround(100.0 * part));
}

}  // namespace

StatusLine::StatusLine(Studio& studio, Canvas& canvas, QWidget* parent)
    : QStatusBar(parent), studio_(studio), canvas_(canvas), hint_(new QLabel(this)) {
  hint_->setAccessibleName(tr("Hint"));
  hint_->setTextFormat(Qt::PlainText);
  hint_->setMinimumWidth(1);
  hint_->setContentsMargins(6, 0, 6, 0);
  hint_->installEventFilter(this);
  addWidget(hint_, 1);
  place_ = field(tr("Position of the pen"), QStringLiteral("-888.8, -888.8 mm"));
  pressure_ = field(tr("Pressure"), tr("Pressure %1").arg(percent(1.0)));
  zoom_ = field(tr("Zoom"), QStringLiteral("8888\u202f%"));
  angle_ = field(tr("Rotation of the view"), QStringLiteral("-888\u00b0"));
  device_ = field(tr("Device"), QString());
  saved_ = field(tr("State of the file"), QString());
  saved_->setTextFormat(Qt::RichText);
  connect(saved_, &QLabel::linkActivated, this,
          [](const QString& link) { QDesktopServices::openUrl(QUrl(link)); });
  connect(&canvas, &Canvas::hint_changed, this, &StatusLine::show_tool);
  connect(&studio, &Studio::shown, this, &StatusLine::show_pen);
  connect(&studio.loop(), &HapticLoop::device_changed, this, &StatusLine::show_device);
  connect(&studio.loop(), &HapticLoop::forces_changed, this, &StatusLine::show_device);
  connect(&studio.loop(), &HapticLoop::device_status_changed, this, &StatusLine::show_device);
  connect(&studio, &Studio::modified_changed, this, &StatusLine::show_saved);
  connect(&studio, &Studio::opened, this, &StatusLine::show_saved);
  connect(&canvas, &Canvas::view_changed, this, &StatusLine::show_view);
  connect(&studio, &Studio::refused, this, [this](const QString& why) {
    showMessage(why, kRefusedMs);
    is_message_new_ = true;
  });
  // A message ends when its reason does: when the user changes an option or the tool, or draws.
  connect(&studio, &Studio::option_changed, this, &StatusLine::end_message);
  connect(&studio, &Studio::tool_changed, this, &StatusLine::end_message);
  connect(&studio, &Studio::shown, this, [this] { is_message_new_ = false; });
  connect(&studio, &Studio::sampled, this, [this](const PenSample& sample) {
    if (!std::exchange(is_pen_down_, in_contact(sample)) && is_pen_down_) end_message();
  });
  connect(new ReadingSpeech(studio, canvas), &ReadingSpeech::spoken, this,
          &StatusLine::show_reading);
  show_tool();
  show_pen();
  show_view();
  show_device();
  show_saved();
}

QLabel* StatusLine::field(const QString& name, const QString& widest) {
  auto* label = new QLabel(this);
  label->setAccessibleName(name);
  label->setToolTip(name);
  label->setTextFormat(Qt::PlainText);
  label->setContentsMargins(8, 0, 8, 0);
  // The width fits the widest text, so that the fields do not move while the user draws.
  if (!widest.isEmpty())
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 20);
  addPermanentWidget(label);
  return label;
}

/// Ends the present message, unless it was caused by what the user is doing now.
void StatusLine::end_message() {
  if (!is_message_new_) clearMessage();
}

void StatusLine::show_reading(const QString& words) {
  reading_ = words;
  show_tool();
}

void StatusLine::show_tool() {
  hint_text_ = reading_.isEmpty() ? canvas_.hint() : reading_;
  elide_hint();
}

void StatusLine::elide_hint() {
  hint_->setToolTip(hint_text_);
  hint_->setText(hint_->fontMetrics().elidedText(hint_text_, Qt::ElideRight, hint_->width() - 12));
}

/// Elides the hint by the size of its own label, which also changes when another field appears or
/// disappears.
bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == hint_ && event->type() == QEvent::Resize) elide_hint();
  return QStatusBar::eventFilter(watched, event);
}

void StatusLine::show_pen() {
  const PenState& pen = studio_.pen();
  if (!pen.is_known) return;
  const QLocale locale;
  const QString place = tr("%1, %2 mm")
                            .arg(locale.toString(pen.sample.position.x, 'f', 1),
                                 locale.toString(pen.sample.position.y, 'f', 1));
  if (place != place_->text()) place_->setText(place);
  const bool is_pressed = in_contact(pen.sample) && pen.sample.pressure;
  const QString pressure =
      is_pressed ? tr("Pressure %1").arg(percent(*pen.sample.pressure)) : QString();
  if (pressure != pressure_->text()) pressure_->setText(pressure);
}

void StatusLine::show_view() {
  zoom_->setText(percent(canvas_.zoom()));
  const double angle = canvas_.view().angle_deg();
  angle_->setText(QStringLiteral("%1\u00b0").arg(std::lround(angle)));
  angle_->setVisible(std::lround(angle) != 0);
}

void StatusLine::show_device() {
  const PenDeviceInfo& info = studio_.loop().device().info();
  const QString& name = info.short_label.isEmpty() ? info.label : info.short_label;
  const DeviceStatus status = studio_.loop().device_status();
  // Shows the loop's rate only if motors push the user's hand, because it does not matter for a
  // simulated device.
  const double rate_hz =
      status.rate_hz > 0.0
          ? status.rate_hz
          : 1e9 / double(studio_.loop().device().device().capabilities().period_ns);
  QString text = studio_.loop().forces_are_on() ? name : tr("%1, forces off").arg(name);
  if (status.fault) text = tr("%1: %2").arg(name, words_for(*status.fault));
  device_->setToolTip(info.moves_hand ? tr("%1, %L2 Hz").arg(info.label).arg(rate_hz, 0, 'f', 0)
                                      : info.label);
  device_->setText(text);
}

void StatusLine::show_saved() {
  const QFileInfo file(file_);
  QString text;
  if (studio_.is_modified()) {
    text = tr("Not saved");
  } else if (!file_.isEmpty()) {
    const QUrl folder = QUrl::fromLocalFile(file.absolutePath());
    const QString name = file.absoluteDir().dirName();
    text = tr("Saved in %1")
               .arg(QStringLiteral("<a href=\"%1\">%2</a>")
                        .arg(folder.toString(QUrl::FullyEncoded).toHtmlEscaped(),
                             (name.isEmpty() ? file.absolutePath() : name).toHtmlEscaped()));
  }
  saved_->setText(text);
  saved_->setToolTip(file_.isEmpty() ? tr("State of the file")
                                     : QDir::toNativeSeparators(file.absoluteFilePath()));
}

void StatusLine::set_file(const QString& path) {
  file_ = path;
  show_saved();
}

}  // namespace felt::desktop
