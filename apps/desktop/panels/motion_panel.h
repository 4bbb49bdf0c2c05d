#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "felt/document/key_timing.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QListWidget;
class QSpinBox;

namespace felt::desktop {

/// Lists the key drawings (felt/motion/key_layers.h) in their order, and shows and edits the timing
/// of the current layer: the number of in-betweens to the next key drawing, the frames for which it
/// is shown, and the speed. Timings are in the drawing, and each change is a step of undo. Adds the
/// actions "layer.add_key", "layer.same_timing", "view.onion_skin", "view.correct_matches",
/// "view.play" and "file.animation".
///
/// While the onion skin is on, the other key drawings are out of view (UseView), and the ones
/// before and after the current one shine through. The drawing does not change.
class MotionPanel : public QWidget {
  Q_OBJECT

 public:
  MotionPanel(Studio& studio, Actions& actions, QWidget* parent = nullptr);

  /// Makes a key drawing the current layer.
  void choose(LayerId key);
  /// Adds an empty layer above the current one for the next key drawing, with the same timing.
  void add_key();
  void set_onion(bool on);

 Q_SIGNALS:
  /// The onion skin changed; nullopt: it is off.
  void onion_changed(const std::optional<felt::Document>& onion);
  /// The user wants to correct the matches of the current key drawing, or no longer.
  void wants_matches(bool on);
  /// The user wants to see or to export the film of the key drawings.
  void wants_play();
  void wants_export();

 private:
  void add_actions(Actions& actions);
  void build(const Actions& actions);
  QGridLayout* make_buttons(const Actions& actions);
  void add_ease(const QString& name, const EaseCurve& ease);
  void on_edit(const Edit& edit);
  [[nodiscard]] KeyTiming timing() const;
  /// Gives the timing of the current layer to all key drawings.
  void use_timing_for_all();
  void show_keys();
  std::optional<std::size_t> add_begun_key();
  void show_timing();
  void show_length();
  void show_onion();

  Studio& studio_;
  QListWidget* list_;
  QSpinBox* between_;
  QSpinBox* hold_;
  QComboBox* ease_;
  QLabel* length_;
  std::vector<EaseCurve> eases_;  // as listed in ease_
  QTimer onion_delay_;
  bool is_onion_on_ = false;
  std::vector<LayerId> keys_;  // as shown in the list
};

}  // namespace felt::desktop
