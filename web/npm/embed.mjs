// node embed.mjs MODULE OUT: writes the module as a text that inflate.js decodes. gzip, which servers
// use, makes base64 of compressed bytes as small as the bytes; base64 of the module itself would be
// a quarter larger. zopfli makes it a twentieth smaller than zlib does.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { inflate } from './src/inflate.js';

const [, , modulePath, outPath] = process.argv;
const bytes = readFileSync(modulePath);
const packed = execFileSync('zopfli', ['--deflate', '-c', modulePath], { maxBuffer: bytes.length });
if (!bytes.equals(inflate(packed, bytes.length))) throw new Error('inflate.js does not return the module');
writeFileSync(outPath, `export const size = ${bytes.length};\nexport const text = '${packed.toString('base64')}';\n`);
