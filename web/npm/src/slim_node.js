// The form of slim.js for Node, whose fetch() reads no files.
import { readFile } from 'node:fs/promises';
import { fetched, initFrom } from './slim_init.js';

const wasm = new URL('./feltline.wasm', import.meta.url);

export const init = (source = wasm) =>
  initFrom(source, wasm, (url) => (url.protocol === 'file:' ? readFile(url) : fetched(url)));

export * from './api.js';
export { default } from './api.js';
