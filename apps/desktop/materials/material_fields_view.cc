#include "desktop/materials/material_fields_view.h"

#include <QLabel>
#include <algorithm>
#include <array>
#include <type_traits>

#include "desktop/materials/figure_rows.h"

namespace felt::desktop {
namespace {

constexpr int kRowGapPx = 7;
constexpr int kGroupGapPx = 8;

/// Tables of the files, and what people call them.
struct GroupName {
  const char* id;
  const char* name;
};
constexpr std::array kGroups{
    GroupName{"", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "General")},
    GroupName{"feel", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "In the hand")},
    GroupName{"grain", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Grain")},
    GroupName{"line", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "Line")},
    GroupName{"look", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "To the eye")},
    GroupName{"sound", QT_TRANSLATE_NOOP("felt::desktop::MaterialFieldsView", "To the ear")},
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
  sheets_ = make_page(sheet_fields());
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

void MaterialFieldsView::add_to_group(bool of_sheets, const QString& group, QWidget* widget) {
  for (const auto& [name, layout] : (of_sheets ? sheets_ : media_).groups) {
    if (name == group) layout->addWidget(widget);
  }
}

const MaterialFieldsView::Page& MaterialFieldsView::shown_page() const {
  return media_.widget->isHidden() ? sheets_ : media_;
}

FigureRow* MaterialFieldsView::row(std::string_view field) const {
  for (FigureRow* row : shown_page().rows) {
    if (row->field() == field) return row;
  }
  return nullptr;
}

void MaterialFieldsView::show_material(const AnyMaterial& now, const AnyMaterial& origin) {
  const bool is_sheet = std::holds_alternative<SurfaceMaterial>(now);
  sheets_.widget->setVisible(is_sheet);
  media_.widget->setVisible(!is_sheet);
  const auto show = [](const auto& fields, const auto& rows, const auto& is, const auto& was) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i]->show_value(fields[i].get(is), fields[i].get(was));
    }
  };
  if (is_sheet) {
    const auto& sheet = std::get<SurfaceMaterial>(now);
    show(sheet_fields(), sheets_.rows, sheet, std::get<SurfaceMaterial>(origin));
    // A picture is one relief, whatever the seed.
    const bool is_picture = sheet.grain_character == HeightCharacter::kPicture && sheet.picture;
    if (FigureRow* seed = row("grain.seed")) seed->setEnabled(!is_picture);
  } else {
    show(medium_fields(), media_.rows, std::get<Medium>(now), std::get<Medium>(origin));
  }
}

}  // namespace felt::desktop
