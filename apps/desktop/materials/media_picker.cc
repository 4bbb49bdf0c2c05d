#include "desktop/materials/media_picker.h"

#include <QEvent>
#include <QResizeEvent>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "desktop/feel/feel_icons.h"
#include "desktop/feel/material_words.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

constexpr int kRoomPx = 8;  // margin around picture and text
constexpr int kGapPx = 3;
constexpr int kMinColumns = 2;

std::vector<Medium> drawing_media(const Materials& materials) {
  std::vector<Medium> all;
  for (const Medium& medium : materials.media()) {
    if (medium.draws) all.push_back(medium);
  }
  return all;
}

}  // namespace

bool take_medium(Studio& studio, const std::string& id) {
  const Medium* known = studio.materials().find_medium(id);
  if (!known || !known->draws) return false;
  const std::vector<SetOption> wanted = options_for_medium(studio.session(), *known);
  for (const SetOption& option : wanted) {
    const Result<OptionValue> now = studio.session().option(option.id);
    if (now && *now == option.value) continue;
    if (!studio.apply(option)) return false;
  }
  return true;
}

bool choose_medium(Studio& studio, const std::string& id) {
  if (!take_medium(studio, id)) return false;
  const Session& session = studio.session();
  if (!session.selection().empty()) {
    studio.apply(RestyleEvent{.medium = id});
    return true;
  }
  const ToolInfo& tool = session.tool().info();
  if (tool.kind == ToolKind::kDraws || tool.kind == ToolKind::kShapes) return true;
  // A tool with this option gives lines the colour or the medium of new ink.
  const std::string gives = std::string(tool.id) + ".gives";
  if (const Result<OptionValue> now = session.option(gives)) {
    if (*now == OptionValue(std::string("colour"))) {
      studio.apply(SetOption{gives, std::string("medium")});
    }
    return true;
  }
  const Tool* draws = session.first_tool(ToolKind::kDraws);
  if (draws) studio.apply(SelectTool{std::string(draws->info().id)});
  return true;
}

MediaPicker::MediaPicker(Studio& studio, const MediaPictures& pictures, QWidget* parent)
    : QWidget(parent), studio_(studio), pictures_(pictures), group_(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("media"));
  setAccessibleName(tr("Drawing medium"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(group_, &QButtonGroup::idClicked, this, [this](int index) {
    choose_medium(studio_, ids_[static_cast<std::size_t>(index)]);
    follow_choice();  // if refused, shows the present medium again
  });
  connect(&studio_, &Studio::option_changed, this, [this](const QString& id) {
    if (id.toStdString() == drawing_option(studio_.session(), "medium")) follow_choice();
  });
  connect(&pictures_, &MediaPictures::changed, this, &MediaPicker::show_pictures);
  connect(&studio_, &Studio::materials_changed, this, &MediaPicker::make_buttons);
  connect(&studio_, &Studio::opened, this, &MediaPicker::make_buttons);
  make_buttons();
}

QAbstractButton* MediaPicker::button(const std::string& id) const {
  const auto at = std::find(ids_.begin(), ids_.end(), id);
  return at == ids_.end() ? nullptr : buttons_[static_cast<std::size_t>(at - ids_.begin())];
}

void MediaPicker::make_buttons() {
  std::vector<std::string> ids;
  const std::vector<Medium> media = drawing_media(studio_.materials());
  for (const Medium& medium : media) ids.push_back(medium.id);
  if (ids != ids_) {
    for (QAbstractButton* button : std::exchange(buttons_, {})) {
      group_->removeButton(button);
      button->deleteLater();
      button->hide();
    }
    ids_ = std::move(ids);
    for (std::size_t i = 0; i < media.size(); ++i) {
      auto* button = new QToolButton(this);
      button->setCheckable(true);
      button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
      button->setIconSize(MediaPictures::kSize);
      button->setFocusPolicy(Qt::StrongFocus);
      group_->addButton(button, static_cast<int>(i));
      buttons_.push_back(button);
      button->show();
    }
  }
  labels_.clear();
  for (std::size_t i = 0; i < media.size(); ++i) {
    const QString words = medium_words(media[i]);
    labels_.push_back(medium_label(media[i]));
    buttons_[i]->setAccessibleName(labels_[i]);
    buttons_[i]->setToolTip(labels_[i] + QStringLiteral(". ") + words);
    buttons_[i]->setAccessibleDescription(words);
  }
  place_buttons();
  updateGeometry();
  follow_choice();
  show_pictures();
}

void MediaPicker::follow_choice() {
  // If the medium has no button (the eraser, or a medium of a previous drawing), no button is
  // checked.
  group_->setExclusive(false);
  const std::string chosen = drawing_medium(studio_.session());
  for (std::size_t i = 0; i < ids_.size(); ++i) buttons_[i]->setChecked(ids_[i] == chosen);
  group_->setExclusive(true);
}

void MediaPicker::show_pictures() {
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const QImage picture = pictures_.of(ids_[i]);
    if (!picture.isNull()) {
      buttons_[i]->setIcon(swatch_icon(QPixmap::fromImage(picture), palette()));
    }
  }
}

/// Returns the size of a cell. It is wide enough for the longest name.
QSize MediaPicker::cell() const {
  QSize size = MediaPictures::kSize + QSize(kRoomPx, 2 * kRoomPx + fontMetrics().height());
  for (const QString& label : labels_) {
    size.setWidth(std::max(size.width(), fontMetrics().horizontalAdvance(label) + 2 * kRoomPx));
  }
  return size;
}

int MediaPicker::columns(int width) const {
  return std::max(kMinColumns, (width + kGapPx) / (cell().width() + kGapPx));
}

int MediaPicker::height_for(int width) const {
  const int across = columns(width), count = static_cast<int>(buttons_.size());
  const int rows = (count + across - 1) / across;
  return rows * (cell().height() + kGapPx) - kGapPx;
}

QSize MediaPicker::sizeHint() const {
  const int width = kMinColumns * (cell().width() + kGapPx) - kGapPx;
  return {width, height_for(std::max(width, this->width()))};
}

QSize MediaPicker::minimumSizeHint() const {
  return {kMinColumns * (MediaPictures::kSize.width() + kRoomPx + kGapPx) - kGapPx, 0};
}

void MediaPicker::place_buttons() {
  const int across = columns(width()), height = cell().height();
  const int each = (width() - (across - 1) * kGapPx) / across;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const int column = static_cast<int>(i) % across, row = static_cast<int>(i) / across;
    buttons_[i]->setGeometry(column * (each + kGapPx), row * (height + kGapPx), each, height);
    buttons_[i]->setText(fontMetrics().elidedText(labels_[i], Qt::ElideRight, each - kRoomPx));
  }
  setFixedHeight(height_for(width()));
}

void MediaPicker::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_buttons();
}

void MediaPicker::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_pictures();
  if (event->type() == QEvent::FontChange) place_buttons();
}

}  // namespace felt::desktop
