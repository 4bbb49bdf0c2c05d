// node embed.mjs MODULE OUT: writes the module as a text that inflate.js decodes. gzip, which servers
// use, makes base64 of compressed bytes as small as the bytes; base64 of the module itself would be
// a quarter larger.
import { readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';
import { inflate } from './src/inflate.js';

const [, , modulePath, outPath] = process.argv;
const bytes = readFileSync(modulePath);
const packed = deflateRawSync(bytes, { level: 9, memLevel: 9 });
if (!bytes.equals(inflate(packed, bytes.length))) throw new Error('inflate.js does not return the module');
writeFileSync(outPath, `export const size = ${bytes.length};\nexport const text = '${packed.toString('base64')}';\n`);
