// node pack.mjs MODULE OUT: packs a wasm module with xz into a text that module.js unpacks. gzip, which servers use, makes
// base64 of packed bytes as small as the bytes.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';

const [, , module, out] = process.argv;
const packed = execFileSync('xz', ['--format=lzma', '-9e', '--stdout', module], { maxBuffer: 1 << 28 });
writeFileSync(out, `export const size = ${readFileSync(module).length};\nexport const text = '${packed.toString('base64')}';\n`);
