#include "felt/autosave/layer_look.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/store/felt_tables.h"

namespace felt {
namespace {

enum class PictureBytes : std::uint8_t { kNone, kKnown, kHere, kEarlier };

constexpr unsigned kBlendShift = 4;
constexpr std::uint8_t kGroupVisible = 1, kGroupLocked = 2;  // flags of a group
static_assert(kBlendModeNames.size() <= 16);

}  // namespace

std::uint8_t flags_of_blend(BlendMode blend) noexcept {
  return static_cast<std::uint8_t>(static_cast<unsigned>(blend) << kBlendShift);
}

BlendMode blend_of_flags(std::uint8_t flags) noexcept {
  const unsigned mode = static_cast<unsigned>(flags) >> kBlendShift;
  return mode < kBlendModeNames.size() ? static_cast<BlendMode>(mode) : BlendMode::kNormal;
}

void append_layer_look(ByteWriter& out, const LayerState& state, const PictureData* known,
                       PicturesInBytes& written) {
  out.f64(state.opacity);
  if (!state.picture) {
    out.u8(static_cast<std::uint8_t>(PictureBytes::kNone));
    return;
  }
  const LayerPicture& picture = *state.picture;
  const auto is_same = [&picture](const auto& data) {
    return data && (&*data == picture.data.get() || *data == *picture.data);
  };
  const auto earlier = std::find_if(written.begin(), written.end(), is_same);
  const PictureBytes bytes = is_same(known)             ? PictureBytes::kKnown
                             : earlier != written.end() ? PictureBytes::kEarlier
                                                        : PictureBytes::kHere;
  out.u8(static_cast<std::uint8_t>(bytes));
  const Affine& m = picture.place;
  for (const double x : {m.a, m.b, m.c, m.d, m.e, m.f}) out.f64(x);
  out.u8(picture.exported ? 1 : 0);
  if (bytes == PictureBytes::kEarlier) {
    out.u32(static_cast<std::uint32_t>(earlier - written.begin()));
  } else if (bytes == PictureBytes::kHere) {
    out.text(picture.data->png);
    written.push_back(picture.data);
  }
}

void read_layer_look(ByteReader& in, LayerState& state,
                     const std::shared_ptr<const PictureData>& known, PicturesInBytes& read) {
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
    read.push_back(picture.data);
  } else if (bytes == PictureBytes::kEarlier) {
    const std::uint32_t index = in.u32();
    picture.data = index < read.size() ? read[index] : nullptr;
  }
  if (!in.ok() || !picture.data || !is_picture_place(picture.place)) return;
  state.picture = std::make_shared<const LayerPicture>(std::move(picture));
}

void append_layer_group(ByteWriter& out, const LayerGroupPtr& group) {
  out.u64(group ? group->id.value : 0);
  if (!group) return;
  out.text(utf8_prefix(group->name, kMaxLayerNameBytes));
  out.u8(static_cast<std::uint8_t>((group->visible ? kGroupVisible : 0) |
                                   (group->locked ? kGroupLocked : 0) |
                                   flags_of_blend(group->blend)));
  out.f64(group->opacity);
}

LayerGroupPtr read_layer_group(ByteReader& in) {
  LayerGroup group{.id = {in.u64()}, .name = {}};
  if (!group.id) return nullptr;
  group.name = std::string(in.text(kMaxLayerNameBytes));
  const std::uint8_t flags = in.u8();
  group.visible = (flags & kGroupVisible) != 0;
  group.locked = (flags & kGroupLocked) != 0;
  group.blend = blend_of_flags(flags);
  group.opacity = in.f64();
  const bool is_valid = is_id(static_cast<std::int64_t>(group.id.value)) && is_utf8(group.name) &&
                        group.opacity >= 0.0 && group.opacity <= 1.0;
  if (!in.ok() || !is_valid) return nullptr;
  return std::make_shared<const LayerGroup>(std::move(group));
}

}  // namespace felt
