#pragma once

#include "desktop/materials/material_fields_view.h"

namespace felt::desktop {

/// What a row needs to know of a field of either table.
struct FigureSpec {
  std::string id;
  MaterialFieldKind kind = MaterialFieldKind::kNumber;
  OptionSpec option;  ///< as panels/OptionRow shows it; texts of the table, which live for good
};

template <class Field>
FigureSpec figure_spec(const Field& field);

/// The row that suits the kind.
FigureRow* make_figure_row(const FigureSpec& spec, QWidget* parent);

/// "µm" for "um".
std::string_view shown_unit(std::string_view unit) noexcept;

template <class Field>
FigureSpec figure_spec(const Field& field) {
  FigureSpec spec{std::string(field.id), field.kind, {}};
  spec.option.id = field.id;
  spec.option.label = field.label;
  spec.option.unit = shown_unit(field.unit);
  spec.option.min = field.min;
  spec.option.max = field.max;
  spec.option.choices = field.choices;
  spec.option.help = field.help;
  if (field.kind == MaterialFieldKind::kSwitch) spec.option.kind = OptionKind::kSwitch;
  if (field.kind == MaterialFieldKind::kChoice) spec.option.kind = OptionKind::kChoice;
  return spec;
}

}  // namespace felt::desktop
