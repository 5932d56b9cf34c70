// SPDX-License-Identifier: Apache-2.0
// The picture of the editor: that of a report, with the knots, points and switches of a cam as handles.

const grip_radius = 11, snap_px = 1.5, same_px = 4;

/// A number of a picture as text: without the rounding of its last digits.
const tidy = (value) => Number(value.toPrecision(12));

/// The ranges of the switches over the master, as rows of outputs.
function switchRows({switches, knots}) {
  const start = knots[0].master, end = knots.at(-1).master;
  return switches.map(({track, first, last}) => [`track ${track}`,
    last === null ? [[first, first]] : first <= last ? [[first, last]] : [[start, last], [first, end]]]);
}

class CamPicture extends Report {
  /// `actions`: preview(change), drop(change), cancel() of a drag.
  constructor(figure, data, actions) {
    super(figure, data, 'main');
    this.actions = actions;
  }

  /// Shows the curves of a text, with the knots of `cam` (null: none).
  take(data, cam) {
    this.cam = cam;
    if (cam?.switches.length > 0) data = {...data, views: [{...data.views[0], outputs: switchRows(cam)}, ...data.views.slice(1)]};
    this.replace(data);
    this.change();
  }

  /// Lays measured points [[master, slave], ...] under the curve; null: none.
  lay(points) {
    this.measured = points;
    this.change();
  }

  /// The handles: knots with the derivatives that the laws permit, points of segments, edges of switches. A handle has its
  /// place, the directions in which it moves, and the change that moves it.
  handles() {
    const {knots, segments, switches} = this.cam, curve = this.view.curves[0], all = [];
    knots.forEach((knot, k) => {
      const exact = !(curve instanceof Outline) && curve.contains(knot.master) ? curve.sides(knot.master) : null;
      const inner = k > 0 && k < knots.length - 1;
      const add = (order, value, more) => all.push({label: `knot ${k}`, data: {knot: k, order}, order, master: knot.master, value, y: true, ...more});
      add(0, knot.slave, {x: inner, between: inner ? [knots[k - 1].master, knots[k + 1].master] : null, change: (master, slave) => ({do: 'move', knot: k, master, slave})});
      [['geo_velocity', knot.sets_velocity], ['geo_acceleration', knot.sets_acceleration]].forEach(([key, sets], i) => {
        if (sets && exact) add(i + 1, exact[1][i + 1], {change: (_, value) => ({do: 'set', knot: k, key, value})});
      });
    });
    segments.forEach((segment, i) => (segment.through ?? []).forEach(([master, slave], k, points) => {
      const places = [knots[i].master, ...points.map(([place]) => place), knots[i + 1].master];
      const value = slave ?? (curve instanceof Outline ? null : curve.jet(master)[0]);
      if (value !== null) all.push({label: `point ${k + 1} of segment ${i + 1}`, data: {segment: i + 1, point: k + 1}, order: 0, small: true, master, value, x: true, y: slave !== null,
        between: [places[k], places[k + 2]], change: (x, y) => ({do: 'point', segment: i + 1, point: k + 1, master: x, slave: slave === null ? 0 : y})});
    }));
    switches.forEach(({track, first, last}, i) => [first, last].forEach((master, edge) => {
      if (master !== null) all.push({label: `switch ${i + 1}, track ${track}: ${edge ? 'last' : 'first'} position`, data: {switch: i + 1, edge}, row: i, order: 0, small: true, master, x: true,
        change: (x) => ({do: 'switch', switch: i + 1, first: edge ? first : x, last: edge ? x : last})});
    }));
    return all;
  }

  decorate() {
    if (!this.cam || this.index !== 0 || this.difference) return;
    const {toX, panels, left, right, rows} = this.drawing;
    const group = svg('g', {class: 'handles'});
    this.grips = this.handles();
    this.grips.forEach((handle, i) => {
      const x = toX(handle.master), {panel, toY, top, bottom} = panels[handle.order];
      if (x < left - 1 || x > right + 1) return;
      const y = handle.row === undefined ? clamped(toY(handle.value / panel.size), top, bottom) : rows[handle.row] + 7.5;
      const held = this.drag?.index === i ? ' held' : '';
      const grip = svg('circle', {class: `grip${held}`, cx: px(x), cy: px(y), r: handle.small ? 8 : grip_radius}, svg('title', {}, handle.label));
      Object.assign(grip.dataset, {...handle.data, grip: i});
      group.append(grip, svg('circle', {class: `handle${held}`, cx: px(x), cy: px(y), r: handle.order === 0 && !handle.small ? 5 : 4}));
    });
    this.svg.append(this.measuredPoints(), group);
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
    first('keydown', (event) => event.key === 'Escape' && this.drag && this.release(false));
    first('keydown', (event) => event.key === 's' && !event.ctrlKey && !event.metaKey && this.cam && this.actions.split(this.x));
  }

  grab(event) {
    const index = Number(event.target.dataset.grip), handle = this.grips[index], {panels, left, right} = this.drawing;
    const {panel, low, high} = panels[handle.order];
    const scale = this.scale / this.svg.getBoundingClientRect().width;
    this.drag = {
      pointer: event.pointerId, index, handle, x: event.clientX, y: event.clientY, moved: false,
      per_x: scale * (this.to - this.from) / (right - left), per_y: -scale * (high - low) / look.panel * panel.size,
      step_x: tickStep(this.to - this.from, (right - left) / snap_px), step_y: tickStep(high - low, look.panel / snap_px) * panel.size,
    };
    this.held = panels.map((each) => [each.low, each.high]);
    this.plot.focus({preventScroll: true});
    this.plot.setPointerCapture(event.pointerId);
    return true;
  }

  /// The place of the held handle under the pointer, snapped to steps of the axes and to knots.
  pull(event) {
    const drag = this.drag, {handle} = drag;
    let dx = event.clientX - drag.x, dy = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(dx, dy) < 3) return true;
    drag.moved = true;
    if (event.shiftKey) Math.abs(dx) > Math.abs(dy) ? dy = 0 : dx = 0;
    const finer = event.altKey ? 100 : 1;
    const snapped = (value, step) => tidy(Math.round(value / (step / finer)) * (step / finer));
    let {master, value} = handle;
    if (handle.y && dy !== 0) {
      value = snapped(value + dy * drag.per_y, drag.step_y);
      const near = handle.order === 0 && !event.altKey && this.cam.knots.find(({slave}, k) => k !== handle.data.knot && Math.abs(slave - value) < same_px * Math.abs(drag.per_y));
      if (near) value = near.slave;
    }
    if (handle.x && dx !== 0) {
      const step = drag.step_x / finer;
      master = snapped(master + dx * drag.per_x, drag.step_x);
      if (handle.between) {
        const [low, high] = handle.between;
        if (master <= low) master = tidy(low + Math.min(step, (high - low) / 4));
        if (master >= high) master = tidy(high - Math.min(step, (high - low) / 4));
      } else master = clamped(master, this.view.start, this.view.end);
    }
    drag.change = handle.change(master, value);
    this.moveTo(master);
    this.actions.preview(drag.change);
    return true;
  }

  release(keep) {
    const {change} = this.drag;
    this.drag = null;
    this.held = null;
    this.change();
    if (keep && change) this.actions.drop(change); else this.actions.cancel();
    return true;
  }
}
