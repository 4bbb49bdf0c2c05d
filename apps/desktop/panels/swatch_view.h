#pragma once

#include <QAbstractListModel>
#include <QColor>
#include <QListView>
#include <vector>

#include "felt/io/gpl_palette.h"

namespace felt::desktop {

/// The colours of a palette as a list. Their names are the tool tips and the texts for screen
/// readers.
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

/// Shows swatches side by side. The user chooses a swatch with a click or the arrow keys. The
/// current colour has a mark.
class SwatchView : public QListView {
  Q_OBJECT

 public:
  /// If `one_row`, shows only one row; otherwise as many rows as fit.
  SwatchView(const QString& name, bool one_row, QWidget* parent = nullptr);

  void set_colors(std::vector<NamedColor> colors) { model_->set_colors(std::move(colors)); }
  [[nodiscard]] const std::vector<NamedColor>& colors() const { return model_->colors(); }
  /// Sets the colour that has the mark.
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

/// These functions convert between the library's colours and Qt's.
QColor qcolor(Rgba color);
Rgba rgba(const QColor& color);

}  // namespace felt::desktop
