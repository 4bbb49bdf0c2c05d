#include "desktop/files/recovery_offer.h"

#include <QFileInfo>
#include <utility>

namespace felt::desktop {
namespace {

std::optional<SavedDrawing> saved_of(const RecoveredDrawing& recovered) {
  if (recovered.path.empty()) return {};
  const QString path = QString::fromStdString(recovered.path);
  const QFileInfo info(path);
  if (!info.isFile()) return {};
  Result<Drawing> drawing = read_felt(recovered.path);
  if (!drawing) return {};
  return SavedDrawing{*std::move(drawing), info.lastModified()};
}

/// Whether it could go without a loss.
bool is_worthless(const RecoveryOffer& offer) {
  const RecoveredDrawing& recovered = offer.recovered;
  if (recovered.has_changes) return false;
  if (recovered.drawing.document.stroke_count() == 0) return true;
  // It was saved, and the file is still there to prove it. An example has no file, and is no loss.
  return offer.saved.has_value() || recovered.path.empty();
}

}  // namespace

std::vector<RecoveryOffer> read_offers(std::vector<AbandonedStore> stores) {
  std::vector<RecoveryOffer> offers;
  for (AbandonedStore& store : stores) {
    Result<RecoveredDrawing> recovered = recover_store(store.folder);
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
