// node same_bytes.mjs DIST FELTLINE ROOT: plays event scripts in the core and with the native program, and compares the
// drawings. The functions of libm differ in their last digits; the test counts the drawings that differ, and by how much.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { load_core, packed, random_of, text_of } from './core_loader.mjs';

const [, , dist, feltline, root] = process.argv;
const createCore = load_core(dist);
const folder = mkdtempSync(join(tmpdir(), 'feltline-page-'));
const kClose = 1e-6;  // mm

function native(script, ...options) {
  const out = join(folder, 'native.ndjson');
  execFileSync(feltline, ['replay', script, '-o', out, ...options], { stdio: ['ignore', 'ignore', 'pipe'] });
  return readFileSync(out, 'utf8');
}

/** Returns 'same', or how much the numbers of two drawings differ; Infinity if more than numbers does. */
function difference(ours, theirs) {
  if (ours === theirs) return 'same';
  const number = /-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;
  if (ours.replace(number, '#') !== theirs.replace(number, '#')) return Infinity;
  const a = ours.match(number).map(Number), b = theirs.match(number).map(Number);
  return Math.max(...a.map((x, i) => Math.abs(x - b[i])));
}

/** Returns the strokes of the core's drawing. The program writes no header. */
const strokes_of = (core) => text_of(core.save('ndjson')).replace(/^\{"feltline".*\n/, '');

function scripts() {
  const found = [join(root, 'share/samples/cat.ndjson')];
  for (const tool of readdirSync(join(root, 'src/felt/tools'), { withFileTypes: true })) {
    if (!tool.isDirectory()) continue;
    for (const part of ['.', 'scenarios']) {
      const at = join(root, 'src/felt/tools', tool.name, part);
      let names = [];
      try {
        names = readdirSync(at);
      } catch {  // a tool without scenarios
      }
      found.push(...names.filter((name) => name.endsWith('.ndjson')).map((name) => join(at, name)));
    }
  }
  return found.sort();
}

const core = await createCore();
const counts = { same: 0, close: 0, other: [], refused: 0 };
let largest = 0, drawn = 0;
for (const script of scripts()) {
  let theirs = null;
  try {
    theirs = native(script);
  } catch {  // scripts that need a drawing or a device
    ++counts.refused;
    continue;
  }
  const done = core.replay(readFileSync(script));
  assert.ok(done.ok, `${script}: ${done.error}`);
  const ours = strokes_of(core);
  drawn += ours.split('\n').length - 1;
  const away = difference(ours, theirs);
  if (away === 'same') ++counts.same;
  else if (away <= kClose) ++counts.close;
  else counts.other.push(`${script.split('/').slice(-1)} (${away})`);
  if (away !== 'same' && away !== Infinity) largest = Math.max(largest, away);
}
console.log(`scripts: ${counts.same} same bytes, ${counts.close} differ in digits of libm by at most ${largest} mm, ` +
  `${counts.other.length} by more: ${counts.other.join(', ')}; ${counts.refused} left out; ${drawn} strokes`);

// What is drawn on the page, its records played by the native program: the same bytes.
const random = random_of(3), hand = await createCore({ width: 800, height: 600 });
let now = 100;
for (const tool of ['pencil', 'pull', 'smooth', 'width', 'eraser', 'pencil']) {
  hand.event({ event: 'tool', id: tool });
  for (let stroke = 0; stroke < 4; ++stroke) {
    let x = 150 + 500 * random(), y = 100 + 400 * random(), angle = 6.3 * random();
    for (let i = 0; i < 120; ++i, now += 3) {
      angle += 0.3 * (random() - 0.5);
      x += 2 * Math.cos(angle);
      y += 2 * Math.sin(angle);
      hand.samples(packed([{ time: now, x, y, touching: i > 2 && i < 117, pressure: 0.3 + 0.3 * random() }]));
    }
    hand.advance(now += 100);
  }
}
hand.finish();
hand.rebased();
const { writeFileSync } = await import('node:fs');
const recording = join(folder, 'recording.ndjson');
writeFileSync(recording, hand.recorded());
const theirs = native(recording, '--as-recorded'), ours = strokes_of(hand);
const away = difference(ours, theirs);
console.log(`drawn on the page, played by the native program: ${away === 'same' ? 'same bytes' : `differ by ${away}`}`);
rmSync(folder, { recursive: true });
assert.ok(away === 'same' || away <= kClose);
assert.ok(ours.split('\n').length > 5, ours);
assert.ok(counts.other.length <= 0, 'drawings differ by more than digits');
assert.ok(counts.same > counts.close);
