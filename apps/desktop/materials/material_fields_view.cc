#include "desktop/materials/material_fields_view.h"

#include <QColorDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>
#include <array>
#include <random>
#include <type_traits>

#include "desktop/engine/tool_texts.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

/// The part of a field that a row needs, for surfaces and media.
struct FigureSpec {
  std::string id;
  MaterialFieldKind kind = MaterialFieldKind::kNumber;
  OptionSpec option;  ///< for panels/OptionRow; refers to texts that exist as long as the program
                      ///< runs
};

template <class Field>
FigureSpec figure_spec(const Field& field);

/// Makes the row for a field of this kind.
FigureRow* make_figure_row(const FigureSpec& spec, QWidget* parent);

/// Returns the unit as the user sees it: "µm" for "um".
std::string_view shown_unit(std::string_view unit) noexcept;

template <class Field>
FigureSpec figure_spec(const Field& field) {
  FigureSpec spec{std::string(field.id), field.kind, {}};
  spec.option.id = field.id;
  spec.option.label = field.label;
  spec.option.unit = shown_unit(field.unit);
  spec.option.min = field.min;
  spec.option.max = field.max;
  spec.option.choices = field.choices;
  spec.option.help = field.help;
  if (field.kind == MaterialFieldKind::kSwitch) spec.option.kind = OptionKind::kSwitch;
  if (field.kind == MaterialFieldKind::kChoice) spec.option.kind = OptionKind::kChoice;
  return spec;
}

constexpr int kSameRunMs = 700;  // changes by keys or wheel within this time are one step of undo
constexpr QSize kColorPx{44, 16};

/// Numbers the runs of values. All values between a press and the release of the slider have the
/// same number, and so do values that follow each other within kSameRunMs.
class Runs {
 public:
  void begin() { held_ = next(); }
  void end() { held_ = 0; }
  quint64 now() {
    if (held_ != 0) return held_;
    if (!since_.isValid() || since_.elapsed() > kSameRunMs) loose_ = next();
    since_.start();
    return loose_;
  }

 private:
  static quint64 next() {
    static quint64 last = 0;
    return ++last;
  }
  quint64 held_ = 0, loose_ = 0;
  QElapsedTimer since_;
};

/// A row with the control of the tools' options: slider and number, check box, or list.
class OptionFigureRow final : public FigureRow {
 public:
  OptionFigureRow(const FigureSpec& spec, QWidget* parent)
      : FigureRow(parent), spec_(spec), row_(new OptionRow(spec.option, this)) {
    auto* lines = new QVBoxLayout(this);
    lines->setContentsMargins({});
    lines->addWidget(row_);
    connect(row_, &OptionRow::chosen, this,
            [this](const OptionValue& value) { Q_EMIT chosen(number_of(value), runs_.now()); });
    if (auto* slider = row_->findChild<QSlider*>()) {
      connect(slider, &QSlider::sliderPressed, this, [this] { runs_.begin(); });
      connect(slider, &QSlider::sliderReleased, this, [this] { runs_.end(); });
    }
  }
  [[nodiscard]] const std::string& field() const noexcept override { return spec_.id; }
  void show_value(double now, double origin) override {
    row_->set_default(value_of(origin));
    row_->show_value(value_of(now));
  }

 private:
  [[nodiscard]] OptionValue value_of(double number) const {
    if (spec_.kind == MaterialFieldKind::kSwitch) return number != 0.0;
    if (spec_.kind != MaterialFieldKind::kChoice) return number;
    const std::size_t last = spec_.option.choices.size() - 1;
    return std::string(spec_.option.choices[std::min(static_cast<std::size_t>(number), last)]);
  }
  [[nodiscard]] double number_of(const OptionValue& value) const {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* on = std::get_if<bool>(&value)) return *on ? 1.0 : 0.0;
    const auto& choices = spec_.option.choices;
    const auto at = std::find(choices.begin(), choices.end(), std::get<std::string>(value));
    return static_cast<double>(at - choices.begin());
  }

  FigureSpec spec_;
  OptionRow* row_;
  Runs runs_;
};

/// A row with name and control side by side.
class PlainFigureRow : public FigureRow {
 public:
  PlainFigureRow(const FigureSpec& spec, QWidget* parent)
      : FigureRow(parent), spec_(spec), line_(new QHBoxLayout(this)) {
    line_->setContentsMargins({});
    setToolTip(help());
  }
  [[nodiscard]] const std::string& field() const noexcept override { return spec_.id; }

 protected:
  void add(QWidget* control, const QString& name) {
    control->setAccessibleName(name);
    control->setAccessibleDescription(help());
    control->setToolTip(help());
    if (line_->isEmpty()) {
      auto* label = new QLabel(this->name(), this);
      label->setBuddy(control);
      line_->addWidget(label, 1);
    }
    line_->addWidget(control);
  }
  [[nodiscard]] QString name() const { return translated(spec_.option.label); }
  [[nodiscard]] QString help() const { return translated(spec_.option.help); }

 private:
  FigureSpec spec_;
  QHBoxLayout* line_;
};

/// A row for an integer without a scale: it is typed or chosen at random.
class SeedRow final : public PlainFigureRow {
 public:
  SeedRow(const FigureSpec& spec, QWidget* parent)
      : PlainFigureRow(spec, parent), spin_(new QDoubleSpinBox(this)) {
    spin_->setDecimals(0);
    spin_->setRange(spec.option.min, spec.option.max);
    spin_->setKeyboardTracking(false);
    spin_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    add(spin_, name());
    auto* other = new QToolButton(this);
    other->setText(MaterialFieldsView::tr("New seed"));
    other->setFocusPolicy(Qt::StrongFocus);
    add(other, MaterialFieldsView::tr("Chooses another seed"));
    connect(spin_, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { Q_EMIT chosen(value, 0); });
    connect(other, &QToolButton::clicked, this, [this] {
      std::random_device device;
      Q_EMIT chosen(static_cast<double>(device() % 10'000), 0);
    });
  }
  void show_value(double now, double) override {
    const QSignalBlocker quiet(spin_);
    spin_->setValue(now);
  }

 private:
  QDoubleSpinBox* spin_;
};

class ColorRow final : public PlainFigureRow {
 public:
  ColorRow(const FigureSpec& spec, QWidget* parent)
      : PlainFigureRow(spec, parent), button_(new QToolButton(this)) {
    button_->setIconSize(kColorPx);
    button_->setFocusPolicy(Qt::StrongFocus);
    button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add(button_, name());
    connect(button_, &QToolButton::clicked, this, [this] {
      const QColor color = QColorDialog::getColor(color_, window(), name());
      if (color.isValid()) Q_EMIT chosen(static_cast<double>(color.rgb() & 0xFFFFFFU), 0);
    });
  }
  void show_value(double now, double) override {
    color_ = QColor::fromRgb(static_cast<QRgb>(now));
    QPixmap swatch(kColorPx * devicePixelRatioF());
    swatch.setDevicePixelRatio(devicePixelRatioF());
    swatch.fill(color_);
    QPainter painter(&swatch);
    painter.setPen(QColor(128, 128, 128));
    painter.drawRect(0, 0, kColorPx.width() - 1, kColorPx.height() - 1);
    painter.end();
    button_->setIcon(swatch);
    button_->setText(color_.name());
  }

 private:
  QToolButton* button_;
  QColor color_;
};

std::string_view shown_unit(std::string_view unit) noexcept {
  return unit == "um" ? std::string_view("µm") : unit;
}

FigureRow* make_figure_row(const FigureSpec& spec, QWidget* parent) {
  switch (spec.kind) {
    case MaterialFieldKind::kColor:
      return new ColorRow(spec, parent);
    case MaterialFieldKind::kWhole:
      return new SeedRow(spec, parent);
    case MaterialFieldKind::kNumber:
    case MaterialFieldKind::kSwitch:
    case MaterialFieldKind::kChoice:
      break;
  }
  return new OptionFigureRow(spec, parent);
}

constexpr int kRowGapPx = 7;
constexpr int kGroupGapPx = 8;

/// A table of the file format, with its title for the user.
struct GroupName {
  const char* id;
  const char* name;
};
constexpr std::array kGroups{
    GroupName{"", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "General")},
    GroupName{"feel", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Touch")},
    GroupName{"grain", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Grain")},
    GroupName{"line", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Line")},
    GroupName{"look", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Appearance")},
    GroupName{"sound", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Sound")},
    GroupName{"style", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Style of lines")},
};

QString group_id(std::string_view field) {
  const std::size_t dot = field.find('.');
  return dot == std::string_view::npos
             ? QString()
             : QString::fromUtf8(field.data(), static_cast<qsizetype>(dot));
}

QString group_name(const QString& id) {
  for (const GroupName& group : kGroups) {
    if (id == QLatin1String(group.id)) return MaterialFieldsView::tr(group.name);
  }
  return id;
}

}  // namespace

MaterialFieldsView::MaterialFieldsView(QWidget* parent)
    : QWidget(parent), pages_(new QVBoxLayout(this)) {
  pages_->setContentsMargins({});
  surfaces_ = make_page(surface_fields());
  media_ = make_page(medium_fields());
  media_.widget->hide();
}

template <class Field>
MaterialFieldsView::Page MaterialFieldsView::make_page(std::span<const Field> fields) {
  Page page;
  page.widget = new QWidget(this);
  auto* all = new QVBoxLayout(page.widget);
  all->setContentsMargins({});
  for (const Field& field : fields) {
    QVBoxLayout* group = group_of(page, all, field.id);
    FigureRow* row = make_figure_row(figure_spec(field), page.widget);
    group->addWidget(row);
    page.rows.push_back(row);
    connect(row, &FigureRow::chosen, this, [this, row](double value, quint64 run) {
      Q_EMIT chosen(QString::fromStdString(row->field()), value, run);
    });
  }
  all->addStretch(1);
  int widest = 0;
  const auto options = page.widget->findChildren<OptionRow*>();
  for (const OptionRow* row : options) widest = std::max(widest, row->number_width());
  for (OptionRow* row : options) row->set_number_width(widest);
  pages_->addWidget(page.widget);
  return page;
}

QVBoxLayout* MaterialFieldsView::group_of(Page& page, QVBoxLayout* all, std::string_view field) {
  const QString id = group_id(field);
  for (const auto& [name, layout] : page.groups) {
    if (name == id) return layout;
  }
  auto* layout = new QVBoxLayout;
  layout->setSpacing(kRowGapPx);
  auto* heading = new QLabel(group_name(id), page.widget);
  QFont font = heading->font();
  font.setBold(true);
  heading->setFont(font);
  if (!page.groups.empty()) layout->addSpacing(kGroupGapPx);
  layout->addWidget(heading);
  all->addLayout(layout);
  page.groups.emplace_back(id, layout);
  return layout;
}

void MaterialFieldsView::add_to_group(bool of_surfaces, const QString& group, QWidget* widget) {
  for (const auto& [name, layout] : (of_surfaces ? surfaces_ : media_).groups) {
    if (name == group) layout->addWidget(widget);
  }
}

const MaterialFieldsView::Page& MaterialFieldsView::shown_page() const {
  return media_.widget->isHidden() ? surfaces_ : media_;
}

FigureRow* MaterialFieldsView::row(std::string_view field) const {
  for (FigureRow* row : shown_page().rows) {
    if (row->field() == field) return row;
  }
  return nullptr;
}

void MaterialFieldsView::show_material(const AnyMaterial& now, const AnyMaterial& origin) {
  const bool is_surface = std::holds_alternative<SurfaceMaterial>(now);
  surfaces_.widget->setVisible(is_surface);
  media_.widget->setVisible(!is_surface);
  const auto show = [](const auto& fields, const auto& rows, const auto& is, const auto& was) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i]->show_value(fields[i].get(is), fields[i].get(was));
    }
  };
  if (is_surface) {
    const auto& surface = std::get<SurfaceMaterial>(now);
    show(surface_fields(), surfaces_.rows, surface, std::get<SurfaceMaterial>(origin));
    // A picture is one fixed relief and does not depend on the seed.
    const bool is_picture = surface.grain_character == HeightCharacter::kPicture && surface.picture;
    if (FigureRow* seed = row("grain.seed")) seed->setEnabled(!is_picture);
  } else {
    show(medium_fields(), media_.rows, std::get<Medium>(now), std::get<Medium>(origin));
  }
}

}  // namespace felt::desktop
