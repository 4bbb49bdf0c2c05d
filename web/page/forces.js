// The force on the pen as a plot, the sound of the pen, and cues for hands: a tick of the tool makes a phone, a
// touchpad or a gamepad tick.
import { make, icon_button } from './dom.js';
import { t, d, number } from './words.js';

const kSeconds = 4;
const kRate = 1000;                  // ticks a second
const kPoints = kSeconds * kRate;
const kAsked = '#d55e00';
// The names of the forces, as in the desktop program.
const kTerms = { plane: 'Surface', friction: 'Friction', texture: 'Grain', edit: 'Curve', snap: 'Snap', tether: 'Tether',
  stabiliser: 'Stabiliser', stop: 'Stop', damping: 'Damping', other: 'Other' };

/** The panel with the plot of the last seconds, and the largest share of each force. */
export class ForcePanel {
  constructor(page) {
    this.page = page;
    this.asked = new Float32Array(kPoints);
    this.sent = new Float32Array(kPoints);
    this.at = 0;
    this.newest = 0;
    this.legend_time = 0;
    this.canvas = make('canvas', { role: 'img' });
    this.legend = make('ul');
    this.moves = make('input', { type: 'checkbox', id: 'moves',
      onchange: () => page.set_moves(this.moves.checked) });
    this.strength = make('input', { type: 'range', id: 'strength', min: 0, max: 1, step: 0.05,
      oninput: () => page.set_strength(Number(this.strength.value)) });
    this.element = make('section', { id: 'forces', className: 'card', hidden: true });
  }

  show_words() {
    this.canvas.setAttribute('aria-label', t('Forces'));
    this.element.setAttribute('aria-label', t('Forces'));
    this.element.replaceChildren(
      make('header', {}, make('h2', {}, t('Forces')), icon_button('close', t('Close'), () => this.page.toggle('forces'))),
      this.canvas, this.legend,
      make('div', { className: 'row' }, make('label', { htmlFor: 'moves' }, t('Pen moves with forces')), this.moves),
      make('div', { className: 'row' }, make('label', { htmlFor: 'strength' }, d('FeelPanel', 'Strength')), this.strength),
      make('p', { className: 'quiet' }, t('The plot shows what a force-feedback pen would let you feel.')));
  }

  /** Shows the state of the core. */
  show(state) {
    if (this.element.hidden) return;
    this.strength.value = state.strength;
    if (state.device === this.device) return;
    this.device = state.device;
    this.moves.checked = this.page.core.devices().some(({ id, hasForce }) => id === state.device && hasForce);
  }

  /** Adds ticks: Core.forces(). Returns true if one of them has a force. */
  add(ticks) {
    let moves = false;
    for (let i = 0; i + 6 < ticks.length; i += 7) {
      this.asked[this.at] = Math.hypot(ticks[i + 1], ticks[i + 2], ticks[i + 3]);
      this.sent[this.at] = Math.hypot(ticks[i + 4], ticks[i + 5], ticks[i + 6]);
      moves ||= this.asked[this.at] > 0;
      this.at = (this.at + 1) % kPoints;
    }
    return moves;
  }

  draw(terms, now) {
    if (this.element.hidden) return;
    const ratio = devicePixelRatio, { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width) return;
    if (this.canvas.width !== Math.round(width * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const context = this.canvas.getContext('2d'), style = getComputedStyle(this.element);
    const text = style.getPropertyValue('--text'), edge = style.getPropertyValue('--edge');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const top = this.scale();
    const y_of = (newtons) => height - 4 - (newtons / top) * (height - 20);
    context.font = '11px system-ui, sans-serif';
    context.fillStyle = style.getPropertyValue('--dim');
    context.strokeStyle = edge;
    context.lineWidth = 1;
    for (const newtons of [0, top / 2, top]) {
      context.beginPath();
      context.moveTo(0, y_of(newtons));
      context.lineTo(width, y_of(newtons));
      context.stroke();
      if (newtons) context.fillText(`${number(newtons, 2)} N`, 0, y_of(newtons) - 3);
    }
    this.curve(context, this.asked, width, y_of, kAsked, 1);
    this.curve(context, this.sent, width, y_of, text, 1.5);
    if (now - this.legend_time > 200) this.show_terms(terms, now);
  }

  scale() {
    let most = 0.4;
    for (let i = 0; i < kPoints; ++i) most = Math.max(most, this.asked[i], this.sent[i]);
    return Math.ceil(most * 5) / 5;
  }

  /** Draws the largest value of each pixel, so that short peaks stay visible. */
  curve(context, values, width, y_of, color, line_width) {
    context.beginPath();
    for (let x = 0; x < width; ++x) {
      const from = Math.floor((x * kPoints) / width), to = Math.floor(((x + 1) * kPoints) / width);
      let most = 0;
      for (let i = from; i < to; ++i) most = Math.max(most, values[(this.at + i) % kPoints]);
      context.lineTo(x, y_of(most));
    }
    context.strokeStyle = color;
    context.lineWidth = line_width;
    context.stroke();
  }

  show_terms(terms, now) {
    this.legend_time = now;
    const newest = (this.at + kPoints - 1) % kPoints;
    const rows = [[d('SafetyWords', 'Sum, requested'), kAsked, this.asked[newest]]];
    // A pointer without forces gets none.
    if (this.sent.some((newtons) => newtons > 0)) rows.push([d('SafetyWords', 'Sent to the pen'), 'var(--text)', this.sent[newest]]);
    const label = `${rows[0][0]}: ${number(rows[0][2], 2)} N`;
    this.canvas.setAttribute('aria-label', `${t('Forces')}: ${label}`);
    for (const term of terms.slice(0, 5)) {
      rows.push([kTerms[term.name] ? d('SafetyWords', kTerms[term.name]) : term.name, 'transparent', Math.hypot(term.x, term.y, term.z)]);
    }
    this.legend.replaceChildren(...rows.map(([name, color, newtons]) => {
      const mark = make('i', { 'aria-hidden': 'true' });
      mark.style.background = color;
      return make('li', {}, mark, make('span', {}, name), make('span', { className: 'value' }, `${number(newtons, 2)} N`));
    }));
  }
}

// The worklet asks for more when less than kAhead samples are left. A queue keeps the sound free of gaps when a frame
// is late.
const kBlock = 1024, kAhead = 3072;
const kWorklet = `registerProcessor('feltline', class extends AudioWorkletProcessor {
  constructor() {
    super();
    this.queue = []; this.at = 0; this.left = 0; this.blocks = 0;
    this.port.onmessage = ({ data }) => { this.queue.push(data); this.left += data.length; };
  }
  process(_, [[out]]) {
    for (let i = 0; i < out.length; ++i) {
      if (!this.queue.length) { out[i] = 0; continue; }
      out[i] = this.queue[0][this.at++]; --this.left;
      if (this.at === this.queue[0].length) { this.queue.shift(); this.at = 0; }
    }
    if (++this.blocks % 4 === 0) this.port.postMessage(this.left);
    return true;
  }
});`;

/** The rubbing of the pen, through an AudioWorklet. A browser allows it only after a gesture of the user. */
export class Sound {
  constructor(core) {
    this.core = core;  // a function, because a core may be replaced
    this.is_on = false;
  }

  async set(on) {
    if (!on) {
      this.is_on = false;
      return void this.context?.suspend();
    }
    this.started ??= this.start();
    try {
      await this.started;
    } catch (error) {
      this.started = null;  // the next call tries again
      throw error;
    }
    await this.context.resume();
    this.is_on = true;
    this.feed();
  }

  async start() {
    let context;
    try {
      context = new AudioContext({ sampleRate: 48000, latencyHint: 'interactive' });
      // At file://, a worklet can be loaded only from a blob.
      const url = URL.createObjectURL(new Blob([kWorklet], { type: 'text/javascript' }));
      await context.audioWorklet.addModule(url);
      URL.revokeObjectURL(url);
      this.node = new AudioWorkletNode(context, 'feltline', { numberOfInputs: 0, outputChannelCount: [1] });
    } catch (error) {
      context?.close();
      throw error;
    }
    this.context = context;
    this.node.connect(context.destination);
    this.node.port.onmessage = ({ data: left }) => { this.left = left; };
  }

  /** Sends the sound of the time that has passed. Call it every frame. */
  feed() {
    if (!this.is_on || !this.node) return;
    for (let left = this.left ?? 0; left < kAhead; left += kBlock) {
      const samples = this.core().sound(kBlock);
      if (!samples.length) return;
      this.node.port.postMessage(samples.slice());
      this.left = left + kBlock;
    }
  }
}

/** Lets a touchpad, a phone or a gamepad tick, where the browser can. */
export function play_cue() {
  try {
    if (navigator.playHaptics) navigator.playHaptics('tick');
    else navigator.vibrate?.(8);
    for (const pad of navigator.getGamepads?.() ?? []) {
      pad?.vibrationActuator?.playEffect?.('dual-rumble', { duration: 20, strongMagnitude: 0.2, weakMagnitude: 0.6 });
    }
  } catch { /* no cue */ }
}
