// SPDX-License-Identifier: Apache-2.0
// Points of segments and switches as tables; measured points; the gallery of a new file.

/// A table of numbers. `rows`: [label, [[heading, value or null], ...], change(values)].
class NumberTable {
  /// `actions`: change(change, input), refuse(words).
  constructor(section, actions) {
    this.section = section;
    this.actions = actions;
    this.shape = '';
  }

  take(heads, rows) {
    this.section.hidden = rows.length === 0;
    const shape = JSON.stringify([heads, rows.map(([label, values]) => [label, values.map((value) => value === null)])]);
    if (shape !== this.shape) this.build(heads, rows, shape);
    rows.forEach(([, values, change], r) => {
      this.inputs[r].change = change;
      values.forEach((value, c) => {
        const input = this.inputs[r][c];
        input.removeAttribute('aria-invalid');
        const text = value === null ? '' : String(value);
        if (input !== document.activeElement || input.dataset.shown === input.value) input.value = text;
        input.dataset.shown = text;
      });
    });
  }

  build(heads, rows, shape) {
    this.shape = shape;
    this.inputs = rows.map(([label, values]) => values.map((value, c) => {
      const input = html('input', {className: 'n', inputMode: 'decimal', disabled: value === null, 'aria-label': `${heads[c + 1]}: ${label}`});
      input.addEventListener('change', () => this.commit(input));
      return input;
    }));
    this.section.querySelector('table').replaceChildren(
      html('thead', {}, html('tr', {}, ...heads.map((text) => html('th', {scope: 'col', textContent: text})))),
      html('tbody', {}, ...rows.map(([label], r) => html('tr', {}, html('th', {scope: 'row', textContent: label}), ...this.inputs[r].map((input) => html('td', {}, input))))));
  }

  commit(input) {
    const row = this.inputs.find((inputs) => inputs.includes(input));
    const value = numberOf(input.value);
    if (value === null || Number.isNaN(value)) {
      input.setAttribute('aria-invalid', 'true');
      return this.actions.refuse(`${input.getAttribute('aria-label')}: give a number`);
    }
    return this.actions.change(row.change(row.map((each) => each.disabled ? null : Number(each.value))), input);
  }
}

/// The rows of the points of all segments.
const pointRows = ({segments}) => segments.flatMap(({through, name}, i) => (through ?? []).map(([master, slave], k) => [
  `${k + 1} of segment ${i + 1}${name ? ` ${name}` : ''}`, [master, slave],
  ([x, y]) => ({do: 'point', segment: i + 1, point: k + 1, master: x, slave: y ?? 0})]));

const switchRowsOf = ({switches}) => switches.map(({track, first, last}, i) => [
  `switch ${i + 1}, track ${track}`, [first, last], ([x, y]) => ({do: 'switch', switch: i + 1, first: x, last: y})]);

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
