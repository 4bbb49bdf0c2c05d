// Cut, copy and paste, within the page and with other programs: a copy is an SVG file and a picture.
import { make } from './dom.js';
import { t, d, loss } from './words.js';
import { kMaxBytes } from './files.js';

const kBesideMm = 5;  // each paste of the same lines is moved by this from the former one
const kSvg = 'image/svg+xml', kText = 'text/plain', kPng = 'image/png';
const words = (text) => d('ClipboardActions', text);

/** Returns true if a text is a drawing: SVG, InkML, a journal, or lines of JSON. */
const is_drawing = (text) => /^\s*((?=<)[^]{0,4000}?<(\w+:)?(svg|ink|xournal)(?=[\s/>])|\{\s*")/.test(text);

/** Some systems change the ends of lines. */
const same_text = (a, b) => a.replaceAll('\r', '') === b.replaceAll('\r', '');

/** Returns true if the browser itself cuts, copies and pastes here. */
const is_text = ({ target }) => Boolean(target.closest?.('input:not([type=range], [type=checkbox], [type=color]), textarea') ||
  document.querySelector('dialog[open]'));

function png_of({ data, width, height }) {
  const canvas = make('canvas', { width, height });
  canvas.getContext('2d').putImageData(new ImageData(data, width, height), 0, 0);
  return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), kPng));
}

export class Clipboard {
  constructor(page) {
    this.page = page;
    this.pastes = 0;  // of `copied`, the lines that were copied here
    for (const type of ['copy', 'cut']) {
      addEventListener(type, (event) => {
        if (is_text(event) || String(getSelection()) !== '') return;  // such as a marked message
        this.copy(type === 'cut', event);
      });
    }
    addEventListener('paste', (event) => {
      if (is_text(event)) return;
      event.preventDefault();
      const { clipboardData: data } = event;
      this.paste_data({ svg: data?.getData(kSvg) ?? '', text: data?.getData(kText) ?? '', files: [...data?.files ?? []],
        has_html: data?.types.includes('text/html') ?? false });
    });
  }

  /** Copies the selected lines, or all if none is selected. `cuts`: removes them, which only whole lines can be. `event`: that of
   * the browser's own command, if it is one. */
  copy(cuts, event = null) {
    const { page } = this;
    if (!page.core?.isComplete || page.is_waiting) return page.when_complete(() => this.copy(cuts));
    page.settle();
    page.guard((core) => core.finish());
    if (cuts && page.core?.state().selected === 0) return page.say(t('Nothing is selected. Draw around lines with the lasso first.'));
    const made = page.guard((core) => core.copied({ whole: cuts }));
    if (!made) return page.say(cuts ? words('Only whole strokes can be cut. Select a whole stroke first.') : t('There is nothing to copy.'));
    this.copied = made.svg;
    this.pastes = cuts ? -1 : 0;  // after a cut, the first paste is in the old place
    if (event) {
      for (const type of [kText, kSvg]) event.clipboardData?.setData(type, made.svg);
      event.preventDefault();  // only now, because it empties the clipboard if there is nothing to copy
      if (cuts) page.apply({ event: 'delete' });
    }
    return this.write(made).then(() => { if (cuts && !event) this.remove(made); }).catch((error) => {
      console.info('Feltline: clipboard:', error);
      if (!event) page.say(t('The browser does not let the page copy. Press %1.', page.key_name(cuts ? 'Ctrl+X' : 'Ctrl+C')));
    });
  }

  /** Removes what was copied, unless something else is selected meanwhile. */
  remove({ svg }) {
    const { page } = this;
    page.settle();
    const now = page.guard((core) => (core.state().selected > 0 ? core.copied({ whole: true, dpi: 10 }) : null));
    if (now?.svg === svg) page.apply({ event: 'delete' });
  }

  /** Writes for other programs, which the browser's own command does not. */
  async write({ svg, picture }) {
    const content = { [kText]: new Blob([svg], { type: kText }) };
    if (ClipboardItem.supports?.(kSvg)) content[kSvg] = new Blob([svg], { type: kSvg });
    if (picture) content[kPng] = png_of(picture);
    await navigator.clipboard.write([new ClipboardItem(content)]);
  }

  /** Pastes what a browser gives only if the user allows it: for the menu. */
  async paste() {
    const content = await this.read();
    if (content) return this.paste_data(content, false);
    return this.page.say(t('The browser does not let the page paste. Press %1.', this.page.key_name('Ctrl+V')));
  }

  /** Returns true if the browser reads the clipboard without asking the user. */
  async may_read() {
    const permission = await navigator.permissions?.query({ name: 'clipboard-read' }).catch(() => null);
    return permission?.state === 'granted';
  }

  /** Returns what is on the clipboard, or null if the browser does not say it. */
  async read() {
    try {
      const [item] = await navigator.clipboard.read(), content = { svg: '', text: '', files: [], has_html: false };
      for (const type of item?.types ?? []) {
        if (type === kSvg) content.svg = await (await item.getType(type)).text();
        if (type === kText) content.text = await (await item.getType(type)).text();
        if (type === kPng) content.files.push(new File([await item.getType(type)], 'clipboard.png', { type }));
      }
      return content;
    } catch {
      return null;
    }
  }

  /** Adds a drawing or, if there is none, pictures. The text comes before the SVG file, which browsers write anew. A browser's own
   * command may hide an SVG file behind its picture; then the browser is asked for it, if `may_ask` and the user has already
   * permitted it. A picture with a text in HTML was copied from a web page and has none. */
  async paste_data(content, may_ask = true) {
    const { page } = this, { svg, text, files, has_html } = content;
    const drawing = is_drawing(text) ? text : svg;
    if (drawing) return this.add(drawing);
    if (may_ask && text === '' && !has_html && files.every(({ type }) => type === kPng) && await this.may_read()) {
      const all = await this.read();
      if (all?.svg) return this.add(all.svg);
    }
    if (files.length > 0) return page.files.load_all(files, true);
    return page.say(words('The clipboard holds no strokes.'));
  }

  /** Adds a drawing: lines that were copied here beside their originals, others in the middle of the window. */
  async add(text) {
    const { page } = this, refuse = (error) => page.say(`${words('The clipboard cannot be pasted')}: ${error}`);
    if (text.length > kMaxBytes) return refuse(t('it is too large'));
    const loaded = await page.files.ready(), is_own = same_text(text, this.copied ?? ''), name = words('the clipboard');
    if (!loaded.ok) return refuse(page.reason(loaded));
    const beside = is_own ? kBesideMm * ++this.pastes : 0;
    page.guard((core) => core.finish());
    const done = page.guard((core) => core.add(text, name, is_own ? { by: [beside, beside] } : { middle: core.toPage(...page.middle()) }));
    if (done && !done.ok) return refuse(done.error.replace(`${name}: `, ''));
    if (done?.notices) page.files.say_all(done.notices.map(loss));
    return page.wake();
  }
}
