#pragma once

#include <QObject>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Keeps the options of all tools (medium, widths, snapping, stabiliser, eraser mode, ...) and the
/// colour of new ink in the settings. The next window and the next start of the program begin with
/// these values. An option that has its default value is not stored, so that a later version can
/// change the default. Stored values that are no longer valid are ignored. Two kinds of values are
/// not kept: the colour that comes with an opened drawing (Studio::open), and options that the user
/// sets only for a few gestures (transform.duplicate, lasso.combine, ...).
///
///   new KeptOptions(studio, window);   // restores the stored options, then stores changes
class KeptOptions : public QObject {
  Q_OBJECT

 public:
  explicit KeptOptions(Studio& studio, QObject* parent = nullptr);

 private:
  void restore();
  void store(const QString& id);

  Studio& studio_;
};

}  // namespace felt::desktop
