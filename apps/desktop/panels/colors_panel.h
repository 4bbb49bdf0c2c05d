#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QWidget>
#include <vector>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/panels/color_field.h"
#include "desktop/panels/palettes.h"
#include "desktop/panels/swatch_view.h"

namespace felt::desktop {

/// Returns the contrast ratio of two opaque colours, 1..21, as defined by WCAG 2.2.
double contrast_of(Rgba a, Rgba b);
/// Returns the colour that results from `color` over the opaque `ground`.
Rgba seen_on(Rgba color, Rgba ground);

/// The colour of new ink: a field of shades, its number and its opacity; recently used colours;
/// palettes, ours and .gpl files, opened by a button or dropped here; and the contrast to the
/// paper. Applies SetOption events of sheet.color, and follows changes of it from elsewhere.
class ColorsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ColorsPanel(Studio& studio, QWidget* parent = nullptr);

  /// Reads a .gpl file, shows it and keeps it for the next start. Returns false if it cannot be
  /// read; the studio's `refused` says why.
  bool open_palette(const QString& path);
  /// Writes the palette that is shown. Returns false if it cannot; `refused` says why.
  bool export_palette(const QString& path);
  /// Returns the palette that is shown, with its name.
  [[nodiscard]] Palette shown_palette() const;
  /// Offers and shows a palette that came with a drawing, until another drawing is opened. An empty
  /// palette only ends the offer.
  void show_drawing_palette(const Palette& palette);
  /// Asks for the file, then opens or exports.
  void ask_open();
  void ask_export();
  /// Adds the current colour to the user's palette; drop_color() removes it.
  void keep_color();
  void drop_color();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void build();
  QWidget* make_numbers();
  QWidget* make_palette_row();
  void connect_all();
  [[nodiscard]] Rgba color() const;
  void choose(Rgba color);
  void choose_opaque(Rgba color);
  void recolor_selected();
  void take_number();
  void follow();
  void note_drawn(const Edit& edit);
  void list_palettes(const QString& wanted);
  void show_palette(int i);
  [[nodiscard]] Palette own_palette() const;

  Studio& studio_;
  ColorField* field_;
  QLabel* sample_;
  QLineEdit* number_;
  QSpinBox* opacity_;
  QLabel* contrast_;
  SwatchView* recent_;
  QComboBox* palettes_;
  SwatchView* swatches_;
  std::vector<PaletteSource> sources_;  // parallel to palettes_
  Palette of_drawing_;
};

/// Adds edit.palette_open, edit.palette_export, edit.palette_keep, edit.palette_drop. Both
/// arguments must outlive the actions.
void add_color_actions(Actions& actions, ColorsPanel& panel);

}  // namespace felt::desktop
