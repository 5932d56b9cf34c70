// SPDX-License-Identifier: Apache-2.0
// node report_values.js ROOT CHART_VALUES: the script of a report against the library, for the examples. The texts of
// the cursor are equal. Polynomials are equal to the last bit; a sine may differ by the rounding of Math.sin.
'use strict';
const {execFileSync} = require('child_process');
const fs = require('fs');
const vm = require('vm');

const [root, program] = process.argv.slice(2);
for (const name of ['curve', 'picture', 'report'])
  vm.runInThisContext(fs.readFileSync(`${root}/plot/assets/${name}.js`, 'utf8'));
const {prepared_, valuesAt_, number_} = vm.runInThisContext('({prepared_: prepared, valuesAt_: valuesAt, number_: number})');

let failures = 0, places = 0, exact = 0;
function expect(ok, message) {
  if (!ok && ++failures <= 20) console.error(message);
}

// Numbers between 0 and 1, the same in each run (Lehmer, 1951).
let state = 20261126;
const random = () => (state = state * 48271 % 2147483647) / 2147483647;

const rounding = 1e-12;  // share of the greatest value of a derivative
const per_view = 80;

function compare(spec) {
  const data = JSON.parse(execFileSync(program, [spec], {maxBuffer: 1 << 28}));
  data.views.map(prepared_).forEach((view, index) => {
    const [curve] = view.curves;
    const xs = [curve.start, curve.end, ...curve.breaks.slice(1, 12)];
    for (let i = 0; i < per_view; ++i) xs.push(curve.start + random() * (curve.end - curve.start));
    const expected = JSON.parse(execFileSync(program, [spec, String(index)], {input: xs.join('\n'), maxBuffer: 1 << 28}));
    const size = [0, 1, 2, 3].map((k) => Math.max(...expected.map(({jet}) => Math.abs(jet[k])), Number.MIN_VALUE));
    xs.forEach((x, i) => {
      const jet = curve.jet(x), shown = valuesAt_(view, x).map(({value}) => value);
      const sines = curve.pieces.some((piece) => piece.length > 2);
      ++places;
      jet.forEach((value, k) => {
        const want = expected[i].jet[k];
        exact += value === want;
        expect(sines ? Math.abs(value - want) <= rounding * size[k] : value === want, `${spec}, view ${index}, x ${x}: derivative ${k} is ${value}, not ${want}`);
        expect(shown[k] === expected[i].texts[k], `${spec}, view ${index}, x ${x}: shows ${shown[k]}, not ${expected[i].texts[k]}`);
      });
    });
  });
}

const folder = `${root}/examples`;
const specs = ['pmc600-cam', 'packaging-pusher', 'valve-train', 'residual-17hz', 'printing-register', 'spring-coiler', 'pusher-torque']
  .map((name) => `${folder}/${name}/cam.toml`)
  .concat(`${folder}/rotary-knife/knife.toml`, fs.readdirSync(`${folder}/generators`).filter((name) => name.endsWith('.toml')).map((name) => `${folder}/generators/${name}`));
specs.forEach(compare);

for (const [value, digits, text] of [[0, 6, '0'], [-0, 6, '0'], [-3.392271, 6, '−3.39227'], [1.5e12, 6, '1.5×10¹²'], [1e-5, 6, '10⁻⁵'], [1e-4, 6, '0.0001'],
  [999999.5, 6, '10⁶'], [999999, 6, '999999'], [123456789, 9, '123456789'], [Infinity, 6, '∞'], [-1e300, 3, '−10³⁰⁰'], [100, 6, '100']])
  expect(number_(value, digits) === text, `number(${value}, ${digits}) is ${number_(value, digits)}, not ${text}`);

expect(places >= 1000, `only ${places} places were compared`);
console.log(`${places} places of ${specs.length} specs: ${exact} of ${4 * places} values are equal to the last bit; ${failures} failures`);
process.exit(failures > 0 ? 1 : 0);
