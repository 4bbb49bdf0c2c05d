#include "desktop/materials/material_editor.h"

#include <QAbstractSpinBox>
#include <QEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/materials/material_setting_keys.h"
#include "desktop/materials/media_picker.h"
#include "desktop/panels/tool_icons.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

constexpr QSize kFirstSize{1060, 700};
constexpr int kMarginPx = 8;
constexpr int kFrameMs = 33;  // interval between two repaints of the plot

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

QScrollArea* scrolling(QWidget* content, const QString& name, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);
  area->setAccessibleName(name);
  return area;
}

}  // namespace

MaterialEditor::MaterialEditor(Studio& studio, MaterialEditorModel& model, QWidget* parent)
    : QWidget(parent, Qt::Window),
      studio_(studio),
      model_(model),
      list_(new MaterialList(this)),
      name_(heading({}, this)),
      state_(new QLabel(this)),
      presets_(new QComboBox(this)),
      fields_(new MaterialFieldsView(this)),
      pairs_(new PairTable(this)),
      shape_(new ShapeRow(this)),
      preview_(new StrokePreview(this)),
      plot_(new ProbePlot(this)),
      sign_(new StabilitySign(this)),
      graph_(new ForceGraph(history_, this)),
      notice_(new QLabel(this)),
      parts_(new QSplitter(Qt::Horizontal, this)) {
  setObjectName(QStringLiteral("material_editor"));
  setWindowTitle(tr("Materials"));
  make_actions();
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, kMarginPx);
  rows->addWidget(make_bar());
  rows->addWidget(parts_, 1);
  rows->addWidget(notice_);
  notice_->setContentsMargins(kMarginPx, 0, kMarginPx, 0);
  notice_->setWordWrap(true);
  notice_->hide();
  parts_->setChildrenCollapsible(false);
  parts_->addWidget(list_);
  parts_->addWidget(make_figures());
  parts_->addWidget(make_looks());
  parts_->setStretchFactor(0, 2);
  parts_->setStretchFactor(1, 3);
  parts_->setStretchFactor(2, 4);
  list_->setMinimumWidth(16 * fontMetrics().averageCharWidth());
  resize(kFirstSize);
  restoreGeometry(Settings::the().value(material_keys::kGeometry).toByteArray());
  parts_->restoreState(Settings::the().value(material_keys::kParts).toByteArray());
  watch();
  follow_list();
  follow_desk();
}

void MaterialEditor::watch() {
  connect(list_, &MaterialList::chosen, &model_, &MaterialEditorModel::select);
  connect(fields_, &MaterialFieldsView::chosen, this,
          [this](const QString& field, double value, quint64 run) {
            const bool needs_picture = field == QLatin1String("grain.character") &&
                                       value == double(HeightCharacter::kPicture) &&
                                       !std::get<SurfaceMaterial>(model_.now()).picture;
            if (needs_picture) {
              ask_relief();
              follow_desk();
            } else {
              model_.set(field.toStdString(), value, run);
            }
          });
  for (auto* number : findChildren<QLineEdit*>()) number->installEventFilter(this);
  for (auto* number : findChildren<QAbstractSpinBox*>()) number->installEventFilter(this);
  connect(pairs_, &PairTable::chosen, &model_, &MaterialEditorModel::set_pair);
  connect(shape_, &ShapeRow::chosen, &model_, &MaterialEditorModel::set_shape);
  connect(&model_, &MaterialEditorModel::selected, this, &MaterialEditor::follow_desk);
  connect(&model_, &MaterialEditorModel::changed, this, &MaterialEditor::follow_desk);
  connect(&model_, &MaterialEditorModel::failed, this, [this](const QString& why) { report(why); });
  connect(&model_.own(), &UserMaterials::changed, this, &MaterialEditor::follow_list);
  connect(&model_.steps(), &QUndoStack::indexChanged, this, &MaterialEditor::tell_names);
  connect(&studio_, &Studio::materials_changed, this, &MaterialEditor::follow_list);
  connect(&studio_, &Studio::option_changed, this, &MaterialEditor::ask_probe);
  connect(&studio_.loop(), &HapticLoop::device_changed, this, [this] {
    history_.clear();
    ask_probe();
  });
  connect(&studio_.loop(), &HapticLoop::strength_changed, this, &MaterialEditor::ask_probe);
  connect(&studio_, &Studio::opened, this, &MaterialEditor::follow_list);
  connect(&studio_.loop(), &HapticLoop::ticked, this, &MaterialEditor::take_tick);
  connect(&probe_, &ForceProbe::figured, this, [this](const ProbeFigures& figures) {
    plot_->show_figures(figures);
    sign_->show_words(stability_words(request(), figures, studio_.loop().device().info().label));
  });
  frame_.setSingleShot(true);
  frame_.setInterval(kFrameMs);
  connect(&frame_, &QTimer::timeout, graph_, qOverload<>(&QWidget::update));
}

QWidget* MaterialEditor::make_figures() {
  auto* column = new QWidget(this);
  auto* rows = new QVBoxLayout(column);
  rows->setContentsMargins(kMarginPx, 0, 0, 0);
  QFont large = name_->font();
  large.setPointSizeF(1.2 * large.pointSizeF());
  name_->setFont(large);
  name_->setWordWrap(true);
  state_->setWordWrap(true);
  rows->addWidget(name_);
  rows->addWidget(state_);
  auto* line = new QHBoxLayout;
  auto* label = new QLabel(tr("S&tart from:"), column);
  label->setBuddy(presets_);
  presets_->setAccessibleName(tr("Use the values of another material"));
  presets_->setToolTip(
      tr("Sets all values to those of another material; you can then change them"));
  presets_->setPlaceholderText(tr("Values of…"));
  connect(presets_, &QComboBox::activated, this, [this](int index) {
    const MaterialKey key{model_.key().is_surface,
                          presets_->itemData(index).toString().toStdString()};
    const std::optional<AnyMaterial> from = find_in(studio_.materials(), key);
    if (from) model_.take_figures(*from);
    presets_->setCurrentIndex(-1);
  });
  line->addWidget(label);
  line->addWidget(presets_, 1);
  rows->addLayout(line);
  auto* content = new QWidget(column);
  auto* figures = new QVBoxLayout(content);
  figures->setContentsMargins(0, 0, kMarginPx, 0);
  fields_->add_to_group(true, QStringLiteral("grain"), make_relief_button());
  fields_->add_to_group(false, QStringLiteral("feel"), pairs_);
  fields_->add_to_group(false, QStringLiteral("style"), shape_);
  figures->addWidget(fields_);
  QScrollArea* area = scrolling(content, tr("Values"), column);
  rows->addWidget(area, 1);
  column->setMinimumWidth(content->minimumSizeHint().width() + 24);
  return column;
}

QWidget* MaterialEditor::make_relief_button() {
  auto* button = new QToolButton(this);
  button->setText(tr("Relief from a picture\u2026"));
  button->setToolTip(
      tr("A PNG of 8 or 16 bits; white is high. It is scaled to a square of 32 grain wavelengths "
         "and repeats seamlessly"));
  button->setAccessibleName(button->text());
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::clicked, this, &MaterialEditor::ask_relief);
  return button;
}

QWidget* MaterialEditor::make_looks() {
  auto* content = new QWidget(this);
  auto* rows = new QVBoxLayout(content);
  rows->setContentsMargins(kMarginPx, 0, kMarginPx, 0);
  rows->addWidget(heading(tr("Light, firm, hard"), content));
  rows->addWidget(preview_, 3);
  rows->addWidget(heading(tr("What a stroke feels like"), content));
  rows->addWidget(plot_, 3);
  auto* hatched =
      new QLabel(tr("Hatched: changes below 0.04 N, which are too small to feel."), content);
  hatched->setWordWrap(true);
  rows->addWidget(hatched);
  rows->addWidget(sign_);
  rows->addWidget(heading(tr("Forces on the pen now"), content));
  rows->addWidget(graph_, 2);
  return scrolling(content, tr("Result"), this);
}

void MaterialEditor::follow_list() {
  list_->show_materials(studio_.materials(), model_);
  list_->show_chosen(model_.key());
  fill_presets();
}

void MaterialEditor::fill_presets() {
  QList<std::pair<QString, QString>> all;
  const auto add = [&](const AnyMaterial& material) {
    if (key_of(material) == model_.key()) return;
    all.push_back({name_of(material), QString::fromStdString(id_of(material))});
  };
  if (model_.key().is_surface) {
    for (const SurfaceMaterial& surface : studio_.materials().surfaces()) add(surface);
  } else {
    for (const Medium& medium : studio_.materials().media()) add(medium);
  }
  const QSignalBlocker quiet(presets_);
  presets_->clear();
  for (const auto& [name, id] : all) presets_->addItem(name, id);
  presets_->setCurrentIndex(-1);
}

void MaterialEditor::follow_desk() {
  const AnyMaterial now = model_.now();
  fields_->show_material(now, model_.origin());
  if (const auto* medium = std::get_if<Medium>(&now)) {
    pairs_->show_pairs(*medium, studio_.materials());
    shape_->show_shape(medium->style.shape);
  }
  list_->show_chosen(model_.key());
  fill_presets();
  tell_names();
  ask_probe();
}

void MaterialEditor::tell_names() {
  name_->setText(name_of(model_.now()));
  state_->setText(state_words());
  QUndoStack& steps = model_.steps();
  action("undo")->setEnabled(steps.canUndo());
  action("redo")->setEnabled(steps.canRedo());
  action("undo")->setToolTip(steps.canUndo() ? tr("Undo: %1").arg(steps.undoText()) : tr("Undo"));
  action("redo")->setToolTip(steps.canRedo() ? tr("Redo: %1").arg(steps.redoText()) : tr("Redo"));
  action("revert")->setEnabled(model_.now() != model_.origin());
  action("save")->setEnabled(model_.is_changed());
  action("rename")->setEnabled(model_.is_own());
  const QString kept = model_.own().kept_because(model_.key());
  action("delete")->setEnabled(model_.is_own() && kept.isEmpty());
  action("delete")->setToolTip(model_.is_own() && !kept.isEmpty()
                                   ? kept
                                   : tr("Deletes the material and its file; undo restores both"));
  report_slots();
}

QString MaterialEditor::state_words() const {
  if (model_.is_own()) {
    return model_.is_changed() ? tr("Your own, not saved to a file yet. Feltline remembers it.")
                               : tr("Your own, saved.");
  }
  return is_built_in(model_.key())
             ? tr("Comes with Feltline. Changing it makes your own copy.")
             : tr("Comes with this drawing. Changing it makes your own copy.");
}

void MaterialEditor::report_slots() {
  const QChar slot = QLatin1Char(model_.slot());
  const QChar other = QLatin1Char(model_.slot() == 'A' ? 'B' : 'A');
  QAction* flip = action("flip");
  flip->setText(model_.slots_are_alike() ? tr("Compare: A = B") : tr("Compare: %1").arg(slot));
  flip->setToolTip(tr("You feel, see and hear %1. Press B for %2.").arg(slot).arg(other));
  flip->setEnabled(model_.is_own());
  action("copy_to_other")->setText(tr("Copy %1 to %2").arg(slot).arg(other));
  action("copy_to_other")->setEnabled(model_.is_own() && !model_.slots_are_alike());
}

ProbeRequest MaterialEditor::request() const {
  ProbeRequest request;
  request.surface = studio_.session().surface();
  const Medium* in_hand = studio_.materials().find_medium(drawing_medium(studio_.session()));
  request.medium = in_hand ? *in_hand : media().front();
  const AnyMaterial now = model_.now();
  if (const auto* surface = std::get_if<SurfaceMaterial>(&now)) request.surface = *surface;
  if (const auto* medium = std::get_if<Medium>(&now)) request.medium = *medium;
  request.device = studio_.loop().device().device().capabilities();
  request.strength = studio_.loop().strength();
  return request;
}

void MaterialEditor::ask_probe() {
  if (!isVisible()) return;
  const ProbeRequest wanted = request();
  probe_.ask(wanted);
  preview_->show_medium(wanted.medium, wanted.surface);
}

void MaterialEditor::take_tick(const TickReport& tick) {
  history_.add(tick);
  if (isVisible() && !frame_.isActive()) frame_.start();
}

void MaterialEditor::report(const Result<void>& done, const QString& success) {
  report(done ? success : QString::fromStdString(done.error().message));
}

void MaterialEditor::report(const QString& words) {
  notice_->setText(words);
  notice_->setVisible(!words.isEmpty());
}

void MaterialEditor::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  graph_->set_shows_sent(studio_.loop().device().device().capabilities().has_force());
  follow_desk();
}

void MaterialEditor::hideEvent(QHideEvent* event) {
  Settings::the().set(material_keys::kGeometry, saveGeometry());
  Settings::the().set(material_keys::kParts, parts_->saveState());
  model_.own().keep_changes();
  QWidget::hideEvent(event);
}

void MaterialEditor::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) draw_icons();
}

}  // namespace felt::desktop
