// The wasm modules inside scripts, so that the page also works from file://, where a browser loads nothing else. The
// first one is in the bundle; the full one and the one with SQLite are in scripts of their own. All are packed, and a
// module of some kB unpacks them.
import { size, text } from 'generated/module_text.js';
import { text as unpacker } from 'generated/unpack_text.js';

const kPage = 65536, kPart = 16384;
const kBusyMs = 8;  // then a module that is not urgent lets the page handle its events

const bytes_of = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

async function unpacked({ size, text }, is_urgent) {
  const { instance } = await WebAssembly.instantiate(bytes_of(unpacker), {
    env: { emscripten_notify_memory_growth() {} }, wasi_snapshot_preview1: { proc_exit() {} } });
  const { memory, decode, begin, unpack } = instance.exports;
  const at = kPage * memory.grow(Math.ceil((text.length + size) / kPage) + 1), out = at + text.length;
  new TextEncoder().encodeInto(text, new Uint8Array(memory.buffer, at, text.length));
  decode(at, text.length);
  let done = begin(at, out, size), since = performance.now();
  while (done > 0 && done < size) {
    done = unpack(kPart);
    if (is_urgent || performance.now() - since < kBusyMs) continue;
    await new Promise((resolve) => setTimeout(resolve));
    since = performance.now();
  }
  if (done === 0) throw new Error('the module is damaged');
  return new Uint8Array(memory.buffer, out, size);
}

/** The first module. Compiling begins before the page asks for it. */
export const first_module = unpacked({ size, text }, true).then(WebAssembly.compile);
first_module.catch(() => {});  // createCore() reports the error

/** Loads a script beside the page. */
const load_beside = (name) => new Promise((resolve, reject) => {
  const script = document.createElement('script');
  script.src = name;
  script.onload = resolve;
  script.onerror = () => reject(new Error('it is not there'));
  document.head.append(script);
});

/** Returns the full module. */
export async function full_module(load_script = load_beside) {
  if (!globalThis.feltlineFull) await load_script('core_full.js');
  return WebAssembly.compile(await unpacked(globalThis.feltlineFull, false));
}

/** Loads the module with SQLite, but does not unpack it. */
export async function load_felt(load_script = load_beside) {
  if (!globalThis.feltlineFelt) await load_script('core_felt.js');
}

let compiled_felt = null;

/** Returns the module with SQLite. */
export async function felt_module(load_script = load_beside) {
  await load_felt(load_script);
  compiled_felt ??= await WebAssembly.compile(await unpacked(globalThis.feltlineFelt, false));
  return compiled_felt;
}
