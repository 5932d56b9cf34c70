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
const page = vm.runInThisContext('({prepared, valuesAt, number, pathData})');

let failures = 0, places = 0, exact = 0, jumps = 0;
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
  data.views.map((view) => page.prepared(view)).forEach((view, index) => {
    const [curve] = view.curves;
    const xs = [curve.start, curve.end, ...curve.breaks.slice(1, 12)];
    for (let i = 0; i < per_view; ++i) xs.push(curve.start + random() * (curve.end - curve.start));
    const expected = JSON.parse(execFileSync(program, [spec, String(index)], {input: xs.join('\n'), maxBuffer: 1 << 28}));
    const size = [0, 1, 2, 3].map((k) => Math.max(...expected.map(({jet}) => Math.abs(jet[k])), Number.MIN_VALUE));
    xs.forEach((x, i) => {
      const jet = curve.jet(x), shown = page.valuesAt(view, x).map(({value}) => value);
      const sines = curve.pieces.some((piece) => piece.length > 2);
      ++places;
      jumps += shown.some((text) => text.includes('→'));
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
  [999999.5, 6, '10⁶'], [999999, 6, '999999'], [123456789, 9, '123456789'],
  [1.953125, 6, '1.95312'], [9.765625, 6, '9.76562'], [5.859375, 6, '5.85938'], [2 ** -13, 9, '0.000122070312'], [1.9531250000000002, 6, '1.95313'], [Infinity, 6, '∞'], [-1e300, 3, '−10³⁰⁰'], [100, 6, '100']])
  expect(page.number(value, digits) === text, `number(${value}, ${digits}) is ${page.number(value, digits)}, not ${text}`);

// The difference of two versions, whose joints are at different places.
const panels = ['position', 'velocity', 'acceleration', 'jerk'].map((name) => ({name, unit: '', size: 1, noise: 0, lower: null, upper: null, marks: []}));
const versions = [{label: 'a', start: 0, pieces: [[1, [0, 1, 2, 3]], [2, [6, -1], [0.5, 3, 0.1]]]}, {label: 'b', start: 0.5, pieces: [[2, [1, 0, 4]]]}];
const both = page.prepared({panels, segments: [], curves: versions});
expect(String(both.difference.breaks) === '0.5,1,2.5', `the difference has the joints ${both.difference.breaks}`);
for (let i = 0; i < 200; ++i) {
  const x = 0.5 + 2 * random();
  const [a, b, difference] = [both.curves[0].jet(x), both.curves[1].jet(x), both.difference.jet(x)];
  expect(difference.every((value, k) => value === a[k] - b[k]), `the difference at ${x} is ${difference}`);
  expect(page.valuesAt(both, x).every((row, k) => row.difference === page.number(a[k] - b[k], 9)), `the texts of the difference at ${x}`);
}
expect(page.valuesAt(both, 0.25)[0].difference === '–', 'there is no difference where one version is not defined');

// At a jump, both sides are shown; "used" is that of the greater one.
const limited = page.prepared({panels: panels.map((panel) => ({...panel, lower: -4, upper: 8})), segments: [], curves: versions.slice(0, 1)});
const [, jump] = page.valuesAt(limited, 1);
const sides = [limited.curves[0].at(0, 1)[1], limited.curves[0].at(1, 1)[1]];
expect(sides[0] === 14 && sides[1] !== 14, `the velocity at the joint is ${sides}`);
expect(jump.value === `14 → ${page.number(sides[1], 9)}` && jump.limit === '8' && jump.use === '175 %', `the jump is ${JSON.stringify(jump)}`);
expect(!page.valuesAt(limited, 0.999)[1].value.includes('→'), 'only a joint has two sides');

// The range of a block of a large curve.
const block = {label: 'large', edges: [0, 1, 3], low: [[-1, 2], [0, 0], [0, 0], [0, 0]], high: [[4, 5], [1, 1], [1, 1], [1, 1]], count: 9};
const large = page.prepared({panels, segments: [], curves: [block]});
expect(page.valuesAt(large, 0.5)[0].value === '−1 … 4' && page.valuesAt(large, 1)[0].value === '2 … 5', 'the range of a block');

// Points of one half pixel: the first, the lowest, the highest and the last one are kept.
const line = page.pathData([0, 0.1, 0.2, 0.3, 0.35, 0.4, 1], [5, 6, 1, 9, 7, 4, 3], (x) => x, (y) => y);
expect(line === 'M0 5L0.2 1L0.3 9L0.4 4L1 3', `the line is ${line}`);

expect(jumps >= 50, `only ${jumps} places have a jump`);
expect(places >= 1000, `only ${places} places were compared`);
console.log(`${places} places of ${specs.length} specs: ${exact} of ${4 * places} values are equal to the last bit; ${failures} failures`);
process.exit(failures > 0 ? 1 : 0);
