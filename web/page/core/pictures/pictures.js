// Pictures in drawings: the core asks for their pixels, and the browser decodes them.

/** Returns the pixels of a PNG file: RGBA with straight alpha. */
async function decode_png(bytes) {
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
}

export class Pictures {
  /** `decoded` is called when a picture has been decoded. */
  constructor(decoded, decode = decode_png) {
    Object.assign(this, { decoded, decode, pixels: new Map() });
  }

  /** Another drawing begins, whose pictures are other ones. */
  forget() {
    this.pixels.clear();
  }

  /** Copies the pixels of a picture to memory, or decodes it first. */
  copy(name, png, to) {
    const pixels = this.pixels.get(name);
    if (pixels?.length === to.length) to.set(pixels);
    if (pixels !== undefined) return;
    const { pixels: all } = this;
    all.set(name, null);  // being decoded, or damaged
    this.decode(png.slice()).then((decoded) => {
      all.set(name, decoded);
      this.decoded();
    }).catch((error) => console.info('Feltline: a picture was not decoded:', error));
  }
}
