// SPDX-License-Identifier: Apache-2.0
// The page of `jounce edit`. The server has the text, its versions and the library; docs/reference/http.md describes its
// interface. The page shows the answers and sends changes; it keeps no state but what is being typed or dragged.

const token = location.hash.slice(1);  // after #: a browser never sends that part
const $ = (id) => document.getElementById(id);
const again_ms = 1000, typing_ms = 350;

let state = null;      // the last answer of /document
let shownCam = null;   // the cam of the curves in the picture
let picture = null, axis = 0;
let laws = [];
let busy = 0;          // requests that change the document and are not answered yet
let typing = 0;        // timer of the text

// ---- requests ------------------------------------------------------------------------------------

class Rejected extends Error {
  constructor(status, reason) {
    super(reason);
    this.status = status;
  }
}

async function request(method, path, body) {
  const answer = await fetch(path, {method, headers: {'X-Jounce-Token': token, ...(body && {'Content-Type': 'application/json'})}, body: body && JSON.stringify(body)});
  const text = await answer.text();
  const json = answer.headers.get('Content-Type').startsWith('application/json');
  if (!answer.ok) throw new Rejected(answer.status, json ? JSON.parse(text).reason : text.trim());
  return json ? JSON.parse(text) : text;
}

let turn = Promise.resolve();  // of the last request that changes the document: each waits for the one before

/// Runs a function after those that were given before it.
function inTurn(run) {
  turn = turn.then(run, run);
  return turn;
}

/// Sends a request that changes the document, and shows its answer. Returns true if the server accepted it.
function act(path, body, input) {
  ++busy;
  return inTurn(() => send(path, body, input)).finally(() => --busy);
}

async function send(path, body, input) {
  if (!await sendTyped()) return false;
  try {
    show(await request('POST', path, {revision: state.revision, ...body}));
    return true;
  } catch (error) {
    if (error instanceof Rejected && error.status === 409) await load();
    say(error instanceof Rejected ? error.message : unreachable, true);
    if (input) { input.setAttribute('aria-invalid', 'true'); input.title = error.message; }
    else if (state) show(state);
    return false;
  }
}

const change = (what, input) => act('/change', {change: what}, input);

async function load() {
  show(await request('GET', '/document'));
}

// ---- notices -------------------------------------------------------------------------------------

const unreachable = 'The editor does not answer. It has ended, or the computer is busy. The unsaved text is in its side file.';

/// Shows a notice with this key, or removes it (words = null). `buttons`: [text, act].
function notice(key, words, bad = false, buttons = []) {
  const old = $('notices').querySelector(`[data-key="${key}"]`);
  if (!words) return old?.remove();
  const box = html('div', {className: `notice${bad ? ' bad' : ''}`, role: bad ? 'alert' : 'status'}, html('span', {textContent: words}),
    ...buttons.map(([text, run]) => html('button', {type: 'button', textContent: text, onclick: run})));
  box.dataset.key = key;
  if (old?.textContent === box.textContent) return undefined;
  return old ? old.replaceWith(box) : $('notices').append(box);
}

/// Shows a message until the next change.
function say(words, bad = false) {
  notice('said', words, bad, words ? [['Close', () => say(null)]] : []);
}

function showNotices() {
  const name = state.file.split('/').at(-1);
  notice('conflict', state.on_disk === 'changed' ? `Another program has changed ${name}, and this text has unsaved changes. Nothing was replaced.` : null, true, [
    ['Compare', compare], ['Use the text of the file', () => act('/conflict', {use: 'file'})], ['Keep this text', () => act('/conflict', {use: 'mine'})]]);
  notice('missing', state.on_disk === 'missing' ? `${name} does not exist on the disk. Save writes it.` : null, state.text !== '');
  notice('recovered', state.recovered ? `This text was not saved when an earlier editor ended. Undo shows the text of ${name}.` : null, false, [['Undo', () => act('/undo')]]);
  notice('side', state.side_error ? `The unsaved text cannot be kept beside the file: ${state.side_error}` : null, true);
}

// ---- the document --------------------------------------------------------------------------------

function show(answer) {
  const other = state && answer.revision !== state.revision;
  state = answer;
  if (other) say(null);
  const name = state.file.split('/').at(-1);
  document.title = `${state.saved ? '' : '● '}${name}`;
  $('name').textContent = name;
  $('saved').textContent = state.saved ? 'saved' : 'unsaved changes';
  $('save').disabled = state.saved;
  for (const [id, label] of [['undo', state.undo], ['redo', state.redo]]) {
    $(id).disabled = label === null;
    $(id).title = label === null ? '' : `${id === 'undo' ? 'Undo' : 'Redo'}: ${label} (Ctrl+${id === 'undo' ? 'Z' : 'Shift+Z'})`;
  }
  if (!pane.isTyped) pane.take(state.text);
  showNotices();
  showAnalysis(state);
}

/// Shows the curves, the table and the findings of an answer of /document or /preview.
function showAnalysis(answer) {
  const stale = answer.charts.length === 0 && picture !== null;
  document.querySelector('.left').classList.toggle('stale-curves', stale);
  $('stale').hidden = !stale;
  showAxes(answer.charts);
  if (answer.charts.length > 0) {
    shownCam = answer.cam;
    const data = answer.charts[axis];
    if (!picture) {
      picture = new EditPicture($('figure'), data, {preview, drop, cancel: cancelDrag, insert, moved: (x) => plane.mark(x)});
    }
    picture.take(data, axis, answer.edit, answer.cam);
  }
  $('segments').hidden = answer.cam === null;
  if (answer.cam) table.take(answer.cam, laws, stale ? null : picture?.views[0]);
  plane.take(answer.charts, answer.edit);
  tables.take(answer.edit?.tables ?? []);
  $('insert').hidden = !answer.edit?.insert || answer.cam !== null || stale;
  $('help').hidden = picture === null;
  $('help').querySelector('p').hidden = !(answer.edit?.handles.length > 0 || answer.edit?.plane.length > 0);
  $('measured').hidden = answer.cam === null && answer.result.kind !== '' && answer.edit !== null;
  showMeasured();
  showGallery();
  $('optimize').hidden = !answer.can_optimize;
  showFindings(answer.result);
  $('check').hidden = answer.check === '';
  $('check-text').textContent = answer.check;
}

/// Buttons for the axes of a spec of several axes.
function showAxes(charts) {
  $('axes').hidden = charts.length < 2;
  axis = Math.min(axis, Math.max(charts.length - 1, 0));
  $('axes').replaceChildren(...charts.map(({name}, i) => {
    const button = html('button', {type: 'button', textContent: name, onclick: () => { axis = i; showAnalysis(state); }});
    button.setAttribute('aria-pressed', i === axis);
    return button;
  }));
}

const words_of = {error: 'error', broken: 'broken', warning: 'warning', note: 'note', ok: 'ok'};

/// The level of a finding: an "error" with a limit or a place on the curve is a broken check.
const levelOf = ({severity, rule}) => severity === 'error' && !rule.startsWith('input/') ? 'broken' : severity;

function showFindings({findings}) {
  const shown = findings.map((finding) => ({...finding, level: levelOf(finding)}));
  const bad = shown.filter(({level}) => level === 'broken' || level === 'error').length;
  const warnings = shown.filter(({level}) => level === 'warning').length;
  const verdict = $('verdict');
  verdict.hidden = !$('gallery').hidden;
  verdict.className = `verdict ${bad ? 'no' : 'ok'}`;
  verdict.children[0].textContent = bad ? '✗' : '✓';
  verdict.children[1].textContent = bad ? `${bad} ${bad === 1 ? 'finding needs' : 'findings need'} a change: ${raisedUnit(shown[0].message)}`
    : `All checks hold${warnings ? `; ${warnings} ${warnings === 1 ? 'warning' : 'warnings'}` : ''}.`;
  $('findings').replaceChildren(...shown.map((finding) => html('li', {className: finding.level}, html('b', {textContent: words_of[finding.level]}),
    html('span', {}, html('button', {type: 'button', textContent: raisedUnit(finding.message), onclick: () => goToFinding(finding)}),
      html('small', {textContent: [finding.advice, finding.line ? `line ${finding.line}` : ''].filter(Boolean).join(' – ')})))));
  pane.mark(shown);
}

/// Shows a finding in the picture and in the text.
function goToFinding({where, where_unit: unit, line, column}) {
  if (line) pane.goTo(line, where === null);
  if (where !== null && !unit && picture) picture.goTo(where, where);
}

// ---- dragging ------------------------------------------------------------------------------------

let wanted = null, asked = false;  // the newest change to preview, and whether a preview is on its way

async function preview(what) {
  wanted = what;
  if (asked) return;
  asked = true;
  while (wanted) {
    const now = wanted;
    wanted = null;
    try {
      const answer = await request('POST', '/preview', {change: now});
      if (picture?.drag || plane.drag) showAnalysis(answer);
    } catch (error) {
      if (error instanceof Rejected) say(error.message, true);
    }
  }
  asked = false;
}

async function drop(what) {
  wanted = null;
  await change(what);
}

function cancelDrag() {
  wanted = null;
  showAnalysis(state);
}

/// Inserts a point, or a knot of a cam, on the curve at x.
const insert = (x) => change({do: 'insert', at: tidy(x)}) && true;

// ---- the text ------------------------------------------------------------------------------------

const pane = new TextPane($('text'), $('gutter'), $('place'), {typed: () => {
  clearTimeout(typing);
  typing = setTimeout(() => inTurn(sendTyped), typing_ms);
  $('saved').textContent = 'unsaved changes';
  $('save').disabled = false;
}});

/// Sends what was typed. If another page has changed the document meanwhile, the reader decides.
/// Returns true if the server has the text of the page.
async function sendTyped() {
  clearTimeout(typing);
  while (pane.isTyped) {
    const text = $('text').value;
    try {
      const answer = await request('POST', '/document', {revision: state.revision, text});
      notice('other', null);
      pane.shown = text;
      pane.changed = [0, 0];
      show(answer);
    } catch (error) {
      if (!(error instanceof Rejected)) typing = setTimeout(() => inTurn(sendTyped), again_ms);
      if (error.status !== 409) { say(error instanceof Rejected ? error.message : unreachable, true); return false; }
      state = await request('GET', '/document');
      notice('other', 'The document was changed elsewhere while you typed here. Your text is not sent yet.', true, [
        ['Use my text', () => { notice('other', null); inTurn(sendTyped); }],
        ['Use the other text', () => { notice('other', null); pane.shown = $('text').value; show(state); }]]);
      return false;
    }
  }
  return true;
}

// ---- the windows ---------------------------------------------------------------------------------

function openWindow(title, ...content) {
  $('window-title').textContent = title;
  $('window-body').replaceChildren(...content);
  if (!$('window').open) $('window').showModal();
}

/// A picture of two curves; it is drawn when its element is on the page.
function comparisonPicture(charts, id) {
  const figure = html('figure');
  requestAnimationFrame(() => { if (charts.length > 0) new Report(figure, charts[0], id); });
  return figure;
}

function differenceText(before, now) {
  const pre = html('pre', {tabIndex: 0});
  for (const [kind, line] of lineDifference(before, now))
    pre.append(html('span', {className: kind === '+' ? 'add' : kind === '-' ? 'cut' : '', textContent: `${kind} ${line}\n`}));
  return pre;
}

/// Compares the text with the saved file (against = "file") or with the newest commit ("head").
async function compareWith(against) {
  const words = {file: 'the file', head: 'the newest commit'};
  const other = against === 'file' ? 'head' : 'file';
  const title = `Comparison with ${words[against]}`;
  const switching = html('button', {type: 'button', textContent: `Compare with ${words[other]}`, onclick: () => compareWith(other)});
  try {
    await inTurn(sendTyped);
    const {before, difference, charts} = await request('GET', `/difference?against=${against}`);
    if (before === state.text) return openWindow(title, switching, html('p', {textContent: `The text is that of ${words[against]}.`}));
    openWindow(title, switching, differenceText(before, state.text), comparisonPicture(charts, 'difference'), html('pre', {textContent: difference, tabIndex: 0}));
  } catch (error) {
    if (against === 'head') return openWindow(title, switching, html('p', {textContent: error.message}));
    say(error.message, true);
  }
}
const compare = () => compareWith('file');

// ---- measured points -----------------------------------------------------------------------------

let measured = null;  // {name, text, pairs}

async function takePoints(file) {
  const text = await file.text(), pairs = pairsOf(text);
  if (pairs.length < 2) return say(`${file.name}: no line has two numbers: give the columns master and slave`, true);
  measured = {name: file.name, text, pairs, units: unitsOf(text)};
  $('fit-tolerance').value = '';
  return showMeasured();
}

function showMeasured() {
  $('fit').hidden = measured === null;
  const units = shownCam?.units;
  const fits = measured && units && [units.master, units.slave].every((unit, i) => (measured.units[i] ?? unit) === unit);
  const shown = fits ? measured.pairs : undefined;
  if (picture && picture.measured !== shown) picture.lay(shown);
  if (measured === null) return;
  const most = fits ? farthest(picture.views[0].curves[0], measured.pairs) : null;
  $('fit-facts').textContent = `${measured.name}: ${measured.pairs.length} points`
    + (units && !fits ? `; the picture does not show them: their units are ${measured.units.join(' and ')}, those of the cam ${units.master} and ${units.slave}` : '')
    + (most ? `; greatest distance ${number(most.distance)} ${units.slave} at ${number(most.x)} ${units.master}` : '');
}

async function fitPoints() {
  const units = state.cam?.units;
  try {
    await inTurn(sendTyped);
    const result = await request('POST', '/fit', {name: measured.name, points: measured.text, tolerance: $('fit-tolerance').value.trim(),
      ...($('fit-period').value.trim() && {period: $('fit-period').value.trim()}),
      ...(units && {master_unit: units.master, position_unit: units.slave})});
    const take = html('button', {type: 'button', textContent: 'Take the fitted cam', onclick: () => { $('window').close(); act('/document', {text: result.spec}); }});
    openWindow('Cam through the measured points', take, comparisonPicture(result.charts, 'fitted'), html('pre', {textContent: result.text, tabIndex: 0}));
  } catch (error) {
    say(error.message, true);
  }
}

// ---- templates -----------------------------------------------------------------------------------

let templates = null;

/// The first sentence of the comment at the beginning of a text.
const aboutOf = (text) => text.split(/\n(?:# *\n|(?!#))/)[0].replace(/\n?# ?/g, ' ').trim().split('. ')[0].replace(/[.:]$/, '');

async function showGallery() {
  const is_empty = state.text.trim() === '';
  $('gallery').hidden = !is_empty;
  $('finding-list').hidden = is_empty;
  for (const id of ['validate', 'difference', 'measured', 'report', 'table', 'stream']) $(id).disabled = is_empty;
  if ($('gallery').hidden || templates) return;
  templates = await request('GET', '/templates');
  templates.sort((a, b) => (a.picture === '') - (b.picture === ''));  // motions first
  $('gallery').querySelector('.cards').replaceChildren(...templates.map(({kind, text, picture: drawing}) => html('button', {type: 'button', className: 'card', onclick: () => act('/document', {text})},
    html('b', {textContent: kind}), html('small', {textContent: aboutOf(text)}), ...(drawing ? [html('img', {alt: `Curve of the template ${kind}`, src: `data:image/svg+xml,${encodeURIComponent(drawing)}`})] : []))));
}

const short = (value) => value === null ? '∞' : number(value, 4);

/// All laws with their characteristic values, and the peaks of the segment with each law.
async function showLaws(k) {
  const quantity = (name) => picture.views[0].panels[name];
  const rows = laws.map((law) => {
    const use = html('button', {type: 'button', textContent: 'Use', 'aria-label': `use ${law.title}`, onclick: () => { $('window').close(); change({do: 'law', segment: k, law: law.name}); }});
    const peaks = [1, 2, 3].map(() => html('td', {className: 'n', textContent: '…'}));
    return {law, peaks, element: html('tr', {}, html('th', {scope: 'row', textContent: law.title, title: law.use}),
      ...['cv', 'ca', 'cj', 'cm'].map((name) => html('td', {className: 'n', textContent: law.values ? short(law.values[name]) : ''})), ...peaks, html('td', {}, use))};
  });
  const unit = (order) => ` [${quantity(order).unit}]`;
  const head = ['law', 'Cv', 'Ca', 'Cj', 'Cm', `velocity${unit(1)}`, `acceleration${unit(2)}`, `jerk${unit(3)}`, ''];
  openWindow(`Laws for segment ${k}`,
    html('p', {textContent: 'Cv, Ca, Cj and Cm are the characteristic values of VDI 2143. The last three columns are the peaks of the whole cam with this law in the segment.'}),
    html('div', {className: 'scroll', tabIndex: 0}, html('table', {}, html('thead', {}, html('tr', {}, ...head.map((text, i) => html('th', {scope: 'col', textContent: text, className: i > 0 ? 'n' : ''})))),
      html('tbody', {}, ...rows.map(({element}) => element)))));
  for (const {law, peaks} of rows) {
    if (!$('window').open) return;
    try {
      const {charts} = await request('POST', '/preview', {change: {do: 'law', segment: k, law: law.name}});
      peaks.forEach((cell, i) => {
        const marks = charts[0]?.views[0].panels[i + 1].marks ?? [];
        cell.textContent = marks.length > 0 ? number(Math.max(...marks.map(([, y]) => Math.abs(y))), 5) : '–';
      });
    } catch (error) {
      for (const cell of peaks) cell.textContent = '–';
    }
  }
}

const stream = new StreamDialog({
  request, window: openWindow,
  broken: () => state.result.findings.filter((finding) => ['broken', 'error'].includes(levelOf(finding))).length,
  limits: () => state.charts[axis].views[0].panels.filter(({upper, lower}) => upper !== null || lower !== null).map(({name, unit, upper, lower, marks}) => [
    name, `${number(Math.max(0, ...marks.map(([, y]) => Math.abs(y))))} ${unit}`,
    `${[lower, upper].filter((limit) => limit !== null).map((limit) => number(limit)).join(' to ')} ${unit}`]),
});

async function openStream() {
  await inTurn(sendTyped);
  if (state.charts.length === 0) return say('The text describes no motion that can be sent.', true);
  const {name, views: [view]} = state.charts[axis];
  const kind = state.result.kind === 'follow' ? 'follow' : view.axis.startsWith('master') ? 'cam' : 'move';
  const executor = state.charts.length > 1 ? name.split(' ').at(-1) : name;
  return stream.open({axis, name: /^[\w-]{1,23}$/.test(executor) ? executor : '', kind, master_unit: view.unit});
}

const table = new SegmentTable($('knots'), {
  change, laws: showLaws, refuse: (words) => say(words, true),
  show: (k) => {
    const {knots, segments} = shownCam;
    pane.goTo(segments[k - 1].line, false);
    picture.goTo(knots[k - 1].master, knots[k].master);
  },
  hover: (k) => picture?.highlight(k === null || !shownCam?.knots[k] ? null : [shownCam.knots[k - 1].master, shownCam.knots[k].master]),
});

const tables = new NumberTables($('tables'), {change, refuse: (words) => say(words, true), goTo: (line) => line && pane.goTo(line, false)});
const plane = new Plane($('plane'), {preview, drop, cancel: cancelDrag});

// ---- the optimizer -------------------------------------------------------------------------------

let job = null;  // of the last event

async function showJob(now) {
  const ended = job?.running !== false && now?.running === false;
  job = now;
  $('job').hidden = !now;
  if (!now) { $('outcome').replaceChildren(); $('outcome-text').hidden = true; return; }
  $('progress').value = now.done;
  $('progress').hidden = $('stop').hidden = !now.running;
  $('step').textContent = now.running ? `${Math.round(100 * now.done)} % ${now.step}` : now.error || 'finished';
  $('discard').hidden = now.running;
  if (now.running) { $('take').hidden = true; $('outcome-text').hidden = true; $('outcome').replaceChildren(); }
  if (!ended) return;
  const result = await request('GET', '/optimum');
  $('take').hidden = result.spec === null;
  $('outcome-text').hidden = !result.text;
  $('outcome-text').textContent = result.text + (result.broken ? `\nThe result breaks these checks:\n${result.broken}` : '');
  $('outcome').replaceChildren();
  if (result.charts) new Report($('outcome'), result.charts[0], 'outcome');
}

// ---- `jounce validate` ---------------------------------------------------------------------------

let proof = null;  // of the last event

async function showProof(now) {
  const ended = proof?.running !== false && now?.running === false;
  proof = now;
  $('proof').hidden = !now;
  if (!now) return;
  $('proof-done').value = now.done;
  $('proof-done').hidden = $('proof-stop').hidden = !now.running;
  $('proof-close').hidden = now.running;
  $('proof-step').textContent = now.running ? `${Math.round(100 * now.done)} % ${now.step}` : now.error;
  $('proof-stale').hidden = now.running || now.current;
  if (now.running) $('proof-verdict').hidden = $('proof-text').hidden = true;
  if (!ended || now.error) return;
  const result = await request('GET', '/proof');
  const verdict = $('proof-verdict');
  verdict.hidden = false;
  verdict.className = `verdict ${result.proven ? 'ok' : 'no'}`;
  verdict.children[0].textContent = result.proven ? '✓' : '✗';
  verdict.children[1].textContent = result.proven ? 'Proven: the integration agrees with the curve and with the table.' : 'Not proven: the text below has the reasons.';
  $('proof-text').hidden = false;
  $('proof-text').textContent = raisedUnit(result.text.trimEnd());
}

// ---- buttons, keys, events -----------------------------------------------------------------------

function download(name, blob) {
  const url = URL.createObjectURL(blob);
  html('a', {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), again_ms);
}

/// A file of the server, as its bytes.
async function fileOf(path) {
  const answer = await fetch(path, {headers: {'X-Jounce-Token': token}});
  if (!answer.ok) throw new Rejected(answer.status, JSON.parse(await answer.text()).reason);
  return answer.blob();
}

const stem = () => state.file.split('/').at(-1).replace(/\.toml$/, '');

async function downloadReport() {
  try {
    await inTurn(sendTyped);
    download(`${stem()}.html`, await fileOf(`/report?axis=${axis}`));
  } catch (error) {
    say(error.message, true);
  }
}

let forms = [];
const exporter = new ExportDialog({request, file: fileOf, save: download, window: openWindow});

async function exportTable() {
  await inTurn(sendTyped);
  if (state.charts.length === 0) return say('The text describes no motion that can be exported.', true);
  const {views} = state.charts[axis];
  return exporter.open({axis, stem: stem(), over: views.length > 1, forms, first: views[0].axis.split(' [')[0], units: [views[0].unit, views[0].panels[0].unit]});
}

async function save() {
  await inTurn(sendTyped);
  if (!state.saved && await act('/save', {})) say(null);
}

function listen() {
  $('undo').onclick = () => act('/undo');
  $('redo').onclick = () => act('/redo');
  $('save').onclick = save;
  $('difference').onclick = compare;
  $('stream').onclick = openStream;
  $('measured').onclick = () => $('measured-file').click();
  $('measured-file').onchange = () => { if ($('measured-file').files.length > 0) takePoints($('measured-file').files[0]); $('measured-file').value = ''; };
  $('fit-form').onsubmit = (event) => { event.preventDefault(); fitPoints(); };
  $('fit-remove').onclick = () => { measured = null; showMeasured(); };
  addEventListener('dragover', (event) => { if (event.dataTransfer?.types.includes('Files')) event.preventDefault(); });
  addEventListener('drop', (event) => {
    if (!event.dataTransfer?.files.length) return;
    event.preventDefault();
    takePoints(event.dataTransfer.files[0]);
  });
  $('report').onclick = downloadReport;
  $('table').onclick = exportTable;
  $('split').onclick = $('insert').onclick = () => insert(picture.x);
  $('append').onclick = () => change({do: 'append'});
  $('whole-what').onchange = () => { $('whole-by').hidden = $('whole-what').value.startsWith('mirror'); };
  $('whole').onsubmit = (event) => {
    event.preventDefault();
    const [what, of] = $('whole-what').value.split(' ');
    const by = numberOf($('whole-by').value);
    if (what === 'mirror') return change({do: what, axis: of});
    if (by === null || Number.isNaN(by)) return table.refuse($('whole-by'), 'give a number');
    $('whole-by').removeAttribute('aria-invalid');
    return change({do: what, axis: of, by}, $('whole-by'));
  };
  const optimizer = (body) => async () => {
    try {
      await inTurn(sendTyped);
      if (body.do) show(await request('POST', '/optimum', {revision: state.revision, ...body}));
      else await request('POST', '/optimize', {});
    } catch (error) {
      say(error.message, true);
    }
  };
  const prover = (path, body) => async () => {
    try {
      await inTurn(sendTyped);
      await request('POST', path, body);
    } catch (error) {
      say(error.message, true);
    }
  };
  $('validate').onclick = prover('/validate', {});
  $('proof-stop').onclick = prover('/proof', {do: 'stop'});
  $('proof-close').onclick = prover('/proof', {do: 'discard'});
  $('optimize').onclick = optimizer({});
  for (const id of ['stop', 'take', 'discard']) $(id).onclick = optimizer({do: id});
  addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    const run = {s: save, z: () => act(event.shiftKey ? '/redo' : '/undo'), y: () => act('/redo')}[key];
    if (!run) return;
    event.preventDefault();
    run();
  });
}

/// Reads the events until the connection ends: the number of the document, and the optimizer.
async function follow() {
  const ended = new AbortController();  // a page that the browser keeps for "back" must not keep a connection
  addEventListener('pagehide', () => ended.abort(), {once: true});
  const answer = await fetch('/events', {headers: {'X-Jounce-Token': token}, signal: ended.signal});
  if (!answer.ok) throw new Rejected(answer.status, await answer.text());
  const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
  for (let rest = '';;) {
    const {value, done} = await reader.read();
    if (done) return;
    const parts = (rest + value).split('\n\n');
    rest = parts.pop();
    for (const part of parts) {
      const event = JSON.parse(part.replace(/^data: /, ''));
      if (event.revision !== state.revision && busy === 0) await load();
      stream.show(event.stream);
      await showJob(event.optimum);
      await showProof(event.proof);
    }
  }
}

/// The laws, with their characteristic values as text for the list.
const lawsOf = (list) => list.map(({law, title, use, inflection, cv, ca, cj, cm}) => ({
  name: law, title, use, inflection, values: cv === undefined ? null : {cv, ca, cj, cm},
  text: cv === undefined ? '' : `Cv ${short(cv)}, Ca ${short(ca)}, Cj ${short(cj)}`,
}));

async function begin() {
  if (token === '') return notice('token', 'This address has no token. Open the address that `jounce edit` printed.', true);
  listen();
  for (;;) {
    try {
      if (laws.length === 0) {
        laws = lawsOf(await request('GET', '/laws'));
        forms = await request('GET', '/forms');
      }
      await load();
      notice('lost', null);
      await follow();
    } catch (error) {
      if (error instanceof Rejected && error.status === 403) return notice('token', `${error.message} The address has another token.`, true);
    }
    notice('lost', unreachable, true);
    await new Promise((resolve) => setTimeout(resolve, again_ms));
  }
}

begin();
