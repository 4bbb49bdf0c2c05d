#pragma once

#include <memory>

#include "felt/document/edit.h"
#include "felt/store/byte_writer.h"

namespace felt {

/// Appends the opacity and the picture of a layer. If its picture has the data `known`, the bytes
/// of the picture are left out; the reader then needs the same `known`.
void append_layer_look(ByteWriter& out, const LayerState& state, const PictureData* known);

/// Reads what append_layer_look() has written into `state`. Invalid bytes give an opacity of 1, or
/// no picture.
void read_layer_look(ByteReader& in, LayerState& state,
                     const std::shared_ptr<const PictureData>& known);

}  // namespace felt
