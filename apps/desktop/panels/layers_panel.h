#pragma once

#include <QComboBox>
#include <QListView>
#include <QSlider>
#include <QToolButton>
#include <QWidget>
#include <cstddef>
#include <optional>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/panels/layers_model.h"

class QVBoxLayout;

namespace felt::desktop {

class LayerDelegate;

/// Lists the layers, the topmost first. The user can show, lock, rename and reorder them and choose
/// the current layer, which receives new ink. The slider and the box set the opacity and the blend
/// mode of the highlighted layer. Groups of layers have rows of their own, with the same controls;
/// a click on the arrow of a group, or the left and right arrow keys, collapse and expand it.
/// A click on a row makes its layer the current one; a click on the eye or the lock at the ends of
/// the row shows, hides, locks or unlocks the layer; a double click or F2 renames the layer;
/// dragging a row moves its layer. With the keyboard, the arrow keys move the highlight, Enter
/// makes the highlighted layer current, and Space shows or hides it.
class LayersPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayersPanel(Studio& studio, QWidget* parent = nullptr);

  /// Returns the layer that is highlighted in the list, usually the current one.
  [[nodiscard]] LayerId chosen() const;
  void choose(LayerId layer);
  /// Returns the group whose row is highlighted; an empty id if the row is that of a layer.
  [[nodiscard]] GroupId chosen_group() const;
  void choose_group(GroupId group);
  /// Return true if the highlighted layer or group can be moved by one position, or if the
  /// highlighted layer can be merged with the one below.
  [[nodiscard]] bool can_raise() const;
  [[nodiscard]] bool can_lower() const;
  [[nodiscard]] bool can_merge() const;
  /// Applies an event to the highlighted layer or group.
  void apply(LayerEvent::Do what);
  /// Shows or hides the layer `id`, or the highlighted layer if `id` is empty. toggle_locked()
  /// locks or unlocks it.
  void toggle_visible(LayerId id = {});
  void toggle_locked(LayerId id = {});
  /// Makes the next layer above or below the current one the current layer. Skips hidden and locked
  /// layers.
  void use_next(bool above);
  /// Opens the text field in the highlighted row.
  void rename();
  /// Sets the opacity of the highlighted layer, 0..1. Values that follow each other while
  /// `is_dragging` is true are one step of undo.
  void set_opacity(double opacity, bool is_dragging);
  /// Sets the blend mode of the highlighted layer or group.
  void set_blend(BlendMode mode);
  /// Puts the highlighted layer into the group of the layer below it, or both into a new group.
  void group_with_below();
  /// Dissolves the highlighted group, or the group of the highlighted layer.
  void ungroup();
  /// Takes the highlighted layer out of its group and puts it above the group.
  void leave_group();

 Q_SIGNALS:
  /// Emitted when another layer is highlighted, or its visibility, lock or position changed.
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* button(const char* icon, const QString& name, const QString& tip);
  void add_opacity(QVBoxLayout& lines);
  void add_blend(QVBoxLayout& lines);
  void fold(bool collapsed);
  [[nodiscard]] LayerEvent event_of(LayerEvent::Do what) const;
  struct Range {
    std::size_t first = 0, last = 0;  // `last` is not included
  };
  [[nodiscard]] Range chosen_range() const;
  void connect_list(LayerDelegate& delegate);
  void follow_model();
  void follow_chosen();
  void use_chosen();
  void use_clicked();
  [[nodiscard]] QString why_not_open(const Layer& layer) const;
  /// Reports a layer that the session has added because no layer was open to draw on.
  void report_layer_for_ink();

  Studio& studio_;
  LayersModel* model_;
  QListView* list_;
  QSlider* opacity_;
  QComboBox* blend_;
  QToolButton* raise_ = nullptr;
  QToolButton* lower_ = nullptr;
  QToolButton* merge_ = nullptr;
  QToolButton* remove_ = nullptr;
  bool was_icon_ = false;                     // the current click was on an eye or a lock
  std::uint64_t ink_layers_ = 0;              // Session::layers_added_for_ink()
  std::optional<std::size_t> dragged_steps_;  // steps of undo after the last value of a drag
  LayerId kept_;        // layer that was highlighted before the list was rebuilt
  GroupId kept_group_;  // set if the row of a group was highlighted
};

/// Adds layer.add, layer.duplicate, layer.merge, layer.remove, layer.rename, layer.raise,
/// layer.lower, layer.group, layer.ungroup, layer.leave_group, layer.show, layer.lock,
/// layer.export_picture, layer.use_above and layer.use_below; layer.show, layer.lock and
/// layer.export_picture are switches. layer.add, layer.use_above and layer.use_below start from the
/// current layer; the other commands apply to the layer that is highlighted in the panel. All
/// arguments must outlive the actions.
void add_layer_actions(Actions& actions, Studio& studio, LayersPanel& panel);

}  // namespace felt::desktop
