// The package with its wasm module inside this file.
import { inflate } from './inflate.js';
import { setModule, setModuleSource } from './module.js';
import { size, text } from './module_text.js';

const moduleBytes = () => inflate(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), size);

setModuleSource(() => new WebAssembly.Module(moduleBytes()));

export async function init() {
  setModule(await WebAssembly.compile(moduleBytes()));
}

export * from './api.js';
export { default } from './api.js';
