// SPDX-License-Identifier: Apache-2.0
// Tables of numbers: knots, points, switches, and all numbers of a text; measured points.

/// A table of numbers as the server describes it: heads, and rows with a label, cells {key, value}, and the change that sets
/// a cell.
class NumberTable {
  /// `actions`: change(change, input), refuse(words), goTo(line).
  constructor(name, title, actions) {
    this.actions = actions;
    this.table = html('table', {className: 'numbers'});
    this.section = html('section', {id: name.replace(/\W+/g, '-')}, html('h2', {textContent: title}), html('div', {className: 'scroll', tabIndex: 0}, this.table));
    this.section.setAttribute('aria-label', title);
    this.shape = '';
  }

  take({heads, rows}) {
    const shape = JSON.stringify([heads, rows.map(({label, cells, remove}) => [label, cells.map(({key}) => key), remove !== null])]);
    this.rows = rows;
    if (shape !== this.shape) this.build(heads, shape);
    rows.forEach(({cells}, r) => cells.forEach(({value}, c) => {
      const input = this.inputs[r][c];
      input.removeAttribute('aria-invalid');
      const text = value === null ? '' : String(value);
      if (input !== document.activeElement || input.dataset.shown === input.value) input.value = text;
      input.dataset.shown = text;
    }));
  }

  build(heads, shape) {
    this.shape = shape;
    const {rows} = this;
    this.inputs = rows.map(({label, cells}, r) => cells.map(({key}, c) => {
      const input = html('input', {className: 'n', inputMode: 'decimal', disabled: key === null, 'aria-label': `${heads[c + 1]}: ${label}`});
      input.addEventListener('change', () => this.commit(input, r, c));
      input.addEventListener('keydown', (event) => this.key(event, input, r, c));
      return input;
    }));
    const removes = rows.some(({remove}) => remove !== null);
    this.table.classList.toggle('wide', heads.length > 6);
    this.table.replaceChildren(
      html('thead', {}, html('tr', {}, ...heads.map((text) => html('th', {scope: 'col', textContent: raisedUnit(text)})), ...(removes ? [html('th', {scope: 'col'})] : []))),
      html('tbody', {}, ...rows.map((row, r) => html('tr', {}, this.head(r), ...this.inputs[r].map((input) => html('td', {}, input)),
        ...(removes ? [html('td', {}, ...(row.remove ? [this.remover(r)] : []))] : [])))));
  }

  /// The label of a row; it goes to the line of the text.
  head(r) {
    const go = html('button', {type: 'button', className: 'go', textContent: raisedUnit(this.rows[r].label), onclick: () => this.actions.goTo(this.rows[r].line)});
    return html('th', {scope: 'row'}, go);
  }
  remover(r) {
    return html('button', {type: 'button', textContent: 'Remove', 'aria-label': `Remove ${this.rows[r].label}`, onclick: () => this.actions.change(this.rows[r].remove)});
  }

  commit(input, r, c) {
    const {cells, change} = this.rows[r], value = numberOf(input.value);
    if (Number.isNaN(value) || (value === null && change.do !== 'numbers')) {
      input.setAttribute('aria-invalid', 'true');
      return this.actions.refuse(`${input.getAttribute('aria-label')}: give a number`);
    }
    return this.actions.change({...change, [cells[c].key]: value}, input);
  }

  key(event, input, r, c) {
    if (event.key === 'Escape') input.value = input.dataset.shown;
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (step === undefined || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const next = this.inputs[r + step]?.[c];
    next?.focus();
    next?.select();
  }
}

/// All tables of a document, each in a section of its own.
class NumberTables {
  constructor(root, actions) {
    Object.assign(this, {root, actions, tables: new Map()});
  }
  take(list) {
    const kept = list.map(({name, title}) => this.tables.get(name + title) ?? new NumberTable(name, title, this.actions));
    this.tables = new Map(list.map(({name, title}, i) => [name + title, kept[i]]));
    const sections = kept.map(({section}) => section);
    if (sections.length !== this.root.children.length || sections.some((section, i) => section !== this.root.children[i])) this.root.replaceChildren(...sections);
    kept.forEach((table, i) => table.take(list[i]));
  }
}

// ---- measured points -----------------------------------------------------------------------------

/// The pairs of numbers of a CSV text: its first two columns. Lines without two numbers are skipped.
function pairsOf(text) {
  const pairs = [];
  for (const line of text.split(/\r?\n/)) {
    const cells = line.split(/[,;\t]/).map((cell) => cell.trim());
    const [x, y] = [Number(cells[0]), Number(cells[1])];
    if (cells.length > 1 && cells[0] !== '' && cells[1] !== '' && Number.isFinite(x) && Number.isFinite(y)) pairs.push([x, y]);
  }
  return pairs;
}

/// The units of the first two columns in the header of a CSV text; undefined: not stated in brackets.
function unitsOf(text) {
  const header = text.split(/\r?\n/).find((line) => line.trim() !== '' && !line.startsWith('#')) ?? '';
  return header.split(/[,;\t]/).slice(0, 2).map((cell) => /[[(]([^\])]+)[\])]/.exec(cell)?.[1].trim());
}

/// The greatest distance of the curve from the points, and its place; null: no point is on the curve.
function farthest(curve, points) {
  let most = null;
  if (curve instanceof Outline) return null;
  for (const [x, y] of points) {
    if (!curve.contains(x)) continue;
    const distance = Math.abs(curve.jet(x)[0] - y);
    if (!most || distance > most.distance) most = {distance, x};
  }
  return most;
}
