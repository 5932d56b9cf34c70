// SPDX-License-Identifier: Apache-2.0
// The plane of two axes, or of two coordinates of a group: the planned path, the path of the last seconds, and the present
// place.

const path_s = 10;
const plane_box = {left: 52, right: 8, top: 6, bottom: 34};

/// The place of a planned path at a length; null: outside.
function placeAt({at, places}, length) {
  if (at.length === 0 || length < at[0] || length > at.at(-1)) return null;
  let low = 0, high = at.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (at[middle] <= length) low = middle; else high = middle;
  }
  const share = at[high] > at[low] ? (length - at[low]) / (at[high] - at[low]) : 0;
  return places.map((place) => place[low] + share * (place[high] - place[low]));
}

class PathPlane {
  constructor(section) {
    this.section = section;
    const part = (name) => section.querySelector(`[data-path=${name}]`);
    this.of = part('of');
    this.selects = [part('x'), part('y')];
    this.facts = part('facts');
    this.canvas = section.querySelector('canvas');
    this.chosen = null;      // what the reader has chosen in the list "of"
    this.seen = new Map();   // by axis or group: {places: Map of the tick to the position, or to the place of the tool}
    this.plans = new Map();  // by group: the last answer of /path
    this.units = () => '';   // the unit of an axis
    this.of.addEventListener('change', () => { this.chosen = this.of.value; this.choose(); });
    for (const select of this.selects) select.addEventListener('change', () => this.draw());
    new IntersectionObserver((seen) => { this.visible = seen.at(-1).isIntersecting; }).observe(section);
    this.run();
  }

  /// Takes the axes of an event. A group is offered when its status has arrived.
  offer(axes) {
    const groups = axes.filter(({group}) => group?.axes.length > 1).map(({name, group}) => ({
      name, names: this.isTool(name, group.axes) ? this.plans.get(name)?.names ?? group.axes : group.axes}));
    const single = axes.filter(({group}) => !group).map(({name}) => name);
    if (single.length > 1) groups.push({name: '', names: single});
    const shape = JSON.stringify(groups);
    this.section.hidden = groups.length === 0;
    if (shape === this.shape) return;
    if (groups.some(({name}) => name !== '')) document.getElementById('axes').before(this.section);  // first what moves the axes
    this.shape = shape;
    this.groups = groups;
    this.of.replaceChildren(...groups.map(({name}) => new Option(name ? `group ${name}` : 'two axes', name)));
    if (groups.some(({name}) => name === this.chosen)) this.of.value = this.chosen;
    this.of.closest('label').hidden = groups.length < 2;
    this.choose();
  }

  get group() { return this.groups?.find(({name}) => name === this.of.value); }

  choose() {
    this.selects.forEach((select, k) => {
      select.replaceChildren(...(this.group?.names ?? []).map((name) => new Option(name)));
      select.selectedIndex = k;
    });
    this.draw();
  }

  async run() {
    for (;;) {
      await new Promise((resolve) => setTimeout(resolve, 2 * turn_ms));
      if (!this.visible || document.hidden || !this.group) continue;
      try {
        await this.update();
        this.draw();
      } catch (error) { /* the next turn tries it again */ }
    }
  }

  async update() {
    const {name, names} = this.group;
    if (name) {
      const plan = await question('/path', {axis: name, seen: this.plans.get(name)?.number ?? 0});
      if (plan.at || plan.number === 0) this.plans.set(name, plan);
    }
    if (this.isTool(name, names)) return this.updateTool(name);
    for (const select of this.selects) await this.updateAxis(select.value, ({low}, i) => low.position[i]);
    return undefined;
  }

  /// True if the coordinates of a group are not axes: they are those of its tool.
  isTool(name, names) { return name !== '' && names.some((axis) => !axes.has(axis)); }

  /// The tool is on the planned path, at the position of its group.
  updateTool(name) {
    const plan = this.plans.get(name);
    return this.updateAxis(name, ({low}, i) => plan?.at ? placeAt(plan, low.position[i] - plan.origin) : null);
  }

  /// Adds the ticks since the last call.
  async updateAxis(name, placeOf) {
    const kept = this.seen.get(name) ?? {places: new Map()};
    this.seen.set(name, kept);
    const data = await question('/trace', {axis: name, span: kept.when ? Math.min(path_s, (Date.now() - kept.when) / 1e3 + 0.3) : path_s, buckets: 0});
    kept.when = Date.now();
    if (kept.places.size && !(data.newest >= kept.newest)) kept.places.clear();  // the executor was started again
    kept.newest = data.newest;
    data.ticks.forEach((tick, i) => {
      const place = placeOf(data, i);
      if (place !== null && !kept.places.has(tick)) kept.places.set(tick, place);
    });
    kept.actual = data.low?.['actual position']?.at(-1);
    for (const tick of kept.places.keys()) {
      if (tick >= data.newest - path_s / data.period) break;
      kept.places.delete(tick);
    }
  }

  /// The set places of the last seconds, and the actual place (null: not known), in the two shown coordinates.
  trail() {
    const {name, names} = this.group, shown = this.selects.map((select) => select.value);
    if (this.isTool(name, names)) {
      const known = this.plans.get(name)?.names ?? [], [a, b] = shown.map((coordinate) => known.indexOf(coordinate));
      return {places: a < 0 || b < 0 ? [] : [...this.seen.get(name)?.places.values() ?? []].map((place) => [place[a], place[b]]), actual: null};
    }
    const [a, b] = shown.map((axis) => this.seen.get(axis)), places = [];
    if (!a || !b) return {places, actual: null};
    for (const [tick, x] of a.places) if (b.places.has(tick)) places.push([x, b.places.get(tick)]);
    const actual = [a.actual, b.actual];
    return {places, actual: actual.every((value) => typeof value === 'number') ? actual : null};
  }

  /// The planned path in the two shown coordinates.
  planned() {
    const plan = this.plans.get(this.group.name);
    if (!plan?.at?.length) return [];
    const [a, b] = this.selects.map((select) => plan.names.indexOf(select.value));
    return a < 0 || b < 0 ? [] : plan.at.map((_, i) => [plan.places[a][i], plan.places[b][i]]);
  }

  unitOf(coordinate) { return this.units(coordinate) || this.plans.get(this.group.name)?.unit || ''; }

  /// The scales of the plane: the same on both axes if their units are the same.
  scales(places, box, units) {
    const {left, right, top, bottom} = plane_box, sizes = [box.width - left - right, box.height - top - bottom];
    const ends = [0, 1].map((k) => places.reduce(([low, high], place) => [Math.min(low, place[k]), Math.max(high, place[k])], [Infinity, -Infinity]));
    const spans = ends.map(([low, high]) => Math.max(high - low, 1e-9) * 1.1);
    const per_px = spans.map((span, k) => span / sizes[k]);
    if (units[0] === units[1]) per_px.fill(Math.max(...per_px));
    const middle = ends.map(([low, high]) => (low + high) / 2);
    return {
      low: middle.map((value, k) => value - per_px[k] * sizes[k] / 2), high: middle.map((value, k) => value + per_px[k] * sizes[k] / 2),
      x: (v) => left + sizes[0] / 2 + (v - middle[0]) / per_px[0], y: (v) => top + sizes[1] / 2 - (v - middle[1]) / per_px[1],
      left, right: box.width - right, top, bottom: box.height - bottom, steps: per_px.map((scale) => step(scale * sizes[1], 5)),
    };
  }

  draw() {
    if (!this.group) return;
    const planned = this.planned(), {places, actual} = this.trail(), all = [...planned, ...places];
    const surface = all.length > 0 ? ink_of(this.canvas) : null;
    if (!surface) return;
    const names = this.selects.map((select) => select.value), units = names.map((name) => this.unitOf(name));
    const {ink, box} = surface, scales = this.scales(all, box, units);
    this.grid(ink, scales, names.map((name, k) => name + (units[k] ? ` [${units[k]}]` : '')));
    ink.save();
    ink.beginPath();
    ink.rect(scales.left, scales.top, scales.right - scales.left, scales.bottom - scales.top);
    ink.clip();
    this.line(ink, planned, scales, 'soft', 1.5, [5, 4]);
    this.line(ink, places, scales, 'one', 2, []);
    ink.restore();
    const now = places.at(-1);
    if (actual) this.dot(ink, actual, scales, 'three', false);
    if (now) this.dot(ink, now, scales, 'one', true);
    const at = ([a, b]) => `(${short(a)}, ${short(b)})`;
    this.facts.textContent = [planned.length > 0 && 'planned path (dashed)', now && `set position ${at(now)}`,
      actual && `actual position ${at(actual)}`, places.length > 0 && `the last ${path_s} s`].filter(Boolean).join('; ');
    this.canvas.setAttribute('aria-label', `${names.join(' and ')}: ${this.facts.textContent}`);
  }

  line(ink, places, {x, y}, color, width, dash) {
    ink.strokeStyle = color_of(color);
    ink.lineWidth = width;
    ink.lineJoin = 'round';
    ink.setLineDash(dash);
    ink.beginPath();
    for (const [at, up] of places) ink.lineTo(x(at), y(up));
    ink.stroke();
    ink.setLineDash([]);
  }

  dot(ink, [at, up], {x, y}, color, fill) {
    ink.beginPath();
    ink.arc(x(at), y(up), 5, 0, 2 * Math.PI);
    ink.lineWidth = 1.5;
    ink[fill ? 'fillStyle' : 'strokeStyle'] = color_of(color);
    if (fill) ink.fill(); else ink.stroke();
  }

  grid(ink, {low, high, x, y, left, right, top, bottom, steps}, titles) {
    ink.lineWidth = 1;
    ink.strokeStyle = color_of('grid');
    ink.fillStyle = color_of('soft');
    const text = (v, k) => short(Math.abs(v) < steps[k] * 1e-9 ? 0 : v);
    const segment = (x0, y0, x1, y1) => { ink.beginPath(); ink.moveTo(x0, y0); ink.lineTo(x1, y1); ink.stroke(); };
    ink.textBaseline = 'top';
    ink.textAlign = 'center';
    for (let v = Math.ceil(low[0] / steps[0]) * steps[0]; v <= high[0]; v += steps[0]) {
      segment(x(v), top, x(v), bottom);
      ink.fillText(text(v, 0), x(v), bottom + 4);
    }
    ink.textBaseline = 'middle';
    ink.textAlign = 'right';
    for (let v = Math.ceil(low[1] / steps[1]) * steps[1]; v <= high[1]; v += steps[1]) {
      segment(left, y(v), right, y(v));
      ink.fillText(text(v, 1), left - 6, y(v));
    }
    ink.strokeStyle = color_of('frame');
    ink.strokeRect(left, top, right - left, bottom - top);
    ink.textBaseline = 'bottom';
    ink.fillText(titles[0], right, bottom + plane_box.bottom);
    ink.textAlign = 'left';
    ink.textBaseline = 'top';
    ink.fillText(titles[1], left + 5, top + 4);
  }
}
