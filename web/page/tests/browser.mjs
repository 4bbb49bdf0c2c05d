// Drives Chromium through its debugging pipe, without a library: browser.open(url) gives a Tab, tab.run(function)
// runs a function in the page, tab.send(...) is a command of the Chrome DevTools Protocol.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kCommandMs = 120_000;

export class Browser {
  constructor(profile) {
    this.profile = profile ?? mkdtempSync(join(tmpdir(), 'feltline-page-'));
    this.owns_profile = !profile;
    this.answers = new Map();
    this.listeners = [];
    this.next = 1;
    this.process = spawn(process.env.CHROMIUM ?? 'chromium', ['--headless', '--no-sandbox', '--disable-gpu', '--remote-debugging-pipe',
      '--no-first-run', '--disable-background-networking', '--disable-component-update', '--autoplay-policy=no-user-gesture-required',
      '--allow-file-access-from-files=false', `--user-data-dir=${this.profile}`, 'about:blank'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    this.ended = new Promise((resolve) => this.process.on('exit', resolve));
    this.input = this.process.stdio[3];
    let text = '';
    this.process.stdio[4].setEncoding('utf8').on('data', (data) => {
      const messages = (text + data).split('\0');
      text = messages.pop();
      messages.forEach((message) => this.handle(JSON.parse(message)));
    });
  }

  handle(message) {
    if (!message.id) return this.listeners.forEach((listener) => listener(message));
    const { resolve, reject, timer } = this.answers.get(message.id);
    this.answers.delete(message.id);
    clearTimeout(timer);
    if (message.error) reject(new Error(message.error.message));
    else resolve(message.result);
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.next++;
    this.input.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => reject(new Error(`${method}: no answer`)), kCommandMs);
      this.answers.set(id, { resolve, reject, timer });
    });
  }

  /** Opens a tab. `prepare(tab)` runs before the page is loaded. */
  async open(url, { width = 1280, height = 800, dpr = 1, mobile = false, prepare = null, wait = true } = {}) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const tab = new Tab(this, sessionId, targetId);
    for (const domain of ['Page', 'Runtime', 'Network', 'Log']) await tab.send(`${domain}.enable`);
    await tab.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: dpr, mobile });
    if (mobile) await tab.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 5 });
    await prepare?.(tab);
    await tab.load(url, wait);
    return tab;
  }

  async close() {
    await this.send('Browser.close').catch(() => {});
    await this.ended;
    this.clean();
  }

  /** Ends the browser as a crash would. */
  async kill() {
    this.process.kill('SIGKILL');
    await this.ended;
    this.clean();
  }

  clean() {
    for (const { timer } of this.answers.values()) clearTimeout(timer);
    if (this.owns_profile) rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

export class Tab {
  constructor(browser, session, target) {
    Object.assign(this, { browser, session, target, errors: [], requests: [], loaded: null, asked: 0 });
    browser.listeners.push((message) => {
      if (message.sessionId === session) this.handle(message.method, message.params);
    });
  }

  handle(method, params) {
    if (method === 'Runtime.exceptionThrown') this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type)) {
      this.errors.push(params.args.map((one) => one.value ?? one.description).join(' '));
    }
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.errors.push(`${params.entry.text} ${params.entry.url ?? ''}`);
    if (method === 'Network.requestWillBeSent' && !/^(data|blob):/.test(params.request.url)) this.requests.push(params.request.url);
    if (method === 'Page.loadEventFired') this.loaded?.();
    // The page asks before unsaved lines are lost; the user leaves it.
    if (method === 'Page.javascriptDialogOpening') {
      this.asked += 1;
      this.send('Page.handleJavaScriptDialog', { accept: true }).catch(() => {});
    }
  }

  send(method, params = {}) {
    return this.browser.send(method, params, this.session);
  }

  async load(url, wait = true) {
    const loaded = new Promise((resolve) => { this.loaded = resolve; });
    if (url) await this.send('Page.navigate', { url });
    else await this.send('Page.reload');
    await loaded;
    // The first module draws immediately; most tests need the full one.
    if (wait) await this.until((is_first) => globalThis.feltlinePage?.input && (is_first || feltlinePage.core?.isComplete || feltlinePage.incomplete),
      wait === 'first');
  }

  reload(wait = true) {
    return this.load(null, wait);
  }

  /** Runs a function in the page; arguments and result are JSON. */
  async run(code, ...args) {
    const expression = `(${code})(...${JSON.stringify(args)})`;
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true, userGesture: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async until(code, ...args) {
    for (let i = 0; i < 600; ++i) {
      if (await this.run(`async (...a) => Boolean(await (${code})(...a))`, ...args)) return;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error(`never true: ${code}; console: ${this.errors.join('; ')}`);
  }

  async frames(count = 2) {
    await this.run((n) => new Promise((resolve) => {
      const next = () => (n-- > 0 ? requestAnimationFrame(next) : resolve());
      next();
    }), count);
  }

  mouse(type, x, y, more = {}) {
    return this.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1, ...more });
  }

  /** Draws a line with the mouse, or a pen if `more.pointerType` is 'pen'. */
  async stroke(points, more = {}) {
    await this.mouse('mouseMoved', ...points[0], { ...more, button: 'none', buttons: 0 });
    await this.mouse('mousePressed', ...points[0], more);
    for (const point of points) await this.mouse('mouseMoved', ...point, more);
    await this.mouse('mouseReleased', ...points.at(-1), more);
    // The pen of the core follows with a short delay.
    await new Promise((resolve) => setTimeout(resolve, 60));
    await this.frames(3);
    await this.until(() => !feltlinePage.core.state().gesture);
  }

  async key(key, { modifiers = 0, code = key.length === 1 ? `Key${key.toUpperCase()}` : key, down = true, up = true } = {}) {
    const event = { key, code, modifiers, windowsVirtualKeyCode: key.length === 1 ? key.toUpperCase().charCodeAt(0) : 0 };
    if (down) await this.send('Input.dispatchKeyEvent', { type: 'rawKeyDown', ...event });
    if (up) await this.send('Input.dispatchKeyEvent', { type: 'keyUp', ...event });
  }

  async screenshot() {
    const { data } = await this.send('Page.captureScreenshot', { format: 'png' });
    return Buffer.from(data, 'base64');
  }
}
