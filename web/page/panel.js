// SPDX-License-Identifier: Apache-2.0
// The live page of `jounce page`: statuses come as server-sent events, commands go as POSTs.

const token = location.hash.slice(1);  // after #: a browser never sends that part
const axes = new Map();  // by name: {element, parts, scope, sliding}

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

/// A position of a master, in its period if that is known: "30 of 360 deg".
const masterAt = (position, unit, modulo) => !modulo || position === null ? number(position, unit)
  : `${number(position - modulo * Math.floor(position / modulo))} of ${number(modulo, unit)}`;
/// A master: where it is, how fast, how long ago that was measured.
const wordsOf = (master, modulo) => master.lost ? `${master.name} is lost`
  : `${master.name} ${masterAt(master.position, master.unit, modulo)}, ${number(master.velocity, `${master.unit}/s`)}`
    + (master.age_ms ? `, ${number(master.age_ms, 'ms')} old` : '');

/// The place of a group on its path, with the line of the source.
const coordinatesOf = (group) => (group.framed ? 'in the frame: ' : '')
  + group.axes.map((axis, k) => `${axis} ${number(group.place[k], group.units[k])}`).join(', ');
const placeOf = (group, unit) => group.length === null ? number(group.position, unit)
  : `${number(group.position, unit)} of ${number(group.length, unit)}, line ${group.line}`;
/// What remains of the path of a group, and how much of it is planned without braking.
const remainingOf = (group, unit) => [group.remaining !== null && `${number(group.remaining, 's')}${group.estimated ? ' (estimate)' : ''}`,
  `${group.commands} commands`, group.look_ahead !== null && `look-ahead ${number(group.look_ahead, unit)}`].filter(Boolean).join(', ');

function say(text, ok) {
  const line = document.getElementById('said');
  line.textContent = text;
  line.classList.toggle('no', !ok);
}

/// Sends a command; true if the axis has accepted it.
async function post(path, body) {
  const {axis, what} = body;
  try {
    const answer = await fetch(path, {method: 'POST', keepalive: true, headers: {'X-Jounce-Token': token, 'Content-Type': 'application/json'},
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
const send = (axis, what, value, hold) => post('/order', {axis, what, value, hold});  // JSON leaves out what is undefined

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
  const view = {element, parts, sliding: false, units: {unit: '', group: null, master: ''}};
  parts.name.textContent = name;
  for (const input of element.querySelectorAll('.controls button,.controls input,.rare button,.orders button')) input.disabled = token === '';
  wire(name, view);
  document.getElementById('axes').append(element);
  axes.set(name, view);
  view.scope = new Scope(name, element.querySelector('.scope'));
  view.orders = new Orders(name, element.querySelector('.orders'), () => view.units);
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
  parts.master.textContent = axis.masters.length ? axis.masters.map((master) => wordsOf(master, view.scope.modulo)).join('; ')
    : masterAt(axis.master, axis.master_unit, view.scope.modulo);
  parts.queue.textContent = `${axis.queue} of ${axis.capacity}`;
  parts.level.value = axis.capacity ? axis.queue / axis.capacity : 0;
  if (axis.group) {
    parts.path.textContent = `${coordinatesOf(axis.group)}; ${placeOf(axis.group, unit)}`;
    parts.remaining.textContent = remainingOf(axis.group, unit);
  }
  for (const [part, known] of [['path', axis.group], ['remaining', axis.group], ['error', axis.error !== null],
    ['master', (axis.master !== null && axis.master_unit !== '') || axis.masters.length > 0], ['queue', axis.capacity > 0],
    ['homed', !axis.group]])
    parts[part].closest('dl > div').hidden = !known;
  parts.move.hidden = parts.jog.closest('.jog').hidden = axis.group !== null;  // a group has commands of its own
  if (axis.group && !view.leads) {  // before its axes
    view.leads = true;
    view.element.parentElement.prepend(view.element);
  }
  parts.homed.textContent = axis.homed ? 'yes' : 'no';
  parts.late.textContent = axis.late;
  parts.motions.textContent = `${axis.finished} done, ${axis.stopped} stopped`;
  parts.unit.textContent = unit;
  parts['jog-unit'].textContent = unit && `${unit}/s`;
  if (!view.sliding) {
    parts.slider.value = Math.round(axis.override * 100);
    parts.override.textContent = `${Math.round(axis.override * 100)} %`;
  }
  view.units = {unit, group: axis.group, master: axis.master_unit || axis.masters[0]?.unit || ''};
  view.scope.units = view.units;
  active.set(axis.name, axis.table);
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
  const counts = canvas.counts, surface = ink_of(canvas);
  if (!counts || !surface) return;
  const {ink, box} = surface;
  const bottom = box.height - 18, wide = box.width / counts.length;
  const most = Math.log10(1 + Math.max(10, ...counts));
  ink.textBaseline = 'top';
  ink.textAlign = 'right';
  counts.forEach((n, bin) => {
    ink.fillStyle = color_of('one');
    const high = Math.log10(1 + n) / most * (bottom - 6);
    ink.fillRect(bin * wide + 1, bottom - high, wide - 2, high);
    ink.fillStyle = color_of('soft');
    if (bin % 3 === 0) ink.fillText(bin === counts.length - 1 ? 'more' : bin < 10 ? `${2 ** bin} µs` : `${Math.round(2 ** bin / 1000)} ms`, Math.max(26, (bin + 1) * wide), bottom + 4);
  });
  ink.fillRect(0, bottom, box.width, 1);
}

function paint() {
  for (const canvas of document.querySelectorAll('canvas[data-bins]')) drawBins(canvas);
  dirty = false;
}

const path = new PathPlane(document.getElementById('path'));
path.units = (name) => axes.get(name)?.units.unit ?? '';
setInterval(() => { if (!document.hidden) showTables().catch(() => {}); }, 1000);

/// Draws everything again: the colors or the widths have changed.
function redraw() {
  for (const view of axes.values()) view.scope.draw();
  path.draw();
  tables_shown = '';
}
matchMedia('(prefers-color-scheme:dark)').addEventListener('change', redraw);
addEventListener('resize', redraw);

let dirty = false;
const link = document.getElementById('link');
document.getElementById('look').hidden = token !== '';

function take(event) {
  const {axes: axesNow, log} = JSON.parse(event);
  axesNow.forEach(show);
  showEvents(log);
  path.offer(axesNow);
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
