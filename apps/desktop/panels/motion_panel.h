#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "felt/motion/key_film.h"

class QComboBox;
class QLabel;
class QListWidget;
class QSpinBox;

namespace felt::desktop {

/// Lists the key drawings (key_layers.h) in their order and holds the settings of their film: the
/// number of in-betweens, the frames of each key drawing, and the speed. These are settings of the
/// user, not of the drawing. Adds the actions "layer.add_key", "view.onion_skin", "view.play" and
/// "file.animation".
///
/// While the onion skin is on, only the current key drawing is shown, and the ones before and after
/// it shine through. The panel hides and shows layers by events, so each is a step of undo.
class MotionPanel : public QWidget {
  Q_OBJECT

 public:
  MotionPanel(Studio& studio, Actions& actions, QWidget* parent = nullptr);

  [[nodiscard]] KeyFilmOptions options() const;
  /// Makes a key drawing the current layer.
  void choose(LayerId key);
  /// Adds an empty layer above the current one for the next key drawing.
  void add_key();
  void set_onion(bool on);

 Q_SIGNALS:
  /// The onion skin changed; nullopt: it is off.
  void onion_changed(const std::optional<felt::Document>& onion);
  /// The user wants to see or to export the film of the key drawings.
  void wants_play();
  void wants_export();

 private:
  void add_actions(Actions& actions);
  void build(const Actions& actions);
  void add_ease(const QString& name, const char* ease);
  void on_edit(const Edit& edit);
  void hide_others();
  void show_keys();
  void show_length();
  void send_onion();

  Studio& studio_;
  QListWidget* list_;
  QSpinBox* between_;
  QSpinBox* hold_;
  QComboBox* ease_;
  QLabel* length_;
  QTimer onion_delay_;
  bool is_onion_on_ = false;
  std::vector<LayerId> keys_;    // as shown in the list
  std::vector<LayerId> hidden_;  // the layers that the panel has hidden
};

}  // namespace felt::desktop
