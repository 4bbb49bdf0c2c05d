// node make_extras.mjs ROOT: prints the cat and the version of the repository as a module.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const root = process.argv[2];
const cat = readFileSync(join(root, 'share/samples/cat.ndjson'), 'utf8');
const version = /^project\(.* VERSION ([0-9.]+)/m.exec(readFileSync(join(root, 'CMakeLists.txt'), 'utf8'))[1];
for (const [name, value] of Object.entries({ cat, version })) console.log(`export const ${name} = ${JSON.stringify(value)};`);
