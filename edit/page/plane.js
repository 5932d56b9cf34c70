// SPDX-License-Identifier: Apache-2.0
// The path of two axes in their plane, with the points of the text as handles.

const plane_look = {left: 62, right: 12, top: 10, bottom: 40, samples: 2000, most_height: 520};

class Plane {
  /// `actions`: preview(change), drop(change), cancel() of a drag.
  constructor(section, actions) {
    Object.assign(this, {section, actions, shown: [0, 1], x: 0});
    this.root = section.querySelector('svg');
    this.choices = [...section.querySelectorAll('select')];
    this.choices.forEach((select, i) => { select.onchange = () => { this.shown[i] = Number(select.value); this.change(); }; });
    const on = (name, act) => this.root.addEventListener(name, (event) => { if (act(event)) event.preventDefault(); });
    on('pointerdown', (event) => event.button === 0 && event.target.dataset?.grip !== undefined && this.grab(event));
    on('pointermove', (event) => this.drag?.pointer === event.pointerId && this.pull(event));
    on('pointerup', (event) => this.drag?.pointer === event.pointerId && this.release(true));
    on('pointercancel', (event) => this.drag?.pointer === event.pointerId && this.release(false));
    on('dblclick', (event) => this.addOrRemove(event));
    addEventListener('keydown', (event) => { if (event.key === 'Escape' && this.drag) this.release(false); });
    new ResizeObserver(() => this.change()).observe(section);
  }

  /// Shows the charts of all axes with the handles of the plane. `stale`: the curves are those of an older text.
  take(charts, edit) {
    const axes = edit?.plane[0]?.at.length ?? 0;
    this.section.hidden = axes < 2;
    if (axes < 2) return;
    this.edit = edit;
    if (charts.length >= axes) this.curves = charts.slice(0, axes).map(({name, views: [view]}) => ({name: name.split(' ').at(-1), unit: view.panels[0].unit, size: view.panels[0].size, curve: curveOf(view.curves[0])}));
    if (!this.curves || this.curves.length !== axes) { this.section.hidden = true; return; }
    this.shown = this.shown.map((axis, i) => axis < axes ? axis : i);
    this.choices.forEach((select, i) => {
      select.replaceChildren(...this.curves.map(({name}, a) => html('option', {value: a, textContent: name})));
      select.value = this.shown[i];
    });
    this.section.querySelector('form').hidden = axes < 3;
    this.change();
  }

  /// Draws in the next frame.
  change() {
    this.frame ??= requestAnimationFrame(() => { this.frame = null; this.draw(); });
  }

  /// Shows the place of the path at a time.
  mark(x) {
    this.x = x;
    if (!this.section.hidden && this.marker) this.drawMark();
  }

  /// The path as points; empty if a curve is too large for the page.
  points() {
    const [a, b] = this.shown.map((axis) => this.curves[axis]);
    if (a.curve instanceof Outline || b.curve instanceof Outline) return [];
    const {start, end} = a.curve, n = plane_look.samples;
    const at = new Set([...Array.from({length: n + 1}, (_, i) => start + (end - start) * i / n), ...a.curve.breaks, ...b.curve.breaks]);
    return [...at].sort((p, q) => p - q).map((t) => [a, b].map(({curve, size}) => curve.jet(clamped(t, curve.start, curve.end))[0] / size));
  }

  draw() {
    if (this.section.hidden || !this.curves || (this.drag && !this.drag.change)) return;  // a click needs its circle
    const {left, right, top, bottom, most_height} = plane_look, width = Math.max(300, this.section.clientWidth);
    const units = this.shown.map((axis) => this.curves[axis]);
    this.path = this.points();
    this.grips = this.edit.plane.map((handle) => {
      const [x, y] = this.shown.map((axis) => handle.at[axis]);
      return {...handle, x, y, place: [x.place, y.place], order: 0};
    });
    if (!this.drag) this.fit(width, units);
    const {low, high, height} = this.box, [x0, x1] = [left, width - right], [y0, y1] = [height - bottom, top];
    this.toX = (value) => x0 + (value - low[0]) / (high[0] - low[0]) * (x1 - x0);
    this.toY = (value) => y0 + (value - low[1]) / (high[1] - low[1]) * (y1 - y0);
    this.steps = [tickStep(high[0] - low[0], (x1 - x0) / snap_px), tickStep(high[1] - low[1], (y0 - y1) / snap_px)];
    const children = [];
    for (const [value, words] of ticks(low[0], high[0], Math.max(3, width / 90))) children.push(path('grid', `M${px(this.toX(value))} ${y1}V${y0}`), label('tick mid', this.toX(value), y0 + 15, words));
    for (const [value, words] of ticks(low[1], high[1], 6)) children.push(path('grid', `M${x0} ${px(this.toY(value))}H${x1}`), label('tick end', x0 - 6, this.toY(value) + 4, words));
    children.push(path('frame', `M${x0} ${y1}H${x1}V${y0}H${x0}Z`), label('soft mid', (x0 + x1) / 2, height - 6, `${units[0].name} [${units[0].unit}]`), label('soft', 4, y1 + 10, `${units[1].name} [${units[1].unit}]`));
    const sides = this.corners().map(({place}, i) => `${i ? 'L' : 'M'}${px(this.toX(place[0] / units[0].size))} ${px(this.toY(place[1] / units[1].size))}`).join('');
    children.push(path('sides', sides));
    if (this.path.length > 0) children.push(path('l l1', this.path.map(([x, y], i) => `${i ? 'L' : 'M'}${px(this.toX(x))} ${px(this.toY(y))}`).join('')));
    this.marker = svg('circle', {class: 'dot', r: 4});
    children.push(this.marker);
    this.grips.forEach((handle, i) => {
      handle.at = [this.toX(handle.place[0] / units[0].size), this.toY(handle.place[1] / units[1].size)];
      children.push(...gripOf(handle, i, this.drag?.index === i));
    });
    this.root.setAttribute('viewBox', `0 0 ${width} ${height}`);
    this.root.setAttribute('width', width);
    this.root.setAttribute('height', height);
    this.root.replaceChildren(...children);
    this.drawMark();
  }

  drawMark() {
    const at = this.shown.map((axis) => this.curves[axis]).map(({curve, size}) => curve instanceof Outline || !curve.contains(this.x) ? NaN : curve.jet(this.x)[0] / size);
    const shows = at.every(Number.isFinite);
    this.marker.setAttribute('visibility', shows ? 'visible' : 'hidden');
    if (shows) { this.marker.setAttribute('cx', px(this.toX(at[0]))); this.marker.setAttribute('cy', px(this.toY(at[1]))); }
  }

  /// The range of both axes; two lengths have the same scale.
  fit(width, units) {
    const {left, right, top, bottom, most_height} = plane_look;
    const all = [...this.path, ...this.grips.map(({place}) => place.map((value, i) => value / units[i].size))];
    const low = [0, 1].map((i) => all.reduce((least, point) => Math.min(least, point[i]), Infinity));
    const high = [0, 1].map((i) => all.reduce((most, point) => Math.max(most, point[i]), -Infinity));
    for (const i of [0, 1]) {
      const room = 0.08 * (high[i] - low[i]) || 0.1 * Math.abs(high[i]) || 1;
      low[i] -= room;
      high[i] += room;
    }
    let height = Math.min(most_height, width * 0.6);
    if (units[0].unit === units[1].unit) {
      const per_px = Math.max((high[0] - low[0]) / (width - left - right), (high[1] - low[1]) / (most_height - top - bottom));
      height = clamped((high[1] - low[1]) / per_px, 160, most_height - top - bottom) + top + bottom;
      [width - left - right, height - top - bottom].forEach((size, i) => {
        const middle = (low[i] + high[i]) / 2;
        [low[i], high[i]] = [middle - per_px * size / 2, middle + per_px * size / 2];
      });
    }
    this.box = {low, high, height};
  }

  /// The handles that are ends of commands or points of a spline, in order.
  corners() { return this.grips.filter(({small, corner}) => !small || corner); }

  pointOf(event) {
    const box = this.root.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /// A place in px as numbers of the two axes, snapped to their steps.
  snapped([x, y], finer = 1) {
    const {low, high, height} = this.box, {left, right, top, bottom} = plane_look, width = Number(this.root.getAttribute('width'));
    const raw = [low[0] + (x - left) / (width - left - right) * (high[0] - low[0]), low[1] + (height - bottom - y) / (height - top - bottom) * (high[1] - low[1])];
    return raw.map((value, i) => {
      const step = this.steps[i] / finer;
      return tidy(Math.round(value / step) * step * this.curves[this.shown[i]].size);
    });
  }

  grab(event) {
    const index = Number(event.target.dataset.grip), handle = this.grips[index], [x, y] = this.pointOf(event);
    this.drag = {pointer: event.pointerId, index, handle, off: [handle.at[0] - x, handle.at[1] - y], from: [x, y]};
    this.root.setPointerCapture(event.pointerId);
    return true;
  }

  pull(event) {
    const {drag} = this, {handle} = drag, [x, y] = this.pointOf(event);
    if (!drag.change && Math.hypot(x - drag.from[0], y - drag.from[1]) < 3) return true;
    const place = this.snapped([x + drag.off[0], y + drag.off[1]], event.altKey ? 100 : 1);
    if (event.shiftKey) Math.abs(x - drag.from[0]) > Math.abs(y - drag.from[1]) ? place[1] = handle.place[1] : place[0] = handle.place[0];
    drag.change = movedChange(handle, [[handle.x, place[0]], [handle.y, place[1]]]);
    this.actions.preview(drag.change);
    return true;
  }

  release(keep) {
    const {change} = this.drag;
    this.drag = null;
    if (keep && change) this.actions.drop(change); else this.actions.cancel();
    return true;
  }

  /// A double click on a point removes it; one on a line adds a point.
  addOrRemove(event) {
    const [x, y] = this.pointOf(event), near = nearestGrip(this.grips, x, y);
    if (near) return near.remove ? (this.actions.drop(near.remove), true) : false;
    if (!this.edit.plane_insert) return false;
    const side = this.sideAt(x, y);
    if (!side) return false;
    const place = this.edit.plane[0].at.map((_, axis) => tidy(side.from.at_all[axis] + side.share * (side.to.at_all[axis] - side.from.at_all[axis])));
    this.snapped([x, y]).forEach((value, i) => { place[this.shown[i]] = value; });
    this.actions.drop({do: 'insert_in_plane', before: side.before, place});
    return true;
  }

  /// The line to an end of a command that is nearest to a place, or on whose part of the path it is; null: none is near.
  sideAt(x, y) {
    const near_path = this.path.some(([u, v]) => Math.hypot(this.toX(u) - x, this.toY(v) - y) < near_px);
    const corners = this.corners().map((handle) => ({...handle, at_all: this.edit.plane[this.grips.indexOf(handle)].at.map(({place}) => place)}));
    let best = null;
    corners.slice(1).forEach((to, i) => {
      if (to.corner) return;  // a new command would divide a spline
      const from = corners[i], [dx, dy] = [to.at[0] - from.at[0], to.at[1] - from.at[1]];
      const share = clamped(((x - from.at[0]) * dx + (y - from.at[1]) * dy) / (dx * dx + dy * dy || 1), 0, 1);
      const distance = Math.hypot(from.at[0] + share * dx - x, from.at[1] + share * dy - y);
      if (!best || distance < best.distance) best = {distance, share, from, to, before: to.before ?? i + 2};
    });
    return best && (best.distance < near_px || near_path) ? best : null;
  }
}
