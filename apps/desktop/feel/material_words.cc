#include "desktop/feel/material_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <array>

#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

struct Name {
  std::string_view id;
  const char* label;
};
constexpr std::array<Name, 8> kNames{{
    {"paper", QT_TRANSLATE_NOOP("Material", "Paper")},
    {"rough-paper", QT_TRANSLATE_NOOP("Material", "Rough paper")},
    {"watercolour", QT_TRANSLATE_NOOP("Material", "Watercolour paper")},
    {"canvas", QT_TRANSLATE_NOOP("Material", "Canvas")},
    {"blackboard", QT_TRANSLATE_NOOP("Material", "Blackboard")},
    {"felt", QT_TRANSLATE_NOOP("Material", "Felt")},
    {"wood", QT_TRANSLATE_NOOP("Material", "Wood")},
    {"glass", QT_TRANSLATE_NOOP("Material", "Glass")},
}};

constexpr std::array<Name, 16> kMedia{{
    {"pencil", QT_TRANSLATE_NOOP("Material", "Pencil")},
    {"pencil-hard", QT_TRANSLATE_NOOP("Material", "Hard pencil")},
    {"pencil-soft", QT_TRANSLATE_NOOP("Material", "Soft pencil")},
    {"charcoal", QT_TRANSLATE_NOOP("Material", "Charcoal")},
    {"chalk", QT_TRANSLATE_NOOP("Material", "Chalk")},
    {"crayon", QT_TRANSLATE_NOOP("Material", "Crayon")},
    {"felt-tip", QT_TRANSLATE_NOOP("Material", "Felt-tip")},
    {"ink-pen", QT_TRANSLATE_NOOP("Material", "Ink pen")},
    {"brush-pen", QT_TRANSLATE_NOOP("Material", "Brush pen")},
    {"eraser", QT_TRANSLATE_NOOP("Material", "Eraser")},
    {"dashed-pen", QT_TRANSLATE_NOOP("Material", "Dashed pen")},
    {"double-line", QT_TRANSLATE_NOOP("Material", "Double line")},
    {"arrow-pen", QT_TRANSLATE_NOOP("Material", "Arrow pen")},
    {"rope", QT_TRANSLATE_NOOP("Material", "Rope")},
    {"leaf", QT_TRANSLATE_NOOP("Material", "Leaf")},
    {"hatched", QT_TRANSLATE_NOOP("Material", "Hatched pen")},
}};

/// Returns the label of a material. The label of a built-in material is translated by its id,
/// unless the user changed it.
template <std::size_t kCount>
QString label_of(const std::array<Name, kCount>& names, std::string_view id,
                 std::string_view label) {
  for (const Name& name : names) {
    if (name.id == id && name.label == label) {
      return QCoreApplication::translate("Material", name.label);
    }
  }
  return text_of(label.empty() ? id : label);
}

QString grain_of(const Medium& medium) {
  if (medium.look.grain < 0.1) {
    return medium.grain < 0.5
               ? QCoreApplication::translate("Material", "covers the grain")
               : QCoreApplication::translate("Material", "grain is felt but not visible");
  }
  return medium.look.grain < 0.9 ? QCoreApplication::translate("Material", "fills the grain")
                                 : QCoreApplication::translate("Material", "shows the grain");
}

QString widths_of(const MediumLine& line) {
  const QLocale locale;
  return QCoreApplication::translate("Material", "%1 to %2 mm")
      .arg(locale.toString(line.min_mm, 'g', 2), locale.toString(line.max_mm, 'g', 3));
}

QString hardness(double n_per_m) {
  if (n_per_m >= 700.0) return QCoreApplication::translate("Material", "Hard");
  if (n_per_m >= 400.0) return QCoreApplication::translate("Material", "Firm");
  return QCoreApplication::translate("Material", "Soft");
}

QString friction(double mu) {
  if (mu < 0.15) return QCoreApplication::translate("Material", "slippery");
  if (mu < 0.3) return QCoreApplication::translate("Material", "some friction");
  if (mu < 0.4) return QCoreApplication::translate("Material", "much friction");
  return QCoreApplication::translate("Material", "strong friction");
}

QString grain(const SurfaceMaterial& material) {
  if (!(material.grain_um > 0.0)) return QCoreApplication::translate("Material", "smooth");
  switch (material.grain_character) {
    case HeightCharacter::kWeave:
      return QCoreApplication::translate("Material", "coarse weave");
    case HeightCharacter::kFibres:
      return QCoreApplication::translate("Material", "matted fibres");
    case HeightCharacter::kWood:
      return QCoreApplication::translate("Material", "grain along the board");
    case HeightCharacter::kRough:
      return material.grain_mm < 1.5 ? QCoreApplication::translate("Material", "rough grain")
                                     : QCoreApplication::translate("Material", "hilly grain");
    case HeightCharacter::kGrain:
    case HeightCharacter::kPicture:
      break;
  }
  return material.grain_mm < 1.5 ? QCoreApplication::translate("Material", "fine grain")
                                 : QCoreApplication::translate("Material", "rough grain");
}

}  // namespace

QString material_label(const SurfaceMaterial& material) {
  return label_of(kNames, material.id, material.label);
}

QString material_words(const SurfaceMaterial& material) {
  return QCoreApplication::translate("Material", "%1, %2, %3.")
      .arg(hardness(material.stiffness_n_per_m), friction(material.friction), grain(material));
}

QString medium_label(const Medium& medium) {
  return label_of(kMedia, medium.id, medium.label);
}

QString medium_words(const Medium& medium) {
  QString slides = friction(medium.friction);
  if (!slides.isEmpty()) slides[0] = slides[0].toUpper();
  return QCoreApplication::translate("Material", "%1, %2, lines of %3.")
      .arg(slides, grain_of(medium), widths_of(medium.line));
}

}  // namespace felt::desktop
