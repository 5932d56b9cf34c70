// SPDX-License-Identifier: Apache-2.0
// The interaction of a report: it replaces the still figure by one that the reader can zoom and read. Without this
// script, the page is complete.

/// An HTML element with properties; its children follow. Keys with a dash are attributes.
function html(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.includes('-') || key === 'role') element.setAttribute(key, value); else element[key] = value;
  }
  element.append(...children);
  return element;
}

/// The curves of a view, and the range of its x axis.
function prepared(view) {
  const curves = view.curves.map(curveOf);
  const exact = curves.every((curve) => curve instanceof Curve);
  const start = Math.min(...curves.map((curve) => curve.start)), end = Math.max(...curves.map((curve) => curve.end));
  const overlap = curves.length > 1 && Math.max(...curves.map((c) => c.start)) < Math.min(...curves.map((c) => c.end));
  return {...view, curves, start, end, difference: exact && overlap ? new Difference(...curves) : null};
}

/// The rows of the table at the cursor: for each panel, its quantity and the texts of value, before, difference, limit
/// and use of the limit. Where a value jumps, the texts show both sides: "0.05 → 0".
function valuesAt(view, x) {
  const before = view.curves[1];
  return view.panels.map((panel, k) => {
    const read = (curve) => !curve || curve instanceof Outline || !curve.contains(x) ? null : curve.sides(x).map((jet) => jet[k]);
    const text = (sides) => {
      if (sides === null) return '–';
      const [left, right] = sides.map((value) => number(shownValue(panel, value), cursor_digits));
      const jumps = Math.abs(sides[0] - sides[1]) / panel.size > panel.noise && left !== right;
      return jumps ? `${left} → ${right}` : right;
    };
    const sides = read(view.curves[0]), other = read(before);
    const shown = view.curves[0] instanceof Outline && view.curves[0].contains(x)
      ? view.curves[0].range(x, k).map((y) => number(shownValue(panel, y), cursor_digits)).join(' … ') : text(sides);
    const uses = (sides ?? []).map((value) => {
      const limit = value < 0 ? panel.lower : panel.upper;
      return {limit, share: limit === null || limit === 0 ? -1 : shownValue(panel, value) / limit};
    });
    const {limit, share} = uses.reduce((most, use) => use.share >= most.share ? use : most, {limit: null, share: -1});
    return {
      quantity: panel.name, unit: panel.unit, value: shown,
      before: before ? text(other) : '',
      difference: before ? text(sides === null || other === null ? null : sides.map((value, i) => value - other[i])) : '',
      limit: limit === null ? '' : number(limit),
      use: share < 0 || k === 0 ? '' : `${number(100 * share, 4)} %`,
    };
  });
}

/// The name of the segment at x.
const segmentAt = (view, x) => (view.segments.find(([a, b]) => x >= a && x < b) ?? view.segments.find(([, b]) => x === b) ?? [])[2];

class Report {
  constructor(figure, data, id) {
    this.figure = figure;
    this.build(id);
    this.replace(data);
    this.render();
    this.box.hidden = false;
    figure.classList.add('live');  // only now: after an error, the still figure stays
    new ResizeObserver(() => this.change()).observe(this.plot);
  }

  build(id) {
    const button = (text, title, act) => html('button', {type: 'button', textContent: text, title, onclick: act});
    this.switchers = [];
    this.differing = html('button', {type: 'button', textContent: 'difference', title: 'Draws the motion minus the motion before (d)', onclick: () => this.toggleDifference()});
    this.tools = html('div', {className: 'tools', role: 'toolbar', 'aria-label': 'Picture'},
      this.differing,
      button('−', 'Zoom out (−)', () => this.zoom(2)), button('+', 'Zoom in (+)', () => this.zoom(0.5)), button('whole', 'Shows the whole motion (0)', () => this.whole()));
    this.svg = svg('svg', {class: 'jf', id: `picture-${id}`, 'aria-hidden': 'true'});
    this.plot = html('div', {className: 'plot', tabIndex: 0, role: 'slider', 'aria-describedby': `keys-${id}`}, this.svg);
    this.place = html('caption');
    this.table = html('tbody');
    this.heads = html('tr');
    this.readout = html('div', {className: 'scroll', tabIndex: 0}, html('table', {className: 'at'}, this.place, html('thead', {}, this.heads), this.table));
    const keys = html('p', {className: 'keys', id: `keys-${id}`,
      textContent: 'Move the pointer, or use the keys: ← → cursor, Page Up and Page Down next joint, + − zoom, Shift with ← → pan, 0 whole. ' +
        'The wheel zooms after a click into the picture, or with Ctrl. Two fingers zoom and pan; dragging pans.'});
    this.note = html('p', {className: 'keys'});
    this.box = html('div', {className: 'live', hidden: true}, this.tools, this.plot, this.note, this.readout, keys);
    this.figure.prepend(this.box);
    this.listen();
  }

  get view() { return this.views[this.index]; }

  /// Shows other data. If it has the same axis, the cursor and a part that is zoomed stay.
  replace(data) {
    const old = this.views?.[this.index], {from, to, x} = this;
    this.name = data.name;
    this.views = data.views.map(prepared);
    for (const button of this.switchers) button.remove();
    this.switchers = this.views.map((view, i) => html('button', {type: 'button', textContent: `over ${view.axis.replace(/ \[.*/, '')}`, onclick: () => this.show(i)}));
    if (this.views.length > 1) this.tools.prepend(...this.switchers);
    this.show(old && this.views[this.index]?.axis === old.axis ? this.index : 0);
    if (old?.axis !== this.view.axis) return;
    this.x = clamped(x, this.view.start, this.view.end);
    if (from !== old.start || to !== old.end) this.window(from, to);
  }

  show(index) {
    this.index = index;
    const view = this.view;
    Object.assign(this, {from: view.start, to: view.end, x: view.start, piece: null});
    this.difference = this.difference && view.difference !== null;
    this.differing.hidden = view.difference === null;
    this.switchers.forEach((button, i) => button.setAttribute('aria-pressed', i === index));
    const [first] = view.curves;
    this.note.hidden = !(first instanceof Outline);
    this.note.textContent = first instanceof Outline
      ? `The curve has ${first.pieceCount} segments. The picture shows the exact least and greatest values of ${first.count} blocks of segments.` : '';
    this.heads.replaceChildren(...['quantity', 'value', ...(view.curves.length > 1 ? [view.curves[1].label, 'difference'] : []), 'unit', 'limit', 'used']
      .map((text, i) => html('th', {scope: 'col', textContent: text, className: i > 0 && text !== 'unit' ? 'n' : ''})));
    this.rows = view.panels.map((panel) => html('tr', {}, html('th', {scope: 'row', textContent: panel.name}),
      ...Array.from({length: this.heads.children.length - 1}, (_, i) => html('td', {className: this.heads.children[i + 1].className}))));
    this.table.replaceChildren(...this.rows);
    const extremes = view.panels.map((panel) => panel.marks.slice(0, 2).map(([x, y]) => `${panel.name} ${number(y)} ${panel.unit} at ${number(x)} ${view.unit}`).join(', '));
    this.plot.setAttribute('aria-label', `Cursor over the curve of ${this.name}. ${extremes.join('; ')}`);
    this.plot.setAttribute('aria-valuemin', view.start);
    this.plot.setAttribute('aria-valuemax', view.end);
    this.change();
  }

  toggleDifference() {
    this.difference = !this.difference && this.view.difference !== null;
    this.change();
  }

  /// Draws in the next frame.
  change() {
    this.redraw = true;
    this.moved();
  }
  moved() {
    this.frame ??= requestAnimationFrame(() => this.render());
  }

  render() {
    this.frame = null;
    if (this.redraw || !this.drawing) {
      const width = Math.max(300, this.plot.clientWidth || 860);
      this.differing.setAttribute('aria-pressed', Boolean(this.difference));
      this.drawing = draw(this.svg, this.view, this, width);
      this.decorate();
      this.scale = width;
      this.redraw = false;
    }
    drawCursor(this.drawing, this.difference ? [this.view.difference] : this.view.curves, this.x);
    const name = segmentAt(this.view, this.x);
    const place = `at ${number(this.x, cursor_digits)} ${this.view.unit}${name ? `, segment ${name}` : ''}`;
    const values = valuesAt(this.view, this.x);
    this.place.textContent = place;
    values.forEach((row, k) => {
      const texts = [row.value, ...(this.view.curves.length > 1 ? [row.before, row.difference] : []), row.unit, row.limit, row.use];
      texts.forEach((text, i) => { this.rows[k].children[i + 1].textContent = text; });
    });
    this.plot.setAttribute('aria-valuenow', this.x);
    this.plot.setAttribute('aria-valuetext', `${place}: ${values.map((row) => `${row.quantity} ${row.value} ${row.unit}`).join(', ')}`);
  }

  /// Adds to a new drawing; for pages that extend this class.
  decorate() {}

  /// Shows [from, to], within the motion and not narrower than rounding permits.
  window(from, to) {
    const {start, end} = this.view;
    const least = 1e-9 * Math.max(end - start, Math.abs(start), Math.abs(end));
    const span = clamped(to - from, least, end - start);
    this.from = clamped((from + to - span) / 2, start, end - span);
    this.to = this.from + span;
    if (span === end - start) [this.from, this.to] = [start, end];
    this.change();
  }
  whole() { this.window(this.view.start, this.view.end); }
  zoom(factor, at = clamped(this.x, this.from, this.to)) {
    this.window(at - (at - this.from) * factor, at + (this.to - at) * factor);
  }
  pan(share) {
    const step = share * (this.to - this.from);
    const moved = clamped(step, this.view.start - this.from, this.view.end - this.to);
    this.window(this.from + moved, this.to + moved);
  }
  /// Moves the cursor; the window follows a cursor that would leave it.
  moveTo(x, alone = false) {
    for (const other of alone ? [] : this.others ?? []) if (other.view.axis === this.view.axis) other.moveTo(x, true);
    this.x = clamped(x, this.view.start, this.view.end);
    if (this.x < this.from || this.x > this.to) this.pan((this.x - clamped(this.x, this.from, this.to)) / (this.to - this.from));
    this.moved();
  }
  /// The next joint of the curves in a direction.
  joint(direction) {
    const {breaks} = this.view.curves[0];
    const i = intervalAt(breaks, this.x);
    this.moveTo(direction > 0 ? breaks[i + 1] : breaks[i] < this.x ? breaks[i] : breaks[Math.max(i - 1, 0)]);
  }

  valueAt(event) {
    const box = this.svg.getBoundingClientRect();
    return clamped(this.drawing.toValue((event.clientX - box.left) / box.width * this.scale), this.from, this.to);
  }

  listen() {
    const step = () => (this.to - this.from) / 400;
    const keys = {
      ArrowLeft: (e) => e.shiftKey ? this.pan(-0.1) : this.moveTo(this.x - step()),
      ArrowRight: (e) => e.shiftKey ? this.pan(0.1) : this.moveTo(this.x + step()),
      ArrowDown: () => this.moveTo(this.x - 10 * step()), ArrowUp: () => this.moveTo(this.x + 10 * step()),
      PageDown: () => this.joint(1), PageUp: () => this.joint(-1),
      Home: () => this.moveTo(this.view.start), End: () => this.moveTo(this.view.end),
      '+': () => this.zoom(0.5), '=': () => this.zoom(0.5), '-': () => this.zoom(2), '0': () => this.whole(),
      d: () => this.toggleDifference(),
    };
    this.plot.addEventListener('keydown', (event) => {
      const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
      if (!act) return;
      event.preventDefault();
      act(event);
    });
    this.plot.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && document.activeElement !== this.plot) return;  // the page scrolls
      event.preventDefault();
      if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) this.pan(event.deltaX / 1000);
      else this.zoom(Math.exp(clamped(event.deltaY, -200, 200) / 300), this.valueAt(event));
    }, {passive: false});
    this.plot.addEventListener('dblclick', () => this.whole());
    this.pointers = new Map();
    this.plot.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;  // the menu of the right button may take its release
      this.pointers.set(event.pointerId, event.clientX);
      this.plot.setPointerCapture(event.pointerId);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) this.plot.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    this.plot.addEventListener('pointermove', (event) => this.pointed(event));
  }

  /// One pointer moves the cursor, or pans with the button of a mouse; two fingers zoom and pan.
  pointed(event) {
    const last = this.pointers.get(event.pointerId);
    if (last !== undefined) this.pointers.set(event.pointerId, event.clientX);
    const plotted = (this.drawing.right - this.drawing.left) / this.scale * this.svg.getBoundingClientRect().width;
    if (this.pointers.size === 2 && last !== undefined) {
      const [other] = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, x]) => x);
      const [before, now] = [Math.abs(last - other), Math.abs(event.clientX - other)];
      if (before > 10 && now > 10) this.zoom(before / now, this.valueAt({clientX: (last + other) / 2}));
      this.pan((last - event.clientX) / 2 / plotted);
    } else if (last !== undefined && event.pointerType === 'mouse') {
      this.pan((last - event.clientX) / plotted);
    }
    if (this.pointers.size < 2) this.moveTo(this.valueAt(event));
  }

  /// Shows a place of a table: a range, or a point with its surroundings.
  goTo(from, to) {
    if (this.index !== 0) this.show(0);
    const {start, end} = this.view;
    const around = to > from ? 0.05 * (to - from) : 0.06 * (end - start);
    this.x = clamped(from, start, end);
    this.window(from - around, to + around);
    this.plot.focus({preventScroll: true});
    this.box.scrollIntoView({block: 'nearest'});
  }
  highlight(piece) {
    if (this.index !== 0) return;
    this.piece = piece;
    this.change();
  }

  /// Connects the rows of tables that have a place.
  link(rows) {
    for (const row of rows) {
      const [from, to] = [Number(row.dataset.from), Number(row.dataset.to)];
      const cell = [...row.cells].find((each) => each.textContent && !each.classList.contains('m'));
      if (!cell) continue;
      cell.replaceChildren(html('button', {type: 'button', className: 'go', textContent: cell.textContent, title: 'Shows this place in the picture',
        onclick: () => this.goTo(from, to)}));
      for (const [event, piece] of [['pointerenter', [from, to]], ['focusin', [from, to]], ['pointerleave', null], ['focusout', null]])
        row.addEventListener(event, () => this.highlight(piece));
    }
  }
}

/// Starts the reports of the page: one for each axis. The tables below a report have its places, and all reports have one
/// cursor.
function start() {
  const reports = [...document.querySelectorAll('figure > script[type="application/json"]')]
    .map((script, id) => new Report(script.parentElement, JSON.parse(script.textContent), id));
  const follows = (row, report) => report.figure.compareDocumentPosition(row) & Node.DOCUMENT_POSITION_FOLLOWING;
  const rows = [...document.querySelectorAll('tr[data-from]')];
  reports.forEach((report, i) => {
    report.others = reports.filter((other) => other !== report);
    report.link(rows.filter((row) => follows(row, report) && !(i + 1 < reports.length && follows(row, reports[i + 1]))));
  });
  return reports;
}

if (typeof document !== 'undefined') start();
