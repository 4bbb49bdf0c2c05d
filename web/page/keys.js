// The keys of the desktop program, as far as a browser leaves them to a page.
import { make } from './dom.js';
import { t, d } from './words.js';

const kHoldMs = 300;  // a tool's key that is held longer, or while something was drawn, only borrows the tool
const kStepPx = 4, kFineStepPx = 1, kStepsPerFactor = 8, kMaxFactor = 8;  // as in the desktop's keyboard pen
const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const is_mac = /Mac|iPad|iPhone/.test(navigator.platform);

/** Returns the name of a key combination for people: "Strg+Z", "⌘Z". */
export function key_name(keys) {
  if (is_mac) return keys.replace('Ctrl+', '⌘').replace('Shift+', '⇧').replace('Alt+', '⌥');
  return document.documentElement.lang === 'de' ? keys.replace('Ctrl', 'Strg').replace('Shift', 'Umschalt') : keys;
}

export class Keys {
  constructor(page, input) {
    Object.assign(this, { page, input, held: null, key: '', repeats: 0, pen: null, keeps_alt: false });
    addEventListener('keydown', (event) => this.down(event));
    addEventListener('keyup', (event) => this.up(event));
    addEventListener('pointerdown', () => document.body.classList.remove('keys'), true);
    addEventListener('blur', () => {
      input.release_all();
      this.give_back();
    });
  }

  /** [keys, context and text of the desktop program, what it does] */
  commands() {
    const { page } = this, event = (what) => () => page.apply(what);
    return this.list ??= [
      ['Ctrl+Z', 'EditActions', 'Undo', event({ event: 'undo' })],
      ['Ctrl+Shift+Z', 'EditActions', 'Redo', event({ event: 'redo' })],
      ['Ctrl+Y', '', '', event({ event: 'redo' })],
      // The browser itself handles these: clipboard.js.
      ...[['X', 'Cut'], ['C', 'Copy'], ['V', 'Paste']].map(([key, text]) => [`Ctrl+${key}`, 'ClipboardActions', text, null]),
      ['Ctrl+A', 'EditActions', 'Select all', event({ event: 'select', what: 'all' })],
      ['Ctrl+Shift+A', 'EditActions', 'Select none', event({ event: 'select', what: 'none' })],
      ['Delete', 'EditActions', 'Delete', event({ event: 'delete' })],
      ['Backspace', '', '', event({ event: 'delete' })],
      ['Ctrl+D', 'EditActions', 'Duplicate', event({ event: 'duplicate' })],
      ['Home', 'EditActions', 'Bring to front', event({ event: 'order', to: 'front' })],
      ['End', 'EditActions', 'Send to back', event({ event: 'order', to: 'back' })],
      ['Ctrl+R', 'EditActions', 'Line as drawn', event({ event: 'as-drawn' })],
      ['Escape', 'EditActions', 'Cancel or clear selection', () => page.escape()],
      ['Ctrl+O', '', t('Open…'), () => page.files.choose(false)],
      ['Ctrl+S', '', t(page.has_felt ? 'Save as Feltline drawing' : 'Save as SVG'), () => page.files.save(page.has_felt ? 'felt' : 'svg')],
      ['Ctrl+Shift+E', '', t('Export as PNG'), () => page.files.export_png()],
      ['Ctrl+E', 'EditActions', 'Make exact', event({ event: 'exact' })],
      ['F2', '', t('Rename the layer'), () => page.rename_layer()],
      ['+', 'ViewActions', 'Zoom in', () => page.zoom_middle(1.25)],
      ['=', '', '', () => page.zoom_middle(1.25)],
      ['-', 'ViewActions', 'Zoom out', () => page.zoom_middle(0.8)],
      ['1', 'ViewActions', 'Life size', () => page.life_size()],
      ['3', 'ViewActions', 'Fit page', () => page.fit()],
      ['0', '', '', () => page.fit()],
      ['M', 'ViewActions', 'Mirror view', () => page.mirror()],
      ['4', 'ViewActions', 'Turn left', () => page.turn(-15)],
      ['6', 'ViewActions', 'Turn right', () => page.turn(15)],
      ['5', 'ViewActions', 'Upright', () => page.turn(null)],
      ['[', 'ToolActions', 'Smaller', () => page.scale_size(1 / 1.25)],
      [']', 'ToolActions', 'Larger', () => page.scale_size(1.25)],
      ['X', 'ToolKeys', 'Eraser while held', null],
      ['?', '', t('Keyboard shortcuts'), () => page.show_keys()],
    ];
  }

  forget_words() {
    this.list = null;
  }

  down(event) {
    if (!this.page.core) return;
    if (event.target.matches?.('input:not([type=range], [type=checkbox], [type=color]), textarea') || document.querySelector('dialog[open]')) return;
    if (event.key === 'Tab' || event.key in kArrows) document.body.classList.add('keys');
    this.input.set_modifiers(event);
    if (event.key === 'Alt') this.keep_alt(event);
    // AltGr writes brackets on many keyboards.
    const alt_graph = event.getModifierState?.('AltGraph') ?? false;
    if (event.isComposing || (event.altKey && !alt_graph)) return;
    const on_sheet = event.target === this.input.sheet || event.target === document.body;
    if (on_sheet && this.sheet_key(event)) return event.preventDefault();
    // Keys that a control handles itself: a list chooses by letters, a slider moves with arrows.
    const plain = alt_graph || (!event.ctrlKey && !event.metaKey);
    if (event.target.matches?.('select, input') && plain) return;
    if (plain && !event.shiftKey && this.tool_key(event)) return event.preventDefault();
    const keys = alt_graph ? event.key : this.name_of(event);
    const command = this.commands().find(([name]) => name === keys);
    if (!command?.[3]) return;
    event.preventDefault();
    command[3]();
  }

  /** Keeps Alt from the browser, whose menu would take the focus, if it was down while something was drawn. */
  keep_alt(event) {
    this.keeps_alt ||= this.page.draws;
    if (this.keeps_alt) event.preventDefault();
  }

  name_of(event) {
    const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
    const is_letter = event.key.length > 1 || key !== event.key.toLowerCase();
    return (event.ctrlKey || event.metaKey ? 'Ctrl+' : '') + (event.shiftKey && is_letter ? 'Shift+' : '') + key;
  }

  up(event) {
    this.input.set_modifiers(event);
    if (event.key === 'Alt') {
      this.keep_alt(event);
      this.keeps_alt = false;
    }
    if (event.code === 'Space') this.set_space(false);
    if (event.key === this.key) [this.key, this.repeats] = ['', 0];
    if (this.held && event.code === this.held.code) this.give_back();
  }

  // --- Tools

  tool_key(event) {
    const key = event.key.toLowerCase(), { page } = this;
    const tool = key === 'x' ? page.tool_of_kind('erases') : page.catalog?.tools.find((one) => one.shortcut === key)?.id;
    if (!tool) return false;
    if (event.repeat || this.held) return true;
    const state = page.core.state();
    this.held = { code: event.code, tool: state.tool, since: performance.now(), gestures: page.gestures, always: key === 'x' };
    page.use_tool(tool);
    return true;
  }

  /** The release of a tool's key: if it was held to use the tool meanwhile, the former tool is active again. */
  give_back() {
    const { held, page } = this;
    this.held = null;
    if (!page.core || !held || held.tool === page.core.state().tool) return;
    if (held.always || (performance.now() - held.since > kHoldMs && page.gestures !== held.gestures)) page.use_tool(held.tool);
  }

  // --- The sheet

  set_space(on) {
    this.input.space = on;
    this.input.sheet.classList.toggle('pans', on);
  }

  sheet_key(event) {
    const { page } = this;
    if (event.code === 'Space' && !event.ctrlKey) {
      this.set_space(true);
      return true;
    }
    const arrow = kArrows[event.key];
    if (arrow && !event.metaKey) {
      if (page.core?.state().selected > 0) page.nudge(arrow, event);
      else this.step(arrow, event);
      return true;
    }
    if ((event.key === 'Enter' || event.key === 'Insert') && !event.ctrlKey) {
      if (!event.repeat) this.touch(!this.pen?.down);
      return true;
    }
    return false;
  }

  place() {
    const { sheet } = this.input;
    this.pen ??= { x: sheet.clientWidth / 2, y: sheet.clientHeight / 2, down: false };
    return this.pen;
  }

  step([dx, dy], event) {
    const pen = this.place();
    this.repeats = event.key === this.key ? this.repeats + 1 : 0;
    this.key = event.key;
    const px = event.shiftKey ? kFineStepPx : kStepPx * Math.min(1 + Math.floor(this.repeats / kStepsPerFactor), kMaxFactor);
    const { clientWidth, clientHeight } = this.input.sheet;
    pen.x = Math.min(Math.max(pen.x + px * dx, 0), clientWidth);
    pen.y = Math.min(Math.max(pen.y + px * dy, 0), clientHeight);
    this.send(event.timeStamp);
  }

  touch(down) {
    if (this.input.drawing !== null) return;
    this.page.begins();
    this.place().down = down;
    this.input.keys_draw = down;
    this.send(performance.now());
    this.page.tell(t(down ? 'The pen is down' : 'The pen is up'));
  }

  send(time) {
    const { x, y, down } = this.pen;
    // Shift makes fine steps, so it is no modifier here.
    this.page.samples(Float64Array.of(time, x, y, down ? 1 : 0, NaN, NaN, NaN, 0));
  }

  /** Lifts the pen that the keys have put down. */
  lift() {
    if (this.pen?.down) this.touch(false);
  }

  /** A pointer moves the pen from now on. */
  lead_by_pointer(x, y) {
    this.lift();
    this.pen = { x, y, down: false };
  }
}

/** The table of the keys, for the dialog. */
export function key_table(keys, page) {
  const row = (name, text) => make('div', {}, make('dt', {}, make('kbd', {}, key_name(name))), make('dd', {}, text));
  const tools = (page.catalog?.tools ?? []).filter((tool) => tool.shortcut)
    .map((tool) => row(tool.shortcut.toUpperCase(), d('tools', tool.label)));
  const commands = keys.commands().filter(([, , text]) => text)
    .map(([name, context, text]) => row(name, context ? d(context, text) : text));
  return make('dl', {}, ...tools, ...commands, row(t('arrow keys'), t('Move the pen')), row('Enter', t('Pen down, pen up')),
    row(t('Space and drag'), t('Pan')));
}
