// The autosave: the drawing of the last visit is in the browser's database, as a base and the events since then. If
// the tab is killed, at most the last half second and the gesture in progress are lost.
//
// Each open tab has a slot of its own. The store `bases` has the base of a slot, `records` has its events, at the keys
// [slot, number]. Numbers without a gap belong together; a base says which is its first. So events that follow a
// failed write are never read as part of the drawing.

const kDatabase = 'feltline', kStores = ['bases', 'records'];
const kReloadMs = 300;               // the page before a reload may hold its slot for this time
const kBeatMs = 3000, kLostMs = 10_000;  // an owner that has not been seen for kLostMs has closed

const done = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

/** Values that last as long as the tab, also over a reload. */
const of_tab = {
  get(name) {
    try {
      return sessionStorage.getItem(`feltline.${name}`);
    } catch {
      return null;
    }
  },
  set(name, value) {
    try {
      sessionStorage.setItem(`feltline.${name}`, value);
    } catch { /* after a reload, the tab begins with the first free slot */ }
  },
};

/** Returns 1, 2, ..., after the slot that the tab had before a reload. */
function* slots() {
  const last = Number(of_tab.get('slot'));
  if (last > 0) yield last;
  for (let slot = 1; ; ++slot) if (slot !== last) yield slot;
}

const lock_name = (slot) => `feltline-drawing-${slot}`;

/** Holds the lock of a slot until the function is called that this resolves to, or the tab is closed. Resolves to false if
 * another tab has it. */
function lock_slot(slot, options) {
  return new Promise((resolve, reject) => {
    navigator.locks.request(lock_name(slot), options, (lock) => {
      if (!lock) return resolve(false);
      return new Promise(resolve);
    }).catch((error) => (error.name === 'TimeoutError' || error.name === 'AbortError' ? resolve(false) : reject(error)));
  });
}

async function locked_slot(suits) {
  const last = Number(of_tab.get('slot'));
  for (const slot of slots()) {
    if (!await suits(slot)) continue;
    const release = await lock_slot(slot, { ifAvailable: true }) ||
      (slot === last && await lock_slot(slot, { signal: AbortSignal.timeout(kReloadMs) }));
    if (release) return { slot, release };
  }
}

/** The keys of the owners and descriptions are texts, those of the bases are numbers. */
const owner_key = (slot) => `owner-${slot}`;
const info_key = (slot) => `info-${slot}`;

export class Storage {
  /** Opens the store, which may take for ever, and returns the drawing of the last visit (load()). Fails if the browser
   * does not allow it. */
  async open() {
    await this.connect();
    await this.find_slot();
    return this.load();
  }

  constructor() {
    this.id = `${Date.now()}-${Math.random()}`;
    this.next = 0;
    this.is_leaving = false;  // the page may end now
    this.is_broken = false;   // the stored drawing ends before the present one; only restart() mends that
    this.is_mending = false;  // that restart() is being written
    this.written = Promise.resolve(true);  // what the last write resolves to: whether it succeeded
  }

  async connect() {
    const request = indexedDB.open(kDatabase, 1);
    request.onupgradeneeded = () => {
      for (const name of kStores) request.result.createObjectStore(name);
    };
    this.database = await done(request);
    this.database.onclose = () => this.fail(new Error('the database was closed'));
  }

  /** Finds a free slot; `suits`: whether it is wanted. */
  async find_slot(suits = async () => true) {
    const { release } = this;
    // Without a secure context, such as http in a local network, a browser has no locks.
    Object.assign(this, await (navigator.locks ? locked_slot(suits) : this.owned_slot(suits)));
    release?.();
    of_tab.set('slot', this.slot);
    of_tab.set('id', this.id);
    if (navigator.locks || this.beat) return;
    this.beat = setInterval(() => this.seen(Date.now()), kBeatMs);
    addEventListener('pagehide', () => this.seen(0));
    addEventListener('pageshow', (event) => { if (event.persisted) this.seen(Date.now()); });
  }

  // --- Slots without locks: their owners, with the time when they were last seen, are in the database

  /** Makes this tab the owner of a free slot. A reloaded tab has its slot back immediately, and so has a copy of a tab;
   * then the original moves to another slot with its next write. */
  async owned_slot(suits) {
    const before = of_tab.get('id'), now = Date.now();
    const bases = this.database.transaction('bases', 'readwrite').objectStore('bases');
    for (const slot of slots()) {
      if (!await suits(slot, bases)) continue;
      const owner = await done(bases.get(owner_key(slot)));
      if (owner && owner.id !== this.id && owner.id !== before && now - owner.time < kLostMs) continue;
      await done(bases.put({ id: this.id, time: now }, owner_key(slot)));
      return { slot };
    }
  }

  /** Notes that this tab lives; `time` 0: that it ends. */
  seen(time) {
    try {
      const transaction = this.database.transaction('bases', 'readwrite');
      if (time > 0) this.check_owner(transaction);
      transaction.objectStore('bases').put({ id: this.id, time }, owner_key(this.slot));
      transaction.onabort = () => this.fail(transaction.error);
      if (time === 0) transaction.commit();
    } catch (error) {
      this.fail(error);
    }
  }

  /** Undoes the transaction if another tab has the slot. */
  check_owner(transaction) {
    if (navigator.locks) return;
    const request = transaction.objectStore('bases').get(owner_key(this.slot));
    request.onsuccess = () => {
      if (request.result?.id === this.id) return;
      this.is_taken = true;
      transaction.abort();
    };
  }

  // --- The drawing

  get bases() {
    return this.database.transaction('bases').objectStore('bases');
  }

  /** Moves to a slot without a drawing. The drawing of the former one stays. */
  async leave_slot() {
    if (!navigator.locks) this.seen(0);
    await this.find_free_slot();
    this.is_broken = this.is_mending = false;
  }

  /** Finds a slot that has no drawing. That of a closed tab has one. */
  async find_free_slot() {
    await this.find_slot(async (slot, bases = this.bases) => !await done(bases.get(slot)));
    this.next = 0;
  }

  /** Returns the drawings that are open in no tab, the newest first: { slot, time, strokes }. Those with nothing are left out. */
  async others() {
    const { bases } = this, texts = IDBKeyRange.lowerBound('');
    const [slots_used, keys, values, locks] = await Promise.all([done(bases.getAllKeys(IDBKeyRange.upperBound(Infinity))),
      done(bases.getAllKeys(texts)), done(bases.getAll(texts)), navigator.locks?.query()]);
    const found = Object.fromEntries(keys.map((key, i) => [key, values[i]]));
    const is_open = (slot) => slot === this.slot || locks?.held.some(({ name }) => name === lock_name(slot)) ||
      (!locks && Date.now() - (found[owner_key(slot)]?.time ?? 0) < kLostMs);
    return slots_used.filter((slot) => !is_open(slot)).map((slot) => ({ slot, ...found[info_key(slot)] }))
      .filter(({ strokes, is_empty = strokes === 0 }) => !is_empty).sort((a, b) => (b.time ?? 0) - (a.time ?? 0));
  }

  /** The next page of this tab, such as after a reload, begins with this slot. The present one stays locked until then, because
   * the user may stay on the page. */
  change_to(slot) {
    of_tab.set('slot', slot);
  }

  /** Returns the drawing of the last visit, { base, page, recorded }, or null. */
  async load() {
    const transaction = this.database.transaction(kStores);
    const [first, keys, records] = await Promise.all([
      done(transaction.objectStore('bases').get(this.slot)),
      done(transaction.objectStore('records').getAllKeys(this.range())),
      done(transaction.objectStore('records').getAll(this.range())),
    ]);
    const begin = first?.first ?? keys[0]?.[1] ?? 0;
    this.next = begin;
    const recorded = records.filter((_, i) => keys[i][1] === this.next && ++this.next);
    // Records behind a gap are of a failed write.
    if (keys.length > 0 && keys.at(-1)[1] >= this.next) this.is_broken = true;
    return first ? { base: first.base, page: first.page, recorded: recorded.join('') } : null;
  }

  /** Appends events. */
  append(recorded) {
    if (recorded && !this.is_broken) this.write(null, recorded);
  }

  /** Begins a new drawing, followed by these events: all events so far are removed. `base` is null for an empty drawing,
   * whose page is `page`. */
  restart(base, page, recorded) {
    this.is_mending ||= this.is_broken;
    this.is_broken = false;
    this.write({ base, page, first: ++this.next }, recorded);
  }

  range() {
    return IDBKeyRange.bound([this.slot, 0], [this.slot, Number.MAX_SAFE_INTEGER]);
  }

  /** Writes a base, or null, and events; all or nothing. */
  write(base, recorded) {
    const { strokes, is_empty } = this;
    try {
      const transaction = this.database.transaction(kStores, 'readwrite', { durability: 'relaxed' });
      transaction.onabort = () => this.fail(transaction.error);
      this.written = new Promise((resolve) => {
        transaction.addEventListener('complete', () => resolve(true));
        transaction.addEventListener('abort', () => resolve(false));
      });
      if (!this.is_leaving) this.check_owner(transaction);
      const records = transaction.objectStore('records');
      if (base) {
        records.delete(this.range());
        transaction.objectStore('bases').put(base, this.slot);
      }
      if (recorded) records.put(recorded, [this.slot, this.next++]);
      if (base || recorded) transaction.objectStore('bases').put({ time: Date.now(), strokes, is_empty }, info_key(this.slot));
      if (base) {
        transaction.oncomplete = () => {
          this.is_mending = false;
          this.restarted?.();
        };
      }
      // The end of the page would abort a transaction that waits for the answers of its requests.
      if (navigator.locks || this.is_leaving) transaction.commit();
    } catch (error) {
      this.written = Promise.resolve(false);
      this.fail(error);
    }
  }

  /** A write failed: nothing is appended until restart(). */
  fail(error) {
    this.is_broken = true;
    if (this.is_taken) this.move();
    else this.failed?.(error);
  }

  /** Continues in another slot, because another tab took this one. */
  async move() {
    this.is_taken = false;
    try {
      await this.find_free_slot();
      this.moved?.();
    } catch (error) {
      this.failed?.(error);
    }
  }

  /** Opens the database again after a failure. */
  async reopen() {
    this.database?.close();
    await this.connect();
  }
}
