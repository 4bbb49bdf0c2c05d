// The module with SQLite, as the full module calls it (calls.h).
import { instantiate } from '../instantiate.mjs';
import { felt_module } from '../module.js';

export class DatabaseModule {
  constructor(load_script) {
    this.load_script = load_script;
    this.exports = null;
  }

  get is_ready() {
    return this.exports !== null;
  }

  async start() {
    this.exports ??= await instantiate(await felt_module(this.load_script));
  }

  /** Returns the size of the answer, -1 without a module, or -2 if it ends. */
  call(what, handle, bytes) {
    if (!this.exports) return -1;
    try {
      const at = this.exports.database_input(bytes.length);
      new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
      this.size = this.exports.database_call(what, handle);
      return this.size;
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
      this.exports = null;  // the next start() makes another one
      return -2;
    }
  }

  copy_answer(memory, to) {
    const bytes = new Uint8Array(this.exports.memory.buffer, this.exports.database_answer(), this.size);
    new Uint8Array(memory.buffer, to, this.size).set(bytes);
  }
}
