// The wasm modules inside scripts, so that the page also works from file://, where a browser loads nothing else. The
// small one is in the bundle; the full one, which also reads files, in a script of its own. Both are packed, and a module
// of some kB unpacks them.
import { size, text } from 'generated/module_text.js';
import { text as unpacker } from 'generated/unpack_text.js';

const kPage = 65536;
const bytes_of = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

async function unpacked({ size, text }) {
  const packed = bytes_of(text);
  const { instance } = await WebAssembly.instantiate(bytes_of(unpacker), {
    env: { emscripten_notify_memory_growth() {} }, wasi_snapshot_preview1: { proc_exit() {} } });
  const { memory, unpack } = instance.exports;
  const at = kPage * memory.grow(Math.ceil((packed.length + size) / kPage) + 1), out = at + packed.length;
  new Uint8Array(memory.buffer).set(packed, at);
  if (unpack(at, out, size) !== 1) throw new Error('the module is damaged');
  return new Uint8Array(memory.buffer, out, size);
}

export const module_bytes = () => unpacked({ size, text });

/** Loads a script beside the page. */
const load_beside = (name) => new Promise((resolve, reject) => {
  const script = document.createElement('script');
  script.src = name;
  script.onload = resolve;
  script.onerror = () => reject(new Error('it is not there'));
  document.head.append(script);
});

/** Returns the bytes of the full module. */
export async function full_bytes(load_script = load_beside) {
  if (!globalThis.feltlineFull) await load_script('core_full.js');
  return unpacked(globalThis.feltlineFull);
}
