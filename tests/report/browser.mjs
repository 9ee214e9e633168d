// The pages of a graded class in a browser, as an instructor and a student meet them: run by
// tests/view/browser, which keeps screenshots. What a page must show is read from report.json.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {appendFileSync, cpSync, mkdirSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {before, test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {no_serious_finding, open, pictures, program, work} from '../view/pages.mjs';

const samples = join(dirname(fileURLToPath(import.meta.url)), '../submissions');
const hostile = '<img src=x onerror=hurt=1>"\'&<script>hurt=1<\u2215script>';  // a file name has no slash
const out = join(work, 'graded');
before(async () => {
  const hand_ins = join(work, 'hand-ins'), take = (name, sample) => cpSync(join(samples, sample), join(hand_ins, name), {recursive: true});
  take('ada', 'right/explicit-loops');
  take('bob', 'wrong/two-mistakes');
  take('cai', 'wrong/two-mistakes');
  // one for every kind of picture: mistakes of several students, in the files of two
  take('dee', 'wrong/pair-one-body-only');
  take('eve', 'wrong/world-inertia-transposed');
  const from = (name, sample, file) => cpSync(join(samples, sample, file), join(hand_ins, name, file));
  from('dee', 'wrong/inertia-one-sixth', 'Cuboid.cpp');
  from('dee', 'wrong/plane-inertia-missing', 'CollisionPlane.cpp');
  from('eve', 'wrong/tangent-not-normalised', 'CollisionPlane.cpp');
  take(hostile, 'wrong/torque-about-origin');
  appendFileSync(join(hand_ins, hostile, 'Cuboid.cpp'), `
#include <cstdio>
static int shout = std::printf("%s\\n", "\\033[31m<img src=x onerror=hurt=1></pre><script>hurt=1</script>");\n`);
  const plane = join(hand_ins, hostile, 'CollisionPlane.cpp');
  writeFileSync(plane, readFileSync(plane, 'utf8').replace(/applyCollisionResponse\([^)]*\)\s*\{/, `$&\n  static_assert(false, "</pre><script>hurt=1</script>'\x1b[31m");`));
  mkdirSync(join(hand_ins, 'ivy'));
  writeFileSync(join(hand_ins, 'ivy', 'notes.txt'), 'nothing that is graded');
  const graded = spawnSync(program, ['class', hand_ins, '--out', out, '--jobs', '2', '--cases', '25'], {encoding: 'utf8'});
  assert.equal(graded.status, 1, 'one could not be graded');
  assert.match(graded.stderr, /^rigor class: the default rubric: seed is [^\n]*\n(  [^\n]*\n)*rigor class: ivy: [^\n]*\n$/);
});

const page_of = student => pathToFileURL(join(out, directory(student), 'report.html')).href;
const report_of = student => JSON.parse(readFileSync(join(out, directory(student), 'report.json'), 'utf8'));
const directory = student => student === hostile ? readdirSync(out).find(name => name.startsWith('%3C')) : student;

async function nothing_wrong(page) {
  assert.deepEqual(page.wrong, []);
  assert.deepEqual(page.asked, [page.url().replace(/#.*/, '')]);
  await no_serious_finding(page);
}
const open_all = page => page.evaluate(() => { for (const d of document.querySelectorAll('details')) d.open = true; });
const shot = (page, name) => page.screenshot({path: join(pictures, name + '.png'), fullPage: true});

test('a report shows what was judged: formula, picture, numbers, diagnosis, how to repeat it', async () => {
  for (const student of ['bob', 'dee', 'eve']) {
    const page = await open(page_of(student)), report = report_of(student);
    await open_all(page);
    assert.equal(await page.locator('.card math').count(), report.checks.length, 'every check has its formula');
    assert.equal(await page.locator('[aria-label=formula]').evaluateAll(all => all.filter(box => box.scrollHeight > box.clientHeight).length), 0, 'no formula is cut or scrolls up and down');
    const most = await page.locator('table').first().locator('tbody td:last-child').allTextContents();
    assert.ok(most.length > 4 && most.every(points => +points > 0), 'parts without points are not in the table of points');
    for (const check of report.checks) {
      const card = page.locator(`details[id="${check.id}"]`);
      assert.match(await card.locator('summary').textContent(), new RegExp(check.verdict === 'fail' && check.max_points === 0 ? 'advice' : check.verdict));
      if (check.verdict === 'pass' || !check.counterexample) continue;
      if (check.id !== 'scene.runs') assert.equal(await card.locator('figure.case svg').count(), 1, `${check.id} has a picture`);
      assert.ok((await card.locator('pre').allTextContents()).includes(check.replay), check.id);
      for (const d of check.diagnosis) assert.ok((await card.textContent()).includes(`${d.agreements} of ${d.cases} cases`));
      const rows = await card.locator('table').nth(1).locator('tbody tr').evaluateAll(list => list.map(row => [...row.cells].map(cell => cell.textContent)));
      const wanted = Object.entries(check.counterexample.got);
      assert.equal(rows.length, wanted.length);
      for (const [k, [verdict, name, unit, got, want, bound, ratio]] of rows.entries()) {
        const key = wanted[k][0], exact = [wanted[k][1], check.counterexample.want[key], check.counterexample.bound[key]];
        assert.equal(`${name} [${unit}]`, key);
        if (exact.some(x => typeof x !== 'number')) continue;
        for (const [shown, x, digits] of [[got, exact[0], 6e-7], [want, exact[1], 6e-7], [bound === 'none' ? '0' : bound, exact[2], 0.06]]) assert.ok(Math.abs(parseFloat(shown) - x) <= digits * Math.abs(x), `${key}: ${shown}, not ${x}`);
        const times = exact[0] === exact[1] ? 0 : Math.abs(exact[0] - exact[1]) / exact[2];
        assert.ok(Math.abs(parseFloat(ratio) - times) <= 0.06 * times, `${key}: ${ratio} times, not ${times}`);
        assert.equal(verdict, times <= 1 ? 'right' : 'wrong');
      }
    }
    for (const text of await page.locator('svg[role=img]').evaluateAll(all => all.map(svg => svg.querySelector('title').textContent + svg.querySelector('desc').textContent)))
      assert.ok(text.length > 30, 'every picture has a text alternative');
    await nothing_wrong(page);
    await shot(page, 'report-' + student);
  }
});

test('a report is read with the keyboard, in the dark, on a phone, on paper and without scripts', async () => {
  const page = await open(page_of('bob'));
  const summary = page.locator('details[id="moi.body"] summary');
  await summary.focus();
  await page.keyboard.press('Enter');
  assert.ok(await page.locator('details[id="moi.body"]').evaluate(d => d.open));
  assert.ok(await summary.evaluate(s => parseFloat(getComputedStyle(s).outlineWidth) >= 2), 'the focus is seen');
  await page.emulateMedia({media: 'print'});
  assert.ok(await page.locator('figure.plot > svg').first().isVisible(), 'on paper the static picture');
  assert.ok(!await page.locator('.hover').first().isVisible());
  await page.pdf({path: join(pictures, 'report-print.pdf')});

  const dark = await open(page_of('dee'), {colorScheme: 'dark'});
  await open_all(dark);
  await nothing_wrong(dark);
  await shot(dark, 'report-dark');

  const phone = await open(page_of('dee'), {viewport: {width: 390, height: 800}, hasTouch: true});
  await open_all(phone);
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing hangs over the edge');
  await phone.locator('details[id="pair.impulse"] figure').evaluate(f => f.scrollIntoView({block: 'center'}));
  await phone.screenshot({path: join(pictures, 'report-phone.png')});

  const plain = await open(page_of('bob'), {javaScriptEnabled: false});
  assert.ok(await plain.locator('figure.plot > svg').first().isVisible());
});

// uPlot's own search for ticks does not end from 1.3647e-6/1.4 to 0.036918 times 1.4: of a run of `study work-precision`
test('a logarithmic axis has its ticks whatever its ends', async () => {
  const html = readFileSync(fileURLToPath(page_of('ada')), 'utf8'), [whole, text] = html.match(/<script type="application\/json">(.*?)<\/script>/s), plot = JSON.parse(text);
  assert.ok(plot.log_x && plot.log_y);
  plot.series = [{...plot.series[0], x: [0.01, 0.1, 1], y: [1.3647e-6, 1e-3, 0.036918]}];
  const changed = join(out, 'ticks.html');
  writeFileSync(changed, html.replace(whole, () => whole.replace(text, () => JSON.stringify(plot))));
  const page = await open(pathToFileURL(changed).href);
  assert.ok((await page.locator('.hover canvas').first().boundingBox()).width > 300);
  await nothing_wrong(page);
});

test('plots answer to the pointer', async () => {
  const page = await open(page_of('ada'));
  assert.equal(await page.locator('figure.plot').count(), 3);  // update against the step, energy, momenta
  const over = page.locator('.hover .u-over').first();
  await over.scrollIntoViewIfNeeded();
  const at = await over.boundingBox();
  // the legend: names alone, then names and values; nothing moves
  const legend = page.locator('.hover .u-legend').first(), colons = () => legend.locator('th').evaluateAll(all => all.map(th => getComputedStyle(th, '::after').visibility));
  const where = () => legend.locator('th').evaluateAll(all => all.map(th => [th.getBoundingClientRect().x, th.getBoundingClientRect().y].map(Math.round)));
  const away = await where();
  assert.deepEqual([...new Set(await colons())], ['hidden']);
  assert.ok(!await legend.locator('tr').first().isVisible(), 'no x before the pointer is there');
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  assert.match(await legend.textContent(), /step h, s0\.0\d/);
  assert.deepEqual([...new Set(await colons())], ['visible']);
  assert.ok(Math.max(...(await where()).flat().map((x, i) => Math.abs(x - away.flat()[i]))) <= 1);
  const curve = page.locator('.hover').first().locator('.u-legend .u-series').nth(1), is_off = () => curve.evaluate(c => c.classList.contains('u-off'));
  await curve.locator('th').click();
  assert.ok(await is_off(), 'a click on its name hides a curve');
  await curve.locator('th').click();
  assert.ok(!await is_off(), 'and another shows it again');
  await nothing_wrong(page);
  await shot(page, 'report-ada');
});

test('a name, output and compiler errors with HTML and escapes are text', async () => {
  const page = await open(page_of(hostile)), report = report_of(hostile);
  await open_all(page);
  assert.ok((await page.title()).startsWith(hostile), await page.title());
  assert.ok(report.output.includes('</pre><script>'), 'the sample does print HTML');
  const shown = await page.locator('main').textContent();
  assert.ok(shown.includes('\uFFFD[31m<img src=x onerror=hurt=1></pre><script>hurt=1</script>'), 'the output is shown, its escape is not');
  assert.ok(report.checks.some(check => check.verdict === 'not-compiled' && check.words.includes('<script>')), 'so does the compiler');
  assert.equal(await page.locator('img').count(), 0);
  assert.equal(await page.evaluate(() => window.hurt), undefined);
  await nothing_wrong(page);
  const printed = spawnSync('cat', [join(out, directory(hostile), 'report.txt')], {encoding: 'utf8'}).stdout;
  assert.ok(!/[\x00-\x09\x0b-\x1f\x7f]/.test(printed), 'a terminal is told nothing but text');
});

test('the page of the class', async () => {
  for (const [name, options] of [['class', {}], ['class-dark', {colorScheme: 'dark'}], ['class-phone', {viewport: {width: 390, height: 800}}]]) {
    const page = await open(pathToFileURL(join(out, 'class.html')).href, options), text = await page.locator('main').textContent();
    assert.match(text, /bob, cai/, 'who failed the same');
    assert.match(text, /no evidence/);
    assert.match(text, /ivy/);
    assert.equal(await page.locator('img').count(), 0);
    assert.equal(await page.evaluate(() => window.hurt), undefined);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing hangs over the edge');
    const counts = await page.locator('div[aria-label^="check, by number"] td.n').evaluateAll(all => all.map(cell => cell.getBoundingClientRect().right));
    assert.ok(counts.length > 0 && counts.every(right => right <= page.viewportSize().width), `how many failed a check is seen: ${counts}`);
    await nothing_wrong(page);
    await shot(page, name);
    if (name !== 'class') continue;
    for (const link of await page.locator('td a').all()) {
      const target = await open(await link.evaluate(a => a.href));
      assert.ok((await target.title()).startsWith(await link.textContent()));
    }
  }
});

test('a study has the same look, and its plots answer too', async () => {
  execFileSync(program, ['study', 'convergence', '--problem', 'short-A', '--method', 'sheet', '--out', join(work, 'study')], {stdio: 'pipe'});
  const name = readdirSync(join(work, 'study')).find(file => file.endsWith('.html'));
  const page = await open(pathToFileURL(join(work, 'study', name)).href);
  assert.ok(await page.locator('.hover .uplot').count() > 0);
  assert.equal(await page.locator('main > h1').count(), 1);
  await nothing_wrong(page);
  await shot(page, 'study');
});
