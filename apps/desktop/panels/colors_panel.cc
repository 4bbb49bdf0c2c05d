#include "desktop/panels/colors_panel.h"

#include <QAbstractItemView>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpressionValidator>
#include <QSignalBlocker>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "desktop/engine/settings.h"
#include "desktop/panels/color_contrast.h"
#include "desktop/panels/panel_setting_keys.h"
#include "desktop/panels/stored_colors.h"
#include "desktop/panels/tool_icons.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

constexpr std::size_t kMaxRecent = 16;
constexpr std::size_t kMaxOwn = 500;
constexpr int kSamplePx = 28;
const char* const kColor = "ink.color";

QString hex_of(Rgba color) {
  return QString::fromStdString(color_to_text(color));
}

QStringList opened_files() {
  return Settings::the().value(QString::fromLatin1(panel_keys::kPaletteFiles)).toStringList();
}

/// Returns the path of the first .gpl file among the dropped files, or "".
QString palette_of(const QMimeData* data) {
  for (const QUrl& url : data->urls()) {
    const QString path = url.toLocalFile();
    if (path.endsWith(QLatin1String(".gpl"), Qt::CaseInsensitive)) return path;
  }
  return {};
}

QPixmap sample_of(Rgba color, double ratio) {
  QPixmap pixmap(QSize(kSamplePx, kSamplePx) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath shape;
  shape.addRoundedRect(QRectF(0.5, 0.5, kSamplePx - 1, kSamplePx - 1), 5, 5);
  if (color.a < 255) {
    painter.fillPath(shape, Qt::white);
    painter.fillPath(shape, QBrush(Qt::lightGray, Qt::Dense4Pattern));
  }
  painter.fillPath(shape, qcolor(color));
  painter.setPen(QPen(Qt::gray, 1));
  painter.drawPath(shape);
  return pixmap;
}

}  // namespace

ColorsPanel::ColorsPanel(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      field_(new ColorField(this)),
      sample_(new QLabel(this)),
      number_(new QLineEdit(this)),
      opacity_(new QSpinBox(this)),
      contrast_(new QLabel(this)),
      recent_(new SwatchView(tr("Recent colours"), true, this)),
      palettes_(new QComboBox(this)),
      swatches_(new SwatchView(tr("Colours of the palette"), false, this)) {
  setAcceptDrops(true);
  build();
  recent_->set_colors(stored_colors(panel_keys::kRecentColors));
  recent_->setVisible(!recent_->colors().empty());
  list_palettes(Settings::the().text(QString::fromLatin1(panel_keys::kPalette)));
  connect_all();
  follow();
}

void ColorsPanel::build() {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(10, 8, 10, 8);
  lines->setSpacing(7);
  lines->addWidget(field_, 3);
  lines->addWidget(make_numbers());
  contrast_->setWordWrap(true);
  lines->addWidget(contrast_);
  lines->addWidget(recent_);
  lines->addWidget(make_palette_row());
  lines->addWidget(swatches_, 2);
}

QWidget* ColorsPanel::make_numbers() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  sample_->setAccessibleName(tr("Colour of new lines"));
  number_->setAccessibleName(tr("Colour code"));
  number_->setToolTip(tr("The colour as #rrggbb, #rgb or #rrggbbaa"));
  number_->setObjectName(QStringLiteral("color_number"));
  number_->setMaxLength(9);
  number_->setMinimumWidth(number_->fontMetrics().averageCharWidth() * 9);
  static const QRegularExpression kNumber(
      QStringLiteral("#?([0-9a-fA-F]{3}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})"));
  number_->setValidator(new QRegularExpressionValidator(kNumber, number_));
  opacity_->setRange(0, 100);
  opacity_->setSuffix(tr(" %"));
  opacity_->setAccessibleName(tr("Opacity"));
  opacity_->setToolTip(tr("Opacity: 0 % is transparent"));
  opacity_->setKeyboardTracking(false);
  opacity_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(sample_);
  row->addWidget(number_, 1);
  row->addWidget(opacity_);
  return box;
}

QWidget* ColorsPanel::make_palette_row() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  palettes_->setAccessibleName(tr("Palette"));
  palettes_->view()->setAccessibleName(tr("Palettes"));
  palettes_->setToolTip(tr("The palette below"));
  palettes_->setMinimumContentsLength(8);
  palettes_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  row->addWidget(palettes_, 1);
  const auto button = [&](const char* icon, const QString& name) {
    auto* made = new QToolButton(box);
    made->setIcon(icon_of(icon));
    made->setIconSize({18, 18});
    made->setAutoRaise(true);
    made->setAccessibleName(name);
    made->setToolTip(name);
    row->addWidget(made);
    return made;
  };
  connect(button("add", tr("Keep this colour in your own palette")), &QToolButton::clicked, this,
          &ColorsPanel::keep_color);
  QToolButton* more = button("more", tr("Palettes"));
  auto* menu = new QMenu(more);
  menu->addAction(icon_of("open"), tr("&Open a palette…"), this, &ColorsPanel::ask_open);
  menu->addAction(icon_of("export"), tr("&Export this palette…"), this, &ColorsPanel::ask_export);
  menu->addSeparator();
  menu->addAction(icon_of("remove"), tr("Remove the &colour from your palette"), this,
                  &ColorsPanel::drop_color);
  more->setMenu(menu);
  more->setPopupMode(QToolButton::InstantPopup);
  return box;
}

void ColorsPanel::connect_all() {
  connect(field_, &ColorField::chosen, this,
          [this](const QColor& shade) { choose_opaque(rgba(shade)); });
  connect(field_, &ColorField::settled, this, &ColorsPanel::recolor_selected);
  connect(number_, &QLineEdit::editingFinished, this, &ColorsPanel::take_number);
  connect(opacity_, &QSpinBox::valueChanged, this, [this](int percent) {
    Rgba with = color();
    with.a = static_cast<std::uint8_t>(std::lround(percent * 2.55));
    choose(with);
    if (!studio_.session().selection().empty()) {
      studio_.apply(RestyleEvent{.opacity = with.a / 255.0});
    }
  });
  connect(recent_, &SwatchView::chosen, this, [this](Rgba wanted) {
    choose(wanted);
    recolor_selected();
  });
  connect(swatches_, &SwatchView::chosen, this, [this](Rgba wanted) {
    choose_opaque(wanted);
    recolor_selected();
  });
  connect(palettes_, &QComboBox::activated, this, &ColorsPanel::show_palette);
  connect(&studio_, &Studio::option_changed, this, [this](const QString& id) {
    if (id == QLatin1String(kColor)) follow();
  });
  connect(&studio_, &Studio::opened, this, &ColorsPanel::follow);
  connect(&studio_, &Studio::page_changed, this, &ColorsPanel::follow);
  connect(&studio_, &Studio::edited, this, &ColorsPanel::note_drawn);
}

Rgba ColorsPanel::color() const {
  return studio_.session().ink_color();
}

void ColorsPanel::choose(Rgba wanted) {
  if (wanted != color()) studio_.apply(SetOption{kColor, color_to_text(wanted)});
}

/// Sets the colour of the selected lines to the current colour. Called when the user has chosen a
/// colour.
void ColorsPanel::recolor_selected() {
  if (studio_.session().selection().empty()) return;
  studio_.apply(RestyleEvent{.color = color_to_text(color())});
}

/// Sets the colour but keeps the opacity, because shades and palettes are opaque.
void ColorsPanel::choose_opaque(Rgba wanted) {
  wanted.a = color().a;
  choose(wanted);
}

void ColorsPanel::take_number() {
  QString text = number_->text();
  if (!text.startsWith(QLatin1Char('#'))) text.prepend(QLatin1Char('#'));
  const auto wanted = color_from_text(text.toStdString());
  const bool is_typed = number_->isModified();
  if (wanted && text.size() > 7) {
    choose(*wanted);
  } else if (wanted) {
    choose_opaque(*wanted);
  }
  if (wanted && is_typed) recolor_selected();
  number_->setModified(false);
  follow();
}

void ColorsPanel::follow() {
  const Rgba now = color();
  const QSignalBlocker quiet(opacity_);
  field_->show_color(qcolor(now));
  sample_->setPixmap(sample_of(now, devicePixelRatioF()));
  if (!number_->hasFocus() || !number_->isModified()) {
    number_->setText(hex_of({now.r, now.g, now.b}));
  }
  opacity_->setValue(static_cast<int>(std::lround(now.a / 2.55)));
  recent_->mark(now);
  swatches_->mark({now.r, now.g, now.b});
  const Rgba paper = seen_paper(studio_.page().paper);
  const double contrast = contrast_of(seen_on(now, paper), paper);
  const QString ratio = locale().toString(contrast, 'f', 1);
  contrast_->setText(contrast < kFaintContrast ? tr("Low contrast with the paper: %1:1").arg(ratio)
                                               : tr("Contrast with the paper: %1:1").arg(ratio));
}

/// Adds the colours of new strokes to the list of recently used colours.
void ColorsPanel::note_drawn(const Edit& edit) {
  if (edit.changes.empty() || !edit.changes.front().after) return;
  const Rgba used = edit.changes.front().after->data().color;
  std::vector<NamedColor> colors = recent_->colors();
  if (used != color() || (!colors.empty() && colors.front().color == used)) return;
  std::erase_if(colors, [&](const NamedColor& entry) { return entry.color == used; });
  colors.insert(colors.begin(), {used, {}});
  if (colors.size() > kMaxRecent) colors.resize(kMaxRecent);
  store_colors(panel_keys::kRecentColors, colors);
  recent_->set_colors(std::move(colors));
  recent_->show();
}

Palette ColorsPanel::own_palette() const {
  return {tr("My colours").toStdString(), 0, stored_colors(panel_keys::kOwnColors)};
}

void ColorsPanel::list_palettes(const QString& wanted) {
  sources_ = built_in_palettes();
  const Palette own = own_palette();
  if (!own.colors.empty()) sources_.push_back({QString::fromStdString(own.name), {}, own});
  for (PaletteSource& file : palette_files(opened_files())) sources_.push_back(std::move(file));
  // A palette that is in the list already is not added again.
  const auto is_of_drawing = [this](const PaletteSource& source) {
    return source.palette.colors == of_drawing_.colors;
  };
  if (!of_drawing_.colors.empty() &&
      std::none_of(sources_.begin(), sources_.end(), is_of_drawing)) {
    sources_.push_back({QString::fromStdString(of_drawing_.name), {}, of_drawing_});
  }
  palettes_->clear();
  int shown = 0;
  for (const PaletteSource& source : sources_) {
    const bool is_wanted = source.title == wanted || source.path == wanted;
    if (is_wanted && !wanted.isEmpty()) shown = palettes_->count();
    palettes_->addItem(source.title);
    palettes_->setItemData(palettes_->count() - 1, source.path, Qt::ToolTipRole);
  }
  palettes_->setCurrentIndex(shown);
  show_palette(shown);
}

void ColorsPanel::show_palette(int i) {
  PaletteSource& source = sources_[static_cast<std::size_t>(i)];
  if (!source.path.isEmpty() && source.palette.colors.empty()) {
    Result<Palette> read = load_palette(source.path);
    if (!read) {
      Q_EMIT studio_.refused(QString::fromStdString(read.error().message));
      swatches_->set_colors({});
      return;
    }
    source.palette = *std::move(read);
  }
  swatches_->set_colors(source.palette.colors);
  Settings::the().set(QString::fromLatin1(panel_keys::kPalette), source.title);
}

bool ColorsPanel::open_palette(const QString& path) {
  const Result<Palette> read = load_palette(path);
  if (!read) {
    Q_EMIT studio_.refused(QString::fromStdString(read.error().message));
    return false;
  }
  QStringList files = opened_files();
  if (!files.contains(path)) files.push_back(path);
  Settings::the().set(QString::fromLatin1(panel_keys::kPaletteFiles), files);
  list_palettes(path);
  return true;
}

bool ColorsPanel::export_palette(const QString& path) {
  const auto shown = static_cast<std::size_t>(palettes_->currentIndex());
  const Result<void> saved = save_palette(path, sources_[shown].palette);
  if (!saved) Q_EMIT studio_.refused(QString::fromStdString(saved.error().message));
  return saved.has_value();
}

Palette ColorsPanel::shown_palette() const {
  const PaletteSource& source = sources_[static_cast<std::size_t>(palettes_->currentIndex())];
  Palette palette = source.palette;
  // The file format limits the length of a name. The cut must not split a character.
  QString title = source.title;
  while (title.toUtf8().size() > static_cast<int>(PaletteLimits::kMaxNameBytes)) title.chop(1);
  palette.name = title.toStdString();
  return palette;
}

void ColorsPanel::show_drawing_palette(const Palette& palette) {
  of_drawing_ = palette;
  const QString before = palettes_->currentText();
  list_palettes(palette.colors.empty() ? before : QString::fromStdString(palette.name));
}

void ColorsPanel::ask_open() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a palette"), {}, tr("Palettes (*.gpl)"));
  if (!path.isEmpty()) open_palette(path);
}

void ColorsPanel::ask_export() {
  QString path = QFileDialog::getSaveFileName(this, tr("Export the palette"),
                                              palettes_->currentText() + QStringLiteral(".gpl"),
                                              tr("Palettes (*.gpl)"));
  if (!path.isEmpty()) export_palette(path);
}

void ColorsPanel::keep_color() {
  Palette own = own_palette();
  const Rgba now = color();
  const NamedColor kept{{now.r, now.g, now.b}, {}};
  if (std::find(own.colors.begin(), own.colors.end(), kept) == own.colors.end() &&
      own.colors.size() < kMaxOwn) {
    own.colors.push_back(kept);
  }
  store_colors(panel_keys::kOwnColors, own.colors);
  list_palettes(QString::fromStdString(own.name));
}

void ColorsPanel::drop_color() {
  Palette own = own_palette();
  const Rgba now = color();
  std::erase_if(own.colors, [&now](const NamedColor& entry) {
    return entry.color == Rgba{now.r, now.g, now.b};
  });
  store_colors(panel_keys::kOwnColors, own.colors);
  list_palettes(palettes_->currentText());
}

void ColorsPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!palette_of(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ColorsPanel::dropEvent(QDropEvent* event) {
  const QString path = palette_of(event->mimeData());
  if (!path.isEmpty() && open_palette(path)) event->acceptProposedAction();
}

void ColorsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && sample_) follow();
}

}  // namespace felt::desktop
