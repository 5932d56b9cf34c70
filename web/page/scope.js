// SPDX-License-Identifier: Apache-2.0
'use strict';
// The traces of an axis, like an oscilloscope. The server computes the least and the greatest value of all ticks of each
// part of a window, and searches the trigger in all ticks.

const plots = [  // title, signals of the server, colors, power of s in the unit
  {title: 'position', signals: ['position', 'actual position'], colors: ['one', 'three'], per: ''},
  {title: 'velocity', signals: ['velocity'], colors: ['two'], per: '/s'},
  {title: 'acceleration', signals: ['acceleration'], colors: ['four'], per: '/s²'},
  {title: 'following error', signals: ['following error'], colors: ['limit'], per: ''},
  {title: 'torque', signals: ['torque'], colors: ['three'], unit: '× rated'},
  {title: 'master', signals: ['master'], colors: ['soft'], master: true},
];
const buckets = 700;
const turn_ms = 100;
const turns = {deg: 360, '°': 360, rev: 1, rad: 2 * Math.PI};  // a usual period of a master, by its unit

/// A step of 1, 2 or 5 times a power of ten, so that at most `most` of them fit the span.
function step(span, most) {
  const raw = span / most, power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map((k) => k * power).find((s) => s >= raw);
}

const short = (value) => value === null || value === undefined ? '–' : String(Number(value.toPrecision(7))).replace('-', '−');
/// The least and greatest value as text; rounding is 0.
function range_text(least, most) {
  const noise = 1e-12 * Math.max(Math.abs(least), Math.abs(most));
  return [least, most].map((value) => short(Math.abs(value) < noise ? 0 : value)).join(' to ');
}
const color_of = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`);

/// The context of a canvas in CSS pixels, and its box; null: it is not visible.
function ink_of(canvas) {
  const box = canvas.getBoundingClientRect(), scale = devicePixelRatio || 1;
  if (box.width === 0) return null;
  canvas.width = box.width * scale;
  canvas.height = box.height * scale;
  const ink = canvas.getContext('2d');
  ink.scale(scale, scale);
  ink.font = '11px system-ui,sans-serif';
  return {ink, box};
}

async function question(path, values) {
  const query = new URLSearchParams(Object.entries(values).filter(([, value]) => value !== undefined));
  const answer = await fetch(`${path}?${query}`);
  if (!answer.ok) throw Error(await answer.text());
  return answer.json();
}

function save(name, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], {type: 'text/csv'}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

class Scope {
  constructor(name, element) {
    this.name = name;
    this.element = element;
    this.part = (part) => element.querySelector(`[data-scope=${part}]`);
    this.data = null;     // the last answer
    this.frozen = false;
    this.range = null;    // the visible ticks of a frozen window: [first, last]
    this.cursor = null;   // a tick
    this.armed = null;    // single: only later triggers count
    this.units = {unit: '', master: ''};
    this.figures = plots.map((plot) => this.figureOf(plot));
    this.wire();
    new IntersectionObserver((seen) => { this.visible = seen.at(-1).isIntersecting; }).observe(element);
    this.run();
  }

  figureOf(plot) {
    const figure = document.createElement('figure'), caption = document.createElement('figcaption');
    const canvas = document.createElement('canvas');
    figure.dataset.plot = plot.title;
    figure.hidden = true;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    figure.append(caption, canvas);
    this.part('plots').append(figure);
    canvas.addEventListener('pointermove', (event) => this.point(event, canvas));
    canvas.addEventListener('pointerleave', () => { this.cursor = null; this.draw(); });
    canvas.addEventListener('keydown', (event) => this.key(event));
    canvas.addEventListener('wheel', (event) => {
      if (!this.frozen || (document.activeElement !== canvas && !event.ctrlKey)) return;
      event.preventDefault();
      this.zoom(event.deltaY > 0 ? 1.25 : 0.8, this.tickAt(event, canvas));
    }, {passive: false});
    canvas.addEventListener('dblclick', () => { this.range = null; this.draw(); });
    return {plot, figure, caption, canvas};
  }

  wire() {
    for (const signal of plots.flatMap((plot) => plot.signals)) this.part('signal').add(new Option(signal));
    for (const part of ['mode', 'signal', 'edge', 'level', 'before', 'span', 'modulo'])
      this.part(part).addEventListener('change', () => this.rearm());
    this.part('freeze').addEventListener('click', () => this.frozen ? this.rearm() : this.freeze());
    this.part('csv').addEventListener('click', () => this.record());
    this.part('closer').addEventListener('click', () => this.zoom(0.5));
    this.part('wider').addEventListener('click', () => this.zoom(2));
  }

  get span() { return Number(this.part('span').value); }
  get mode() { return this.part('mode').value; }
  get modulo() {
    const typed = this.part('modulo').valueAsNumber;
    return typed > 0 ? typed : undefined;
  }

  /// Continues with new data.
  rearm() {
    this.frozen = false;
    this.range = null;
    this.armed = this.mode === 'single' ? this.data?.newest ?? -1 : null;
    this.part('trigger').hidden = this.mode === 'off';
    this.buttons();
  }

  buttons() {
    this.part('freeze').textContent = this.frozen ? 'Run' : 'Freeze';
    this.part('freeze').setAttribute('aria-pressed', this.frozen);
    for (const part of ['closer', 'wider']) this.part(part).disabled = !this.frozen;
  }

  /// The present window with every tick.
  whole() {
    return question('/trace', {axis: this.name, span: this.span, buckets: 0, until: this.data?.last, modulo: this.modulo});
  }

  async freeze() {
    if (!this.data) return;
    const trigger = this.data.trigger;
    this.frozen = true;
    this.buttons();
    try {
      this.data = {...await this.whole(), trigger};
    } catch (error) { /* the window with its extreme values stays */ }
    this.draw();
  }

  async record() {
    const {low, ticks, period} = this.frozen ? this.data : await this.whole();
    const names = Object.keys(low ?? {});
    const unit = (name) => name === 'torque' ? '' : name === 'master' ? this.units.master
      : name === 'master velocity' ? `${this.units.master}/s`
        : this.units.unit + (name === 'velocity' ? '/s' : name === 'acceleration' ? '/s^2' : '');
    const head = ['time_s', 'tick', ...names.map((name) => name.replaceAll(' ', '_') + (unit(name) && `_${unit(name)}`))];
    const lines = ticks.map((tick, i) => [tick * period, tick, ...names.map((name) => low[name][i] ?? '')].join(','));
    save(`${this.name}-${ticks.at(-1) ?? 0}.csv`, [head.join(','), ...lines, ''].join('\n'));
    say(`${this.name}: saved ${ticks.length} ticks`, true);
  }

  async run() {
    for (;;) {
      await new Promise((resolve) => setTimeout(resolve, turn_ms));
      if (this.frozen || !this.visible || document.hidden) continue;
      try { await this.once(); } catch (error) { this.part('facts').textContent = 'no traces: the server does not answer'; }
    }
  }

  async once() {
    const mode = this.mode, span = this.span;
    const trigger = mode === 'off' ? {} : {
      signal: this.part('signal').value, level: this.part('level').valueAsNumber || 0, edge: this.part('edge').value,
      before: span * Number(this.part('before').value) / 100,
      ...(mode === 'single' ? {after: this.armed ?? -1, pick: 'first'} : {after: this.searched(mode, span)})};
    const data = await question('/trace', {axis: this.name, span, buckets, modulo: this.modulo, ...trigger});
    if (this.frozen || mode !== this.mode || span !== this.span) return;  // the operator was faster
    if (this.data && data.newest < this.data.newest) { this.data = null; this.armed = null; }  // the executor was started again
    this.waits = mode !== 'off' && data.trigger === null;
    if (this.data && this.waits && mode !== 'auto') this.data = {...this.data, newest: data.newest};  // the old picture stays
    else this.data = data;
    if (mode === 'single' && !this.waits) return this.freeze();
    this.draw();
  }

  /// The search for a trigger begins behind this cycle: at the last trigger; auto drops one that is old.
  searched(mode, span) {
    if (!this.data) return -1;
    const {newest, trigger, period} = this.data;
    const recent = mode === 'auto' ? newest - Math.round((2 * span + 1) / period) : -1;
    return Math.max(-1, recent, (trigger ?? 0) - 1);
  }

  // ---- the visible window ------------------------------------------------------------------------

  get ends() { return this.range ?? [this.data.first, this.data.last]; }

  zoom(factor, about) {
    if (!this.frozen) return;
    const [first, last] = this.ends, middle = about ?? this.cursor ?? (first + last) / 2;
    const wide = Math.max(4, (last - first) * factor);
    let begin = middle - (middle - first) / (last - first) * wide;
    begin = Math.max(this.data.first, Math.min(begin, this.data.last - wide));
    this.range = wide >= this.data.last - this.data.first ? null : [begin, begin + wide];
    this.draw();
  }

  key(event) {
    if (!this.data) return;
    const [first, last] = this.ends, to = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (to) {
      this.cursor = Math.round(Math.max(first, Math.min(last, (this.cursor ?? (first + last) / 2) + to * (event.shiftKey ? (last - first) / 20 : this.data.each))));
      this.draw();
    } else if (event.key === '+' || event.key === '=') this.zoom(0.5);
    else if (event.key === '-') this.zoom(2);
    else if (event.key === '0') { this.range = null; this.draw(); } else return;
    event.preventDefault();
  }

  tickAt(event, canvas) {
    const box = canvas.getBoundingClientRect(), [first, last] = this.ends;
    return first + (event.clientX - box.left - 52) / (box.width - 56) * (last - first);
  }

  point(event, canvas) {
    if (!this.data) return;
    const [first, last] = this.ends;
    this.cursor = Math.max(first, Math.min(last, this.tickAt(event, canvas)));
    this.draw();
  }

  /// Index of the bucket that contains a tick.
  indexAt(tick) {
    const {ticks} = this.data;
    let low = 0, high = ticks.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (ticks[middle] <= tick) low = middle + 1; else high = middle;
    }
    return low - 1;
  }

  // ---- pictures ----------------------------------------------------------------------------------

  draw() {
    if (!this.data || this.dirty) return;
    this.dirty = true;
    requestAnimationFrame(() => { this.dirty = false; this.paint(); });
  }

  paint() {
    const {data} = this, low = data.low ?? {};
    const turn = this.part('modulo-label');
    const has_master = 'master' in low && this.units.master !== '';  // an axis of a group has none
    turn.hidden = !has_master;
    if (!turn.hidden && !this.knowsTurn && this.units.master) {
      this.knowsTurn = true;
      this.part('modulo').value = turns[this.units.master] ?? '';
    }
    const [first, last] = this.ends;
    const source = data.source === 'status' ? 'from status messages, 20 each second (every cycle: jounce run --web)'
      : data.each > 1 ? `extreme values of every ${data.each} cycles` : 'every cycle';
    const ms = (data.period * 1e3).toPrecision(3);
    this.part('facts').textContent = `${source}${data.source === 'status' ? '' : `, ${Number(ms)} ms`}`
      + (data.missing && data.source !== 'status' ? `; ${data.missing} cycles are missing` : '')
      + (this.frozen ? '; frozen' : this.waits ? '; waiting for the trigger' : data.trigger !== null ? '; triggered' : '');
    for (const one of this.figures) {
      one.figure.hidden = !one.plot.signals.some((signal) => signal in low) || (one.plot.master && !has_master);
      if (!one.figure.hidden) this.paintOne(one, low, data.high ?? low, first, last);
    }
  }

  paintOne({plot, caption, canvas}, low, high, first, last) {
    const {data} = this, signals = plot.signals.filter((signal) => signal in low);
    const begin = Math.max(0, this.indexAt(first)), end = Math.min(data.ticks.length, this.indexAt(last) + 1);
    const unit = plot.unit ?? (plot.master ? this.units.master : this.units.unit && this.units.unit + plot.per);
    let least = Infinity, most = -Infinity;
    for (const signal of signals)
      for (let i = begin; i < end; ++i) {
        if (low[signal][i] === null) continue;
        least = Math.min(least, low[signal][i]);
        most = Math.max(most, high[signal][i]);
      }
    const title = plot.title + (unit ? ` [${unit}]` : '');
    const at = this.cursor === null ? -1 : this.indexAt(this.cursor);
    const value = (signal) => low[signal][at] === high[signal][at] ? short(low[signal][at])
      : `${short(low[signal][at])} to ${short(high[signal][at])}`;
    caption.textContent = least > most ? title : at >= 0
      ? `${title}: ${signals.map((signal) => (signals.length > 1 ? `${signal === 'position' ? 'set' : 'actual'} ` : '') + value(signal)).join(', ')}`
      : `${title}: ${range_text(least, most)}`;
    canvas.setAttribute('aria-label', `${caption.textContent}, over ${short((last - first) * data.period)} s`);
    const surface = ink_of(canvas);
    if (!surface || least > most) return;
    const {ink, box} = surface;
    const pad = (most - least) * 0.08 || Math.abs(most) * 0.1 || 1;
    const bottom = box.height - 18, left = 52, right = box.width - 4, top = 6;
    const x = (tick) => left + (tick - first) / (last - first) * (right - left);
    const y = (v) => bottom - (v - least + pad) / (most - least + 2 * pad) * (bottom - top);
    this.grid(ink, {least: least - pad, most: most + pad, x, y, left, right, bottom, top, first, last});
    ink.save();
    ink.beginPath();
    ink.rect(left, 0, right - left, box.height);
    ink.clip();
    signals.forEach((signal, k) => this.line(ink, low[signal], high[signal], begin, end, x, y, color_of(plot.colors[k])));
    ink.restore();
    if (at >= 0) this.hair(ink, x(data.ticks[at]), top, bottom, 'ink');
  }

  hair(ink, x, top, bottom, color) {
    ink.strokeStyle = color_of(color);
    ink.lineWidth = 1;
    ink.beginPath();
    ink.moveTo(x, top);
    ink.lineTo(x, bottom);
    ink.stroke();
  }

  grid(ink, {least, most, x, y, left, right, bottom, top, first, last}) {
    ink.lineWidth = 1;
    ink.strokeStyle = color_of('grid');
    ink.fillStyle = color_of('soft');
    ink.textAlign = 'right';
    ink.textBaseline = 'middle';
    const rise = step(most - least, 4);
    for (let v = Math.ceil(least / rise) * rise; v <= most; v += rise) {
      ink.beginPath(); ink.moveTo(left, y(v)); ink.lineTo(right, y(v)); ink.stroke();
      ink.fillText(short(Math.abs(v) < rise * 1e-9 ? 0 : v), left - 6, y(v));
    }
    const {data} = this, zero = data.trigger ?? data.last, beat = step((last - first) * data.period, 5);
    ink.textBaseline = 'top';
    for (let t = Math.ceil((first - zero) * data.period / beat - 1e-9) * beat; zero + t / data.period <= last + 1e-6; t += beat) {
      const at = x(zero + t / data.period), text = Math.abs(t) < beat * 1e-6 ? (data.trigger === null && !this.frozen ? 'now' : '0 s') : `${short(t)} s`;
      ink.textAlign = at > right - 20 ? 'right' : at < left + 20 ? 'left' : 'center';
      ink.fillText(text, at, bottom + 4);
      ink.beginPath(); ink.moveTo(at, top); ink.lineTo(at, bottom); ink.stroke();
    }
    if (data.trigger !== null && data.trigger >= first && data.trigger <= last) this.hair(ink, x(data.trigger), top, bottom, 'frame');
  }

  /// A line through the least and greatest values of the buckets. A missing cycle is a gap.
  line(ink, low, high, begin, end, x, y, color) {
    const {ticks, each, source} = this.data, gap = source === 'status' ? Infinity : 2 * each;
    ink.strokeStyle = color;
    ink.lineWidth = 1.5;
    ink.lineJoin = 'round';
    ink.beginPath();
    let pen = false, last = 0;
    for (let i = begin; i < end; ++i) {
      if (low[i] === null) { pen = false; continue; }
      if (pen && ticks[i] - ticks[i - 1] >= gap) pen = false;
      const at = x(ticks[i]);
      const near = Math.abs(low[i] - last) < Math.abs(high[i] - last) ? low[i] : high[i];
      if (pen) ink.lineTo(at, y(near)); else ink.moveTo(at, y(near));
      if (low[i] !== high[i]) ink.lineTo(at, y(near === low[i] ? high[i] : low[i]));
      last = near === low[i] ? high[i] : low[i];
      pen = true;
    }
    ink.stroke();
  }
}
