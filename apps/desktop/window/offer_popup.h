#pragma once

#include <QFrame>
#include <QPointer>
#include <QToolButton>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"
#include "felt/tools/offer.h"

class QHBoxLayout;
class QLabel;

namespace felt::desktop {

/// The choice at the pen: what the last stroke could mean, or the stroke in progress while the pen
/// rests (Session::offered). One button for each meaning; the one that applies is checked. It does
/// not get the focus; the commands of add_offer_popup() have keys, which its tool tips name. The
/// accessible description of the canvas names the meanings. It disappears when the offer ends.
class OfferPopup : public QFrame {
  Q_OBJECT

 public:
  /// The arguments must outlive this object. `actions` must have the commands of
  /// add_offer_popup().
  OfferPopup(const Actions& actions, Canvas& canvas);

 protected:
  /// Handles pens and fingers, which otherwise would draw on the canvas below.
  bool event(QEvent* event) override;

 private:
  void follow();
  void rebuild(const OfferView& offer);
  void move_to(Point at);
  [[nodiscard]] QToolButton* button_at(QPointF global) const;
  void release_at(QPointF global);

  const Actions& actions_;
  Canvas& canvas_;
  Studio& studio_;
  QHBoxLayout* row_;
  QLabel* hint_;
  std::optional<OfferView> shown_;
  bool is_live_ = false;           // the stroke is in progress
  QPointer<QToolButton> pressed_;  // where a pen or finger was put down
};

/// Returns the text of one meaning: "Delete 3 lines", "Circle".
QString offer_text(const OfferRow& row);

/// Adds the popup to the canvas, and edit.take_offer (Ctrl+Enter) and edit.take_second_offer
/// (Ctrl+Shift+Enter), which choose the first and the second meaning that does not apply yet. The
/// canvas must outlive the actions. Escape (edit.cancel) keeps the ink.
void add_offer_popup(Actions& actions, Canvas& canvas);

}  // namespace felt::desktop
