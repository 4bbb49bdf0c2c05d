#include "desktop/files/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <vector>

#include "desktop/engine/grain_setting.h"
#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "desktop/files/files_setting_keys.h"
#include "desktop/files/format_texts.h"
#include "desktop/files/page_picture.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_materials.h"
#include "felt/formats/format_traits.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

/// Resolution at the scale 1: that of a CSS pixel.
constexpr double kScreenDpi = 96.0;

constexpr QSize kPreviewSize(280, 220);
constexpr int kCheck = 8;  // size of the chequered squares that show transparency
// A preview of more strokes would take too long. If the drawing has more, the preview shows those
// that were drawn last, because they are on top.
constexpr std::size_t kMaxPreviewStrokes = 5000;

/// Returns the formats for export: all that can be written except .felt, which is for saving. The
/// first one is for sharing: every program shows it.
std::vector<const FormatTraits*> export_formats() {
  std::vector<const FormatTraits*> rows;
  for (const FormatTraits& row : format_table()) {
    if (row.writes && row.format != FileFormat::kFelt) rows.push_back(&row);
  }
  std::stable_partition(rows.begin(), rows.end(),
                        [](const FormatTraits* row) { return row->format == FileFormat::kPng; });
  return rows;
}

bool can_swell(FileFormat format) {
  return format == FileFormat::kSvg || format == FileFormat::kPdf;
}

/// Returns the drawing as it is exported for swell paper, for the preview.
Result<Document> black_document(const Document& document) {
  Drawing drawing;
  drawing.document = document;
  SwellReport report;
  Result<Drawing> black = prepare_for_swell_paper(drawing, report);
  if (!black) return tl::unexpected(black.error());
  return std::move(black->document);
}

/// Paints the picture over chequered squares, which show where it is transparent.
QPixmap on_squares(const QImage& picture, double ratio) {
  QPixmap pixmap(picture.size());
  pixmap.fill(Qt::white);
  QPainter painter(&pixmap);
  const int side = int(std::lround(kCheck * ratio));
  for (int y = 0; y < picture.height(); y += side) {
    for (int x = (y / side % 2) * side; x < picture.width(); x += 2 * side) {
      painter.fillRect(x, y, side, side, QColor(225, 225, 225));
    }
  }
  painter.drawImage(0, 0, picture);
  painter.end();
  pixmap.setDevicePixelRatio(ratio);
  return pixmap;
}

/// Returns true if the picture can show the grain of the surface.
bool can_grain(const ExportOptions& chosen) {
  return traits_of(chosen.format).picture && !chosen.compact && !chosen.swell;
}

}  // namespace

ExportDialog::ExportDialog(const Drawing& drawing, const Selection& selection, QWidget* parent)
    : QDialog(parent),
      document_(with_newest_strokes(drawing.document, kMaxPreviewStrokes)),
      selected_(
          with_newest_strokes(selected_only(drawing, selection).document, kMaxPreviewStrokes)),
      page_(drawing.page),
      format_(new QComboBox(this)),
      area_(new QComboBox(this)),
      dpi_(new QDoubleSpinBox(this)),
      scale_(new QComboBox(this)),
      background_(new QCheckBox(tr("With the &paper’s colour"), this)),
      grain_(new QCheckBox(tr("&Grain of the surface in dry media"), this)),
      compact_(new QCheckBox(tr("Small file for &web pages"), this)),
      pictures_(new QCheckBox(tr("P&ictures to draw over"), this)),
      swell_(new QCheckBox(tr("For s&well paper"), this)),
      picture_(new QLabel(this)),
      size_(new QLabel(this)),
      kept_(new QLabel(this)),
      form_(new QFormLayout) {
  setWindowTitle(tr("Export"));
  Settings& settings = Settings::the();
  for (const FormatTraits* row : export_formats()) {
    format_->addItem(format_title(row->format),
                     QString::fromLatin1(row->name.data(), qsizetype(row->name.size())));
  }
  format_->setCurrentIndex(
      std::max(0, format_->findData(settings.text(files_keys::kExportFormat))));
  area_->addItems({tr("The page"), tr("The ink only")});
  if (selected_.stroke_count() > 0) area_->addItem(tr("The selected lines"));
  area_->setCurrentIndex(settings.flag(files_keys::kExportInkOnly, false) ? 1 : 0);
  dpi_->setRange(10.0, 2400.0);
  dpi_->setDecimals(0);
  dpi_->setSuffix(tr(" dots per inch"));
  dpi_->setValue(settings.number(files_keys::kExportDpi, files_keys::kExportDpiDefault));
  background_->setChecked(settings.flag(files_keys::kExportBackground, true));
  if (const Result<Grain> grain = grain_of(drawing)) surface_grain_ = *grain;
  solid_grain_ = Grain::solid(with_texts(drawing.materials));
  grain_->setChecked(surface_grain_ && settings.flag(kShowsGrain, kShowsGrainDefault));
  grain_->setToolTip(tr("As on the screen. Lines stay editable; the grain is added as a picture"));
  compact_->setChecked(settings.flag(files_keys::kExportCompact, false));
  compact_->setToolTip(
      tr("Only the visible ink, which other programs show but cannot edit as lines"));
  swell_->setToolTip(
      tr("Black at true size, with lines at least 1 mm wide and textures instead of "
         "colours, for drawings that are read with the fingers"));
  const auto layers = drawing.document.layers();
  has_pictures_ = std::any_of(layers.begin(), layers.end(),
                              [](const Layer& l) { return l.visible && l.picture; });
  build();
  follow_choices();
}

void ExportDialog::build() {
  picture_->setFixedSize(kPreviewSize);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setAccessibleName(tr("Preview"));
  size_->setWordWrap(true);
  kept_->setWordWrap(true);
  form_->addRow(tr("&Format:"), format_);
  form_->addRow(tr("Keeps:"), kept_);
  form_->addRow(tr("&Show:"), area_);
  form_->addRow(tr("&Resolution:"), resolution_row());
  form_->addRow(QString(), background_);
  form_->addRow(QString(), grain_);
  form_->addRow(QString(), compact_);
  form_->addRow(QString(), pictures_);
  form_->addRow(QString(), swell_);
  form_->addRow(tr("Size:"), size_);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(18);
  columns->addWidget(picture_);
  columns->addLayout(form_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  go_ = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
  go_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QVBoxLayout(this);
  all->addLayout(columns);
  all->addWidget(buttons);
}

/// Returns the resolution in dots per inch, and beside it as a factor; each shows what is chosen in
/// the other.
QWidget* ExportDialog::resolution_row() {
  for (const int scale : {1, 2, 3, 4}) {
    scale_->addItem(tr("%1×").arg(scale), scale * kScreenDpi);
  }
  scale_->setPlaceholderText(tr("Scale"));
  scale_->setAccessibleName(tr("Scale"));
  dpi_->setAccessibleName(tr("Resolution"));
  scale_->setToolTip(tr("1× is 96 dots per inch, as on a screen of usual resolution"));
  const auto follow = [this] { scale_->setCurrentIndex(scale_->findData(dpi_->value())); };
  connect(dpi_, &QDoubleSpinBox::valueChanged, this, follow);
  connect(scale_, &QComboBox::activated, this,
          [this] { dpi_->setValue(scale_->currentData().toDouble()); });
  follow();
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(dpi_, 1);
  row->addWidget(scale_);
  box->setFocusProxy(dpi_);
  return box;
}

void ExportDialog::follow_choices() {
  connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::show_result);
  connect(area_, &QComboBox::currentIndexChanged, this, &ExportDialog::show_result);
  connect(dpi_, &QDoubleSpinBox::valueChanged, this, &ExportDialog::show_result);
  connect(background_, &QCheckBox::toggled, this, &ExportDialog::show_result);
  connect(grain_, &QCheckBox::toggled, this, &ExportDialog::show_result);
  connect(compact_, &QCheckBox::toggled, this, &ExportDialog::show_result);
  connect(pictures_, &QCheckBox::toggled, this, &ExportDialog::show_result);
  connect(swell_, &QCheckBox::toggled, this, &ExportDialog::show_result);
  show_result();
}

ExportOptions ExportDialog::options() const {
  const FileFormat format =
      export_formats()[static_cast<std::size_t>(format_->currentIndex())]->format;
  return {format,
          dpi_->value(),
          background_->isChecked(),
          static_cast<ExportPart>(area_->currentIndex()),
          grain_->isChecked(),
          format == FileFormat::kSvg && compact_->isChecked(),
          pictures_->isEnabled() && pictures_->isChecked(),
          can_swell(format) && swell_->isChecked()};
}

void ExportDialog::accept() {
  Settings& settings = Settings::the();
  settings.set(files_keys::kExportFormat, format_->currentData());
  settings.set(files_keys::kExportInkOnly, area_->currentIndex() == 1);
  if (options().format == FileFormat::kSvg) {
    settings.set(files_keys::kExportCompact, compact_->isChecked());
  }
  settings.set(files_keys::kExportDpi, dpi_->value());
  settings.set(files_keys::kExportBackground, background_->isChecked());
  QDialog::accept();
}

const Document& ExportDialog::shown_document(const ExportOptions& chosen) {
  const bool is_part = chosen.part == ExportPart::kSelection;
  const Document& whole = is_part ? selected_ : document_;
  go_->setEnabled(true);
  if (!chosen.swell) return whole;
  std::optional<Result<Document>>& black = is_part ? swell_selected_ : swell_document_;
  if (!black) black = black_document(whole);
  if (*black) return **black;
  kept_->setText(tr("It cannot be made for swell paper: %1.").arg(text_of(black->error())));
  go_->setEnabled(false);
  return whole;
}

void ExportDialog::enable_options(const ExportOptions& chosen) {
  const bool is_picture = traits_of(chosen.format).picture;
  const bool is_png = chosen.format == FileFormat::kPng;
  scale_->setEnabled(is_png);
  dpi_->setEnabled(is_png || (can_grain(chosen) && chosen.grain));
  grain_->setEnabled(can_grain(chosen) && surface_grain_);
  compact_->setEnabled(chosen.format == FileFormat::kSvg && !chosen.swell);
  swell_->setEnabled(can_swell(chosen.format));
  pictures_->setEnabled(has_pictures_ && chosen.part != ExportPart::kSelection && is_picture &&
                        !chosen.compact && !chosen.swell);
  area_->setEnabled(is_picture || selected_.stroke_count() > 0);
  background_->setEnabled(traits_of(chosen.format).page || is_png);
  if (page_.paper.a == 0 || chosen.swell) background_->setEnabled(false);
}

void ExportDialog::show_result() {
  const ExportOptions chosen = options();
  kept_->setText(chosen.compact
                     ? tr("The picture, for browsers. Feltline does not read the lines back.")
                     : format_kept(chosen.format));
  if (chosen.swell) kept_->setText(tr("Black lines and textures that rise on swell paper."));
  enable_options(chosen);
  const Document& document = shown_document(chosen);
  format_->setAccessibleDescription(kept_->text());
  const Rect area = export_area(ink_bounds(document), page_, chosen);
  const Rgba paper = chosen.background && !chosen.swell ? page_.paper : Rgba{255, 255, 255, 0};
  const double ratio = devicePixelRatioF();
  const bool is_grained = can_grain(chosen) && chosen.grain && surface_grain_;
  const QImage picture = page_thumbnail(
      document, area, kPreviewSize * ratio, paper, is_grained ? *surface_grain_ : solid_grain_,
      chosen.pictures ? PictureChoice::kAll : PictureChoice::kMarked);
  picture_->setPixmap(on_squares(picture, ratio));
  show_size(chosen, area);
}

void ExportDialog::show_size(const ExportOptions& chosen, const Rect& area) {
  const QLocale locale;
  QString text =
      tr("%1 × %2 mm")
          .arg(locale.toString(area.width(), 'f', 1), locale.toString(area.height(), 'f', 1));
  if (chosen.format == FileFormat::kPng) {
    const double scale = chosen.dpi / kMmPerInch;
    text += QLatin1Char('\n') + tr("%1 × %2 pixels")
                                    .arg(locale.toString(std::ceil(area.width() * scale), 'f', 0),
                                         locale.toString(std::ceil(area.height() * scale), 'f', 0));
  }
  if (!traits_of(chosen.format).picture && !traits_of(chosen.format).page) {
    const bool is_part = chosen.part == ExportPart::kSelection;
    text = is_part ? tr("The selected strokes, exactly") : tr("All strokes, exactly");
  }
  size_->setText(text);
}

}  // namespace felt::desktop
