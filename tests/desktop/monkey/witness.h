#pragma once

#include <optional>
#include <string>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Checks a drawing from outside: applies the edits that the studio reports to its own copy of the
/// document. Ink that disappears without an edit makes the two documents differ.
class Witness : public QObject {
 public:
  explicit Witness(Studio& studio);

  /// Returns "" if the studio's document is the result of its edits, otherwise the difference.
  [[nodiscard]] std::string complaint() const;
  /// Undoes and redoes everything. Returns "" if this gives the same document, otherwise the
  /// difference. Requires that no gesture is in progress.
  [[nodiscard]] std::string undo_and_redo();

 private:
  /// Returns nullopt if another edit came between.
  std::optional<std::string> try_undo_and_redo();

  Studio& studio_;
  Document seen_;
  std::string trouble_;
};

}  // namespace felt::desktop
