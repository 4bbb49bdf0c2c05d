#include "desktop/files/recovery_offer.h"

#include <QFileInfo>
#include <utility>

namespace felt::desktop {
namespace {

std::optional<SavedDrawing> saved_of(const Recovered& recovered) {
  if (recovered.path.empty()) return {};
  const QString path = QString::fromStdString(recovered.path);
  const QFileInfo info(path);
  if (!info.isFile()) return {};
  Result<Drawing> drawing = read_felt(recovered.path);
  if (!drawing) return {};
  return SavedDrawing{*std::move(drawing), info.lastModified()};
}

/// Returns true if the autosave can be removed, because the user would lose nothing.
bool is_worthless(const RecoveryOffer& offer) {
  const Recovered& recovered = offer.recovered;
  // If the autosave is damaged, has_changes may be false although there were unsaved changes.
  if (recovered.has_changes || !recovered.problems.empty()) return false;
  const Document& document = recovered.drawing.document;
  if (document.stroke_count() + document.fill_count() == 0) return true;
  if (recovered.path.empty()) return true;  // an unchanged drawing without a file: an example
  // The drawing was saved. If the file contains another drawing now, someone may have restored an
  // older version, and the autosave is needed.
  return offer.saved && offer.saved->drawing.document == recovered.drawing.document;
}

}  // namespace

std::vector<RecoveryOffer> read_offers(std::vector<AbandonedAutosave> stores) {
  std::vector<RecoveryOffer> offers;
  for (AbandonedAutosave& store : stores) {
    Result<Recovered> recovered = recover_autosave(store.folder);
    if (!recovered) continue;
    RecoveryOffer offer{std::move(store), *std::move(recovered), {}};
    offer.saved = saved_of(offer.recovered);
    if (is_worthless(offer)) {
      static_cast<void>(std::move(offer.store).remove());
    } else {
      offers.push_back(std::move(offer));
    }
  }
  return offers;
}

}  // namespace felt::desktop
