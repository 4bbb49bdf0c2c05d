#include "desktop/materials/media_pictures.h"

#include <utility>
#include <vector>

#include "desktop/materials/medium_picture.h"
#include "desktop/panels/swatch_view.h"

namespace felt::desktop {

MediaPictures::MediaPictures(Studio& studio, QWidget* window)
    : QObject(window), studio_(studio), window_(window) {
  maker_.setMaxThreadCount(1);
  connect(&studio_, &Studio::option_changed, this, [this](const QString& id) {
    if (id == QLatin1String("surface.material") || id == QLatin1String("ink.color")) make();
  });
  connect(&studio_, &Studio::materials_changed, this, &MediaPictures::make);
  connect(&studio_, &Studio::opened, this, &MediaPictures::make);
  make();
}

MediaPictures::~MediaPictures() {
  ++round_;
}

QImage MediaPictures::of(const std::string& id) const {
  const auto at = pictures_.find(id);
  return at == pictures_.end() ? QImage() : at->second;
}

void MediaPictures::make() {
  const std::uint64_t round = ++round_;
  QColor ink = qcolor(studio_.session().ink_color());
  ink.setAlpha(255);
  std::vector<MediumPicture> wanted;
  for (const Medium& medium : studio_.materials().media()) {
    if (!medium.draws) continue;
    wanted.push_back({.medium = medium,
                      .surface = studio_.session().surface(),
                      .size = kSize,
                      .dpr = window_->devicePixelRatioF(),
                      .ink = readable_ink(ink, Qt::white)});
  }
  maker_.clear();
  maker_.start([this, round, wanted = std::move(wanted), media = studio_.materials(),
                surface = studio_.session().surface()]() mutable {
    Pictures made;
    const Grain grain = grain_for(surface, media);
    for (MediumPicture& picture : wanted) {
      if (round_ != round) return;
      picture.grain = grain;
      made[picture.medium.id] = draw_medium(picture);
    }
    QMetaObject::invokeMethod(
        this, [this, round, made] { take(round, made); }, Qt::QueuedConnection);
  });
}

void MediaPictures::take(std::uint64_t round, Pictures pictures) {
  if (round != round_) return;
  pictures_ = std::move(pictures);
  Q_EMIT changed();
}

}  // namespace felt::desktop
