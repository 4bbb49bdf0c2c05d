// node fitting.mjs DIST FELTLINE ROOT: compares the time of fitting raw strokes in the core with that of the native
// program, in turns, on the same machine. The bar is a ratio of 2.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { load_core } from './core_loader.mjs';

const [, , dist, feltline, root] = process.argv;
const core = await load_core(dist)();
const folder = mkdtempSync(join(tmpdir(), 'feltline-fitting-'));
const lines = readFileSync(join(root, 'share/samples/page.ndjson'), 'utf8').split('\n').filter((line) => line.includes('"points"'));
const copies = 20, all = join(folder, 'all.ndjson');
writeFileSync(all, Array.from({ length: copies }, (_, k) => lines.map((line, i) =>
  line.replace(/"id":"[^"]*"/, `"id":"s${k * lines.length + i + 1}"`)).join('\n')).join('\n') + '\n');
const bytes = readFileSync(all);

const time = (work) => {
  const begin = process.hrtime.bigint();
  work();
  return Number(process.hrtime.bigint() - begin) / 1e6;
};
const ours = [], theirs = [], start = [];
for (let turn = 0; turn < 5; ++turn) {
  ours.push(time(() => assert.ok(core.open(bytes, 'all.ndjson').ok)));
  theirs.push(time(() => execFileSync(feltline, ['fit', all, '-o', join(folder, 'fit.ndjson'), '-j', '1'])));
  start.push(time(() => execFileSync(feltline, ['--version'], { stdio: 'ignore' })));
}
rmSync(folder, { recursive: true });
const [page, native, empty] = [ours, theirs, start].map((times) => Math.min(...times));
const ratio = page / (native - empty);
console.log(`${copies * lines.length} strokes: page ${page.toFixed(0)} ms, native ${(native - empty).toFixed(0)} ms ` +
  `(without ${empty.toFixed(0)} ms of start), ratio ${ratio.toFixed(2)}`);
assert.ok(ratio <= 2, `the page takes ${ratio.toFixed(2)} times as long as the native program`);
