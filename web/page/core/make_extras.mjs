// node make_extras.mjs ROOT FULL_MODULE OUT: writes two modules into the folder OUT: extras_text.js with what the page needs
// before the full module is loaded, the catalog of the full module and the version of the repository; and full_and_cat.js,
// the text of the full module with the cat, which only that module can draw, and the translations of sentences about
// unsupported content, which only that module says.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { instantiate } from './instantiate.mjs';

const [root, full, out] = process.argv.slice(2);
const read = (path) => readFileSync(join(root, path), 'utf8');
const module = await WebAssembly.compile(readFileSync(full));
const lacking = WebAssembly.Module.imports(module).filter(({ name }) => name.startsWith('_Z'));
if (lacking.length > 0) throw new Error(`the full module lacks ${lacking.map(({ name }) => name).join(', ')}`);
const exports = await instantiate(module);
const size = exports.felt_catalog();
const text = new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.felt_reply(), size));
const version = /^project\(.* VERSION ([0-9.]+)/m.exec(read('CMakeLists.txt'))[1];
const catalog = { version, ...JSON.parse(text) };
const line = (name, value) => `export const ${name} = ${JSON.stringify(value)};\n`;
writeFileSync(join(out, 'extras_text.js'), line('catalog', catalog));
writeFileSync(join(out, 'full_and_cat.js'), `export * from './full_text.js';
export { default as sentences } from './sentences.js';
${line('cat', read('share/samples/cat.ndjson'))}`);
