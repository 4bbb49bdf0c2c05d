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

/// Contrast of two opaque colours, 1..21, as WCAG 2.2 defines it ("contrast ratio").
double contrast_of(Rgba a, Rgba b);
/// A colour as it is seen on an opaque one.
Rgba seen_on(Rgba color, Rgba ground);

/// The colour of new ink: a field of shades, its number, its opacity; colours drawn with lately;
/// palettes, ours and .gpl files, opened by a button or dropped here; how well it is seen on the
/// paper. Writes SetOption events of sheet.color, and follows what others write.
class ColorsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ColorsPanel(Studio& studio, QWidget* parent = nullptr);

  /// Reads a .gpl file, shows it and keeps it for the next time. False: it cannot be read; the
  /// studio's `refused` says why.
  bool open_palette(const QString& path);
  /// Writes the palette that is shown. Likewise.
  bool export_palette(const QString& path);
  /// The palette that is shown, by its name.
  [[nodiscard]] Palette shown_palette() const;
  /// A drawing brought this one: it is offered and shown until another drawing comes. An empty one
  /// changes nothing but the offer.
  void show_drawing_palette(const Palette& palette);
  /// Asks for the file.
  void ask_open();
  void ask_export();
  /// Puts the colour in use into the palette of the person's own, or takes it out.
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
  std::vector<PaletteSource> sources_;  // as in palettes_
  Palette of_drawing_;
};

/// Adds edit.palette_open, edit.palette_export, edit.palette_keep, edit.palette_drop. Both must
/// live as long as the actions.
void add_color_actions(Actions& actions, ColorsPanel& panel);

}  // namespace felt::desktop
