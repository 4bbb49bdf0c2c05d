// The package with its wasm module in a separate file, which init() loads.
import { setModule } from './module.js';

async function bytesOf(source) {
  const url = new URL(source, import.meta.url);
  if (url.protocol !== 'file:' || typeof process === 'undefined') {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
    return response.arrayBuffer();
  }
  const files = 'node:fs/promises';
  return (await import(/* webpackIgnore: true */ /* @vite-ignore */ files)).readFile(url);
}

export async function init(source = new URL('./feltline.wasm', import.meta.url)) {
  let given = await source;
  if (typeof given === 'string' || given instanceof URL) given = await bytesOf(given);
  if (typeof Response !== 'undefined' && given instanceof Response) given = await given.arrayBuffer();
  setModule(given instanceof WebAssembly.Module ? given : await WebAssembly.compile(given));
}

export * from './api.js';
export { default } from './api.js';
