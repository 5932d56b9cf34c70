// SPDX-License-Identifier: Apache-2.0
// All commands of `jounce order`, with their options; the tables of the executor; the list of events.

let commands = null;  // the answer of /commands

const unit_for = (quantity, {unit, master}) => ({position: unit, velocity: unit && `${unit}/s`, acceleration: unit && `${unit}/s^2`,
  jerk: unit && `${unit}/s^3`, master, 'master velocity': master && `${master}/s`,
  'master acceleration': master && `${master}/s^2`, 'master jerk': master && `${master}/s^3`, time: 's'})[quantity] ?? '';

/// The unit of the rates of a command of a group, as the executor reads them: that of the axis with the option `axis`,
/// or of the first coordinate with a value, if none of these has the unit of the path. An arc moves path axes.
function rateUnit(order, coordinates, {unit, group}) {
  if (!group) return unit;
  const {axis} = order.options, list = order.options[coordinates];
  if (axis) return group.units[/^\d+$/.test(axis) ? axis - 1 : group.axes.indexOf(axis)] ?? unit;
  if (!list || order.what === 'move-circular') return unit;
  const units = list.split(',').map((text, k) => {
    const [value, name] = text.split('=').reverse();
    return value.trim() && group.units[name === undefined ? k : group.axes.indexOf(name.trim())];
  }).filter(Boolean);
  return units.includes(unit) ? unit : units[0] ?? unit;
}

/// A field for an option of a command.
function fieldOf(option) {
  const label = document.createElement('label');
  const input = document.createElement(Array.isArray(option.kind) ? 'select' : 'input');
  if (Array.isArray(option.kind)) for (const word of ['', ...option.kind]) input.add(new Option(word));
  else if (option.kind === 'flag') input.type = 'checkbox';
  input.dataset.option = option.name;
  input.title = option.help;
  label.title = option.help;
  label.append(option.name === 'VALUE' ? 'value' : option.name.replaceAll('-', ' '), ' ', input);
  return label;
}

/// The form of all commands of an axis.
class Orders {
  constructor(name, element, units) {
    this.name = name;
    this.units = units;
    this.select = element.querySelector('select');
    this.fields = element.querySelector('[data-orders=fields]');
    this.line = element.querySelector('code');
    element.addEventListener('toggle', () => this.fill());
    this.select.addEventListener('change', () => this.show());
    this.fields.addEventListener('input', () => this.preview());
    element.querySelector('form').addEventListener('submit', (event) => { event.preventDefault(); this.send(); });
  }

  async fill() {
    if (this.select.length) return;
    commands ??= await question('/commands', {});
    for (const [title, group] of [['axis or group', false], ['group only', true]]) {
      const list = document.createElement('optgroup');
      list.label = title;
      for (const command of commands) if (command.group === group) list.append(new Option(command.word));
      this.select.append(list);
    }
    this.show();
  }

  show() {
    const command = commands.find((one) => one.word === this.select.value);
    this.fields.replaceChildren(...command.options.map((option) => fieldOf(option)));
    this.preview();
  }

  words() {
    const order = {axis: this.name, what: this.select.value, value: '', options: {}, flags: []};
    for (const input of this.fields.querySelectorAll('[data-option]')) {
      const {option} = input.dataset;
      if (input.type === 'checkbox') { if (input.checked) order.flags.push(option); } else if (input.value.trim() === '') continue;
      else if (option === 'VALUE') order.value = input.value.trim();
      else order.options[option] = input.value.trim();
    }
    return order;
  }

  /// The units of the fields, as placeholders.
  showUnits(order) {
    const units = this.units(), {options} = commands.find((one) => one.word === order.what);
    const lists = options.filter((option) => option.kind === 'coordinates').map(({name}) => name);
    const rates = rateUnit(order, lists.find((name) => order.options[name]), units);
    for (const {name, quantity, kind} of options) {
      const input = this.fields.querySelector(`[data-option="${name}"]`), is_list = lists.includes(name) && units.group;
      if (kind === 'flag' || Array.isArray(kind)) continue;
      input.placeholder = is_list && quantity === 'position' ? units.group.units.join(', ')
        : unit_for(quantity, quantity === 'position' ? units : {...units, unit: rates});
    }
  }

  /// The same as a command line.
  preview() {
    const order = this.words();
    this.showUnits(order);
    const options = Object.entries(order.options).map(([option, text]) => `--${option} ${text}`);
    this.line.textContent = ['jounce order', this.name, order.what, order.value, ...options, ...order.flags.map((flag) => `--${flag}`)].filter(Boolean).join(' ');
  }

  async send() {
    const order = this.words();
    if (await confirmed([`Send this command to ${this.name}?  ${this.line.textContent}`, 'Send'])) post('/command', order);
  }
}

// ---- tables --------------------------------------------------------------------------------------

const active = new Map();  // by axis: the first digits of the hash of its table

function drawTable(canvas, table) {
  const surface = ink_of(canvas);
  if (!surface) return;
  const {ink, box} = surface, least = Math.min(...table.position), most = Math.max(...table.position);
  const y = (v) => box.height - 5 - (v - least) / (most - least || 1) * (box.height - 10);
  ink.strokeStyle = color_of('one');
  ink.lineWidth = 1.5;
  ink.beginPath();
  table.position.forEach((v, i) => ink.lineTo(3 + i / (table.position.length - 1) * (box.width - 6), y(v)));
  ink.stroke();
}

let tables_shown = '';

async function showTables() {
  const {tables} = await question('/tables', {});
  const section = document.getElementById('tables');
  const state = JSON.stringify([tables.map((table) => table.number), [...active]]);
  section.hidden = tables.length === 0;
  if (state === tables_shown) return;
  tables_shown = state;
  section.querySelector('.cards').replaceChildren(...tables.map((table) => {
    const figure = document.createElement('figure'), canvas = document.createElement('canvas'), caption = document.createElement('figcaption');
    const is_active = (active.get(table.axis) ?? '') !== '' && table.hash.startsWith(active.get(table.axis));
    const text = `${table.axis}, ${table.knots} knots over ${table.over === 'time' ? 'time' : 'the master'} ${short(table.start)} to ${short(table.end)} ${table.x_unit}, `
      + `position ${range_text(Math.min(...table.position), Math.max(...table.position))} ${table.unit}`;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', text);
    const hash = document.createElement('code');
    hash.textContent = table.hash.slice(0, 16);
    figure.classList.toggle('active', is_active);
    caption.append(hash, is_active ? ' (in use)' : '', document.createElement('br'), text);
    figure.append(canvas, caption);
    requestAnimationFrame(() => drawTable(canvas, table));
    return figure;
  }));
}

// ---- events --------------------------------------------------------------------------------------

const most_events = 200;

function showEvents(log) {
  const list = document.querySelector('#log ol');
  for (const event of log) {
    const item = document.createElement('li'), time = document.createElement('time'), text = document.createElement('span');
    time.textContent = `${event.time.toFixed(3)} s`;
    const kind = {state: '', fault: 'Fault: ', rejected: 'Command rejected: ', dropped: 'Waiting motion dropped: ', ended: 'Motion ended: '}[event.kind];
    text.textContent = `${event.axis}: ${kind}${words(event.name)}. ${event.kind === 'state' ? '' : event.text}`;
    item.className = `kind-${event.kind}`;
    item.append(time, text);
    if (event.kind !== 'state' && event.remedy) {
      const remedy = document.createElement('p');
      remedy.textContent = event.remedy;
      item.append(remedy);
    }
    list.prepend(item);
  }
  while (list.children.length > most_events) list.lastChild.remove();
  document.getElementById('log').hidden = list.children.length === 0;
}
