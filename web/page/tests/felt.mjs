// node felt.mjs DIST FELTLINE ROOT: the core and the native program read each other's .felt files, write the same bytes,
// and refuse the same files with the same words.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { draw, load_core, random_of, text_of, wave } from './core_loader.mjs';

const [, , dist, feltline, root] = process.argv;
const createCore = load_core(dist), folder = mkdtempSync(join(tmpdir(), 'feltline-page-'));
const corpus = (name) => readFileSync(join(root, 'tests/fuzz/corpus/felt', name));
const kPng = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==';
const kDamages = 60;

async function make() {
  const core = await createCore({ width: 800, height: 600, decodePicture: async () => new Uint8ClampedArray([255, 0, 0, 255]) });
  assert.deepEqual(await core.prepareFelt(), { ok: true });
  return core;
}

/** Converts a file with the native program. Returns { bytes } or { error }, its sentence without path and advice. */
function native(bytes, ending = 'felt') {
  const [from, to] = [join(folder, 'from.felt'), join(folder, `to.${ending}`)];
  writeFileSync(from, bytes);
  const { status, stderr } = spawnSync(feltline, ['convert', from, '-o', to], { encoding: 'utf8' });
  if (status === 0) return { bytes: readFileSync(to) };
  return { error: stderr.trim().replace(`feltline: ${from}: `, '').replace(/; `feltline convert --salvage`.*/, '') };
}

/** A sentence without the bytes that are not text, which a terminal and a page show in different ways. */
const plain = (text) => text?.replace(/(?:\\x[0-9a-f]{2}|[^ -~])+/g, '?');
const same = (a, b, what) => assert.ok(Buffer.compare(Buffer.from(a), Buffer.from(b)) === 0, `${what}: the bytes differ`);
/** The strokes of a file as lines; the core writes a header. */
const strokes_of = (lines) => text_of(lines).replace(/^\{"feltline".*\n/, '');

/** Opens a file with the native program and with a core: both give the same drawing, or the same sentence. */
function compare(core, bytes, what) {
  const theirs = native(bytes, 'ndjson'), ours = core.open(bytes, 'a.felt');
  assert.equal(ours.ok ? undefined : plain(ours.error.replace('a.felt: ', '')), plain(theirs.error), what);
  if (ours.ok) assert.equal(strokes_of(core.save('ndjson')), strokes_of(theirs.bytes), what);
  return ours.ok;
}

/** Draws with everything that a file can have. */
async function rich_drawing() {
  const core = await make();
  const event = (one) => assert.deepEqual(core.event(one), { ok: true }, JSON.stringify(one));
  let now = draw(core, wave(200, 200), 100, { pressure: 0.4 });
  event({ event: 'layer', do: 'add', name: 'Ideas – „zwei“' });
  assert.ok(core.setMedium('chalk').ok);
  event({ event: 'option', id: 'surface.material', value: 'blackboard' });
  now = draw(core, wave(150, 300), now + 100, { pressure: 0.9 });
  event({ event: 'layer', do: 'opacity', id: core.state().layers[0].id, opacity: 0.5 });
  event({ event: 'layer', do: 'blend', id: core.state().layers[0].id, mode: 'multiply' });
  event({ event: 'guides', do: 'add', kind: 'symmetry', x: 100, y: 80, axes: 2, angle_rad: 0.5 });
  now = draw(core, wave(250, 400, 30), now + 100);
  core.event({ event: 'undo' });
  core.event({ event: 'redo' });
  draw(core, wave(300, 500, 20), now + 100);
  return core;
}

const tests = {
  async 'a drawing has the same bytes as from the native program, and is read back'() {
    for (const core of [await make(), await rich_drawing()]) {
      const bytes = core.save('felt'), theirs = native(bytes);
      assert.equal(theirs.error, undefined);
      same(bytes, theirs.bytes, 'a drawing of the page');
      const other = await make();
      assert.deepEqual(other.open(bytes, 'a.felt'), { ok: true });
      same(other.save('felt'), bytes, 'a drawing that was opened again');
      assert.equal(other.state().layers.length, core.state().layers.length);
      const { strokes, layers } = core.state();
      const { ok, notices = [] } = other.add(bytes, 'a.felt');
      assert.ok(ok);
      assert.equal(notices.some((text) => text.includes('Layers whose lines were added')), layers.length > 1);
      assert.equal(other.state().strokes, 2 * strokes);
    }
  },

  async 'lines have the opacity of their layers, as from the native program'() {
    const core = await rich_drawing(), lines = strokes_of(core.save('ndjson'));
    assert.match(lines, /"color":"#[0-9a-f]{6}80"/);
    assert.equal(lines, strokes_of(native(core.save('felt'), 'ndjson').bytes));
  },

  async 'what the page does not use stays in the file: recordings, and what a newer version stored'() {
    const core = await make();
    for (const name of ['recorded.felt', 'two.felt', 'newer.felt']) {
      assert.ok(compare(core, corpus(name), name));
      const bytes = core.save('felt'), tables = name === 'recorded.felt' ? /CREATE TABLE recording/ : /CREATE TABLE/;
      assert.match(Buffer.from(bytes).toString('latin1'), tables);
      same(native(bytes).bytes, bytes, name);
    }
  },

  async 'a picture stays in the file'() {
    const script = [{ t_ms: 0, event: 'picture', png: kPng, matrix: [10, 0, 0, 10, 20, 20] }, { points: [[10, 10], [60, 30]] }];
    const from = join(folder, 'picture.ndjson'), to = join(folder, 'picture.felt');
    writeFileSync(from, script.map((line) => JSON.stringify(line)).join('\n'));
    assert.equal(spawnSync(feltline, ['replay', from, '-o', to]).status, 0);
    const core = await make();
    assert.deepEqual(core.open(readFileSync(to), 'a.felt'), { ok: true });
    const bytes = core.save('felt');
    assert.match(Buffer.from(bytes).toString('latin1'), /CREATE TABLE picture/);
    same(native(bytes).bytes, bytes, 'a drawing with a picture');
    // It is painted when it has been decoded.
    const is_red = () => {
      const { data, width } = core.pixels(), [x, y] = core.toCanvas(25, 25).map(Math.round), at = 4 * (y * width + x);
      return data[at] > 250 && data[at + 1] < 5;
    };
    core.fitPage();
    core.paint(null, 1000);
    await new Promise((done) => setTimeout(done));
    core.paint(null, 1000);
    assert.ok(is_red(), 'the picture is not painted');
  },

  async 'the autosave keeps a drawing that has only a picture'() {
    const from = join(folder, 'only-picture.ndjson'), to = join(folder, 'only-picture.felt');
    const script = [{ t_ms: 0, event: 'picture', png: kPng, matrix: [10, 0, 0, 10, 20, 20] }, { t_ms: 1, event: 'layer', do: 'remove', id: 1 }];
    writeFileSync(from, script.map((line) => JSON.stringify(line)).join('\n'));
    assert.equal(spawnSync(feltline, ['replay', from, '-o', to]).status, 0);
    const core = await make(), other = await make();
    assert.deepEqual(core.open(readFileSync(to), 'a.felt'), { ok: true });
    assert.equal(core.rebased(), true);
    assert.deepEqual(other.restore(core.base(), core.recorded()), { ok: true });
    same(other.save('felt'), core.save('felt'), 'a picture without lines');
  },

  async 'a file that is added keeps the media of the drawing'() {
    const medium = (kind) => `kind = "medium"\nid = "my-line"\n[style]\nkind = "${kind}"\n`;
    const drawn = (kind) => {
      const from = join(folder, `${kind}.ndjson`), to = join(folder, `${kind}.felt`);
      const lines = [{ t_ms: 0, event: 'material', text: medium(kind) }, { t_ms: 1, event: 'option', id: 'pencil.medium', value: 'my-line' },
        { points: [[10, 10], [60, 30]] }];
      writeFileSync(from, lines.map((line) => JSON.stringify(line)).join('\n'));
      assert.equal(spawnSync(feltline, ['replay', from, '-o', to]).status, 0);
      return readFileSync(to);
    };
    const core = await make();
    assert.deepEqual(core.open(drawn('dashes'), 'dashes.felt'), { ok: true });
    assert.deepEqual(core.add(drawn('double'), 'double.felt'), { ok: true,
      notices: ['“My line” differs here: the added strokes look as it does in this drawing'] });
    const text = Buffer.from(core.save('felt')).toString('latin1');
    assert.match(text, /kind = "dashes"/);
    assert.doesNotMatch(text, /kind = "double"/);
  },

  async 'the samples of the native program are read exactly'() {
    const core = await make();
    for (const name of readdirSync(join(root, 'share/samples'))) {
      const drawing = spawnSync(feltline, ['convert', join(root, 'share/samples', name), '-o', join(folder, 'sample.felt')]);
      assert.equal(drawing.status, 0, name);
      assert.ok(compare(core, readFileSync(join(folder, 'sample.felt')), name));
    }
  },

  async 'files that cannot be read are refused as by the native program'() {
    const core = await rich_drawing(), bytes = core.save('felt'), random = random_of(22), before = core.save('svg');
    const changed = (...edits) => {
      const copy = bytes.slice();
      for (const [at, value] of edits) copy[at] = value;
      return copy;
    };
    const refused = { empty: new Uint8Array(0), 'a text': Buffer.from('no drawing'), cut: bytes.subarray(0, 50), half: bytes.subarray(0, bytes.length / 2),
      'of the future': changed([63, 2]), 'without a version': changed([63, 0]), 'of another program': changed([68, 1]),
      'still open elsewhere': changed([18, 2]), 'with a trigger': corpus('trigger.felt'), 'cut in the corpus': corpus('cut.felt') };
    for (const [what, file] of Object.entries(refused)) {
      assert.equal(compare(core, file, what), false, what);
      assert.deepEqual(core.save('svg'), before, `${what}: the drawing changed`);
    }
    assert.match(core.open(refused['of the future'], 'a.felt').error, /written by a newer Feltline/);
    assert.equal(core.open(refused.empty, 'a.felt').error, 'a.felt: is empty');
    const other = await make();
    let count = 0;
    for (let i = 0; i < kDamages; ++i) {
      const edits = Array.from({ length: 1 + Math.floor(20 * random()) }, () =>
        [Math.floor(100 + random() * (bytes.length - 100)), Math.floor(256 * random())]);
      count += compare(other, changed(...edits), `damage ${JSON.stringify(edits)}`) ? 0 : 1;
    }
    console.log(`${count} of ${kDamages} damaged files refused, with the same words; the others give the same strokes`);
    assert.ok(count > kDamages / 4);
  },

  async 'the autosave of a drawing with SQLite keeps everything'() {
    const core = await make();
    core.open(corpus('recorded.felt'), 'a.felt');
    core.event({ event: 'guides', do: 'add', kind: 'symmetry', x: 100, y: 80, axes: 2, angle_rad: 0.5 });
    core.rebase();
    assert.equal(core.rebased(), true);
    const other = await make();
    assert.ok(other.isFelt(core.base()));
    assert.deepEqual(other.restore(core.base(), core.recorded()), { ok: true });
    same(other.save('felt'), core.save('felt'), 'a restored drawing');
  },

  async 'without SQLite, or if it ends, the drawing stays'() {
    const whole = await rich_drawing(), bytes = whole.save('felt');
    whole.database.exports = null;
    assert.equal(whole.save('felt'), null);
    assert.match(whole.saveError, /core_felt\.js is not loaded/);
    assert.equal(whole.open(bytes, 'a.felt').ok, false);
    whole.rebase();
    assert.ok(whole.rebased() && !whole.isFelt(whole.base()), 'the autosave needs SQLite');
    await whole.prepareFelt();
    same(whole.save('felt'), bytes, 'after another start');
    // A module without memory ends; the core does not.
    whole.database.exports = { database_input() { throw new RangeError('memory'); } };
    assert.equal(whole.save('felt'), null);
    assert.match(whole.saveError, /memory/);
    assert.equal(whole.database.is_ready, false);
    await whole.prepareFelt();
    same(whole.save('felt'), bytes, 'after an end');
  },
};

try {
  for (const [name, test] of Object.entries(tests)) {
    const begin = performance.now();
    await test();
    console.log(`passed: ${name} (${(performance.now() - begin).toFixed(0)} ms)`);
  }
} finally {
  rmSync(folder, { recursive: true });
}
process.exit(0);
