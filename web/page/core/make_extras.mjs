// node make_extras.mjs ROOT FULL_MODULE: prints, as a module, what the page needs before the full module is loaded: the
// catalog of the full module, the version of the repository, and the cat.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { instantiate } from './instantiate.mjs';

const [root, full] = process.argv.slice(2);
const read = (path) => readFileSync(join(root, path), 'utf8');
const module = await WebAssembly.compile(readFileSync(full));
const lacking = WebAssembly.Module.imports(module).filter(({ name }) => name.startsWith('_Z'));
if (lacking.length > 0) throw new Error(`the full module lacks ${lacking.map(({ name }) => name).join(', ')}`);
const exports = await instantiate(module);
const size = exports.felt_catalog();
const text = new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.felt_reply(), size));
const version = /^project\(.* VERSION ([0-9.]+)/m.exec(read('CMakeLists.txt'))[1];
const catalog = { version, ...JSON.parse(text) };
for (const [name, value] of Object.entries({ catalog, cat: read('share/samples/cat.ndjson') })) {
  console.log(`export const ${name} = ${JSON.stringify(value)};`);
}
