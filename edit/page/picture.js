// SPDX-License-Identifier: Apache-2.0
// The picture of the editor: that of a report, with the knots of a cam as handles.

const grip_radius = 11, snap_px = 1.5, same_px = 4;

/// A number of a picture as text: without the rounding of its last digits.
const tidy = (value) => Number(value.toPrecision(12));

class CamPicture extends Report {
  /// `actions`: preview(change), drop(change), cancel() of a drag.
  constructor(figure, data, actions) {
    super(figure, data, 'main');
    this.actions = actions;
  }

  /// Shows the curves of a text, with the knots of `cam` (null: none).
  take(data, cam) {
    this.cam = cam;
    this.replace(data);
    this.change();
  }

  /// The handles of the knots: positions, and derivatives that the laws permit.
  decorate() {
    if (!this.cam || this.index !== 0 || this.difference) return;
    const {toX, panels, left, right} = this.drawing;
    const curve = this.view.curves[0];
    const group = svg('g', {class: 'handles'});
    this.cam.knots.forEach((knot, k) => {
      const x = toX(knot.master);
      if (x < left - 1 || x > right + 1) return;
      const exact = !(curve instanceof Outline) && curve.contains(knot.master) ? curve.sides(knot.master) : null;
      const values = [knot.slave, knot.sets_velocity && exact ? exact[1][1] : null, knot.sets_acceleration && exact ? exact[1][2] : null];
      values.forEach((value, order) => {
        if (value === null) return;
        const {panel, toY, top, bottom} = panels[order];
        const y = clamped(toY(value / panel.size), top, bottom);
        const held = this.drag?.knot === k && this.drag.order === order ? ' held' : '';
        const grip = svg('circle', {class: `grip${held}`, cx: px(x), cy: px(y), r: grip_radius}, svg('title', {}, `knot ${k}`));
        Object.assign(grip.dataset, {knot: k, order, value});
        group.append(grip, svg('circle', {class: `handle${held}`, cx: px(x), cy: px(y), r: order === 0 ? 5 : 4}));
      });
    });
    this.svg.append(group);
  }

  listen() {
    super.listen();
    const first = (name, act) => this.plot.addEventListener(name, (event) => {
      if (!act(event)) return;
      event.stopImmediatePropagation();
      event.preventDefault();
    }, true);
    first('pointerdown', (event) => event.button === 0 && event.target.dataset?.knot !== undefined && this.grab(event));
    first('pointermove', (event) => this.drag?.pointer === event.pointerId && this.pull(event));
    first('pointerup', (event) => this.drag?.pointer === event.pointerId && this.release(true));
    first('pointercancel', (event) => this.drag?.pointer === event.pointerId && this.release(false));
    first('keydown', (event) => event.key === 'Escape' && this.drag && this.release(false));
    first('keydown', (event) => event.key === 's' && !event.ctrlKey && !event.metaKey && this.cam && this.actions.split(this.x));
  }

  grab(event) {
    const {knot, order, value} = event.target.dataset;
    const k = Number(knot), {panels, left, right} = this.drawing;
    const {panel, low, high} = panels[order];
    const scale = this.scale / this.svg.getBoundingClientRect().width;
    this.drag = {
      pointer: event.pointerId, knot: k, order: Number(order), x: event.clientX, y: event.clientY, moved: false,
      master: this.cam.knots[k].master, value: Number(value),
      per_x: scale * (this.to - this.from) / (right - left), per_y: -scale * (high - low) / look.panel * panel.size,
      step_x: tickStep(this.to - this.from, (right - left) / snap_px), step_y: tickStep(high - low, look.panel / snap_px) * panel.size,
    };
    this.ranges = panels.map((each) => [each.low, each.high]);
    this.plot.focus({preventScroll: true});
    this.plot.setPointerCapture(event.pointerId);
    return true;
  }

  /// The place of the held knot under the pointer, snapped to steps of the axes and to other knots.
  pull(event) {
    const drag = this.drag, knots = this.cam.knots;
    let dx = event.clientX - drag.x, dy = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(dx, dy) < 3) return true;
    drag.moved = true;
    if (event.shiftKey) Math.abs(dx) > Math.abs(dy) ? dy = 0 : dx = 0;
    const finer = event.altKey ? 100 : 1;
    const snapped = (value, step) => tidy(Math.round(value / (step / finer)) * (step / finer));
    let value = dy === 0 ? drag.value : snapped(drag.value + dy * drag.per_y, drag.step_y);
    if (drag.order === 0 && dy !== 0 && !event.altKey) {
      const near = knots.find(({slave}, k) => k !== drag.knot && Math.abs(slave - value) < same_px * Math.abs(drag.per_y));
      if (near) value = near.slave;
    }
    const inner = drag.knot > 0 && drag.knot < knots.length - 1 && drag.order === 0;
    let master = drag.master;
    if (inner && dx !== 0) {
      const step = drag.step_x / finer;
      const [low, high] = [knots[drag.knot - 1].master, knots[drag.knot + 1].master];
      master = snapped(drag.master + dx * drag.per_x, drag.step_x);
      if (master <= low) master = tidy(low + Math.min(step, (high - low) / 4));
      if (master >= high) master = tidy(high - Math.min(step, (high - low) / 4));
    }
    drag.change = drag.order === 0 ? {do: 'move', knot: drag.knot, master, slave: value}
      : {do: 'set', knot: drag.knot, key: drag.order === 1 ? 'geo_velocity' : 'geo_acceleration', value};
    this.moveTo(master);
    this.actions.preview(drag.change);
    return true;
  }

  release(keep) {
    const {change} = this.drag;
    this.drag = null;
    this.ranges = null;
    this.change();
    if (keep && change) this.actions.drop(change); else this.actions.cancel();
    return true;
  }
}
