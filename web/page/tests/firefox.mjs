// Drives Firefox by its Marionette protocol, without a library.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { connect, createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const name = process.env.FIREFOX ?? 'firefox-esr';
export const has_firefox = () => spawnSync(name, ['--version']).status === 0;

async function free_port() {
  const server = createServer().listen(0, '127.0.0.1');
  await new Promise((done) => server.on('listening', done));
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return port;
}

export class Firefox {
  static async start() {
    const firefox = new Firefox(), port = await free_port();
    firefox.profile = mkdtempSync(join(tmpdir(), 'feltline-firefox-'));
    writeFileSync(join(firefox.profile, 'user.js'), `user_pref("marionette.port", ${port});\n`
      + 'user_pref("datareporting.policy.dataSubmissionEnabled", false);\nuser_pref("app.update.enabled", false);\n');
    firefox.process = spawn(name, ['--headless', '--no-remote', '--marionette', '--profile', firefox.profile, '--width', '1280', '--height', '800'],
      { stdio: 'ignore', env: { ...process.env, MOZ_DISABLE_CONTENT_SANDBOX: '1', HOME: firefox.profile } });
    for (let i = 0; i < 300 && !firefox.socket; ++i) {
      await new Promise((done) => setTimeout(done, 200));
      firefox.socket = await new Promise((done) => {
        const socket = connect(port, '127.0.0.1', () => done(socket)).on('error', () => done(null));
      });
    }
    firefox.answers = new Map();
    firefox.next = 1;
    let bytes = Buffer.alloc(0);
    firefox.socket.on('data', (data) => {
      bytes = Buffer.concat([bytes, data]);
      for (;;) {
        const colon = bytes.indexOf(58), size = Number(bytes.subarray(0, colon));
        if (colon < 0 || bytes.length < colon + 1 + size) return;
        const message = JSON.parse(bytes.subarray(colon + 1, colon + 1 + size));
        bytes = bytes.subarray(colon + 1 + size);
        if (!Array.isArray(message)) continue;
        const [, id, error, result] = message;
        firefox.answers.get(id)?.(error ? Promise.reject(new Error(error.message)) : result);
      }
    });
    await firefox.send('WebDriver:NewSession', {});
    await firefox.send('WebDriver:SetTimeouts', { script: 60_000 });
    return firefox;
  }

  send(command, parameters = {}) {
    const id = this.next++, text = JSON.stringify([0, id, command, parameters]);
    this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    return new Promise((done) => this.answers.set(id, done));
  }

  load(url) {
    return this.send('WebDriver:Navigate', { url });
  }

  async run(code, ...args) {
    const script = `const done = arguments[arguments.length - 1];
      Promise.resolve((${code})(...[...arguments].slice(0, -1))).then((value) => done([value ?? null]), (error) => done(String(error)));`;
    const { value } = await this.send('WebDriver:ExecuteAsyncScript', { script, args, sandbox: null });
    if (typeof value === 'string') throw new Error(value);
    return value[0];
  }

  async until(code) {
    for (let i = 0; i < 300; ++i) {
      if (await this.run(code)) return;
      await new Promise((done) => setTimeout(done, 100));
    }
    throw new Error(`never true: ${code}`);
  }

  /** Draws a line with the mouse. */
  stroke(points) {
    const at = ([x, y]) => ({ type: 'pointerMove', duration: 0, x: Math.round(x), y: Math.round(y) });
    return this.send('WebDriver:PerformActions', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' },
      actions: [at(points[0]), { type: 'pointerDown', button: 0 }, ...points.map(at), { type: 'pointerUp', button: 0 }] }] });
  }

  async screenshot() {
    const { value } = await this.send('WebDriver:TakeScreenshot', { full: false });
    return Buffer.from(value, 'base64');
  }

  async close() {
    const ended = new Promise((done) => this.process.on('exit', done));
    await Promise.race([this.send('Marionette:Quit', { flags: ['eForceQuit'] }), ended]);
    this.socket.destroy();
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
