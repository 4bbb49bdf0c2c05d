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

/// Shows the colour of new ink: a field of shades, the colour code and the opacity. Also shows
/// recently used colours, palettes, and the contrast to the paper. Palettes are built in, or are
/// .gpl files that the user opens with a button or drops here. When the user chooses a colour, the
/// panel sets the option ink.color, and gives the colour to the selected lines (RestyleEvent); it
/// also shows changes of this option by other code.
class ColorsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ColorsPanel(Studio& studio, QWidget* parent = nullptr);

  /// Reads a .gpl file, shows the palette and remembers the file for the next start. Returns false
  /// if the file cannot be read; then the studio's `refused` says why.
  bool open_palette(const QString& path);
  /// Writes the shown palette to a file. Returns false if writing fails; then `refused` says why.
  bool export_palette(const QString& path);
  /// Returns the shown palette with its name.
  [[nodiscard]] Palette shown_palette() const;
  /// Shows a palette that came with a drawing and keeps it in the list until another drawing is
  /// opened. An empty palette only removes the previous one from the list.
  void show_drawing_palette(const Palette& palette);
  /// These functions ask the user for a file and then call open_palette() or export_palette().
  void ask_open();
  void ask_export();
  /// Adds the current colour to the user's own palette. drop_color() removes the current colour
  /// from it.
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
