// SPDX-License-Identifier: Apache-2.0
'use strict';
// Curves of a report. The evaluation makes the same operations in the same order as the library (Segment, Curve),
// so that both give the same numbers. The data is that of chart_data().

/// The value and three derivatives of a piece [length, [c0, c1, ...], [amplitude, angle, phase, ...]] at s in [0, 1].
function evaluate([length, c, sines = []], s) {
  let p = c[c.length - 1], d1 = 0, d2 = 0, d3 = 0;
  for (let k = c.length - 2; k >= 0; --k) {
    d3 = d3 * s + d2;
    d2 = d2 * s + d1;
    d1 = d1 * s + p;
    p = p * s + c[k];
  }
  d2 *= 2;
  d3 *= 6;
  for (let i = 0; i < sines.length; i += 3) {
    const w = sines[i + 1];
    const sn = sines[i] * Math.sin(w * s + sines[i + 2]);
    const cs = sines[i] * w * Math.cos(w * s + sines[i + 2]);
    p += sn;
    d1 += cs;
    d2 -= w * w * sn;
    d3 -= w * w * cs;
  }
  const r = 1 / length;
  return [p, d1 * r, d2 * r * r, d3 * r * r * r];
}

/// The running sum of the lengths, compensated (Neumaier).
function breaksOf(start, pieces) {
  const breaks = [start];
  let total = start, lost = 0;
  for (const [length] of pieces) {
    const next = total + length;
    lost += Math.abs(total) >= length ? (total - next) + length : (length - next) + total;
    total = next;
    breaks.push(total + lost);
  }
  return breaks;
}

/// The index of the interval between breaks that contains x; at a break, the interval that begins there.
function intervalAt(breaks, x) {
  let low = 0, high = breaks.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (breaks[middle] <= x) low = middle; else high = middle;
  }
  return low;
}

const clamped = (x, low, high) => Math.min(Math.max(x, low), high);

/// A function over breaks: at(i, x) is the value with its derivatives at x, by the formula of interval i.
class Pieces {
  constructor(label, breaks) {
    this.label = label;
    this.breaks = breaks;
  }
  get start() { return this.breaks[0]; }
  get end() { return this.breaks[this.breaks.length - 1]; }
  get count() { return this.breaks.length - 1; }
  contains(x) { return x >= this.start && x <= this.end; }
  jet(x) { return this.at(intervalAt(this.breaks, x), x); }
  /// The values on the left and on the right of x; they differ only at a break with a jump.
  sides(x) {
    const i = intervalAt(this.breaks, x), right = this.at(i, x);
    return [i > 0 && this.breaks[i] === x ? this.at(i - 1, x) : right, right];
  }
  isLine() { return false; }
}

class Curve extends Pieces {
  constructor({label, start, pieces}) {
    super(label, breaksOf(start, pieces));
    this.pieces = pieces;
  }
  at(i, x) { return evaluate(this.pieces[i], clamped((x - this.breaks[i]) / this.pieces[i][0], 0, 1)); }
  isLine(i) { return this.pieces[i][1].length <= 2 && this.pieces[i].length < 3; }
}

/// a - b where both are defined.
class Difference extends Pieces {
  constructor(a, b) {
    const start = Math.max(a.start, b.start), end = Math.min(a.end, b.end);
    const inner = [...a.breaks, ...b.breaks].filter((x) => x > start && x < end).sort((x, y) => x - y);
    super('difference', [start, ...inner, end].filter((x, i, all) => i === 0 || x > all[i - 1]));
    const middle = (i) => (this.breaks[i] + this.breaks[i + 1]) / 2;
    const intervals = (f) => Array.from({length: this.count}, (_, i) => intervalAt(f.breaks, middle(i)));
    this.of = [[a, intervals(a)], [b, intervals(b)]];
  }
  at(i, x) {
    const [p, q] = this.of.map(([f, interval]) => f.at(interval[i], x));
    return p.map((value, k) => value - q[k]);
  }
  isLine(i) { return this.of.every(([f, interval]) => f.isLine(interval[i])); }
}

/// The exact extrema of blocks of pieces, of a curve that is too large for the page.
class Outline extends Pieces {
  constructor({label, edges, low, high, count}) {
    super(label, edges);
    Object.assign(this, {low, high, pieceCount: count});
  }
  /// The least and greatest value of derivative k in the block that contains x.
  range(x, k) {
    const i = intervalAt(this.breaks, x);
    return [this.low[k][i], this.high[k][i]];
  }
}

const curveOf = (data) => data.pieces ? new Curve(data) : new Outline(data);

/// Points of a curve from `from` to `to`: at least one for each `step`, and both sides of each break. Pieces that are
/// far narrower than a step get three points.
function sampled(curve, from, to, step) {
  const x = [], y = [[], [], [], []];
  if (to < curve.start || from > curve.end) return {x, y};
  const last = intervalAt(curve.breaks, Math.min(to, curve.end));
  for (let i = intervalAt(curve.breaks, Math.max(from, curve.start)); i <= last; ++i) {
    const a = Math.max(from, curve.breaks[i]), b = Math.min(to, curve.breaks[i + 1]);
    const n = curve.isLine(i) ? 1 : Math.max(2, Math.ceil((b - a) / step));
    for (let k = 0; k <= n; ++k) {
      const at = k === n ? b : a + (b - a) * k / n;
      const jet = curve.at(i, at);
      x.push(at);
      for (let order = 0; order < 4; ++order) y[order].push(jet[order]);
    }
  }
  return {x, y};
}

/// The band between the least (`low`) and the greatest values (`y`) of an outline: both ends of each block. Blocks within
/// `width` (a pixel) of the x axis are one.
function sampledOutline(curve, from, to, width) {
  const x = [], y = [[], [], [], []], low = [[], [], [], []];
  if (to < curve.start || from > curve.end) return {x, y, low};
  const last = intervalAt(curve.breaks, Math.min(to, curve.end));
  let begin = -Infinity;
  for (let i = intervalAt(curve.breaks, Math.max(from, curve.start)); i <= last; ++i) {
    const left = Math.max(from, curve.breaks[i]), right = Math.min(to, curve.breaks[i + 1]);
    const end = x.length - 1;
    if (right - begin <= width) {
      x[end] = right;
      for (let k = 0; k < 4; ++k) {
        y[k][end - 1] = y[k][end] = Math.max(y[k][end], curve.high[k][i]);
        low[k][end - 1] = low[k][end] = Math.min(low[k][end], curve.low[k][i]);
      }
      continue;
    }
    begin = left;
    x.push(left, right);
    for (let k = 0; k < 4; ++k) {
      y[k].push(curve.high[k][i], curve.high[k][i]);
      low[k].push(curve.low[k][i], curve.low[k][i]);
    }
  }
  return {x, y, low};
}

const raised = (exponent) => [...String(exponent)].map((c) => c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c]).join('');

/// The significant digits of a positive value, "1.95312", and its power of ten. A value halfway between two results
/// gives the even one, as in the library; JavaScript gives the greater one.
function rounded(value, digits) {
  const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
  const more = value.toExponential(digits + 60).split('e')[0].replace('.', '');  // all digits of a halfway value
  const down = /[13579]$/.test(mantissa) && /^50*$/.test(more.slice(digits)) && more[digits - 1] !== mantissa.at(-1);
  return [down ? mantissa.slice(0, -1) + (mantissa.at(-1) - 1) : mantissa, Number(exponent)];
}

/// A number for people, as short_number() of the library writes it: "−3.39227", "1.5×10¹²".
function number(value, digits = 6) {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? 'not a number' : value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  const sign = value < 0 ? '−' : '';
  const [mantissa, power] = rounded(Math.abs(value), digits);
  const trimmed = (text) => text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  if (power >= -4 && power < digits) return sign + trimmed(Number(`${mantissa}e${power}`).toFixed(digits - 1 - power));
  const factor = trimmed(mantissa);
  return `${sign}${factor === '1' ? '' : `${factor}×`}10${raised(power)}`;
}

/// Values of the cursor have this many digits.
const cursor_digits = 9;

/// A value of a panel; rounding is shown as 0, as in the still figure.
const withoutRounding = (panel, value) => Math.abs(value) <= panel.noise ? 0 : value;

/// A value of the curve in the unit of a panel.
const shownValue = (panel, value) => withoutRounding(panel, value / panel.size);
