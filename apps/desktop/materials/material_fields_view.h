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

/// A figure of a material as a person sets it. Says its id and value; shows what it is told.
class FigureRow : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;
  [[nodiscard]] virtual const std::string& field() const noexcept = 0;
  virtual void show_value(double now, double origin) = 0;

 Q_SIGNALS:
  /// Those of one run are one drag.
  void chosen(double value, quint64 run);
};

/// Every figure of a sheet or a medium, made from the tables in material_fields.h: a slider and a
/// number with its unit each, a list for a choice, a colour; what it is like from the start as its
/// reset. In groups, by the tables of the file.
class MaterialFieldsView : public QWidget {
  Q_OBJECT

 public:
  explicit MaterialFieldsView(QWidget* parent = nullptr);

  void show_material(const AnyMaterial& now, const AnyMaterial& origin);
  /// The row of a figure of what is shown; null where there is none.
  [[nodiscard]] FigureRow* row(std::string_view field) const;
  /// Adds a widget at the end of a group of sheets or of media: "grain".
  void add_to_group(bool of_sheets, const QString& group, QWidget* widget);

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
  Page sheets_, media_;
};

}  // namespace felt::desktop
