// SPDX-License-Identifier: Apache-2.0
'use strict';
// The live page of `jounce page`: statuses come as server-sent events, commands go as POSTs.

const token = location.hash.slice(1);  // after #: a browser never sends that part
const window_s = 10;
const axes = new Map();  // by name: {element, parts, samples}

const moving = ['discrete_motion', 'synchronized_motion', 'continuous_motion', 'homing'];
const classOf = (state) => state === 'error_stop' ? 'fault' : moving.includes(state) ? 'moving'
  : state === 'stopping' ? 'waiting' : '';

const asks = {
  stop: (axis) => [`Bring ${axis} to rest?`, 'Stop'],
  hold: (axis) => [`Hold ${axis} on its path?`, 'Hold'],
  resume: (axis) => [`Resume the motion of ${axis}? It may move at once.`, 'Resume'],
  enable: (axis) => [`Enable ${axis}?`, 'Enable'],
  disable: (axis) => [`Disable ${axis}? It will no longer hold its position.`, 'Disable'],
  reset: (axis) => [`Clear the fault of ${axis}?`, 'Reset'],
  move: (axis, value, unit) => [`Move ${axis} to ${value} ${unit}? It moves at once.`, 'Start'],
};

const number = (value, unit) => value === null || value === undefined ? '–'
  : `${Number(value.toPrecision(6)).toLocaleString('en', {maximumFractionDigits: 4, useGrouping: false})}${unit ? ' ' + unit : ''}`;
const words = (text) => text.replaceAll('_', ' ');

/// A master: where it is, how fast, how long ago that was measured.
const wordsOf = (master) => master.lost ? `${master.name} is lost`
  : `${master.name} ${number(master.position, master.unit)}, ${number(master.velocity, `${master.unit}/s`)}`
    + (master.age_ms ? `, ${number(master.age_ms, 'ms')} old` : '');

function say(text, ok) {
  const line = document.getElementById('said');
  line.textContent = text;
  line.classList.toggle('no', !ok);
}

/// Whether the axis has accepted it.
async function send(axis, what, value, hold) {
  const body = {axis, what, value, hold};  // JSON leaves out what is undefined
  try {
    const answer = await fetch('/order', {method: 'POST', keepalive: true, headers: {'X-Jounce-Token': token, 'Content-Type': 'application/json'},
      body: JSON.stringify(body)});
    const text = await answer.text();
    const reason = answer.headers.get('Content-Type').startsWith('application/json') ? JSON.parse(text).reason : text;
    say(answer.ok ? `${axis}: ${what} accepted` : `${axis}: ${what} was rejected: ${reason}`, answer.ok);
    return answer.ok;
  } catch (error) {
    say(`${axis}: the server of this page cannot be reached; the state of the axis is unknown`, false);
    return false;
  }
}

/// Shows the question; true once it was answered with yes.
function confirmed([question, yes]) {
  const dialog = document.getElementById('ask');
  dialog.querySelector('p').textContent = question;
  dialog.querySelector('button[value=yes]').textContent = yes;
  dialog.returnValue = 'no';
  dialog.showModal();
  return new Promise((resolve) =>
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'yes'), {once: true}));
}

function wire(name, view) {
  for (const button of view.element.querySelectorAll('button[data-what]')) {
    const what = button.dataset.what;
    if (what === 'move') continue;
    button.addEventListener('click', async () => { if (await confirmed(asks[what](name))) send(name, what); });
  }
  for (const button of view.element.querySelectorAll('button[data-jog]')) wireJog(name, view, button);
  view.parts.move.addEventListener('submit', async (event) => {
    event.preventDefault();
    const to = view.parts.move.querySelector('input').valueAsNumber;
    if (await confirmed(asks.move(name, to, view.parts.unit.textContent))) send(name, 'move', to);
  });
  const slider = view.parts.slider;
  slider.addEventListener('input', () => { view.sliding = true; view.parts.override.textContent = `${slider.value} %`; });
  slider.addEventListener('change', async () => {
    await send(name, 'override', slider.value / 100);
    view.sliding = false;
  });
}

const again_ms = 100;  // the server ends a jog that it is not asked for during 300 ms

/// A hold-to-run jog: asked for again and again while the button is held. The number of a jog that has ended begins none.
function wireJog(name, view, button) {
  let hold = 0, timer = 0, waiting = 0;
  const post = async (body) => {
    ++waiting;
    const ok = await send(name, body.what, body.value, body.hold);
    --waiting;
    if (!ok && body.hold === hold) end();
  };
  const end = () => {
    if (!hold) return;
    clearInterval(timer);
    button.classList.remove('held');
    const over = hold;
    hold = 0;
    send(name, 'release', undefined, over);
  };
  button.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || hold) return;
    const speed = view.parts.jog.valueAsNumber;
    if (!(speed > 0)) return say(`${name}: the velocity of the jog must be greater than 0`, false);
    button.classList.add('held');
    hold = Date.now();
    const body = {what: 'jog', value: speed * Number(button.dataset.jog), hold};
    post(body);
    timer = setInterval(() => { if (waiting < 3) post(body); }, again_ms);
  });
  for (const gone of ['pointerup', 'pointerleave', 'pointercancel', 'blur', 'contextmenu'])
    button.addEventListener(gone, end);
  addEventListener('blur', end);
  addEventListener('pagehide', end);
  document.addEventListener('visibilitychange', end);
}

function viewOf(name) {
  if (axes.has(name)) return axes.get(name);
  const element = document.getElementById('axis').content.firstElementChild.cloneNode(true);
  const parts = {};
  for (const part of element.querySelectorAll('[data-is]')) parts[part.dataset.is] = part;
  const view = {element, parts, samples: [], sliding: false};
  parts.name.textContent = name;
  for (const input of element.querySelectorAll('button,input')) input.disabled = token === '';
  wire(name, view);
  document.getElementById('axes').append(element);
  axes.set(name, view);
  return view;
}

function show(axis) {
  const view = viewOf(axis.name), parts = view.parts;
  const silent = axis.heard === null || axis.heard > 1;
  view.element.classList.toggle('silent', silent);
  if (axis.heard === null) { parts.state.textContent = 'no message yet'; return; }
  const unit = axis.unit;
  parts.state.textContent = silent ? `silent for ${axis.heard.toFixed(0)} s` : words(axis.state);
  parts.state.className = `state ${silent ? 'waiting' : classOf(axis.state)}`;
  parts.next.textContent = axis.next === 'nothing' ? '' : words(axis.next);
  parts.fault.hidden = axis.fault === null;
  if (axis.fault) parts.fault.textContent = `Fault ${axis.fault.number}, ${words(axis.fault.name)}. ${axis.fault.meaning}`;
  parts.position.textContent = number(axis.position, unit);
  parts.velocity.textContent = number(axis.velocity, unit && `${unit}/s`);
  parts.error.textContent = number(axis.error, unit);
  parts.master.textContent = axis.masters.length ? axis.masters.map(wordsOf).join('; ') : number(axis.master);
  parts.queue.textContent = `${axis.queue} of ${axis.capacity}`;
  parts.level.value = axis.capacity ? axis.queue / axis.capacity : 0;
  for (const [part, known] of [['error', axis.error !== null], ['master', axis.master !== null || axis.masters.length > 0], ['queue', axis.capacity > 0]])
    parts[part].closest('dl > div').hidden = !known;
  parts.homed.textContent = axis.homed ? 'yes' : 'no';
  parts.late.textContent = axis.late;
  parts.motions.textContent = `${axis.finished} done, ${axis.stopped} stopped`;
  parts.unit.textContent = unit;
  parts['jog-unit'].textContent = unit && `${unit}/s`;
  if (!view.sliding) {
    parts.slider.value = Math.round(axis.override * 100);
    parts.override.textContent = `${Math.round(axis.override * 100)} %`;
  }
  parts['position-title'].textContent = `position${unit && ` [${unit}]`}`;
  parts['velocity-title'].textContent = `velocity${unit && ` [${unit}/s]`}`;
  parts['error-title'].textContent = `following error${unit && ` [${unit}]`}`;
  parts['error-plot'].hidden = axis.error === null;
  const last = view.samples.at(-1);
  if (axis.samples.length && last && axis.samples[0][0] < last[0]) view.samples = [];  // it was started again
  view.samples.push(...axis.samples);
  const newest = view.samples.at(-1)?.[0] ?? 0;
  while (view.samples.length && view.samples[0][0] < newest - window_s) view.samples.shift();
}

/// A step of 1, 2 or 5 times a power of ten, so that at most `most` of them fit the span.
function step(span, most) {
  const raw = span / most, power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map((k) => k * power).find((s) => s >= raw);
}

function range(values) {
  let low = Infinity, high = -Infinity;
  for (const v of values) { if (v === null) continue; low = Math.min(low, v); high = Math.max(high, v); }
  if (low > high) return [-1, 1];
  const pad = (high - low) * 0.08 || Math.abs(high) * 0.1 || 1;
  return [low - pad, high + pad];
}

function draw(canvas, samples, column) {
  const box = canvas.getBoundingClientRect(), scale = devicePixelRatio || 1;
  if (box.width === 0) return;
  canvas.width = box.width * scale;
  canvas.height = box.height * scale;
  const ink = canvas.getContext('2d'), css = getComputedStyle(document.documentElement);
  const color = (name) => css.getPropertyValue(`--${name}`);
  ink.scale(scale, scale);
  ink.font = '11px system-ui,sans-serif';
  const left = 46, right = box.width - 4, top = 6, bottom = box.height - 18;
  const end = samples.at(-1)?.[0] ?? 0;
  const [low, high] = range(samples.map((s) => s[column]));
  const x = (t) => right - (end - t) / window_s * (right - left);
  const y = (v) => bottom - (v - low) / (high - low) * (bottom - top);
  ink.textAlign = 'right';
  ink.textBaseline = 'middle';
  ink.lineWidth = 1;
  ink.strokeStyle = color('grid');
  ink.fillStyle = color('soft');
  const rise = step(high - low, 4);
  for (let v = Math.ceil(low / rise) * rise; v <= high; v += rise) {
    ink.beginPath(); ink.moveTo(left, y(v)); ink.lineTo(right, y(v)); ink.stroke();
    ink.fillText(Number(v.toPrecision(6)), left - 6, y(v));
  }
  ink.textBaseline = 'top';
  for (let t = -window_s; t <= 0; t += 5) {
    ink.textAlign = t === 0 ? 'right' : t === -window_s ? 'left' : 'center';
    ink.fillText(t === 0 ? 'now' : `${t} s`.replace('-', '−'), x(end + t), bottom + 4);
  }
  ink.strokeStyle = color(['', 'one', 'two', 'four'][column]);
  ink.lineWidth = 1.5;
  ink.lineJoin = 'round';
  ink.beginPath();
  let pen = false;
  for (const s of samples) {
    if (s[column] === null) { pen = false; continue; }
    if (pen) ink.lineTo(x(s[0]), y(s[column])); else ink.moveTo(x(s[0]), y(s[column]));
    pen = true;
  }
  ink.stroke();
}

/// The upper end of the bin, in us, in which this share of all is reached; bin k ends at 2^k us.
function within(counts, share) {
  const all = counts.reduce((sum, n) => sum + n, 0);
  let seen = 0;
  const bin = counts.findIndex((n) => (seen += n) >= share * all);
  return bin === counts.length - 1 ? `over ${2 ** (bin - 1)}` : 2 ** bin;
}

/// One cycle for all axes: any of them tells it.
function showCycle(axis) {
  const section = document.getElementById('cycle');
  section.hidden = !axis || axis.heard === null;
  if (section.hidden) return;
  const part = (name) => section.querySelector(`[data-cycle=${name}]`);
  part('facts').textContent = `every ${number(axis.cycle_ms, 'ms')}, ${axis.late} late by a period or more`;
  for (const [name, what] of [['lateness', 'wake-up delay'], ['computing', 'computing time']]) {
    part(name).textContent = `${what}: half within ${within(axis[name], 0.5)} µs, 99.9 % within ${within(axis[name], 0.999)} µs`;
    section.querySelector(`canvas[data-bins=${name}]`).counts = axis[name];
  }
}

/// Bars of a histogram; heights by the logarithm, so that one cycle in a million is seen.
function drawBins(canvas) {
  const counts = canvas.counts, box = canvas.getBoundingClientRect(), scale = devicePixelRatio || 1;
  if (!counts || box.width === 0) return;
  canvas.width = box.width * scale;
  canvas.height = box.height * scale;
  const ink = canvas.getContext('2d'), css = getComputedStyle(document.documentElement);
  ink.scale(scale, scale);
  ink.font = '11px system-ui,sans-serif';
  const bottom = box.height - 18, wide = box.width / counts.length;
  const most = Math.log10(1 + Math.max(10, ...counts));
  ink.textBaseline = 'top';
  ink.textAlign = 'right';
  counts.forEach((n, bin) => {
    ink.fillStyle = css.getPropertyValue('--one');
    const high = Math.log10(1 + n) / most * (bottom - 6);
    ink.fillRect(bin * wide + 1, bottom - high, wide - 2, high);
    ink.fillStyle = css.getPropertyValue('--soft');
    if (bin % 3 === 0) ink.fillText(bin === counts.length - 1 ? 'more' : bin < 10 ? `${2 ** bin} µs` : `${Math.round(2 ** bin / 1000)} ms`, Math.max(26, (bin + 1) * wide), bottom + 4);
  });
  ink.fillRect(0, bottom, box.width, 1);
}

function paint() {
  for (const canvas of document.querySelectorAll('canvas[data-bins]')) drawBins(canvas);
  for (const view of axes.values())
    for (const canvas of view.element.querySelectorAll('canvas[data-plot]'))
      draw(canvas, view.samples, Number(canvas.dataset.plot));
  dirty = false;
}

let dirty = false;
const link = document.getElementById('link');
document.getElementById('look').hidden = token !== '';

function take(event) {
  const axesNow = JSON.parse(event).axes;
  axesNow.forEach(show);
  showCycle(axesNow.find((axis) => axis.heard !== null));
  if (!dirty) { dirty = true; requestAnimationFrame(paint); }
}

/// The events until the server ends them. EventSource could not send the token, for which a server with too
/// many readers closes another one.
async function read(answer) {
  const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
  for (let rest = ''; ;) {
    const {value, done} = await reader.read();
    if (done) return;
    rest += value;
    for (let end; (end = rest.indexOf('\n\n')) >= 0; rest = rest.slice(end + 2)) take(rest.slice('data: '.length, end));
  }
}

async function follow() {
  for (;;) {
    let why = 'no connection to the server of this page; trying again';
    try {
      const answer = await fetch('/events', {headers: token ? {'X-Jounce-Token': token} : {}});
      if (answer.ok) { link.textContent = 'live'; await read(answer); } else why = await answer.text();
    } catch (error) { /* as said above */ }
    link.textContent = why;
    for (const view of axes.values()) view.element.classList.add('silent');
    await new Promise((resolve) => setTimeout(resolve, 1000));
  }
}
follow();
