// The bars: commands, tools, ink (medium, colour, size, surface) and view. They show the state of the core and send
// events; they keep nothing.
import { make, icon, icon_button, set_label, press, line, arrow_keys } from './dom.js';
import { t, d, number } from './words.js';

const find = (id) => document.getElementById(id);
const fill = (select, entries) => select.replaceChildren(
  ...entries.map(([value, text]) => make('option', { value }, text)));

export class Bars {
  constructor(page) {
    this.page = page;
    for (const id of ['top', 'tools', 'view']) arrow_keys(find(id));
  }

  show_words() {
    this.top();
    this.tools();
    this.ink();
    this.view();
  }

  top() {
    const { page } = this;
    this.menu = icon_button('menu', t('Menu'), () => page.menu.toggle());
    this.menu.setAttribute('aria-haspopup', 'dialog');
    this.menu.setAttribute('aria-expanded', 'false');
    this.undo = icon_button('undo', d('EditActions', 'Undo'), () => page.apply({ event: 'undo' }), page.key_name('Ctrl+Z'));
    this.redo = icon_button('redo', d('EditActions', 'Redo'), () => page.apply({ event: 'redo' }), page.key_name('Ctrl+Shift+Z'));
    this.turned = make('button', { type: 'button', hidden: true, onclick: () => page.turn(null) });
    this.shown_angle = 0;
    find('top').setAttribute('aria-label', t('Menu'));
    find('top').replaceChildren(this.menu, this.undo, this.redo, this.turned);
    if (page.core) this.show_view(page.core.view());
  }

  tools() {
    const { page } = this;
    this.buttons = new Map();
    find('tools').setAttribute('aria-label', t('Tools'));
    find('tools').replaceChildren(...(page.catalog?.tools ?? []).map((tool) => {
      const button = icon_button(tool.id, d('tools', tool.label), () => page.use_tool(tool.id), tool.shortcut.toUpperCase());
      button.title += `\n${d('tools', tool.help)}`;
      this.buttons.set(tool.id, button);
      return button;
    }));
  }

  ink() {
    const { page } = this;
    const label = (text, control) => make('label', {}, make('span', { className: 'word' }, text), control);
    this.medium = make('select', { 'aria-label': t('Medium'), onchange: () => page.set_medium(this.medium.value) });
    this.surface = make('select', { 'aria-label': t('Surface'),
      onchange: () => page.set_option('surface.material', this.surface.value) });
    this.color = make('input', { type: 'color', 'aria-label': t('Colour'), title: t('Colour'),
      onchange: () => page.set_color(this.color.value) });
    // The scale is logarithmic: the same distance multiplies the size by the same factor.
    this.size = make('input', { type: 'range', min: 0, max: 1, step: 0.005, 'aria-label': t('Size'), title: t('Size'),
      oninput: () => { if (this.range) page.set_size(this.mm_of(Number(this.size.value))); } });
    this.mm = make('span', { className: 'value', 'aria-hidden': 'true' });
    fill(this.medium, (page.catalog?.media ?? []).map(({ id, label: name }) => [id, d('Material', name)]));
    fill(this.surface, (page.catalog?.surfaces ?? []).map(({ id, label: name }) => [id, d('Material', name)]));
    find('ink').setAttribute('aria-label', t('Ink'));
    find('ink').hidden = !page.catalog;
    find('ink').replaceChildren(label(t('Medium'), this.medium), this.color,
      make('label', { title: t('Size') }, make('span', { className: 'word' }, t('Size')), this.size, this.mm),
      label(t('Surface'), this.surface));
  }

  view() {
    const { page } = this;
    this.hand = icon_button('hand', '', () => page.toggle_hand());
    this.sound = icon_button('sound', t('Sound of drawing'), () => page.toggle_sound());
    this.sound.classList.add('sound');
    this.fit = icon_button('fit', t('Fit page'), () => page.fit(), '3');
    this.panels = {
      forces: icon_button('force-plot', t('Show forces'), () => page.toggle('forces')),
      options: icon_button('options', t('Options'), () => page.toggle('options')),
      layers: icon_button('layers', t('Layers'), () => page.toggle('layers')),
    };
    find('view').setAttribute('aria-label', t('View'));
    // On a phone, these are in the menu.
    const wide = [this.fit, line(), this.hand, line()];
    for (const one of wide) one.classList.add('wide');
    find('view').replaceChildren(...wide, this.sound, ...Object.values(this.panels));
    this.show_switches();
  }

  /** Shows what the page itself has switched on. */
  show_switches() {
    const { page } = this;
    press(this.hand, page.plays);
    set_label(this.hand, page.plays ? t('Stop the simulated hand') : t('Let the simulated hand draw the cat'));
    press(this.sound, page.sound?.is_on);
    for (const [id, button] of Object.entries(this.panels)) press(button, page.shown[id]);
  }

  /** Shows by how much the view is turned. */
  show_view({ angle }) {
    if (angle === this.shown_angle) return;
    this.shown_angle = angle;
    const degrees = number(Math.round(angle > 180 ? angle - 360 : angle) || 0);
    if (angle === 0 && document.activeElement === this.turned) find('sheet').focus();
    this.turned.hidden = angle === 0;
    this.turned.textContent = `${degrees}°`;
    set_label(this.turned, t('The sheet is turned by %1°. Turn it upright', degrees), '5');
  }

  /** Shows the state of the core. */
  show(state) {
    const { page } = this;
    this.undo.disabled = state.undo === null;
    this.redo.disabled = state.redo === null;
    const name = (what, of_step, step) => step ? d('EditActions', of_step, d('edits', step)) : d('EditActions', what);
    set_label(this.undo, name('Undo', 'Undo %1', state.undo), page.key_name('Ctrl+Z'));
    set_label(this.redo, name('Redo', 'Redo %1', state.redo), page.key_name('Ctrl+Shift+Z'));
    for (const [id, button] of this.buttons) press(button, id === state.tool);
    if (document.activeElement !== this.color) this.color.value = state.ink.slice(0, 7);
    this.medium.value = state.medium;
    this.surface.value = state.surface;
    this.range = state.size;
    this.size.disabled = !state.size;
    this.mm.textContent = state.size ? `${number(state.size.mm, state.size.mm < 10 ? 2 : 1)} mm` : '';
    if (state.size) {
      const { mm, min, max } = state.size;
      this.size.value = max > min ? Math.log(mm / min) / Math.log(max / min) : 0;
      this.size.setAttribute('aria-valuetext', this.mm.textContent);
    }
  }

  mm_of(share) {
    const { min, max } = this.range;
    return min * (max / min) ** share;
  }
}

const kOffers = { ink: 'Keep the ink', line: 'Straight line', arc: 'Arc', circle: 'Circle', ellipse: 'Ellipse', triangle: 'Triangle',
  rectangle: 'Rectangle', polygon: 'Polygon' };

function offer_text({ id, count }) {
  if (id in kOffers) return d('OfferPopup', kOffers[id]);
  const verb = id === 'delete' ? 'Delete' : 'Select';
  return count === 1 ? d('OfferPopup', `${verb} 1 line`) : d('OfferPopup', `${verb} %1 lines`, count);
}

/** What to do with the selection, what the last stroke could mean, and what the lasso takes: a bar that is there only then. */
export class OfferBar {
  constructor(page) {
    this.page = page;
    this.element = find('offer');
  }

  show(state) {
    const take = state.options['lasso.take'];
    const key = JSON.stringify([state.offers, state.selected > 0, state.canShowAsDrawn, state.exact, Boolean(take)]);
    // If only the choice changes, the buttons stay, and one of them keeps the focus.
    const press_takes = () => this.takes.forEach((button, choice) => press(button, take === choice));
    if (key === this.shown) return press_takes();
    this.shown = key;
    this.takes = new Map();
    const { page } = this, buttons = [];
    const button = (text, event) => make('button', { type: 'button', onclick: () => page.apply(event) }, text);
    for (const offer of state.offers) {
      buttons.push(button(offer_text(offer), { event: 'choose', what: offer.id }));
      press(buttons.at(-1), offer.applies);
    }
    if (state.exact) buttons.push(button(d('EditActions', 'Make exact'), { event: 'exact' }));
    if (state.canShowAsDrawn) buttons.push(button(d('EditActions', 'Line as drawn'), { event: 'as-drawn' }));
    for (const choice of take ? ['parts', 'strokes'] : []) {
      buttons.push(make('button', { type: 'button', onclick: () => page.set_option('lasso.take', choice) }, d('tools', choice)));
      this.takes.set(choice, buttons.at(-1));
    }
    press_takes();
    if (state.selected > 0) {
      const command = (name, text, event) => icon_button(name, d('EditActions', text), () => page.apply(event));
      buttons.push(command('delete', 'Delete', { event: 'delete' }), command('duplicate', 'Duplicate', { event: 'duplicate' }),
        command('raise', 'Bring to front', { event: 'order', to: 'front' }),
        command('lower', 'Send to back', { event: 'order', to: 'back' }),
        command('select-none', 'Select none', { event: 'select', what: 'none' }));
    }
    this.element.hidden = buttons.length === 0;
    this.element.setAttribute('aria-label', t(state.selected > 0 || take ? 'Selection' : 'Suggestions'));
    this.element.replaceChildren(...buttons);
  }
}

/** The menu of the page: files, theme, language, help. */
export class Menu {
  constructor(page) {
    this.page = page;
    addEventListener('pointerdown', (event) => {
      if (this.element && !this.element.contains(event.target) && !page.bars.menu.contains(event.target)) this.close();
    }, true);
  }

  toggle() {
    if (this.element) this.close();
    else this.open();
  }

  open() {
    const { page } = this;
    const entry = (name, text, act, keys = '') => make('button', { type: 'button', onclick: () => { this.close(); page.bars.menu.focus(); act(); } },
      icon(name), make('span', {}, text), keys ? make('kbd', {}, page.key_name(keys)) : null);
    const only = (width, button) => {
      button.classList.add(width);
      return button;
    };
    const choice = (text, value, entries, act) => {
      const select = make('select', { id: `choice-${text}`, onchange: () => act(select.value) });
      fill(select, entries);
      select.value = value;
      return make('div', { className: 'row' }, make('label', { htmlFor: `choice-${text}` }, t(text)), select);
    };
    const { formats } = page.catalog ?? { formats: [] };
    const saves = (id) => formats.some((format) => format.id === id && format.saves);
    this.element = make('div', { className: 'card menu', role: 'dialog', 'aria-label': t('Menu') },
      entry('new', t('New drawing'), () => page.new_drawing()),
      entry('open', t('Open…'), () => page.files.choose(false), 'Ctrl+O'),
      page.storage ? entry('layers', t('Other drawings…'), () => page.show_others()) : null,
      entry('import', t('Add a file to the drawing…'), () => page.files.choose(true)),
      make('hr'),
      page.has_felt ? entry('save', t('Save as Feltline drawing'), () => page.files.save('felt'), 'Ctrl+S') : null,
      saves('svg') ? entry('save-as', t('Save as SVG'), () => page.files.save('svg'), page.has_felt ? '' : 'Ctrl+S') : null,
      saves('ndjson') ? entry('save-as', t('Save as lines of JSON'), () => page.files.save('ndjson')) : null,
      entry('export', t('Export as PNG'), () => page.files.export_png(), 'Ctrl+Shift+E'),
      make('hr'),
      ...[['cut', 'Cut', 'Ctrl+X', () => page.clipboard.copy(true)], ['copy', 'Copy', 'Ctrl+C', () => page.clipboard.copy(false)],
        ['paste', 'Paste', 'Ctrl+V', () => page.clipboard.paste()]]
        .map(([name, text, keys, act]) => entry(name, d('ClipboardActions', text), act, keys)),
      make('hr', { className: 'small' }),
      only('small', entry('hand', page.plays ? t('Stop the simulated hand') : t('Let the simulated hand draw the cat'), () => page.toggle_hand())),
      only('small', entry('fit', t('Fit page'), () => page.fit())),
      only('narrow', entry('sound', `${t('Sound of drawing')}: ${t(page.sound.is_on ? 'on' : 'off')}`, () => page.toggle_sound())),
      make('hr'),
      choice('Theme', page.theme_choice(), [['', t('as in the system')], ['light', t('light')], ['dark', t('dark')]],
        (value) => page.set_theme(value)),
      make('p', { className: 'quiet why', hidden: page.paper_is_dark }, page.why_light()),
      choice('Language', page.language(), page.languages(), (value) => { this.close(); page.set_language(value); page.bars.menu.focus(); }),
      make('hr'),
      entry('keyboard', t('Keyboard shortcuts'), () => page.show_keys(), '?'),
      entry('info', t('About Feltline'), () => page.show_about()));
    this.element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      this.close();
      page.bars.menu.focus();
      event.stopPropagation();
    });
    // Tab leaves the menu.
    this.element.addEventListener('focusout', ({ relatedTarget: to }) => {
      if (to && !this.element?.contains(to) && to !== page.bars.menu) this.close();
    });
    arrow_keys(this.element);
    document.getElementById('top').after(this.element);
    page.bars.menu.setAttribute('aria-expanded', 'true');
    this.element.querySelector('button').focus();
  }

  close() {
    this.element?.remove();
    this.element = null;
    this.page.bars.menu.setAttribute('aria-expanded', 'false');
  }
}
