#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "felt/document/edit.h"
#include "felt/store/byte_writer.h"

namespace felt {

/// The pictures whose bytes are in an edit or a base so far. Each is written once.
using PicturesInBytes = std::vector<std::shared_ptr<const PictureData>>;

/// Appends the opacity and the picture of a layer. If its picture has the data `known`, the bytes
/// of the picture are left out; the reader then needs the same `known`. Otherwise, they are written
/// unless they are in `written`, to which this adds them.
void append_layer_look(ByteWriter& out, const LayerState& state, const PictureData* known,
                       PicturesInBytes& written);

/// The blend mode of a layer is in the upper four bits of the flags of the layer, because programs
/// from before blend modes ignore these bits: they recover the layer as a normal one.
std::uint8_t flags_of_blend(BlendMode blend) noexcept;
/// Returns the mode in these flags. A mode that does not exist gives kNormal.
BlendMode blend_of_flags(std::uint8_t flags) noexcept;

/// Reads what append_layer_look() has written into `state`. Invalid bytes give an opacity of 1, or
/// no picture.
void read_layer_look(ByteReader& in, LayerState& state,
                     const std::shared_ptr<const PictureData>& known, PicturesInBytes& read);

/// Appends a group of layers, which may be null.
void append_layer_group(ByteWriter& out, const LayerGroupPtr& group);
/// Reads what append_layer_group() has written. Invalid bytes give null.
LayerGroupPtr read_layer_group(ByteReader& in);

}  // namespace felt
