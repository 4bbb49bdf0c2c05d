#pragma once

#include <string>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Watches a drawing from outside: keeps a document of its own by the edits that the studio tells,
/// so that ink which goes without an edit is noticed.
class Witness : public QObject {
 public:
  explicit Witness(Studio& studio);

  /// "" while the studio's document is what its edits made of it.
  [[nodiscard]] std::string complaint() const;
  /// "" when undoing everything and doing it again gives the same document. Requires that no
  /// gesture is in work.
  [[nodiscard]] std::string undo_and_redo();

 private:
  Studio& studio_;
  Document seen_;
  std::string trouble_;
};

}  // namespace felt::desktop
