// Small helpers for building the page.

/** Makes an element. `props` are properties, attributes (if their name contains - or is "role" etc.), and on… handlers. */
export function make(tag, props = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (value === undefined || value === null) continue;
    if (name in element && !name.includes('-')) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** Returns the icon of the desktop program with this name. */
export function icon(name) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('aria-hidden', 'true');
  const use = document.createElementNS('http://www.w3.org/2000/svg', 'use');
  use.setAttribute('href', `#i-${name}`);
  svg.append(use);
  return svg;
}

/** Makes a button that shows only an icon. Its name is its tool tip, too; `keys` is its shortcut. */
export function icon_button(name, label, onclick, keys = '') {
  const button = make('button', { type: 'button', className: 'icon', onclick }, icon(name));
  set_label(button, label, keys);
  return button;
}

export function set_label(button, label, keys = '') {
  if (button.getAttribute('aria-label') === label) return;
  button.setAttribute('aria-label', label);
  button.title = keys ? `${label} (${keys})` : label;
}

export function set_icon(button, name) {
  const use = button.querySelector('use');
  if (use.getAttribute('href') !== `#i-${name}`) use.setAttribute('href', `#i-${name}`);
}

export function press(button, on) {
  const text = String(Boolean(on));
  if (button.getAttribute('aria-pressed') !== text) button.setAttribute('aria-pressed', text);
}

export const line = () => make('span', { className: 'line', 'aria-hidden': 'true' });

/** Moves the focus among the buttons of a tool bar with the arrow keys, Home and End; Tab leaves the bar. */
export function arrow_keys(bar) {
  bar.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step && event.key !== 'Home' && event.key !== 'End') return;
    const buttons = [...bar.querySelectorAll('button:not(:disabled)')];
    const at = buttons.indexOf(document.activeElement);
    if (at < 0) return;
    const next = event.key === 'Home' ? 0 : event.key === 'End' ? buttons.length - 1 : at + step;
    buttons[(next + buttons.length) % buttons.length].focus();
    event.preventDefault();
    event.stopPropagation();
  });
}

/** Stored choices of the user. A browser may refuse storage at file://, so that errors are ignored. */
export const choices = {
  get(name) {
    try {
      return localStorage.getItem(`feltline.${name}`);
    } catch {
      return null;
    }
  },
  set(name, value) {
    try {
      localStorage.setItem(`feltline.${name}`, value);
    } catch { /* the choice lasts until the page is closed */ }
  },
};
