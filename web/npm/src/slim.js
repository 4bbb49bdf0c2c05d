// The package with its wasm module in a separate file, which init() loads, for browsers and bundlers. It names no module
// of Node, because bundlers cannot resolve one.
import { fetched, initFrom } from './slim_init.js';

const wasm = new URL('./feltline.wasm', import.meta.url);

export const init = (source = wasm) => initFrom(source, wasm, fetched);

export * from './api.js';
export { default } from './api.js';
