#include "felt/autosave/layer_look.h"

#include <string>
#include <utility>

namespace felt {
namespace {

enum class PictureBytes : std::uint8_t { kNone, kKnown, kHere };

}  // namespace

void append_layer_look(ByteWriter& out, const LayerState& state, const PictureData* known) {
  out.f64(state.opacity);
  if (!state.picture) {
    out.u8(static_cast<std::uint8_t>(PictureBytes::kNone));
    return;
  }
  const LayerPicture& picture = *state.picture;
  const bool is_known = known && (known == picture.data.get() || *known == *picture.data);
  out.u8(static_cast<std::uint8_t>(is_known ? PictureBytes::kKnown : PictureBytes::kHere));
  const Affine& m = picture.place;
  for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) out.f64(x);
  out.u8(picture.exported ? 1 : 0);
  if (!is_known) out.text(picture.data->png);
}

void read_layer_look(ByteReader& in, LayerState& state,
                     const std::shared_ptr<const PictureData>& known) {
  const double opacity = in.f64();
  if (opacity >= 0.0 && opacity <= 1.0) state.opacity = opacity;
  const auto bytes = static_cast<PictureBytes>(in.u8());
  if (bytes == PictureBytes::kNone) return;
  LayerPicture picture{known, {}};
  Affine& m = picture.place;
  for (double* x : {&m.a, &m.b, &m.c, &m.d, &m.e, &m.f}) *x = in.f64();
  picture.exported = in.u8() != 0;
  if (bytes == PictureBytes::kHere) {
    picture.data =
        make_picture_data(std::string(in.text(PictureData::kMaxBytes))).value_or(nullptr);
  }
  if (!in.ok() || !picture.data || !is_picture_place(picture.place)) return;
  state.picture = std::make_shared<const LayerPicture>(std::move(picture));
}

}  // namespace felt
