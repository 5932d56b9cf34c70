// SPDX-License-Identifier: Apache-2.0
// The picture of the editor: that of a report, with handles. The server lists the handles of each kind of spec; a handle
// has its place and the change that moves it (docs/reference/http.md).

const grip_radius = 11, snap_px = 1.5, same_px = 4, near_px = 14, tangent_px = 44, most_tangents = 12;

/// A number of a picture as text: without the rounding of its last digits.
const tidy = (value) => Number(value.toPrecision(12));

/// The ranges of the switches over the master, as rows of outputs.
function switchRows({switches, knots}) {
  const start = knots[0].master, end = knots.at(-1).master;
  return switches.map(({track, first, last}) => [`track ${track}`,
    last === null ? [[first, first]] : first <= last ? [[first, last]] : [[start, last], [first, end]]]);
}

/// The change of a handle whose coordinates have new places: a number changes by as much as its place.
function movedChange(handle, coordinates) {
  const change = {...handle.change};
  for (const [coordinate, now] of coordinates) {
    if (!coordinate?.key) continue;
    const {place, value, key} = coordinate;
    change[key] = value === null || place === null || place === value ? now : tidy(value + (now - place));
  }
  return change;
}

/// The circle of a handle, and a larger one that the pointer takes.
function gripOf(handle, index, is_held) {
  const [x, y] = handle.at, held = is_held ? ' held' : '';
  const grip = svg('circle', {class: `grip${held}`, cx: px(x), cy: px(y), r: handle.small ? 8 : grip_radius}, svg('title', {}, handle.label));
  const {do: what, ...members} = handle.change;  // knot, segment, point, switch
  Object.assign(grip.dataset, members, {grip: index, order: handle.order ?? 0, x: handle.x?.key ?? '', y: handle.y?.key ?? ''});
  return [grip, svg('circle', {class: `handle${held}`, cx: px(x), cy: px(y), r: handle.small || handle.order > 0 ? 4 : 5})];
}

/// The handle at a place of the drawing; undefined: none.
const nearestGrip = (grips, x, y) => grips?.find(({at, small}) => at && Math.hypot(at[0] - x, at[1] - y) <= (small ? 8 : grip_radius));

class EditPicture extends Report {
  /// `actions`: preview(change), drop(change), cancel() of a drag, moved(x) of the cursor.
  constructor(figure, data, actions) {
    super(figure, data, 'main');
    this.actions = actions;
    document.getElementById('help').append(this.box.querySelector('[id^=keys]'));
  }

  /// Shows the curves of an axis of a text, with its handles. `edit`: null: none; `cam`: null: it is no cam.
  take(data, axis, edit, cam) {
    Object.assign(this, {axis, edit});
    if (cam?.switches.length > 0) data = {...data, views: [{...data.views[0], outputs: switchRows(cam)}, ...data.views.slice(1)]};
    this.replace(data);
    this.change();
  }

  /// Lays measured points [[master, slave], ...] under the curve; null: none.
  lay(points) {
    this.measured = points;
    this.change();
  }

  /// The value and derivatives of the curve at x; null: outside, or a curve that is too large for the page.
  exact(x) {
    const curve = this.view.curves[0];
    return !(curve instanceof Outline) && curve.contains(x) ? curve.sides(x)[x === curve.end ? 0 : 1] : null;
  }

  /// The handles of this axis with their places; those on the curve get its value.
  handles() {
    const all = [];
    for (const handle of this.edit?.handles ?? []) {
      const x = handle.x.place, at = this.exact(x);
      const y = !handle.y ? null : handle.y.place ?? (at ? at[handle.order] : undefined);
      if (handle.axis !== this.axis || y === undefined) continue;
      all.push({...handle, place: [x, y], slope: handle.slope && at ? {...handle.slope, value: at[1]} : null});
    }
    return all;
  }

  decorate() {
    if (!this.edit || this.index !== 0 || this.difference) return;
    const {toX, panels, left, right, rows} = this.drawing;
    const group = svg('g', {class: 'handles'});
    this.grips = this.handles();
    this.grips.forEach((handle, i) => {
      const x = toX(handle.place[0]), {panel, toY, top, bottom} = panels[handle.order];
      if (x < left - 1 || x > right + 1) return;
      handle.at = [x, handle.row === undefined ? clamped(toY(handle.place[1] / panel.size), top, bottom) : rows[handle.row] + 7.5];
    });
    const tangents = this.grips.filter(({slope, at}) => slope && at).length <= most_tangents;
    this.grips.forEach((handle, i) => {
      if (handle.at && handle.slope && (tangents || i === this.selected)) group.append(...this.tangent(handle, i));
    });
    this.grips.forEach((handle, i) => { if (handle.at) group.append(...gripOf(handle, i, this.drag?.index === i && !this.drag.tangent)); });
    this.svg.append(this.measuredPoints(), group);
  }

  /// The tangent of a knot: a line with a handle at each end, which changes the velocity of the knot.
  tangent(handle, index) {
    const {toX, panels: [{panel, toY, top, bottom}], left, right} = this.drawing;
    const [x, y] = handle.place, run = toX(x + 1) - toX(x), rise = toY((y + handle.slope.value) / panel.size) - toY(y / panel.size);
    const scale = tangent_px / Math.hypot(run, rise);
    const ends = [-1, 1].map((side) => [handle.at[0] + side * scale * run, handle.at[1] + side * scale * rise])
      .filter(([px_, py]) => px_ > left && px_ < right && py > top - 8 && py < bottom + 8);
    return ends.flatMap(([ex, ey]) => {
      const grip = svg('circle', {class: 'grip', cx: px(ex), cy: px(ey), r: 8}, svg('title', {}, `velocity of ${handle.label}`));
      Object.assign(grip.dataset, {grip: index, tangent: Math.sign(ex - handle.at[0]), y: handle.slope.key});
      return [path('tangent', `M${px(handle.at[0])} ${px(handle.at[1])}L${px(ex)} ${px(ey)}`), grip,
        svg('rect', {class: 'handle', x: px(ex - 3), y: px(ey - 3), width: 6, height: 6})];
    });
  }

  /// Ranges that the y axes show at least: those at the beginning of a drag, or those of the measured points.
  get ranges() {
    const {measured, view} = this;
    if (this.held || !measured || this.index !== 0) return this.held;
    const slaves = measured.filter(([master]) => master >= this.from && master <= this.to).map(([, slave]) => slave);
    const least = slaves.reduce((low, slave) => Math.min(low, slave), Infinity), most = slaves.reduce((high, slave) => Math.max(high, slave), -Infinity);
    return view.panels.map((_, k) => k === 0 ? [least, most] : [Infinity, -Infinity]);
  }

  /// Measured points under the handles.
  measuredPoints() {
    const {toX, panels: [{toY, top, bottom}], left, right} = this.drawing;
    const group = svg('g', {class: 'measured'});
    let last = -1;
    for (const [master, slave] of this.measured ?? []) {
      const x = px(toX(master)), y = px(toY(slave));
      if (x < left || x > right || y < top || y > bottom || (Math.abs(x - last) < 0.5 && this.measured.length > 2000)) continue;
      group.append(svg('circle', {cx: x, cy: y, r: 2}));
      last = x;
    }
    return group;
  }

  listen() {
    super.listen();
    const first = (name, act) => this.plot.addEventListener(name, (event) => {
      if (!act(event)) return;
      event.stopImmediatePropagation();
      event.preventDefault();
    }, true);
    first('pointerdown', (event) => event.button === 0 && event.target.dataset?.grip !== undefined && this.grab(event));
    first('pointermove', (event) => this.drag?.pointer === event.pointerId && this.pull(event));
    first('pointerup', (event) => this.drag?.pointer === event.pointerId && this.release(true));
    first('pointercancel', (event) => this.drag?.pointer === event.pointerId && this.release(false));
    first('dblclick', (event) => this.index === 0 && this.addOrRemove(event));
    first('keydown', (event) => event.key === 'Escape' && this.drag && this.release(false));
    first('keydown', (event) => event.key === 's' && !event.ctrlKey && !event.metaKey && this.edit?.insert && this.actions.insert(this.x));
    first('keydown', (event) => event.key === 'Delete' && !this.drag && this.removeGrip(this.grips?.[this.selected]));
  }

  /// Removes the point of a handle. Returns true if it has one.
  removeGrip(handle) {
    if (!handle?.remove) return false;
    this.selected = undefined;
    this.actions.drop(handle.remove);
    return true;
  }

  /// A double click on a point removes it; one on the curve of the position adds a point.
  addOrRemove(event) {
    const [x, y] = this.pointOf(event), {toY, panel, top, bottom} = this.drawing.panels[0];
    const near = nearestGrip(this.grips, x, y);
    if (near) return this.removeGrip(near);
    if (!this.edit?.insert || y < top || y > bottom) return false;
    const at = this.valueAt(event), exact = this.exact(at);
    if (!exact || Math.abs(toY(exact[0] / panel.size) - y) > near_px) return false;
    const step = tickStep(this.to - this.from, (this.drawing.right - this.drawing.left) / snap_px);
    return this.actions.insert(tidy(Math.round(at / step) * step));
  }

  /// The place of a pointer in the drawing.
  pointOf(event) {
    const box = this.svg.getBoundingClientRect(), scale = this.scale / box.width;
    return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
  }

  grab(event) {
    const {grip, tangent} = event.target.dataset, index = Number(grip), handle = this.grips[index], {panels, left, right} = this.drawing;
    const {panel, low, high} = panels[handle.order];
    const scale = this.scale / this.svg.getBoundingClientRect().width;
    this.selected = index;
    this.drag = {
      pointer: event.pointerId, index, handle, tangent: Number(tangent ?? 0), x: event.clientX, y: event.clientY, moved: false,
      per_x: scale * (this.to - this.from) / (right - left), per_y: -scale * (high - low) / look.panel * panel.size,
      step_x: tickStep(this.to - this.from, (right - left) / snap_px), step_y: tickStep(high - low, look.panel / snap_px) * panel.size,
    };
    this.held = panels.map((each) => [each.low, each.high]);
    this.plot.focus({preventScroll: true});
    this.plot.setPointerCapture(event.pointerId);
    return true;
  }

  pull(event) {
    const drag = this.drag, {handle} = drag;
    let dx = event.clientX - drag.x, dy = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(dx, dy) < 3) return true;
    drag.moved = true;
    const finer = event.altKey ? 100 : 1;
    if (drag.tangent) {
      drag.change = this.turned(event, finer);
    } else {
      if (event.shiftKey) Math.abs(dx) > Math.abs(dy) ? dy = 0 : dx = 0;
      const [x, y] = this.pulled(dx, dy, finer, !event.altKey);
      drag.change = movedChange(handle, [[handle.x, x], [handle.y, y]]);
      this.moveTo(x);
    }
    this.actions.preview(drag.change);
    return true;
  }

  /// The place of the held handle after a move by dx, dy (px), snapped to steps of the axes and to other points.
  pulled(dx, dy, finer, to_points) {
    const drag = this.drag, {handle} = drag;
    const snapped = (value, step) => tidy(Math.round(value / (step / finer)) * (step / finer));
    let [x, y] = handle.place;
    if (handle.y?.key && dy !== 0) {
      y = snapped(y + dy * drag.per_y, drag.step_y);
      const near = handle.order === 0 && to_points && this.grips.find((other, i) => i !== drag.index && other.order === 0 && other.y && Math.abs(other.place[1] - y) < same_px * Math.abs(drag.per_y));
      if (near) y = near.place[1];
    }
    if (!handle.x.key || dx === 0) return [x, y];
    const step = drag.step_x / finer;
    x = snapped(x + dx * drag.per_x, drag.step_x);
    const [low, high] = handle.between ?? [this.view.start, this.view.end];
    if (!handle.between) return [clamped(x, low, high), y];
    const most = low === null || high === null ? step : Math.min(step, (high - low) / 4);
    if (low !== null && x <= low) x = tidy(low + most);
    if (high !== null && x >= high) x = tidy(high - most);
    return [x, y];
  }

  /// The change of the velocity by a tangent that points to the pointer.
  turned(event, finer) {
    const {handle, tangent} = this.drag, {panels, toX} = this.drawing;
    const [x, y] = this.pointOf(event), [{panel, low, high}, velocity] = panels;
    const run = tangent * Math.max(tangent * (x - handle.at[0]), 4) / (toX(1) - toX(0));
    const rise = -(y - handle.at[1]) * (high - low) / look.panel * panel.size;
    const step = tickStep(velocity.high - velocity.low, look.panel / snap_px) * velocity.panel.size / finer;
    return {...handle.slope.change, [handle.slope.key]: tidy(Math.round(rise / run / step) * step)};
  }

  release(keep) {
    const {change} = this.drag;
    this.drag = null;
    this.held = null;
    this.change();
    if (keep && change) this.actions.drop(change); else this.actions.cancel();
    return true;
  }

  render() {
    this.frame = null;
    if (this.drag && !this.drag.moved) return;  // a click needs its circle
    super.render();
    this.actions?.moved(this.x);
  }
}
