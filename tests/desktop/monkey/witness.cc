#include "witness.h"

#include <QThread>

namespace felt::desktop {

Witness::Witness(Studio& studio) : studio_(studio), seen_(studio.session().document()) {
  connect(&studio, &Studio::edited, this, [this](const Edit& edit) {
    const Result<void> applied = seen_.apply(edit);
    if (!applied && trouble_.empty()) trouble_ = applied.error().message;
  });
  connect(&studio, &Studio::opened, this, [this] { seen_ = studio_.session().document(); });
}

std::string Witness::complaint() const {
  if (!trouble_.empty()) return "an edit did not fit: " + trouble_;
  if (!(seen_ == studio_.session().document())) return "the document changed without an edit";
  return {};
}

std::string Witness::undo_and_redo() {
  constexpr int kTries = 50;
  for (int i = 0; i < kTries; ++i) {
    const std::optional<std::string> wrong = try_undo_and_redo();
    if (wrong) return *wrong;
    QThread::msleep(20);  // the line that came between is drawn now
    studio_.process();
  }
  return "a line came between undo and redo " + std::to_string(kTries) + " times";
}

std::optional<std::string> Witness::try_undo_and_redo() {
  const Document before = studio_.session().document();
  const std::uint64_t first = studio_.session().edit_count();
  std::size_t undone = 0;
  while (studio_.session().history().can_undo() && undone < 10'000) {
    const std::uint64_t edits = studio_.session().edit_count();
    studio_.apply(UndoEvent{});
    // The first UndoEvent may end a gesture instead of undoing an edit.
    if (studio_.session().edit_count() != edits) ++undone;
  }
  for (std::size_t i = 0; i < undone; ++i) studio_.apply(RedoEvent{});
  // Ink that a tool held back until now, or a late sample of a pen, correctly ends what can be
  // redone.
  if (studio_.session().edit_count() != first + 2 * undone) return std::nullopt;
  if (!(studio_.session().document() == before)) {
    return "undoing and redoing " + std::to_string(undone) + " steps gave another document";
  }
  return complaint();
}

}  // namespace felt::desktop
