#pragma once

#include <QAbstractListModel>
#include <QColor>
#include <QListView>
#include <vector>

#include "felt/io/gpl_palette.h"

namespace felt::desktop {

/// The colours of a palette as a list; their names for tips and for screen readers.
class SwatchModel : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  void set_colors(std::vector<NamedColor> colors);
  [[nodiscard]] const std::vector<NamedColor>& colors() const noexcept { return colors_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<NamedColor> colors_;
};

/// Swatches side by side, to click or to reach by the arrow keys; the colour in use has a mark.
class SwatchView : public QListView {
  Q_OBJECT

 public:
  /// One row only, or as many as there is room for.
  SwatchView(const QString& name, bool one_row, QWidget* parent = nullptr);

  void set_colors(std::vector<NamedColor> colors) { model_->set_colors(std::move(colors)); }
  [[nodiscard]] const std::vector<NamedColor>& colors() const { return model_->colors(); }
  /// The colour that has the mark.
  void mark(Rgba color);
  [[nodiscard]] Rgba marked() const noexcept { return marked_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void chosen(felt::Rgba color);

 private:
  SwatchModel* model_;
  bool one_row_;
  Rgba marked_;
};

/// Ours as Qt's, and back.
QColor qcolor(Rgba color);
Rgba rgba(const QColor& color);

}  // namespace felt::desktop
