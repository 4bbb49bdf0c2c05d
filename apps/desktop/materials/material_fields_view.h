#pragma once

#include <QDoubleSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "desktop/panels/option_row.h"
#include "felt/material/material_fields.h"
#include "felt/material/material_file.h"

namespace felt::desktop {

/// A row with the control for one figure (a value) of a material. It shows the value that
/// show_value() sets, and emits `chosen` with the value that the user chooses.
class FigureRow : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;
  [[nodiscard]] virtual const std::string& field() const noexcept = 0;
  virtual void show_value(double now, double origin) = 0;

 Q_SIGNALS:
  /// Values with the same `run` belong to one drag.
  void chosen(double value, quint64 run);
};

/// Shows every figure of a surface or a medium, as the tables in material_fields.h define them: a
/// slider and a number with its unit, a list of choices, or a colour. The reset button of a row
/// restores the original value. The figures are grouped like the tables in a material's file.
class MaterialFieldsView : public QWidget {
  Q_OBJECT

 public:
  explicit MaterialFieldsView(QWidget* parent = nullptr);

  void show_material(const AnyMaterial& now, const AnyMaterial& origin);
  /// Returns the row of a figure of the shown material; null if the material does not have that
  /// figure.
  [[nodiscard]] FigureRow* row(std::string_view field) const;
  /// Adds a widget at the end of a group, such as "grain", on the page of the surfaces or of the
  /// media.
  void add_to_group(bool of_surfaces, const QString& group, QWidget* widget);

 Q_SIGNALS:
  void chosen(const QString& field, double value, quint64 run);

 private:
  struct Page {
    QWidget* widget = nullptr;
    std::vector<FigureRow*> rows;
    std::vector<std::pair<QString, QVBoxLayout*>> groups;
  };

  template <class Field>
  Page make_page(std::span<const Field> fields);
  QVBoxLayout* group_of(Page& page, QVBoxLayout* all, std::string_view field);
  [[nodiscard]] const Page& shown_page() const;

  QVBoxLayout* pages_;
  Page surfaces_, media_;
};

}  // namespace felt::desktop
