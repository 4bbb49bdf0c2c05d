// What init() of both forms of feltline/slim does.
import { setModule } from './module.js';

export async function fetched(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
  return response.arrayBuffer();
}

/**
 * Sets the module from a URL, which read(url) reads, a Response, bytes, a module, or a promise of one of these. A URL may
 * be relative to `base`.
 */
export async function initFrom(source, base, read) {
  let given = await source;
  if (typeof given === 'string' || given instanceof URL) given = await read(new URL(given, base));
  if (typeof Response !== 'undefined' && given instanceof Response) given = await given.arrayBuffer();
  setModule(given instanceof WebAssembly.Module ? given : await WebAssembly.compile(given));
}
