#include "desktop/feel/contour_finder.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#ifdef FELT_HAS_CONTOURS
#include "felt/contour/find_contours.h"
#endif

namespace felt::desktop {
namespace {

#ifdef FELT_HAS_CONTOURS
// A larger picture is reduced before it is searched.
constexpr int kMaxSearchedPx = 3'000;

/// Returns the grey values of a picture on white paper.
GreyPicture grey_of(const QImage& image) {
  QImage paper(image.size(), QImage::Format_Grayscale8);
  paper.fill(Qt::white);
  QPainter(&paper).drawImage(0, 0, image);
  GreyPicture grey{paper.width(), paper.height(), {}};
  for (int y = 0; y < paper.height(); ++y) {
    const uchar* row = paper.constScanLine(y);
    grey.grey.insert(grey.grey.end(), row, row + paper.width());
  }
  return grey;
}

std::vector<std::vector<Point>> contours_of(const PictureData& data, double mm_per_px) {
  QImage image = QImage::fromData(reinterpret_cast<const uchar*>(data.png.data()),
                                  static_cast<int>(data.png.size()), "PNG");
  if (image.isNull()) return {};
  const int longest = std::max(image.width(), image.height());
  double factor = 1.0;
  if (longest > kMaxSearchedPx) {
    image =
        image.scaled(kMaxSearchedPx, kMaxSearchedPx, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    factor = static_cast<double>(longest) / kMaxSearchedPx;
  }
  auto found = find_contours(grey_of(image), {.mm_per_px = factor * mm_per_px});
  if (!found) return {};
  for (auto& contour : *found) {
    for (Point& p : contour) p = {factor * p.x, factor * p.y};
  }
  return *std::move(found);
}
#else
std::vector<std::vector<Point>> contours_of(const PictureData& data, double mm_per_px) {
  static_cast<void>(data);
  static_cast<void>(mm_per_px);
  return {};
}
#endif

}  // namespace

bool ContourFinder::is_built_in() noexcept {
#ifdef FELT_HAS_CONTOURS
  return true;
#else
  return false;
#endif
}

double ContourFinder::Place::mm_per_px() const noexcept {
  return std::sqrt(std::fabs(place.a * place.d - place.b * place.c));
}

ContourFinder::ContourFinder(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
  pool_.setMaxThreadCount(1);
  connect(&studio, &Studio::opened, this, &ContourFinder::update_layers);
  connect(&studio, &Studio::edited, this, [this](const Edit& edit) {
    if (!edit.layers.empty()) update_layers();
  });
}

void ContourFinder::set_on(bool on) {
  if (std::exchange(is_on_, on) != on) update_layers();
}

std::vector<std::vector<Point>> ContourFinder::contours() const {
  std::vector<std::vector<Point>> all;
  std::size_t points = 0;
  for (const Place& place : places_) {
    if (!place.contours) continue;
    for (const std::vector<Point>& contour : *place.contours) {
      points += contour.size();
      if (all.size() == UseEdges::kMaxContours || points > UseEdges::kMaxContourPoints) return all;
      std::vector<Point> on_page;
      for (const Point p : contour) on_page.push_back(apply(place.place, p));
      if (std::all_of(on_page.begin(), on_page.end(), is_in_range)) {
        all.push_back(std::move(on_page));
      }
    }
  }
  return all;
}

void ContourFinder::update_layers() {
  std::vector<Place> places;
  for (const Layer& layer : studio_.session().document().layers()) {
    if (!is_on_ || !layer.picture || !layer.visible || !layer.locked) continue;
    places.push_back({layer.picture->data, layer.picture->place});
  }
  const auto is_same = [](const Place& a, const Place& b) {
    return a.data == b.data && a.place == b.place;
  };
  if (std::equal(places.begin(), places.end(), places_.begin(), places_.end(), is_same)) return;
  for (Place& place : places) place.contours = known_contours(place);
  places_ = std::move(places);
  pool_.clear();  // searches that have not begun
  for (const Place& place : places_) {
    if (!place.contours) search(place);
  }
  Q_EMIT changed();
}

/// Returns the contours of the same picture in about the same size, or null.
ContourFinder::Contours ContourFinder::known_contours(const Place& place) const {
  const auto is_as_large = [&place](const Place& known) {
    return std::fabs(known.mm_per_px() - place.mm_per_px()) < 0.01 * place.mm_per_px();
  };
  for (const Place& known : places_) {
    if (known.data == place.data && is_as_large(known)) return known.contours;
  }
  return nullptr;
}

void ContourFinder::search(const Place& place) {
  pool_.start([this, data = place.data, mm_per_px = place.mm_per_px()] {
    auto found =
        std::make_shared<const std::vector<std::vector<Point>>>(contours_of(*data, mm_per_px));
    QMetaObject::invokeMethod(
        this, [this, data, mm_per_px, found] { set_contours(data, mm_per_px, found); },
        Qt::QueuedConnection);
  });
}

void ContourFinder::set_contours(const std::shared_ptr<const PictureData>& data, double mm_per_px,
                                 const Contours& found) {
  bool is_new = false;
  for (Place& place : places_) {
    if (place.data != data || place.contours || place.mm_per_px() != mm_per_px) continue;
    place.contours = found;
    is_new = true;
  }
  if (is_new) Q_EMIT changed();
}

}  // namespace felt::desktop
