#pragma once

#include <QListView>
#include <QToolButton>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/panels/layers_model.h"

namespace felt::desktop {

/// The layers, the topmost first: seen, locked, named, ordered, used. A click on a layer draws
/// there from now on; eye and lock are at its ends; a double click or F2 renames it, dragging moves
/// it. By keys: arrows choose, Enter uses, Space shows and hides.
class LayersPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayersPanel(Studio& studio, QWidget* parent = nullptr);

  /// The layer that is chosen in the list; as a rule the one in use.
  [[nodiscard]] LayerId chosen() const;
  void choose(LayerId layer);
  /// One that acts on the chosen layer.
  void tell(LayerEvent::Do what);
  /// Of this layer; of the chosen one if it is none.
  void toggle_visible(LayerId id = {});
  void toggle_locked(LayerId id = {});
  /// The one above is used from now on, or below; hidden and locked ones are passed over.
  void use_next(bool above);
  /// Opens the field in its row.
  void rename();

 Q_SIGNALS:
  /// Another layer is chosen, or it is seen, locked or placed otherwise.
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* button(const char* icon, const QString& name, const QString& tip);
  void follow_model();
  void follow_chosen();
  void use_chosen();
  void use_clicked();
  void tell(LayerEvent::Do what, LayerId id);

  Studio& studio_;
  LayersModel* model_;
  QListView* list_;
  QToolButton* raise_ = nullptr;
  QToolButton* lower_ = nullptr;
  bool was_icon_ = false;  // the click in hand was on an eye or a lock
  LayerId kept_;           // chosen before the list was read anew
};

/// Adds layer.add, layer.remove, layer.rename, layer.raise, layer.lower, layer.show, layer.lock
/// (the last two on or off), layer.use_above, layer.use_below: all on the layer that is chosen in
/// the panel. All must live as long as the actions.
void add_layer_actions(Actions& actions, Studio& studio, LayersPanel& panel);

}  // namespace felt::desktop
