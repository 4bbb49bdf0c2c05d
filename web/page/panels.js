// The panels: options of the tool, and layers.
import { make, icon_button, press, set_icon, set_label } from './dom.js';
import { t, d, number } from './words.js';

const header = (page, id, title) => make('header', {}, make('h2', {}, title),
  icon_button('close', t('Close'), () => page.toggle(id)));

/** The options of the tool in use, made from the core's table. */
export class OptionsPanel {
  constructor(page) {
    this.page = page;
    this.element = make('section', { id: 'options', className: 'card', hidden: true });
    this.controls = new Map();
  }

  show_words() {
    this.element.setAttribute('aria-label', t('Options'));
    this.made_for = null;
  }

  show(state) {
    if (this.element.hidden) return;
    if (this.made_for !== state.tool) this.make(state.tool);
    for (const [id, { row, option, set }] of this.controls) {
      row.hidden = Boolean(option.when && !option.when.values.includes(String(state.options[option.when.id])));
      if (id in state.options) set(state.options[id]);
    }
  }

  make(tool_id) {
    const { page } = this, tool = page.catalog.tools.find(({ id }) => id === tool_id);
    this.made_for = tool_id;
    this.controls.clear();
    const rows = (seldom) => tool.options.filter((option) => option.isSeldom === seldom).map((option) => this.row(option));
    const seldom = rows(true);
    this.element.replaceChildren(header(page, 'options', d('tools', tool.label)), ...rows(false),
      ...(seldom.length ? [make('details', {}, make('summary', {}, d('OptionsPanel', 'More')), ...seldom)] : []),
      make('button', { type: 'button', onclick: () => this.reset(tool) }, d('OptionsPanel', 'Reset the tool')));
  }

  row(option) {
    const { page } = this, id = `option-${option.id}`;
    const label = make('label', { htmlFor: id, title: d('tools', option.help) }, d('tools', option.label));
    const { control, value, set } = this.control(option, id);
    const row = make('div', { className: 'row' }, label, ...(value ? [value, control] : [control]));
    this.controls.set(option.id, { row, option, set });
    return row;
  }

  control(option, id) {
    const { page } = this;
    if (option.kind === 'switch') {
      const control = make('input', { type: 'checkbox', id, onchange: () => page.set_option(option.id, control.checked) });
      return { control, set: (on) => { control.checked = Boolean(on); } };
    }
    if (option.kind === 'choice') {
      const context = option.open ? 'Material' : 'tools';
      const names = { surfaces: page.catalog.surfaces, media: page.catalog.media }[option.open];
      const entries = names ? names.map((one) => [one.id, one.label]) : option.choices.map((name) => [name, name]);
      const control = make('select', { id, onchange: () => page.set_option(option.id, control.value) },
        ...entries.map(([value, text]) => make('option', { value }, d(context, text))));
      return { control, set: (name) => { control.value = name; } };
    }
    const decimals = Math.max(0, Math.ceil(2 - Math.log10(option.max - option.min)));
    const value = make('span', { className: 'value', 'aria-hidden': 'true' });
    const text = (x) => `${number(x, Math.min(decimals, 2))} ${option.unit}`.trim();
    const control = make('input', { type: 'range', id, min: option.min, max: option.max,
      step: 10 ** -decimals, oninput: () => page.set_option(option.id, Number(control.value)) });
    return {
      control, value,
      set: (x) => {
        control.value = x;
        value.textContent = text(x);
        control.setAttribute('aria-valuetext', text(x));
      },
    };
  }

  reset(tool) {
    for (const option of tool.options) this.page.set_option(option.id, option.fallback);
  }
}

const word = (text, ...values) => d('LayersPanel', text, ...values);

/** The layers and their groups, the highest first. The buttons and the settings apply to the row that is chosen: that of the
 * current layer, on which the user draws, or another one whose name was pressed. */
export class LayersPanel {
  constructor(page) {
    this.page = page;
    this.chosen = null;  // { id } or { group }; null: the current layer
    this.list = make('ul');
    this.keys = make('div', { className: 'keys' });
    this.element = make('section', { id: 'layers', className: 'card', hidden: true }, this.list, this.keys);
  }

  show_words() {
    this.element.setAttribute('aria-label', t('Layers'));
    this.shown = null;
    const { page } = this;
    const button = (name, text, what) => icon_button(name, word(text), () => this.apply(what));
    this.add = icon_button('layer-add', word('Add a layer'), () => page.apply({ event: 'layer', do: 'add' }));
    this.rename = icon_button('rename', t('Rename the layer'), () => this.edit(), 'F2');
    this.group = icon_button('group', '', () => this.change_group());
    this.raise = button('raise', 'Raise the layer', 'raise');
    this.lower = button('lower', 'Lower the layer', 'lower');
    this.remove = button('layer-remove', 'Remove the layer', 'remove');
    this.opacity = make('input', { type: 'range', id: 'opacity', min: 0, max: 1, step: 0.01,
      onchange: () => this.apply('opacity', { opacity: Number(this.opacity.value) }) });
    this.blend = make('select', { id: 'blend', title: word('Multiply makes what is below darker, for shading on line art'),
      onchange: () => this.apply('blend', { mode: this.blend.value }) },
    ...['Normal', 'Multiply'].map((mode) => make('option', { value: mode.toLowerCase() }, word(mode))));
    this.keys.replaceChildren(this.add, this.rename, this.group, this.raise, this.lower, this.remove);
    const row = (text, control) => make('div', { className: 'row' }, make('label', { htmlFor: control.id }, t(text)), control);
    this.element.replaceChildren(header(page, 'layers', t('Layers')), row('Opacity', this.opacity), row('Blend mode', this.blend),
      this.list, this.keys);
  }

  show({ layers, groups, inkLayers }) {
    const current = layers.find((layer) => layer.current) ?? layers[0];
    const known = this.ink_layers ?? inkLayers;
    this.ink_layers = inkLayers;
    if (inkLayers > known) this.page.say(word('All layers were hidden or locked, so “%1” was added to draw on.', current.name));
    if (current.id !== this.current?.id) this.chosen = null;
    this.current = current;
    this.layers = layers;
    this.groups = groups ?? [];
    if (!this.row_of(this.chosen ?? {})) this.chosen = null;  // it is no longer there
    const key = JSON.stringify([layers, groups, this.chosen]);
    if (this.element.hidden || key === this.shown) return;
    if (this.edited && this.list.querySelector('input') && this.row_of(this.edited)) return;
    this.shown = key;
    const chosen = this.target();
    const [first, last] = this.range(chosen), at_end = (edge, next) => !next || (!chosen.group && edge.group > 0 && edge.group !== next.group);
    this.raise.disabled = at_end(layers[first], layers[first - 1]);
    this.lower.disabled = at_end(layers[last], layers[last + 1]);
    set_label(this.group, d('LayerActions', chosen.group ? 'Ungroup layers' : layers[first].group ? 'Take out of the group' : 'Group layers'));
    set_icon(this.group, chosen.group || layers[first].group ? 'ungroup' : 'group');
    const { opacity, blend } = this.row_of(chosen);
    this.opacity.value = opacity;
    this.blend.value = blend;
    const focus = this.focus_mark(), rows = [];
    layers.forEach((layer, i) => {
      const group = layer.group !== layers[i - 1]?.group && this.groups.find(({ id }) => id === layer.group);
      if (group) rows.push(this.item(group, { group: group.id }));
      rows.push(this.item(layer, { id: layer.id }));
    });
    this.list.replaceChildren(...rows);
    if (focus) this.list.querySelector(`[data-mark="${focus}"]`)?.focus();
  }

  /** Returns what the buttons and settings apply to, as in an event: { id } of a layer or { group }. */
  target() {
    return this.chosen ?? { id: this.current.id };
  }

  /** Returns the layer or group in the state of the core. */
  row_of({ id, group }) {
    return group ? this.groups.find((one) => one.id === group) : this.layers.find((one) => one.id === id);
  }

  /** Returns the positions of the first and the last layer of a target. */
  range({ id, group }) {
    const is_in = (layer) => (group ? layer.group === group : layer.id === id);
    return [this.layers.findIndex(is_in), this.layers.findLastIndex(is_in)];
  }

  apply(what, values = {}, target = this.target()) {
    this.page.apply({ event: 'layer', do: what, ...target, ...values });
  }

  /** Dissolves the chosen group, takes the chosen layer out of its group, or groups it with the one below. */
  change_group() {
    const { layers } = this, chosen = this.target();
    if (chosen.group) return this.apply('ungroup');
    const [at] = this.range(chosen), { id, group } = layers[at], below = layers[at + 1];
    // In events, the position of the lowest layer is 0.
    const index = (i) => layers.length - 1 - i;
    if (group) return this.apply('move', { group: 0, index: index(this.range({ group })[0]) }, { id });
    if (below?.group) return this.apply('move', { group: below.group, index: index(at) }, { id });
    return this.apply('group', { ids: below ? [id, below.id] : [id] }, {});
  }

  /** The control that has the focus, so that the new list gives the focus to the same one. */
  focus_mark() {
    return this.list.contains(document.activeElement) ? document.activeElement.dataset.mark : null;
  }

  /** Makes the row of a layer or a group; `target` names it. */
  item(row, target) {
    const { group } = target, mark = group ? `group-${group}` : `${row.id}`;
    const toggle = (name, icons, texts, on, [does, undoes]) => {
      const button = icon_button(icons[on ? 0 : 1], t(texts[on ? 0 : 1], row.name), () => this.apply(on ? does : undoes, {}, target));
      button.dataset.mark = `${name}-${mark}`;
      return button;
    };
    const eye = toggle('eye', ['eye', 'eye-off'], ['Hide “%1”', 'Show “%1”'], row.visible, ['hide', 'show']);
    const lock = toggle('lock', ['lock', 'unlock'], ['Unlock “%1”', 'Lock “%1”'], row.locked, ['unlock', 'lock']);
    const name = make('button', { type: 'button', className: 'name',
      title: group ? word('The group “%1”', row.name) : t('Draw on “%1”', row.name),
      onclick: () => this.choose(target), ondblclick: () => this.edit(target) }, row.name);
    if (!group) press(name, row.current);
    name.dataset.mark = `name-${mark}`;
    const chosen = this.target(), is_chosen = group ? chosen.group === group : chosen.id === row.id;
    const item = make('li', { className: [is_chosen && 'current', group && 'group', row.group && 'grouped'].filter(Boolean).join(' ') }, eye, name, lock);
    item.dataset.row = mark;
    if (is_chosen) item.ariaCurrent = 'true';
    return item;
  }

  /** Chooses a row. Its layer becomes the current one, unless it is hidden or locked. */
  choose(target) {
    const { page } = this, row = this.row_of(target);
    if (!row) return;  // the list is older than the drawing while a name is edited
    this.chosen = target;
    if (!target.group) {
      const group = this.groups.find(({ id }) => id === row.group), name = word('“%1”', row.name);
      if (row.locked || group?.locked) page.say(word('%1 is locked. Unlock it to draw there.', name));
      else if (!row.visible || group?.visible === false) page.say(word('%1 is hidden. Show it to draw there.', name));
      else page.apply({ event: 'layer', do: 'use', ...target });
    }
    this.show(page.core.state());
  }

  /** Replaces the name of a layer or group by a field. Enter keeps the new name, Escape the former one. */
  edit(target = this.target()) {
    const row = this.row_of(target);
    const name = this.list.querySelector(`[data-row="${target.group ? `group-${target.group}` : target.id}"] .name`);
    if (!name || !row) return;
    this.edited = target;
    const field = make('input', { value: row.name, maxLength: 100, 'aria-label': t('Name of the layer') });
    const end = (keeps) => {
      if (!field.isConnected) return;
      field.onblur = null;
      field.replaceWith(name);
      this.shown = this.edited = null;
      const text = field.value.trim();
      if (keeps && text && text !== row.name) this.apply('rename', { name: text }, target);
      this.page.wake();
      name.focus();
    };
    field.onkeydown = (event) => {
      event.stopPropagation();
      if (event.key === 'Enter' || event.key === 'Escape') end(event.key === 'Enter');
    };
    field.onblur = () => end(true);
    name.replaceWith(field);
    field.select();
  }
}
