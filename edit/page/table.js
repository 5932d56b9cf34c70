// SPDX-License-Identifier: Apache-2.0
// The table of segments: the numbers of the cam for the keyboard.

/// The number of a text; null for an empty one, NaN for none.
const numberOf = (text) => text.trim() === '' ? null : /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text.trim()) ? Number(text) : NaN;

class SegmentTable {
  /// `actions`: change(change), laws(segment), show(from, to), hover(range or null).
  constructor(table, actions) {
    this.table = table;
    this.actions = actions;
    this.rows = [];
    this.body = html('tbody');
    this.heads = html('tr');
    this.table.append(html('thead', {}, this.heads), this.body);
    this.body.addEventListener('keydown', (event) => this.key(event));
  }

  /// Shows a cam. `laws`: the laws for the list; `view`: the view of the curve, for derivatives that the text leaves out.
  take(cam, laws, view) {
    this.cam = cam;
    const {units} = cam;
    this.heads.replaceChildren(...['', 'name', 'law', `master [${units.master}]`, `slave [${units.slave}]`, `velocity [${raisedUnit(units.geo_velocity)}]`,
      `acceleration [${raisedUnit(units.geo_acceleration)}]`, 'form', ''].map((text) => html('th', {scope: 'col', textContent: text})));
    if (this.rows.length !== cam.knots.length || this.laws !== laws) {
      const focused = this.placeOf(document.activeElement);
      this.laws = laws;
      this.rows = cam.knots.map((_, k) => this.row(k));
      this.body.replaceChildren(...this.rows.map(({element}) => element));
      if (focused) this.cells(Math.min(focused.row, this.rows.length - 1))[focused.column]?.focus();
    }
    cam.knots.forEach((knot, k) => this.fill(k, knot, view));
  }

  row(k) {
    const name = k === 0 ? 'start' : `segment ${k}`;
    const field = (key, commit) => {
      const input = html('input', {className: key === 'name' ? 'name' : 'n', 'aria-label': `${key.replace('geo_', '')} of ${k === 0 ? 'the start' : name}`});
      if (key !== 'name') input.inputMode = 'decimal';
      input.addEventListener('change', () => commit(input));
      return input;
    };
    const number = (key, required) => field(key, (input) => {
      const value = numberOf(input.value);
      if (Number.isNaN(value) || (required && value === null)) return this.refuse(input, required && value === null ? 'give a number' : 'not a number: write 12.5 or 1e-3');
      this.actions.change({do: 'set', knot: k, key, value}, input);
    });
    const inputs = {master: number('master', true), slave: number('slave', true), geo_velocity: number('geo_velocity'), geo_acceleration: number('geo_acceleration')};
    const numbers = Object.values(inputs).map((input) => html('td', {}, input));
    const head = html('th', {scope: 'row'});
    if (k === 0) return {inputs, element: html('tr', {}, html('th', {scope: 'row', textContent: 'start'}), html('td'), html('td'), ...numbers, html('td'), html('td'))};
    inputs.name = field('name', (input) => this.actions.change({do: 'name', segment: k, name: input.value}, input));
    const law = html('select', {'aria-label': `law of ${name}`}, ...this.laws.map(({name: word, title, text}) => html('option', {value: word, textContent: text ? `${title} – ${text}` : title})));
    law.addEventListener('change', () => this.actions.change({do: 'law', segment: k, law: law.value}, law));
    const form = html('td', {className: 'form'});
    const act = (text, title, change) => html('button', {type: 'button', textContent: text, title, 'aria-label': `${title}: ${name}`, onclick: () => this.actions.change(change)});
    const go = html('button', {type: 'button', className: 'go', textContent: k, title: 'Shows the segment in the picture and in the text', 'aria-label': `show ${name}`});
    go.addEventListener('click', () => this.actions.show(k));
    const buttons = html('td', {className: 'act'},
      html('button', {type: 'button', textContent: 'Laws', title: 'Compare the laws', 'aria-label': `compare laws: ${name}`, onclick: () => this.actions.laws(k)}), ' ',
      act('Merge', 'Merge with the next segment', {do: 'merge', segment: k}), ' ', act('Delete', 'Delete', {do: 'delete', segment: k}));
    head.append(go);
    const element = html('tr', {}, head, html('td', {}, inputs.name), html('td', {}, law), ...numbers, form, buttons);
    for (const [event, on] of [['pointerenter', true], ['focusin', true], ['pointerleave', false], ['focusout', false]])
      element.addEventListener(event, () => { element.classList.toggle('on', on); this.actions.hover(on ? k : null); });
    return {inputs, law, form, element, buttons};
  }

  fill(k, knot, view) {
    const {inputs, law, form, buttons} = this.rows[k];
    const set = (input, value) => {
      input.removeAttribute('aria-invalid');
      input.title = '';
      if (input !== document.activeElement || input.dataset.shown === input.value) input.value = value;
      input.dataset.shown = value;
    };
    const text = (value) => value === null ? '' : String(value);
    for (const key of ['master', 'slave', 'geo_velocity', 'geo_acceleration']) set(inputs[key], text(knot[key]));
    const curve = view?.curves[0];
    const exact = curve && !(curve instanceof Outline) && curve.contains(knot.master) ? curve.sides(knot.master)[k === 0 ? 1 : 0] : null;
    [['geo_velocity', 1, knot.sets_velocity], ['geo_acceleration', 2, knot.sets_acceleration]].forEach(([key, order, sets]) => {
      inputs[key].placeholder = exact ? number(withoutRounding(view.panels[order], exact[order])) : '';
      inputs[key].readOnly = !sets && knot[key] === null;
      if (inputs[key].readOnly) inputs[key].title = 'the laws beside this knot give this value';
    });
    if (k === 0) return;
    const segment = this.cam.segments[k - 1];
    set(inputs.name, segment.name);
    law.value = segment.law;
    buttons.children[1].disabled = k === this.cam.segments.length;
    buttons.children[2].disabled = this.cam.segments.length === 1;
    const shape = JSON.stringify([segment.law, segment.inflection, segment.straight, segment.shares, segment.points]);
    if (form.dataset.shape === shape) return;
    form.dataset.shape = shape;
    form.replaceChildren(...this.formOf(k, segment));
  }

  /// The shape parameters that the law accepts.
  formOf(k, segment) {
    if (segment.points > 0) return [`${segment.points} points`];
    const info = this.laws.find(({name: word}) => word === segment.law);
    const fields = [];
    const field = (key, sign, value, read) => {
      const input = html('input', {className: 'n', value: value ?? '', placeholder: sign, title: key, 'aria-label': `${key} of segment ${k}`});
      input.addEventListener('change', () => {
        const given = read(input.value);
        if (given === undefined) return this.refuse(input, 'not a number');
        this.actions.change({do: 'form', segment: k, key, value: given}, input);
      });
      fields.push(input);
    };
    const one = (text) => { const value = numberOf(text); return Number.isNaN(value) ? undefined : value; };
    if (info?.inflection) field('inflection', 'inflection', segment.inflection, one);
    if (['scca', 'modified_constant_velocity', 'sine_straight'].includes(segment.law)) field('straight', 'straight', segment.straight, one);
    if (segment.law === 'scca')
      field('shares', '1/4, 1/2, 1/4', segment.shares?.join(', '), (text) => {
        const list = text.split(',').map(numberOf);
        return list.length === 3 && list.every((value) => value !== null && !Number.isNaN(value)) ? list : undefined;
      });
    return fields;
  }

  refuse(input, reason) {
    input.setAttribute('aria-invalid', 'true');
    input.title = reason;
    this.actions.refuse(`${input.getAttribute('aria-label')}: ${reason}`);
  }

  cells(row) { return [...this.rows[row].element.querySelectorAll('input,select')]; }
  placeOf(element) {
    const row = this.rows.findIndex((each) => each.element.contains(element));
    return row < 0 ? null : {row, column: this.cells(row).indexOf(element)};
  }

  key(event) {
    const place = this.placeOf(event.target);
    if (!place || event.target.tagName !== 'INPUT' || event.ctrlKey || event.metaKey) return;
    if (event.key === 'Escape') event.target.value = event.target.dataset.shown;
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (step === undefined) return;
    const label = event.target.getAttribute('aria-label').split(' of ')[0];
    const next = this.rows[place.row + step]?.element.querySelector(`input[aria-label^="${label} of"]`);
    event.preventDefault();
    next?.focus();
    next?.select();
  }
}

/// A unit with raised powers: mm/deg².
const raisedUnit = (unit) => unit.replace(/\^(-?\d+)/g, (_, power) => raised(power));
