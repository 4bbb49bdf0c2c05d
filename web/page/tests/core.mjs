// node core.mjs DIST: tests of the core without a browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { draw, has_ink, load_core, packed, random_of, text_of, wave } from './core_loader.mjs';

const [, , dist] = process.argv;
const createCore = load_core(dist);
const make = (options = {}) => createCore({ width: 800, height: 600, dpr: 1, ...options });
const tests = {
  async 'ink is in the picture of the frame after pen-down'() {
    const core = await make({ isFirst: true });
    core.paint(null, 1000);
    assert.ok(!has_ink(core, 400, 300));
    core.samples(packed([{ time: 100, x: 400, y: 300, touching: false }]));
    core.advance(116);
    core.paint();
    core.samples(packed([{ time: 120, x: 400, y: 300, pressure: 0.8 }, { time: 124, x: 404, y: 300, pressure: 0.8 }]));
    core.advance(132);
    core.paint();
    assert.ok(has_ink(core, 402, 300));
  },

  async 'ink is in the next frame, whenever in the frame the pen came down'() {
    for (const isFirst of [true, false]) {
      for (let age = -3; age <= 17; ++age) {  // a frame may have begun before the pen came down
        const core = await make({ isFirst });
        core.paint(null, 1000);
        core.samples(packed([{ time: 100, x: 400, y: 300, touching: false }]));
        core.advance(149);
        core.samples(packed([{ time: 150.3, x: 400, y: 300, pressure: 0.5 }]));
        core.advance(150.3 + age);
        core.paint();
        assert.ok(has_ink(core, 400, 300), `no ink in a frame ${age} ms after pen-down`);
      }
    }
  },

  async 'every sample counts, whatever the frames'() {
    const files = [];
    for (const size of [1, 3, 17]) {
      const core = await make();
      const path = wave(200, 300, 60), samples = [];
      path.forEach(([x, y], i) => samples.push({ time: 100 + i, x, y, pressure: 0.3 + 0.005 * i }));
      samples.push({ time: 170, x: 0, y: 0, touching: false });
      for (let i = 0; i < samples.length; i += size) core.samples(packed(samples.slice(i, i + size)));
      core.advance(300);
      assert.equal(core.state().strokes, 1);
      files.push(text_of(core.save('ndjson')));
    }
    assert.equal(files[0], files[1]);
    assert.equal(files[0], files[2]);
  },

  async 'undo, redo and layers are events'() {
    const core = await make();
    draw(core, wave(200, 200), 100);
    assert.equal(core.state().undo, 'Draw');
    assert.deepEqual(core.event({ event: 'undo' }), { ok: true });
    assert.equal(core.state().strokes, 0);
    core.event('{"event":"redo"}');
    assert.ok(core.event({ event: 'layer', do: 'add', name: 'Ideas' }).ok);
    assert.deepEqual(core.state().layers.map((layer) => layer.name), ['Ideas', 'Ink']);
    assert.match(core.event({ event: 'tool', id: 'nothing' }).error, /nothing/);
    assert.match(core.event('{"event":').error, /JSON|string|incomplete|cut/i);
  },

  async 'a drawing is saved and opened exactly'() {
    const core = await make();
    draw(core, wave(200, 200), 100, { pressure: 0.4 });
    core.event({ event: 'option', id: 'surface.material', value: 'blackboard' });
    draw(core, wave(200, 400), 1000, { pressure: 0.9 });
    const svg = core.save('svg'), lines = core.save('ndjson');
    const other = await make();
    assert.deepEqual(other.open(svg, 'a.svg'), { ok: true });
    assert.deepEqual(other.save('svg'), svg);
    assert.deepEqual(other.save('ndjson'), lines);
    assert.equal(other.state().surface, 'blackboard');
    assert.equal(other.open('no drawing', 'a.svg').ok, false);
    assert.deepEqual(other.save('svg'), svg);
  },

  async 'the autosave gives the same drawing and goes on'() {
    const core = await make();
    let base = null, records = '';
    const store = () => {
      if (core.rebased()) [base, records] = [core.base(), ''];
      records += core.recorded();
    };
    let now = draw(core, wave(200, 200), 100);
    store();
    now = draw(core, wave(200, 300), now + 100);
    core.event({ event: 'tool', id: 'pull' });
    now = draw(core, [...Array(40)].map((_, i) => [300, 200 + i]), now + 100);
    store();
    const other = await make();
    assert.deepEqual(other.restore(base, records), { ok: true });
    assert.equal(text_of(other.save('svg')), text_of(core.save('svg')));
    assert.equal(other.state().tool, 'pull');
    assert.equal(other.state().undo, core.state().undo);
    assert.equal(other.rebased(), false);
    draw(other, wave(200, 500), 50);
    records += other.recorded();
    const third = await make();
    assert.deepEqual(third.restore(base, records), { ok: true });
    assert.equal(text_of(third.save('svg')), text_of(other.save('svg')));
  },

  async 'a step that is older than the base is undone in the autosave, too'() {
    const core = await make();
    let base = null, records = '';
    const store = () => {
      if (core.rebased()) [base, records] = [core.base(), ''];
      records += core.recorded();
    };
    let now = draw(core, wave(200, 200), 100);
    now = draw(core, wave(200, 300), now + 100);
    core.rebase();
    store();
    assert.ok(base);
    core.event({ event: 'undo' });
    now = draw(core, wave(200, 400), now + 100);
    store();
    const other = await make();
    assert.deepEqual(other.restore(base, records), { ok: true });
    assert.equal(text_of(other.save('ndjson')), text_of(core.save('ndjson')));
  },

  async 'the full module continues the drawing of the first'() {
    const core = await make({ isFirst: true }), whole = await make();
    const options_of = (one) => one.catalog().tools.flatMap((tool) => tool.options.map(({ id }) => [id, one.option(id)]));
    let records = '', now = 100;
    const both = (act) => [core, whole].map(act);
    assert.equal(core.rebased(), true);
    for (const y of [150, 250, 350]) {
      both((one) => draw(one, wave(200, y), now));
      now += 1000;
    }
    both((one) => one.event({ event: 'undo' }));
    records += core.recorded();
    both((one) => draw(one, wave(200, 400), now));
    const state = core.state(), view = core.view();
    assert.equal(state.strokes, 3);
    assert.deepEqual(state, whole.state());
    assert.deepEqual(core.pixels().data, whole.pixels().data);
    assert.deepEqual(await core.complete(), { ok: true });
    assert.deepEqual(core.state(), state);
    assert.deepEqual(options_of(core), options_of(whole));
    assert.deepEqual(core.save('ndjson'), whole.save('ndjson'));
    assert.deepEqual(core.view(), view);
    assert.equal(core.rebased(), false);
    core.event({ event: 'tool', id: 'pull' });
    draw(core, [...Array(40)].map((_, i) => [300, 150 + i]), now += 1000);
    records += core.recorded();
    core.event({ event: 'undo' });
    records += core.recorded();
    const other = await make();
    assert.deepEqual(other.restore(core.base(), records), { ok: true });
    assert.equal(text_of(other.save('ndjson')), text_of(core.save('ndjson')));
  },

  async 'the records of the first module alone give the drawing and the options of a new one'() {
    const core = await make({ isFirst: true }), whole = await make();
    draw(core, wave(200, 200), 100);
    core.rebase();
    assert.equal(core.rebased(), true);
    const records = core.recorded();
    const other = await make();
    assert.deepEqual(other.restore(core.base(), records), { ok: true });
    for (const { id } of whole.catalog().tools.flatMap(({ options }) => options)) assert.deepEqual(other.option(id), whole.option(id), id);
    // The options that the full module has added are stored, too.
    other.event({ event: 'option', id: 'pull.radius_mm', value: 9 });
    const third = await make();
    assert.deepEqual(third.restore(core.base(), records + other.recorded()), { ok: true });
    for (const { id } of whole.catalog().tools.flatMap(({ options }) => options)) assert.deepEqual(third.option(id), other.option(id), id);
    assert.equal(text_of(third.save('ndjson')), text_of(other.save('ndjson')));
  },

  async 'the hand plays the cat'() {
    const core = await make();
    assert.deepEqual(core.play(core.scripts()[0].text, { speed: 8 }), { ok: true });
    let now = 0, largest = 0;
    while (core.playing() && now < 120000) {
      core.advance(now += 16);
      core.paint();
      const forces = core.forces();
      for (let i = 0; i < forces.length; i += 7) largest = Math.max(largest, Math.hypot(forces[i + 4], forces[i + 5], forces[i + 6]));
    }
    assert.equal(core.playing(), null);
    assert.equal(core.playError(), '');
    assert.ok(core.state().strokes >= 8, `${core.state().strokes} strokes`);
    assert.ok(largest > 0.1 && largest <= 3.01, `${largest} N`);
    assert.equal(core.state().device, 'tablet');
  },

  async 'a touch ends the play'() {
    const core = await make();
    core.play(core.scripts()[0].text);
    for (let now = 16; now < 3000; now += 16) core.advance(now);
    assert.ok(core.playing());
    draw(core, wave(200, 200), 3000);
    assert.equal(core.playing(), null);
  },

  async 'forces are shown, and felt by a simulated pen'() {
    const core = await make();
    core.warmUp();
    assert.deepEqual(core.setDevice('simulated:touch'), { ok: true });
    draw(core, wave(200, 200), 100);
    const forces = core.forces();
    assert.ok(forces.length >= 7 * 300);
    assert.ok(forces.filter((_, i) => i % 7 >= 4).some((newton) => Math.abs(newton) > 0.1));
    assert.equal(core.setDevice('simulated:nothing').ok, false);
  },

  async 'rubbing sounds'() {
    const core = await make();
    core.sound(128);
    core.event({ event: 'option', id: 'surface.material', value: 'blackboard' });
    core.setMedium('chalk');
    let loud = 0;
    for (let i = 0; i < 120; ++i) {
      core.samples(packed([...Array(4)].map((_, k) => ({ time: 100 + 16 * i + 4 * k, x: 100 + 4 * i + k, y: 200, pressure: 0.8 }))));
      core.advance(116 + 16 * i);
      loud = Math.max(loud, ...core.sound(768).map(Math.abs), 0);
    }
    assert.ok(loud > 0.001 && loud < 1, `${loud}`);
  },

  async 'a moved picture is the picture of the other view'() {
    const core = await make();
    draw(core, wave(200, 200), 100);
    const view = core.view();
    core.setView({ x: view.x + 10 / view.scale, y: view.y - 7 / view.scale });
    core.paint(null, 1000);
    const moved = core.pixels().data.slice();
    core.setView({ angle: 30 });
    core.paint(null, 1000);
    core.setView({ angle: 0 });
    while (core.paint(null, 1000));
    const again = core.pixels().data;
    let largest = 0;
    moved.forEach((value, i) => (largest = Math.max(largest, Math.abs(value - again[i]))));
    assert.ok(largest <= 2, `${largest}`);
    const [x, y] = core.toCanvas(...core.toPage(123, 45));
    assert.ok(Math.hypot(x - 123, y - 45) < 1e-9);
  },

  async 'random events'() {
    const core = await make({ width: 400, height: 300 });
    core.warmUp();
    const random = random_of(7), { tools, media, surfaces } = core.catalog();
    const any = (list) => list[Math.floor(random() * list.length)];
    let now = 0, x = 200, y = 150, touching = false;
    for (let i = 0; i < 3000; ++i) {
      now += random() * 40;
      const what = random();
      if (what < 0.8) {
        x += 40 * (random() - 0.5);
        y += 40 * (random() - 0.5);
        if (random() < 0.1) touching = !touching;
        core.samples(packed([{ time: now, x, y, touching, pressure: random(), keys: Math.floor(random() * 4) }]));
      } else if (what < 0.84) {
        core.event({ event: 'tool', id: any(tools).id });
      } else if (what < 0.88) {
        const option = any(any(tools).options);
        const value = option.kind === 'number' ? option.min + random() * (option.max - option.min)
          : option.kind === 'switch' ? random() < 0.5 : any(option.open === 'media' ? media.map((m) => m.id)
            : option.open === 'surfaces' ? surfaces.map((s) => s.id) : option.choices);
        core.event({ event: 'option', id: option.id, value });
      } else if (what < 0.96) {
        core.event({ event: any(['undo', 'redo', 'cancel', 'delete', 'duplicate', 'as-drawn']) });
      } else {
        core.event({ event: 'layer', do: any(['add', 'hide', 'show', 'lock', 'unlock', 'remove', 'raise']), id: Math.ceil(random() * 3), name: 'L' });
      }
      core.advance(now);
      if (i % 4 === 0) core.paint(null, 2);
      if (i % 16 === 0) core.marks(), core.pen(), core.state();
    }
    core.finish();
    assert.ok(core.save('svg').length > 100);
  },

  async 'weight'() {
    const { gzipSync } = await import('node:zlib');
    const size = gzipSync(readFileSync(`${dist}/core.js`), { level: 9 }).length;
    console.log(`core.js: ${size} bytes with gzip`);
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  const begin = performance.now();
  try {
    await test();
    console.log(`ok   ${name} (${Math.round(performance.now() - begin)} ms)`);
  } catch (error) {
    ++failed;
    console.log(`FAIL ${name}\n${error.stack}`);
  }
}
process.exitCode = failed ? 1 : 0;
