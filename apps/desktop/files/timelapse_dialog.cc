#include "desktop/files/timelapse_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "desktop/engine/grain_setting.h"
#include "desktop/engine/settings.h"
#include "desktop/files/files_setting_keys.h"

namespace felt::desktop {
namespace {

constexpr std::array kTimelapseFormats{TimelapseFormat::kWebm, TimelapseFormat::kGif,
                                       TimelapseFormat::kSvg};

QString format_name(TimelapseFormat format) {
  switch (format) {
    case TimelapseFormat::kGif:
      return TimelapseDialog::tr("GIF (repeats, 256 colours)");
    case TimelapseFormat::kSvg:
      return TimelapseDialog::tr("Animated SVG (for web pages)");
    case TimelapseFormat::kWebm:
      break;
  }
  return TimelapseDialog::tr("WebM film (VP9)");
}

QString source_name(RecordingSource source) {
  switch (source) {
    case RecordingSource::kSession:
      return TimelapseDialog::tr("This window, which is being recorded");
    case RecordingSource::kDrawing:
      return TimelapseDialog::tr("The recording in this drawing");
    case RecordingSource::kFile:
      break;
  }
  return TimelapseDialog::tr("A file");
}

}  // namespace

QString suffix_of(TimelapseFormat format) {
  constexpr std::array kSuffixes{".webm", ".gif", ".svg"};
  return QLatin1String(kSuffixes[static_cast<std::size_t>(format)]);
}

QString filter_of(TimelapseFormat format) {
  return format_name(format) + QStringLiteral(" (*%1)").arg(suffix_of(format));
}

TimelapseDialog::TimelapseDialog(const QList<RecordingSource>& sources,
                                 std::function<QString()> choose_file, const QString& encoder,
                                 QWidget* parent)
    : QDialog(parent),
      choose_file_(std::move(choose_file)),
      encoder_(encoder),
      source_(new QComboBox(this)),
      file_(new QLineEdit(this)),
      choose_(new QPushButton(tr("C&hoose…"), this)),
      format_(new QComboBox(this)),
      seconds_(new QDoubleSpinBox(this)),
      size_(new QSpinBox(this)),
      grain_(new QCheckBox(tr("&Grain of the surface in dry media"), this)),
      hint_(new QLabel(this)) {
  setWindowTitle(tr("Export timelapse"));
  const Settings& settings = Settings::the();
  for (const RecordingSource source : sources) {
    source_->addItem(source_name(source), static_cast<int>(source));
  }
  if (!sources.contains(RecordingSource::kFile)) {
    source_->addItem(source_name(RecordingSource::kFile), static_cast<int>(RecordingSource::kFile));
  }
  for (const TimelapseFormat format : kTimelapseFormats) {
    format_->addItem(format_name(format), suffix_of(format));
  }
  format_->setCurrentIndex(
      std::max(0, format_->findData(settings.text(files_keys::kTimelapseFormat))));
  seconds_->setRange(0.0, FilmLength::kMaxSeconds);
  seconds_->setSpecialValueText(tr("Automatic"));
  seconds_->setDecimals(1);
  seconds_->setSuffix(tr(" s"));
  seconds_->setToolTip(tr("Automatic: 30 s, or less if the drawing took less time"));
  seconds_->setValue(settings.number(files_keys::kTimelapseSeconds, 0.0));
  size_->setRange(FilmOptions::kMinSidePx, FilmOptions::kMaxSidePx);
  size_->setSuffix(tr(" pixels"));
  size_->setToolTip(tr("The longer side of the film"));
  size_->setValue(static_cast<int>(
      settings.number(files_keys::kTimelapseSize, files_keys::kTimelapseSizeDefault)));
  grain_->setChecked(settings.flag(kShowsGrain, kShowsGrainDefault));
  build();
  show_choices();
}

void TimelapseDialog::build() {
  auto* form = new QFormLayout;
  form->addRow(tr("&Recording:"), source_);
  form->addRow(tr("File:"), file_row());
  form->addRow(tr("&Format:"), format_);
  form->addRow(tr("&Length:"), seconds_);
  form->addRow(tr("&Size:"), size_);
  form->addRow(QString(), grain_);
  hint_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  go_ = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
  go_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &TimelapseDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QVBoxLayout(this);
  all->addLayout(form);
  all->addWidget(hint_);
  all->addWidget(buttons);
  connect(source_, &QComboBox::currentIndexChanged, this, &TimelapseDialog::show_choices);
  connect(format_, &QComboBox::currentIndexChanged, this, &TimelapseDialog::show_choices);
}

QWidget* TimelapseDialog::file_row() {
  file_->setReadOnly(true);
  file_->setAccessibleName(tr("File of the recording"));
  file_->setPlaceholderText(tr("A script (.ndjson) or a drawing (.felt)"));
  file_->setMinimumWidth(fontMetrics().averageCharWidth() * 40);
  connect(choose_, &QPushButton::clicked, this, [this] {
    const QString path = choose_file_();
    if (!path.isEmpty()) file_->setText(path);
    show_choices();
  });
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(file_, 1);
  row->addWidget(choose_);
  box->setFocusProxy(choose_);
  return box;
}

RecordingSource TimelapseDialog::source() const {
  return static_cast<RecordingSource>(source_->currentData().toInt());
}

TimelapseRequest TimelapseDialog::request() const {
  TimelapseRequest request;
  if (source() == RecordingSource::kFile) request.recording = file_->text();
  request.format = kTimelapseFormats[static_cast<std::size_t>(format_->currentIndex())];
  if (seconds_->value() > 0.0) request.seconds = seconds_->value();
  request.longer_px = size_->value();
  request.grain = grain_->isEnabled() && grain_->isChecked();
  request.program = encoder_.toStdString();
  return request;
}

void TimelapseDialog::accept() {
  Settings& settings = Settings::the();
  settings.set(files_keys::kTimelapseFormat, format_->currentData());
  settings.set(files_keys::kTimelapseSeconds, seconds_->value());
  settings.set(files_keys::kTimelapseSize, size_->value());
  QDialog::accept();
}

void TimelapseDialog::show_choices() {
  const TimelapseRequest chosen = request();
  const bool is_svg = chosen.format == TimelapseFormat::kSvg;
  const bool from_file = source() == RecordingSource::kFile;
  file_->setEnabled(from_file);
  choose_->setEnabled(from_file);
  grain_->setEnabled(!is_svg);
  const bool can_encode = is_svg || !QStandardPaths::findExecutable(encoder_).isEmpty();
  QString hint;
  if (!can_encode) {
    hint =
        tr("This format needs the program ffmpeg, which is not installed. Install the package "
           "“ffmpeg”, or export an animated SVG.");
  } else if (from_file && chosen.recording.isEmpty()) {
    hint =
        tr("A recording is made by “feltline-desktop --record FILE.ndjson” or “feltline replay "
           "--recording”.");
  }
  hint_->setText(hint);
  hint_->setVisible(!hint.isEmpty());
  go_->setEnabled(can_encode && !(from_file && chosen.recording.isEmpty()));
}

}  // namespace felt::desktop
