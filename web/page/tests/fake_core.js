// A core without WebAssembly, for tests of the user interface alone: remembers samples and events, and draws dots.
globalThis.feltlineCore = {
  async createCore(options) {
    const state = {
      tool: 'pencil', use: { hint: 'Draw.', shift: '', ctrl: '' }, size: { mm: 0.7, min: 0.1, max: 20 }, options: {},
      surface: 'paper', medium: 'pencil', ink: '#23262d', paper: '#ffffff', page: options.page, undo: null, redo: null, strokes: 0, selected: 0,
      layers: [{ id: 1, name: 'Ink', visible: true, locked: false, opacity: 1, blend: 'normal', group: 0, strokes: 0, current: true }], groups: [],
      offers: [], canShowAsDrawn: false, exact: false, device: 'tablet', forces: true, strength: 1, gesture: false,
    };
    const names = ['pencil', 'pull', 'smooth', 'width', 'eraser', 'lasso', 'transform', 'connect'];
    const tools = names.map((id) => ({ id, label: id[0].toUpperCase() + id.slice(1), help: '', shortcut: id[0],
      kind: { pencil: 'draws', eraser: 'erases' }[id] ?? 'edits', options: [], icon: '' }));
    tools[0].options.push({ id: 'pencil.snap', label: 'Snap', unit: '', kind: 'choice', choices: ['off', 'both'], open: '',
      min: 0, max: 0, fallback: 'both', help: '', when: null, isSeldom: false },
    { id: 'pencil.gamma', label: 'Gamma', unit: 'mm', kind: 'number', choices: [], open: '', min: 0.2, max: 3, fallback: 1,
      help: '', when: null, isSeldom: false });
    const changed = new Set(['ink', 'marks', 'state']), samples = [], events = [], fresh = [];
    const view = { x: 0, y: 0, scale: 3.78, angle: 0, mirrored: false };
    const calls = { samples, events,
      fakeSamples: samples,
      samplesOf: (array) => { for (let i = 0; i < array.length; i += 8) samples.push([...array.slice(i, i + 8)]); } };
    const handler = {
      samples(array) { calls.samplesOf(array); fresh.push(array); state.strokes = 1; changed.add('ink').add('state').add('edits'); },
      event(event) { events.push(event); if (event.event === 'tool') state.tool = event.id; changed.add('state'); return { ok: true }; },
      changed: (what) => changed.delete(what), ticks: () => 0, view: () => view, setView: (v) => { Object.assign(view, v); },
      toPage: (x, y) => [view.x + x / view.scale, view.y + y / view.scale],
      toCanvas: (x, y) => [(x - view.x) * view.scale, (y - view.y) * view.scale],
      paint(context) {
        if (!this.white) { context.fillStyle = '#fff'; context.fillRect(0, 0, 5000, 5000); this.white = true; }
        context.fillStyle = '#23262d';
        for (const a of fresh.splice(0)) for (let i = 0; i < a.length; i += 8) if (a[i + 3]) context.fillRect(a[i + 1], a[i + 2], 2, 2);
        return false;
      },
      marks: () => [], pen: () => ({ known: false }), forces: () => new Float64Array(0), forceTerms: () => [],
      sound: () => new Float32Array(0), devices: () => [{ id: 'tablet', hasForce: false }, { id: 'sim', hasForce: true }],
      catalog: () => ({ version: '0', tools, surfaces: [{ id: 'paper', label: 'Paper' }], media: [{ id: 'pencil', label: 'Pencil' }],
        formats: [{ id: 'svg', extension: '.svg', saves: true, opens: true }, { id: 'ndjson', extension: '.ndjson', saves: true, opens: true }] }),
      state: () => state, option: () => 'pencil', playing: () => null, playError: () => '', setMedium: () => ({ ok: true }), rebased: () => false, recorded: () => '', base: () => null, scripts: () => [{ id: 'cat', text: '' }], play: () => ({ ok: true }),
      isComplete: true, complete: async () => ({ ok: true }), restore: () => ({ ok: true }), setSize: () => ({ ok: true }), setDevice: () => ({ ok: true }),
    };
    return new Proxy(handler, { get: (target, name) => target[name] ?? calls[name] ?? (name === 'then' ? undefined : () => undefined) });
  },
};
