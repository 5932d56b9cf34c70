// SPDX-License-Identifier: Apache-2.0
// Sending the table to a running executor: an offer of the server with its facts, and the confirmation of a person.

class StreamDialog {
  /// `actions`: request(method, path, body), limits() as rows [quantity, peak, limit], broken() findings, window(title, ...content).
  constructor(actions) {
    this.actions = actions;
    this.given = {to: '', url: '', key: ''};
    this.now = null;  // the stream of the last event
  }

  /// Asks for the axis. `of`: {axis: number of the axis of the spec, name, kind: "cam", "follow" or "move", master_unit}.
  open(of) {
    const field = (key, text, placeholder) => {
      const input = html('input', {value: this.given[key], placeholder, size: 34, autocomplete: 'off', spellcheck: false, id: `stream-${key}`});
      return html('label', {}, `${text} `, input);
    };
    this.given.to ||= of.name;
    this.kind = of.kind;
    const fields = [field('to', 'Axis or group', 'name in its spec'), field('url', 'Address of the bus', 'default of jounce run, or unix://FOLDER'), field('key', 'Key file', 'none')];
    this.facts = html('div', {id: 'stream-facts'});
    this.master = this.masterFields(of);
    const form = html('form', {className: 'stream'}, ...fields, this.master.element, html('button', {id: 'stream-offer', textContent: 'Prepare'}));
    form.onsubmit = (event) => {
      event.preventDefault();
      ['to', 'url', 'key'].forEach((key, i) => { this.given[key] = fields[i].querySelector('input').value.trim(); });
      this.offer(of.axis);
    };
    this.actions.window('Send to an axis', html('p', {textContent: 'Nothing is sent before you confirm. The executor checks the table against the limits of its axis.'}), form, this.facts);
    if (this.now) this.show(this.now);
    fields[0].querySelector('input').focus();
  }

  /// The fields for the master of a cam or of a follow spec, and the members of the request that they set.
  masterFields({kind, master_unit: unit}) {
    const choice = (id, text, words) => {
      const select = html('select', {id: `stream-${id}`}, ...Object.entries(words).map(([value, textContent]) => html('option', {value, textContent})));
      return {select, label: html('label', {}, `${text} `, select)};
    };
    if (kind === 'follow') {
      const from = choice('relative', 'Positions', {no: 'those of the spec', yes: 'count from the position of the axis'});
      return {element: from.label, members: () => from.select.value === 'yes' ? {relative: true} : {}};
    }
    if (kind !== 'cam') return {element: '', members: () => ({})};
    const master = choice('master', 'Master', {spec: '[master] of the spec', live: 'live master of the axis'});
    const begin = choice('begin', 'Begin', {now: 'at once', position: 'when the master passes', cut: 'at the end of the present pass'});
    const end = choice('end', 'At the end', {brake: 'brake to standstill', keep: 'keep the velocity'});
    const position = html('input', {id: 'stream-position', size: 8, inputMode: 'decimal'});
    const at = html('label', {}, `Position [${unit}] `, position);
    const live = html('span', {className: 'stream'}, begin.label, at, end.label);
    const show = () => { live.hidden = master.select.value !== 'live'; at.hidden = begin.select.value !== 'position'; };
    master.select.onchange = begin.select.onchange = show;
    show();
    return {element: html('span', {className: 'stream'}, master.label, live), members: () => master.select.value !== 'live' ? {} : {
      live: true, ...(begin.select.value === 'position' && {start_at: numberOf(position.value)}),
      ...(begin.select.value === 'cut' && {at_next_cut: true}), ...(end.select.value === 'keep' && {keep_velocity: true})}};
  }

  async offer(axis) {
    const {to, url, key} = this.given, members = this.master.members();
    this.facts.replaceChildren();
    try {
      if (members.start_at === null || Number.isNaN(members.start_at)) throw Error('Give the position of the master at which the cam begins.');
      this.confirm(await this.actions.request('POST', '/stream', {do: 'offer', axis, to, ...(url && {url}), ...(key && {key}), ...members}), members.live || this.kind === 'follow');
    } catch (error) {
      this.facts.replaceChildren(html('p', {className: 'bad', role: 'alert', textContent: error.message}));
    }
  }

  /// Shows what would be sent, and waits for the confirmation.
  confirm(offer, live) {
    const row = (name, value) => html('tr', {}, html('th', {scope: 'row', textContent: name}), html('td', {textContent: value}));
    const broken = this.actions.broken();
    const send = html('button', {type: 'button', id: 'stream-confirm', textContent: live ? `Send; ${offer.to} then follows its master` : `Send, and start the motion of ${offer.to}`});
    send.onclick = async () => {
      send.disabled = true;
      try {
        await this.actions.request('POST', '/stream', {do: 'confirm', confirmation: offer.confirmation});
      } catch (error) {
        this.facts.append(html('p', {className: 'bad', role: 'alert', textContent: error.message}));
      }
    };
    this.facts.replaceChildren(
      html('table', {}, html('tbody', {}, row('axis', offer.to), row('bus', offer.url), row('state of the axis', offer.axis ?? 'no answer: check that the executor runs with this address and key'),
        ...(live ? [row('master', 'the live master of the axis'), row('begin', offer.begin)] : []),
        ...(offer.table ? [row('table (SHA-256)', offer.table), row('knots', offer.knots)] : [row('rows', offer.knots)]),
        row(live ? 'length of the master' : 'duration', `${number(offer.duration)} ${offer.time_unit}`), row('first position', `${number(offer.start)} ${offer.position_unit}`),
        ...this.actions.limits().map(([name, peak, limit]) => row(name, `peak ${peak}; limit ${limit}`)))),
      ...(broken ? [html('p', {className: 'bad', textContent: `${broken} ${broken === 1 ? 'check of the spec is' : 'checks of the spec are'} broken.`})] : []),
      send, html('div', {id: 'stream-outcome', role: 'status'}));
    send.focus();
  }

  /// Shows the stream of an event; null: none.
  show(now) {
    this.now = now;
    const place = document.getElementById('stream-outcome') ?? this.facts;
    if (!now || !place?.isConnected) return;
    const cancel = html('button', {type: 'button', textContent: 'Cancel', onclick: () => this.actions.request('POST', '/stream', {do: 'cancel'})});
    const progress = html('progress', {max: 1, value: now.done, 'aria-label': 'Progress of the stream'});
    place.replaceChildren(now.running ? html('p', {}, progress, ` ${now.step} `, cancel)
      : html('p', {className: now.started ? 'good' : 'bad', textContent: now.text}));
  }
}
