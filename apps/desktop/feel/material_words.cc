#include "desktop/feel/material_words.h"

#include <QCoreApplication>
#include <array>

namespace felt::desktop {
namespace {

struct Name {
  std::string_view id;
  const char* label;
};
constexpr std::array<Name, 4> kNames{{
    {"paper", QT_TRANSLATE_NOOP("Material", "Paper")},
    {"blackboard", QT_TRANSLATE_NOOP("Material", "Blackboard")},
    {"felt", QT_TRANSLATE_NOOP("Material", "Felt")},
    {"glass", QT_TRANSLATE_NOOP("Material", "Glass")},
}};

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
  if (material.grain_mm < 1.5) return QCoreApplication::translate("Material", "fine grain");
  if (material.grain_mm < 3.0) return QCoreApplication::translate("Material", "rough grain");
  return QCoreApplication::translate("Material", "coarse weave");
}

}  // namespace

QString material_label(const SurfaceMaterial& material) {
  for (const Name& name : kNames) {
    if (name.id == material.id) return QCoreApplication::translate("Material", name.label);
  }
  return QString::fromUtf8(material.label.data(), qsizetype(material.label.size()));
}

QString material_words(const SurfaceMaterial& material) {
  return QCoreApplication::translate("Material", "%1, %2, %3.")
      .arg(hardness(material.stiffness_n_per_m), friction(material.friction), grain(material));
}

}  // namespace felt::desktop
