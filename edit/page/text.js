// SPDX-License-Identifier: Apache-2.0
// The text of the spec, with the numbers of its lines and marks of the findings.

/// The lines that differ between two texts: [first, last of before, last of now], by their common beginning and end.
function changedLines(before, now) {
  const a = before.split('\n'), b = now.split('\n');
  let first = 0, end = 0;
  while (first < a.length && first < b.length && a[first] === b[first]) ++first;
  while (end < a.length - first && end < b.length - first && a[a.length - 1 - end] === b[b.length - 1 - end]) ++end;
  return [first, a.length - end, b.length - end];
}

/// The lines of a difference: [' ', '+' or '-', line], by the longest common subsequence of what changed.
function lineDifference(before, now) {
  const [first, endA, endB] = changedLines(before, now);
  const a = before.split('\n'), b = now.split('\n');
  const old = a.slice(first, endA), fresh = b.slice(first, endB);
  const out = a.slice(Math.max(0, first - 3), first).map((line) => [' ', line]);
  const most_cells = 4e6;
  if (old.length * fresh.length > most_cells) out.push(...old.map((line) => ['-', line]), ...fresh.map((line) => ['+', line]));
  else {
    const length = Array.from({length: old.length + 1}, () => new Uint32Array(fresh.length + 1));
    for (let i = old.length - 1; i >= 0; --i)
      for (let k = fresh.length - 1; k >= 0; --k)
        length[i][k] = old[i] === fresh[k] ? length[i + 1][k + 1] + 1 : Math.max(length[i + 1][k], length[i][k + 1]);
    for (let i = 0, k = 0; i < old.length || k < fresh.length;) {
      if (i < old.length && k < fresh.length && old[i] === fresh[k]) { out.push([' ', old[i++]]); ++k; }
      else if (k >= fresh.length || (i < old.length && length[i + 1][k] >= length[i][k + 1])) out.push(['-', old[i++]]);
      else out.push(['+', fresh[k++]]);
    }
  }
  return [...out, ...a.slice(endA, endA + 3).map((line) => [' ', line])];
}

class TextPane {
  /// `actions`: typed() when the text differs from the one that was shown.
  constructor(area, gutter, place, actions) {
    Object.assign(this, {area, gutter, place, actions, shown: '', marks: new Map(), changed: [0, 0]});
    area.addEventListener('input', () => { this.number(); actions.typed(); });
    area.addEventListener('scroll', () => { gutter.scrollTop = area.scrollTop; });
    for (const event of ['keyup', 'click', 'focus']) area.addEventListener(event, () => this.showPlace());
  }

  /// True if the reader has typed something that is not sent yet.
  get isTyped() { return this.area.value !== this.shown; }

  /// Shows a text; the selection stays with its line.
  take(text) {
    if (this.area.value !== text) {
      const {selectionStart, selectionEnd, scrollTop, scrollLeft} = this.area;
      const [first, endA, endB] = changedLines(this.area.value, text);
      const start = (value, line) => value.split('\n', line).reduce((sum, each) => sum + each.length + 1, 0);
      const from = start(this.area.value, endA), shift = text.length - this.area.value.length;
      const moved = (at) => at >= from ? at + shift : Math.min(at, text.length);
      this.area.value = text;
      if (document.activeElement === this.area) this.area.setSelectionRange(moved(selectionStart), moved(selectionEnd));
      Object.assign(this.area, {scrollTop, scrollLeft});
      this.changed = this.shown === '' ? [0, 0] : [first, endB];
    }
    this.shown = text;
    this.number();
  }

  /// Marks lines with the level of their finding.
  mark(findings) {
    this.marks.clear();
    const rank = {error: 3, broken: 2, warning: 1};
    for (const {line, level} of findings)
      if (line && rank[level] > (rank[this.marks.get(line)] ?? 0)) this.marks.set(line, level);
    this.number();
  }

  number() {
    const lines = this.area.value.split('\n').length;
    const [first, end] = this.changed;
    this.showPlace();
    const look = JSON.stringify([lines, first, end, [...this.marks]]);
    if (look === this.look) return;
    this.look = look;
    this.gutter.replaceChildren(...Array.from({length: lines}, (_, i) => html('div', {textContent: i + 1, className: this.marks.get(i + 1) ?? (i >= first && i < end ? 'changed' : '')})));
    this.gutter.scrollTop = this.area.scrollTop;
  }

  showPlace() {
    const before = this.area.value.slice(0, this.area.selectionStart).split('\n');
    this.place.textContent = `line ${before.length}, column ${before.at(-1).length + 1}`;
  }

  /// Selects a line, from 1.
  goTo(line, focus = true) {
    const lines = this.area.value.split('\n');
    const start = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
    if (focus) this.area.focus({preventScroll: false});
    this.area.setSelectionRange(start, start + (lines[line - 1] ?? '').length);
    const height = this.area.scrollHeight / Math.max(lines.length, 1);
    this.area.scrollTop = Math.max(0, (line - 1) * height - this.area.clientHeight / 3);
    this.showPlace();
  }
}
