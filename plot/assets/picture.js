// SPDX-License-Identifier: Apache-2.0
// The drawing of a view: panels above one another, as an SVG with the style of the still figure.

const look = {left: 62, letter: 7, right: 12, panel: 120, header: 24, row: 16, axis: 40, top: 6};

/// An SVG element with attributes; its children follow. A string becomes text.
function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

const px = (value) => Math.round(clamped(value, -1e5, 1e5) * 10) / 10;
const label = (kind, x, y, words) => svg('text', {class: kind, x: px(x), y: px(y)}, words);
const path = (kind, d) => svg('path', {class: kind, d});

/// Steps of 1, 2 or 5 times a power of ten; of an angle from 60 deg on, steps that divide a turn.
function tickStep(span, most, degrees) {
  const least = span / most;
  if (degrees && span >= 60) {
    const angle = [5, 10, 15, 30, 45, 60, 90, 180].find((step) => step >= least);
    return angle ?? 360 * Math.ceil(least / 360);
  }
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * power).find((step) => step >= least * (1 - 1e-9));
}

function ticks(low, high, most, degrees = false) {
  const step = tickStep(high - low, most, degrees);
  const digits = clamped(Math.ceil(-Math.log10(step) + Math.log10(Math.max(Math.abs(low), Math.abs(high), step))) + 14, 1, 15);
  const at = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && at.length < 50; ++k) at.push(k * step);
  return at.map((value) => [value, number(Number(value.toPrecision(digits)), 12)]);
}

/// The line of points as path data. In each half pixel, only the first, last, lowest and highest point are kept, which
/// draws the same pixels (M4: Jugel et al., 2014).
function pathData(xs, ys, toX, toY) {
  let out = '';
  const put = (x, y) => { out += `${out ? 'L' : 'M'}${px(x)} ${px(y)}`; };
  for (let i = 0; i < xs.length;) {
    const column = Math.floor(2 * toX(xs[i]));
    const begin = i;
    let low = i, high = i;
    for (; i < xs.length && Math.floor(2 * toX(xs[i])) === column; ++i) {
      if (ys[i] < ys[low]) low = i;
      if (ys[i] > ys[high]) high = i;
    }
    const kept = i - begin <= 4 ? Array.from({length: i - begin}, (_, k) => begin + k)
      : [begin, Math.min(low, high), Math.max(low, high), i - 1];
    for (const k of kept) put(toX(xs[k]), toY(ys[k]));
  }
  return out;
}

/// A closed band between two lines over the same points.
const bandData = (xs, high, low, toX, toY) => `${pathData(xs, high, toX, toY)}L${pathData([...xs].reverse(), [...low].reverse(), toX, toY).slice(1)}z`;

/// The range of a y axis: the values that are visible, and a limit that is close to them.
function yRange(panel, values, withLimits) {
  let low = Infinity, high = -Infinity;
  for (const list of values)
    for (const value of list) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  if (low > high) [low, high] = [0, 0];
  const floor = Math.max(panel.noise, 1e-12 * Math.max(Math.abs(low), Math.abs(high)));
  if (high - low <= floor) {
    const middle = (low + high) / 2, half = Math.abs(middle) > floor ? 0.1 * Math.abs(middle) : 1;
    [low, high] = [middle - half, middle + half];
  }
  const near = 0.6 * (high - low);
  if (withLimits && panel.upper !== null && panel.upper > high && panel.upper - high < near) high = panel.upper;
  if (withLimits && panel.lower !== null && panel.lower < low && low - panel.lower < near) low = panel.lower;
  const room = 0.21 * (high - low);  // for texts beyond the line
  return [low - room, high + room];
}

/// Draws `view` from `from` to `to` into the element `root`, `width` px wide. Returns the scales of the drawing.
/// `piece` is a range [from, to] to highlight, or null. `ranges` are ranges [low, high] that the y axes show at least.
function draw(root, view, {from, to, difference, piece, ranges}, width) {
  const right = width - look.right;
  const inside = (x) => x >= from && x <= to;
  const curves = difference ? [view.difference] : view.curves;
  const points = curves.map((curve) => curve instanceof Outline ? sampledOutline(curve, from, to, (to - from) / (right - look.left))
    : sampled(curve, from, to, (to - from) / (right - look.left)));
  const panels = view.panels.map((panel, k) => {
    const inUnit = (list) => panel.size === 1 ? list : list.map((value) => value / panel.size);
    const values = points.map(({y}) => inUnit(y[k]));
    const least = points.map((one) => one.low ? inUnit(one.low[k]) : []);  // lower edges of bands
    let [low, high] = yRange(panel, [...values, ...least], !difference);
    if (ranges) [low, high] = [Math.min(low, ranges[k][0]), Math.max(high, ranges[k][1])];
    return {panel, values, least, low, high, yTicks: ticks(low, high, 6)};
  });
  const left = Math.max(look.left, ...panels.flatMap(({yTicks}) => yTicks.map(([, words]) => widthOf(words) + 10)));
  const toX = (x) => left + (x - from) / (to - from) * (right - left);
  const children = [];
  let top = look.top;

  if (view.curves.length > 1 && !difference) {  // the legend
    let x = left;
    const most = Math.floor(((right - left) / view.curves.length - 56) / look.letter);
    view.curves.forEach((curve, i) => {
      const name = cut(curve.label, most);
      children.push(path(i === 0 ? 'l l1' : 'under', `M${px(x)} ${top + 8}h24`), label('soft', x + 32, top + 12, name));
      x += 56 + widthOf(name);
    });
    top += look.row + 4;
  }
  const strips = [view.segments, view.laws, view.shades].filter((names) => names.length > 0).map((names) => {
    const strip = [top, names];
    top += look.row;
    return strip;
  });
  const outputs = view.outputs.map(([name, on]) => {
    const row = [top, name, on];
    top += look.row;
    return row;
  });
  for (const place of panels) {
    Object.assign(place, {top: top + look.header, bottom: top + look.header + look.panel});
    place.toY = (y) => place.bottom - (y - place.low) / (place.high - place.low) * look.panel;
    top = place.bottom;
  }
  const bottom = top;
  const height = bottom + look.axis;

  for (const [y, names] of strips)
    for (const [a, b, name] of names) {
      const [x0, x1] = [toX(Math.max(a, from)), toX(Math.min(b, to))];
      const most = Math.floor((x1 - x0 - 6) / 6.2);
      if (x1 <= x0) continue;
      const shown = names === view.segments ? shortName(name, most) : name.length > most ? '' : name;  // only names of segments are cut
      if (shown) children.push(label(names === view.shades ? 'zonetext mid' : 'soft mid', (x0 + x1) / 2, y + 11, shown));
    }
  for (const [y, name, on] of outputs) {
    children.push(label('soft end', left - 8, y + 11, cut(name, Math.floor((left - 8) / look.letter))));
    children.push(path('grid', `M${left} ${y + 12.5}H${px(right)}`));
    for (const [a, b] of on) {
      if (b < from || a > to) continue;
      const [x0, x1] = [toX(Math.max(a, from)), toX(Math.min(b, to))];
      children.push(svg('rect', {class: 'on', x: px(x0), y: y + 3, width: px(Math.max(x1 - x0, 1)), height: 9},
        svg('title', {}, `${name} on from ${number(a, cursor_digits)} to ${number(b, cursor_digits)} ${view.unit}`)));
    }
  }

  const xTicks = ticksAcross(from, to, right - left, view.degrees);
  const knots = view.segments.length > 0 ? [view.segments[0][0], ...view.segments.map(([, end]) => end)]
    : view.curves[0] instanceof Outline ? [] : view.curves[0].breaks;
  const shownKnots = knots.filter(inside);
  for (const [k, {panel, values, least, top: y0, bottom: y1, low, high, toY, yTicks}] of panels.entries()) {
    const clip = `clip-${root.id}-${k}`;
    children.push(svg('clipPath', {id: clip}, svg('rect', {x: left, y: y0 - 1, width: px(right - left), height: y1 - y0 + 2})));
    const group = svg('g', {'clip-path': `url(#${clip})`});
    for (const [a, b] of view.shades)
      if (b > from && a < to) group.append(svg('rect', {class: 'zone', x: px(toX(a)), y: y0, width: px(toX(b) - toX(a)), height: look.panel}));
    if (piece) group.append(svg('rect', {class: 'piece', x: px(toX(piece[0])), y: y0, width: px(Math.max(toX(piece[1]) - toX(piece[0]), 2)), height: look.panel}));
    children.push(path('grid', yTicks.map(([y]) => `M${left} ${px(toY(y))}H${px(right)}`).join('') +
      xTicks.map(([x]) => `M${px(toX(x))} ${y0}V${y1}`).join('')));
    for (const [y, words] of yTicks) children.push(label('soft end', left - 8, toY(y) + 4, words));
    if (shownKnots.length * 8 < right - left) group.append(path('knot', shownKnots.map((x) => `M${px(toX(x))} ${y0}V${y1}`).join('')));
    const texts = [], taken = [];  // of the limits, above the curve
    for (const [limit, sign] of difference ? [] : [[panel.lower, -1], [panel.upper, 1]]) {
      if (limit === null || limit < low || limit > high) continue;
      const y = toY(limit), edge = sign > 0 ? y0 : y1;
      const above = sign > 0 ? y - y0 > 14 : y1 - y < 16;  // beyond the limit if there is space
      group.append(path('over', `M${left} ${px(y)}H${px(right)}V${edge}H${left}z`), path('lim', `M${left} ${px(y)}H${px(right)}`));
      const words = `limit ${number(limit)}`, base = above ? y - 4 : y + 12;
      taken.push([right - 4 - 3.3 * words.length, base, 3.3 * words.length]);
      texts.push(label('halo limtext end', right - 4, base, words));
    }
    points.map((one, i) => i).reverse().forEach((i) => {
      const kind = i > 0 ? 'under' : 'l l1';
      group.append(curves[i] instanceof Outline ? path(`${kind} band`, bandData(points[i].x, values[i], least[i], toX, toY))
        : path(kind, pathData(points[i].x, values[i], toX, toY)));
    });
    children.push(group, ...texts, path('frame', `M${left} ${y0}H${px(right)}V${y1}H${left}z`));
    const heading = (difference ? 'difference of ' : '') + panel.name + (panel.unit ? ` [${panel.unit}]` : '');
    children.push(label('label', left, y0 - 7, heading));
    const note = difference ? '' : limitsOffScale(panel, low, high, right - left - widthOf(heading) - 12);
    if (note) children.push(label('soft end', right, y0 - 7, note));
    if (!difference) children.push(...marks(panel, inside, toX, toY, [left, right, y0, y1], taken, points[0].x.map((x, i) => [toX(x), toY(values[0][i])])));
  }
  for (const [x, words] of xTicks) children.push(label('soft mid', Math.min(toX(x), width - widthOf(words) / 2), bottom + 16, words));
  children.push(label('label mid', (left + right) / 2, bottom + 34, view.note ? `${view.axis} · ${view.note}` : view.axis));
  const cursor = svg('g', {class: 'cursor'});
  root.setAttribute('viewBox', `0 0 ${width} ${height}`);
  root.replaceChildren(...children, cursor);
  return {toX, toValue: (x) => from + (x - left) / (right - left) * (to - from), panels, cursor, left, right, rows: outputs.map(([y]) => y)};
}

const widthOf = (words) => look.letter * [...words].length;  // px, an estimate for digits and letters

/// Words with at most this many letters; the end of longer ones is cut.
function cut(words, most) {
  const letters = [...words];
  return letters.length > most ? `${letters.slice(0, Math.max(most - 1, 1)).join('')}…` : words;
}

/// A name with at most this many letters: that of a "line 38", or of a narrow "3 return", is its number;
/// the end of another long name is cut.
function shortName(name, most) {
  if ([...name].length <= most) return name;
  const number = (/^\S+ (\d+)$/.exec(name) ?? (most < 5 ? /^(\d+) /.exec(name) : null))?.[1];
  if (number) return number.length <= most ? number : '';
  return most < 2 ? '' : cut(name, most);
}

/// The ticks of the x axis: as many as their texts have space for.
function ticksAcross(from, to, width, degrees) {
  for (let most = Math.floor(clamped(width / 64, 2, 12));; --most) {
    const at = ticks(from, to, most, degrees);
    const longest = Math.max(...at.map(([, words]) => widthOf(words)));
    if (most <= 2 || at.length < 2 || (at[1][0] - at[0][0]) / (to - from) * width >= longest + 8) return at;
  }
}

/// What a panel says of limits outside its range, as the still figure does, in the longest form for which there is space.
function limitsOffScale({lower, upper}, low, high, space) {
  const off = [upper, lower].filter((limit) => limit !== null && (limit < low || limit > high));
  const words = off.length === 2 && lower === -upper ? `limits ±${number(upper)}` : off.map((limit) => `limit ${number(limit)}`).join(' · ');
  return off.length === 0 ? '' : [`${words} off scale`, words].find((text) => widthOf(text) <= space) ?? '';
}

/// The number of parts of a line [[x, y], ...] that a text covers.
function covered(line, [middle, base, half]) {
  let count = 0;
  for (let i = 1; i < line.length; ++i) {
    const [[x0, y0], [x1, y1]] = [line[i - 1], line[i]];
    if (x1 < middle - half - 1 || x0 > middle + half + 1) continue;
    if (Math.max(y0, y1) > base - 10 && Math.min(y0, y1) < base + 3) ++count;
  }
  return count;
}

/// Places of a text beside a point, the best first: outwards from the middle of the panel, then aside, then farther away.
function placesBeside(x, y, half, [left, right, top, bottom]) {
  const up = y < (top + bottom) / 2, places = [];
  for (const away of [0, 14, 28])
    for (const base of up ? [y - 7 - away, y + 4, y + 14 + away] : [y + 14 + away, y + 4, y - 7 - away])
      for (const middle of base === y + 4 ? [x + half + 8 + away, x - half - 8 - away] : [x, x + half + 8 + away, x - half - 8 - away])
        places.push([clamped(middle, left + half + 4, right - half - 4), base, half]);
  return places.filter(([, base]) => base - 10 >= top && base + 3 <= bottom);
}

/// The exact extrema: a circle; beyond a limit, a full diamond. A text stands where it covers least of the `line` of the
/// curve; one that would cover another is left out. `taken` are the texts that are there: [middle, base line, half of the width].
function marks(panel, inside, toX, toY, frame, taken, line) {
  const out = [];
  for (const [at, value, broken] of panel.marks.filter(([x]) => inside(x))) {
    const x = toX(at), y = toY(value), words = number(withoutRounding(panel, value));
    out.push(broken ? path('badmark', `M${px(x)} ${px(y - 4)}l4 4-4 4-4-4z`) : svg('circle', {class: 'mark', cx: px(x), cy: px(y), r: 2.5}));
    const half = 3.3 * words.length;
    let best = null, least = Infinity;
    for (const place of placesBeside(x, y, half, frame)) {
      if (taken.some(([m, b, h]) => Math.abs(m - place[0]) < half + h + 4 && Math.abs(b - place[1]) < 12)) continue;
      if (Math.abs(place[0] - x) < half + 3 && y > place[1] - 13 && y < place[1] + 6) continue;  // over its own circle
      const count = covered(line, place);
      if (count < least) [best, least] = [place, count];
      if (count === 0) break;
    }
    if (!best) continue;
    taken.push(best);
    out.push(label(broken ? 'halo bad mid' : 'halo mid', best[0], best[1], words));
  }
  return out;
}

/// Draws the cursor of a drawing at x: a line over all panels, and a dot on each curve.
function drawCursor({toX, panels, cursor, left, right}, curves, x) {
  const at = toX(x);
  if (at < left - 0.5 || at > right + 0.5) return cursor.replaceChildren();
  const children = panels.map(({top, bottom}) => path('hair', `M${px(at)} ${top}V${bottom}`));
  curves.forEach((curve, i) => {
    if (curve instanceof Outline || !curve.contains(x)) return;
    const sides = curve.sides(x);
    panels.forEach(({panel, toY, top, bottom}, k) => {
      for (const y of new Set(sides.map((jet) => px(toY(jet[k] / panel.size)))))
        if (y >= top - 1 && y <= bottom + 1) children.push(svg('circle', {class: `dot d${i + 1}`, cx: px(at), cy: y, r: 3.5}));
    });
  });
  cursor.replaceChildren(...children);
}
