// Opening, saving and exporting the drawing.
import { make } from './dom.js';
import { t, loss } from './words.js';

const kExportDpi = 192, kMaxPixels = 40e6;
export const kMaxBytes = 1 << 28;  // of a file, also when it is unpacked
export const kPictures = ['image/png', 'image/jpeg', 'image/webp'];
const kMaxPictureBytes = 48e6;  // packed as base64, this is the longest value of an event
const kMaxNotices = 3;          // that are shown in full; the others are counted
const kMaxPictureSide = 8192, kPictureShare = 0.8;  // docs/formats/events.md; of the page

export function download(data, name, type) {
  const url = URL.createObjectURL(data instanceof Blob ? data : new Blob([data], { type }));
  const link = make('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

const kTypes = { svg: 'image/svg+xml', ndjson: 'application/x-ndjson', felt: 'application/x-felt' };

function base64_of(buffer) {
  let text = '';
  const bytes = new Uint8Array(buffer);
  for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(text);
}

/** Returns what packed data contain; `format` is one of DecompressionStream. */
async function inflated(bytes, format) {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format)).getReader(), parts = [];
  for (let size = 0; ;) {
    const { done, value } = await reader.read().catch(() => { throw new Error(t('it is damaged')); });
    if (done) break;
    parts.push(value);
    size += value.length;
    if (size <= kMaxBytes) continue;
    reader.cancel().catch(() => {});
    throw new Error(t('it is too large'));
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** Returns the content of a file in a zip archive, or null. Format: section 4.3 of
 * https://pkware.cachefly.net/webdocs/casestudies/APPNOTE.TXT. */
async function file_in_zip(bytes, name) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const short = (at) => view.getUint16(at, true), long = (at) => view.getUint32(at, true);
  try {
    let end = bytes.length - 22;
    for (const first = Math.max(0, end - 65535); long(end) !== 0x06054b50; --end) {
      if (end === first) throw new RangeError('no end of a directory');
    }
    for (let at = long(end + 16), left = short(end + 10); left > 0; --left) {
      const name_size = short(at + 28), local = long(at + 42);
      if (new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + name_size)) === name) {
        const begin = local + 30 + short(local + 26) + short(local + 28), packed = bytes.subarray(begin, begin + long(at + 20));
        return short(at + 10) === 0 ? packed : await inflated(packed, 'deflate-raw');
      }
      at += 46 + name_size + short(at + 30) + short(at + 32);
    }
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    throw new Error(t('it is damaged'));
  }
  return null;
}

/** Returns the content of gzip data or of a .xopp file that is a zip archive, or the bytes themselves. */
async function unpacked(bytes) {
  if (bytes[0] === 0x1f && bytes[1] === 0x8b) return inflated(bytes, 'gzip');
  if (bytes[0] !== 0x50 || bytes[1] !== 0x4b || bytes[2] !== 3) return bytes;
  const kind = await file_in_zip(bytes, 'mimetype');
  return (kind && new TextDecoder().decode(kind).includes('application/xournal++') && await file_in_zip(bytes, 'content.xml')) || bytes;
}

export class Files {
  constructor(page) {
    this.page = page;
    this.name = '';          // of the file, without its ending
    this.input = document.getElementById('files');
    this.input.addEventListener('change', () => {
      const [file] = this.input.files;
      this.input.value = '';
      if (file) this.load(file, this.adds);
    });
    this.allow_drop();
  }

  /** Lets the user choose a file; `adds`: to add it to the drawing. */
  choose(adds) {
    this.adds = adds;
    this.input.click();
  }

  allow_drop() {
    const carries_files = (event) => [...(event.dataTransfer?.types ?? [])].includes('Files');
    const mark = (on) => document.body.classList.toggle('drop', on);
    addEventListener('dragover', (event) => {
      event.preventDefault();
      mark(carries_files(event));
    });
    addEventListener('dragleave', (event) => { if (!event.relatedTarget) mark(false); });
    addEventListener('drop', (event) => {
      event.preventDefault();
      mark(false);
      const files = [...event.dataTransfer?.files ?? []];
      if (files.length > 0) this.load_all(files, event.shiftKey);
      else this.page.say(t('This is not a file, so it was not added. Save it as a file first, or copy and paste it.'));
    });
  }

  /** Adds a layer with a picture, in the middle of the page. */
  async add_picture(file) {
    if (file.size > kMaxPictureBytes) throw new Error(t('it is too large'));
    const bitmap = await createImageBitmap(file).catch(() => { throw new Error(t('it is damaged')); });
    const { width, height } = bitmap;
    if (Math.max(width, height) > kMaxPictureSide || width * height > kMaxPixels) throw new Error(t('it is too large'));
    let png = file;
    if (file.type !== 'image/png') {
      const canvas = make('canvas', { width, height });
      canvas.getContext('2d').drawImage(bitmap, 0, 0);
      png = await new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
      if (!png || png.size > kMaxPictureBytes) throw new Error(t('it is too large'));
    }
    // The autosave keeps pictures in .felt files.
    const loaded = await this.ready(() => true);
    if (!loaded.ok) return loaded;
    const { page } = this.page.core.state();
    const scale = Math.min(25.4 / 96, (kPictureShare * page.width) / width, (kPictureShare * page.height) / height);
    const event = { event: 'picture', name: file.name.replace(/\.[^.]*$/, ''), png: base64_of(await png.arrayBuffer()),
      matrix: [scale, 0, 0, scale, (page.width - scale * width) / 2, (page.height - scale * height) / 2] };
    this.page.settle();
    return this.page.core.event(event);
  }

  /** Opens the first file, or adds it, and adds the others. */
  async load_all(files, adds) {
    const all = [];
    for (const [i, file] of files.entries()) {
      const said = await this.load(file, adds || i > 0);
      if (said === null) break;  // the user keeps the drawing
      all.push(...said.map((text) => (text.includes(file.name) ? text : `${file.name}: ${text}`)));
    }
    if (files.length > 1 && all.length > 0) this.say_all(all);
  }

  /** Shows sentences: the first ones and, if there are more, their number, a button that shows all, and one that closes the
   * message, which stays. */
  say_all(texts) {
    const more = texts.length - kMaxNotices;
    const shown = texts.slice(0, kMaxNotices).concat(more > 0 ? t('And %1 more.', more) : []);
    this.page.say(shown.join('\n'), more > 0);
    if (more <= 0) return texts;
    const show = () => {
      this.page.end_notice();
      this.page.sheet.focus({ preventScroll: true });  // to which the dialog returns the focus
      this.page.dialog(t('Left out or changed'), make('ul', {}, ...texts.map((text) => make('li', {}, text))),
        [make('button', { className: 'main' }, t('Close'))]);
    };
    const button = (text, onclick) => make('button', { type: 'button', onclick }, text);
    document.getElementById('notice').firstChild.append(' ', button(t('Show all'), show), button(t('Close'), () => this.page.end_notice()));
    return texts;
  }

  /** Opens a file, or adds it. Pictures are always added. Returns the sentences that it shows; null if the user keeps the
   * drawing. */
  async load(file, adds) {
    const refuse = (error) => {
      const why = t('“%1” could not be opened: %2', file.name, error.replace(`${file.name}: `, ''));
      return this.say_all([`${why}${why.endsWith('.') ? '' : '.'} ${t('Your drawing is unchanged.')}`]);
    };
    let said = [];
    try {
      if (file.size > kMaxBytes) return refuse(t('it is too large'));
      if (kPictures.includes(file.type)) {
        const done = await this.add_picture(file);
        this.page.wake();
        return done.ok ? [] : refuse(this.page.reason(done));
      }
      const bytes = await unpacked(new Uint8Array(await file.arrayBuffer().catch(() => {
        throw new Error(t('the browser cannot read it; a folder cannot be opened'));
      })));
      await this.page.complete();  // with which the drawing of the last visit is there
      if (!adds && this.page.unsaved() && !(await this.page.ask(t('Replace the drawing? It is not in a file yet.'), t('Replace')))) return null;
      const done = await this.read(bytes, file.name, adds);
      if (!done.ok) return refuse(this.page.reason(done));
      if (!adds) {
        this.name = file.name.replace(/\.[^.]*$/, '');
        this.page.begun();
      }
      if (done.notices) said = this.say_all(done.notices.map(loss));
    } catch (error) {
      said = refuse(error.message);
    }
    this.page.wake();
    return said;
  }

  async read(bytes, name, adds) {
    const loaded = await this.ready((core) => core.isFelt(bytes));
    if (!loaded.ok) return loaded;
    const { core } = this.page;
    core.finish();
    return adds ? core.add(bytes, name) : core.open(bytes, name);
  }

  /** Waits until the page has a core with what it needs for files; `needs_felt(core)`: for .felt files. */
  async ready(needs_felt = () => false) {
    const done = await this.page.complete(), { core } = this.page;
    if (!done.ok || !needs_felt(core)) return done;
    const loaded = await core.prepareFelt();
    // Another one, if this one has ended meanwhile.
    return this.page.core === core ? loaded : this.ready(needs_felt);
  }

  file_name(ending) {
    return `${this.name || t('Drawing')}.${ending}`;
  }

  /** Runs one of the functions below, which returns { ok, error }. If it fails, the page says why. */
  async try_to(act) {
    const done = await act().catch((error) => ({ ok: false, error: error.message }));
    if (done.ok) return;
    console.info('Feltline: not saved:', done.error);
    this.page.say(t('The drawing could not be saved: %1', this.page.reason(done)));
    this.page.wake();
  }

  save(format) {
    return this.try_to(async () => {
      const loaded = await this.ready(() => format === 'felt');
      if (!loaded.ok) return loaded;
      const { core } = this.page;
      core.finish();
      const data = core.save(format);
      if (!data) return { ok: false, error: core.saveError };
      download(data.slice(), this.file_name(format), kTypes[format]);
      this.page.saved();
      this.say_all([t('Saved as %1', this.file_name(format)), ...core.saveNotices.map(loss)]);
      return loaded;
    });
  }

  /** Saves a stored drawing that could not be restored: its base as a drawing, and the events since then. */
  save_stored({ base, recorded }) {
    const format = base && this.page.core.isFelt(base) ? 'felt' : 'svg';
    if (base?.byteLength > 0) download(base, `${t('Drawing')}.${format}`, kTypes[format]);
    if (recorded) download(recorded, `${t('Drawing')}-events.ndjson`, kTypes.ndjson);
  }

  export_png() {
    return this.try_to(async () => {
      const loaded = await this.ready();
      if (!loaded.ok) return loaded;
      const { core } = this.page, { page } = core.state();
      core.finish();
      // Large pages get fewer pixels per inch, because a browser limits the size of a picture.
      const area = (page.width * page.height) / 25.4 ** 2;
      const picture = core.picture(Math.min(kExportDpi, Math.sqrt(kMaxPixels / area)));
      if (!picture) return { ok: false, error: t('it is too large') };
      const canvas = make('canvas', { width: picture.width, height: picture.height });
      canvas.getContext('2d').putImageData(new ImageData(picture.data.slice(), picture.width, picture.height), 0, 0);
      const blob = await new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
      if (!blob) return { ok: false, error: t('it is too large') };
      download(blob, this.file_name('png'));
      return loaded;
    });
  }
}
