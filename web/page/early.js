// Runs while the page is read, before everything else: collects pointer events of the sheet until the page handles
// them itself, and shows a plain line for them, so that the first touch draws even if the program is still loading.
(() => {
  const sheet = document.getElementById('sheet');
  const chosen = (name) => { try { return localStorage.getItem(`feltline.${name}`); } catch { return null; } };
  const choice = chosen('theme');
  const dark = choice ? choice === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';

  const kMaxEvents = 50_000;  // if the program never comes
  const early = { events: [], stop, failed: null, missing: [] };
  const types = ['pointerdown', 'pointermove', 'pointerup', 'pointercancel'];
  const ratio = devicePixelRatio;
  let context = null, last = null;

  function collect(event) {
    if (early.events.length > kMaxEvents) return;
    // Coalesced events are lists that a browser empties when the event is over, so they are copied now.
    early.events.push({ event, coalesced: event.getCoalescedEvents?.() ?? [] });
    if (event.type === 'pointerdown') last = event;
    if (event.type === 'pointermove' && last && event.buttons) {
      if (!context) {
        sheet.width = innerWidth * ratio;
        sheet.height = innerHeight * ratio;
        context = sheet.getContext('2d', { alpha: false, desynchronized: true });
        const style = getComputedStyle(document.documentElement), value = (name) => style.getPropertyValue(`--${name}`);
        const [left, top, right, bottom] = ['left', 'top', 'right', 'bottom'].map((side) => parseFloat(value(`sheet-${side}`)));
        context.scale(ratio, ratio);
        context.fillStyle = value('desk');
        context.fillRect(0, 0, innerWidth, innerHeight);
        context.fillStyle = '#fff';
        context.fillRect(left, top, innerWidth - left - right, innerHeight - top - bottom);
        context.lineWidth = 1.5;
        context.lineCap = 'round';
        context.strokeStyle = '#30343899';
      }
      context.beginPath();
      context.moveTo(last.clientX, last.clientY);
      context.lineTo(event.clientX, event.clientY);
      context.stroke();
      last = event;
    }
    if (event.type === 'pointerup' || event.type === 'pointercancel') last = null;
  }
  function stop() {
    for (const type of types) sheet.removeEventListener(type, collect);
    return early.events.splice(0);
  }
  for (const type of types) sheet.addEventListener(type, collect);
  addEventListener('error', (event) => {
    const name = event.target.getAttribute?.('src');
    if (!name) return void (early.failed ??= event.message);
    early.missing.push(name);
    // The program itself cannot tell that.
    if (name !== 'page.js') return;
    const words = { de: 'konnte nicht geladen werden. Laden Sie die Seite neu.', nl: 'kon niet worden geladen. Laad de pagina opnieuw.' };
    const language = (chosen('language') || navigator.language).slice(0, 2);
    document.getElementById('notice').innerHTML = `<p>page.js ${words[language] ?? 'could not be loaded. Reload the page.'}</p>`;
  }, true);
  globalThis.feltlineEarly = early;
})();
