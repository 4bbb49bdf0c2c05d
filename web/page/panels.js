// The panels: options of the tool, and layers.
import { make, icon_button } from './dom.js';
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

/** The layers, the highest first. */
export class LayersPanel {
  constructor(page) {
    this.page = page;
    this.list = make('ul');
    this.keys = make('div', { className: 'keys' });
    this.element = make('section', { id: 'layers', className: 'card', hidden: true }, this.list, this.keys);
  }

  show_words() {
    this.element.setAttribute('aria-label', t('Layers'));
    this.shown = null;
    const { page } = this;
    const act = (what) => () => page.apply({ event: 'layer', do: what, id: this.current.id });
    const button = (name, text, what) => icon_button(name, d('LayersPanel', text), act(what));
    this.add = icon_button('layer-add', d('LayersPanel', 'Add a layer'), () => page.apply({ event: 'layer', do: 'add' }));
    this.rename = icon_button('rename', t('Rename the layer'), () => this.edit(this.current), 'F2');
    this.raise = button('raise', 'Raise the layer', 'raise');
    this.lower = button('lower', 'Lower the layer', 'lower');
    this.remove = button('layer-remove', 'Remove the layer', 'remove');
    this.opacity = make('input', { type: 'range', id: 'opacity', min: 0, max: 1, step: 0.01,
      onchange: () => page.apply({ event: 'layer', do: 'opacity', id: this.current.id, opacity: Number(this.opacity.value) }) });
    this.keys.replaceChildren(this.add, this.rename, this.raise, this.lower, this.remove);
    this.element.replaceChildren(header(page, 'layers', t('Layers')),
      make('div', { className: 'row' }, make('label', { htmlFor: 'opacity' }, d('LayersPanel', 'Opacity of the layer')), this.opacity),
      this.list, this.keys);
  }

  show({ layers }) {
    this.current = layers.find((layer) => layer.current) ?? layers[0];
    const key = JSON.stringify(layers);
    if (this.element.hidden || key === this.shown) return;
    if (this.edited && this.list.querySelector('input') && layers.some(({ id }) => id === this.edited)) return;
    this.shown = key;
    const at = layers.indexOf(this.current);
    this.raise.disabled = at === 0;
    this.lower.disabled = at === layers.length - 1;
    this.opacity.value = this.current.opacity;
    const focus = this.focus_mark();
    this.list.replaceChildren(...layers.map((layer) => this.item(layer)));
    if (focus) this.list.querySelector(`[data-mark="${focus}"]`)?.focus();
  }

  /** The control that has the focus, so that the new list gives the focus to the same one. */
  focus_mark() {
    return this.list.contains(document.activeElement) ? document.activeElement.dataset.mark : null;
  }

  item(layer) {
    const { page } = this, act = (what) => page.apply({ event: 'layer', do: what, id: layer.id });
    const eye = icon_button(layer.visible ? 'eye' : 'eye-off', t(layer.visible ? 'Hide “%1”' : 'Show “%1”', layer.name),
      () => act(layer.visible ? 'hide' : 'show'));
    eye.dataset.mark = `eye-${layer.id}`;
    const name = make('button', { type: 'button', className: 'name', title: t('Draw on “%1”', layer.name),
      'aria-pressed': String(layer.current), onclick: () => act('use'), ondblclick: () => this.edit(layer) }, layer.name);
    name.dataset.mark = `name-${layer.id}`;
    const item = make('li', { className: layer.current ? 'current' : '' }, eye, name);
    item.dataset.layer = layer.id;
    return item;
  }

  /** Replaces the name of the layer by a field. Enter keeps the new name, Escape the former one. */
  edit(layer) {
    const item = this.list.querySelector(`[data-layer="${layer.id}"]`), name = item?.querySelector('.name');
    if (!name) return;
    this.edited = layer.id;
    const field = make('input', { value: layer.name, maxLength: 100, 'aria-label': t('Name of the layer') });
    const end = (keeps) => {
      if (!field.isConnected) return;
      field.onblur = null;
      field.replaceWith(name);
      this.shown = this.edited = null;
      const text = field.value.trim();
      if (keeps && text && text !== layer.name) this.page.apply({ event: 'layer', do: 'rename', id: layer.id, name: text });
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
