// SPDX-License-Identifier: Apache-2.0
// The table as a file in any format: the output of `jounce convert` first, then the download.

class ExportDialog {
  /// `actions`: request(method, path), file(path) as a blob, save(name, blob), window(title, ...content).
  constructor(actions) {
    this.actions = actions;
    this.given = {form: 'csv', over: 'master', tolerance: '', x_step: '', p_step: ''};
  }

  /// `of`: {axis: number of the axis of the spec, stem: name of the file, over: true if the motion is over the master and over
  /// time, forms, first: name of the first column, units: [of the first column, of the position]}.
  open(of) {
    this.of = of;
    const label = (text, input, key) => {
      input.id = `export-${key}`;
      input.value = this.given[key];
      input.onchange = () => { this.given[key] = input.value.trim(); this.show(); };
      return html('label', {}, `${text} `, input);
    };
    const select = (words) => html('select', {}, ...Object.entries(words).map(([value, textContent]) => html('option', {value, textContent})));
    const text = (placeholder) => html('input', {size: 12, placeholder, autocomplete: 'off'});
    const [x, p] = of.units;
    this.result = html('pre', {id: 'export-text', tabIndex: 0, role: 'status'});
    this.download = html('button', {id: 'export-download', textContent: 'Download', disabled: true});
    const form = html('form', {className: 'fields'},
      label('Format', select(Object.fromEntries(of.forms.map((name) => [name, name]))), 'form'),
      ...(of.over ? [label('Over', select({master: 'master', time: 'time'}), 'over')] : []),
      label(`Tolerance [${p}]`, text('knots stay'), 'tolerance'), label(`One count of the ${of.first}`, text(`such as 0.001 ${x}`), 'x_step'),
      label('One count of the position', text(`such as 0.001 ${p}`), 'p_step'), this.download);
    form.onsubmit = (event) => { event.preventDefault(); this.save(); };
    this.actions.window('Export the table', html('p', {textContent: 'For a controller that counts in pulses, give the size of one count. With a tolerance, the table gets the fewest knots within it.'}), form, this.result);
    form.querySelector('select').focus();
    this.show();
  }

  get query() {
    const {over, ...members} = this.given;
    const given = {...members, axis: this.of.axis, ...(this.of.over && {over})};
    return new URLSearchParams(Object.entries(given).filter(([, value]) => value !== ''));
  }

  /// Shows what the file would lose. Only the answer to the newest request counts.
  async show() {
    const query = this.newest = this.query;
    this.download.disabled = true;
    try {
      const {text, ending, fits} = await this.actions.request('GET', `/conversion?${query}`);
      if (query !== this.newest) return;
      this.ending = ending;
      this.download.disabled = !fits;
      this.result.className = fits ? '' : 'bad';
      this.result.textContent = raisedUnit(text.trim()) + (fits ? '' : '\ngive a tolerance');
    } catch (error) {
      if (query !== this.newest) return;
      this.result.className = 'bad';
      this.result.textContent = error.message.replace('give a spec with [master], and convert it with --over time',
        this.of.over ? 'select Over: time' : 'add a [master] to the spec, then select Over: time');
    }
  }

  async save() {
    try {
      this.actions.save(`${this.of.stem}${this.ending}`, await this.actions.file(`/table?${this.newest}`));
    } catch (error) {
      this.result.className = 'bad';
      this.result.textContent = error.message;
    }
  }
}
