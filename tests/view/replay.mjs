// The replay page in a browser, as its user meets it. Expected states come from trajectory.csv, not from the page.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {no_serious_finding, open, pictures, program, work} from './pages.mjs';

function replay(name, ...words) {
  execFileSync(program, ['run', ...words, '--quiet', '--out', join(work, name)]);
  return pathToFileURL(join(work, name, 'replay.html')).href;
}
async function scrub(page, frame) {
  await page.locator('#scrub').evaluate((bar, k) => { bar.value = k; bar.dispatchEvent(new Event('input')); }, frame);
}

test('replay scrubs to the states of trajectory.csv', async () => {
  const url = replay('states', 'assignment', '--seed', '3'), page = await open(url);
  const rows = readFileSync(join(work, 'states/trajectory.csv'), 'utf8').trim().split('\n').slice(1).map(line => line.split(',').map(Number));
  const largest = at => Math.max(...rows.flatMap(row => row.slice(at, at + 3).map(Math.abs)));
  const last = +await page.locator('#scrub').getAttribute('max');
  assert.ok(last > 500);
  for (const frame of [0, 1, 17, 43, 200, last])
    for (const body of [0, 4, 9]) {
      await scrub(page, frame);
      await page.selectOption('#body', String(body));
      const time = parseFloat(await page.locator('#time').textContent());
      const row = rows.find(r => Math.abs(r[0] - time) < 6e-4 && r[1] === body);
      assert.ok(row, `trajectory.csv has no row at the time shown, ${time} s`);
      const shown = await page.locator('#state tbody td').allTextContents(), w = await page.locator('#qw').textContent();
      // float32 positions below 16 m, a half of 1/32767 of the largest velocity, of 1 for quaternions; no decimal is shown
      // that is finer than what is kept
      const check = (text, wanted, kept, what) => {
        const last_place = 10 ** -text.split('.')[1].length;
        assert.ok(last_place <= 1e-3 && last_place >= 2 * kept, `${what}: ${text} is kept to ${kept}`);
        assert.ok(Math.abs(parseFloat(text) - wanted) <= 0.51 * last_place + kept, `${what} of ${body} at ${time} s: ${text}, not ${wanted}`);
      };
      for (let k = 0; k < 3; ++k) {
        check(shown[k], row[2 + k], 1e-6, 'position');
        check(shown[3 + k], row[9 + k], largest(9) / 65534, 'velocity');
        check(shown[6 + k], row[12 + k], largest(12) / 65534, 'spin');
      }
      const q = [parseFloat(w.slice(2)), ...shown.slice(9).map(parseFloat)], same = q.reduce((sum, x, k) => sum + x * row[5 + k], 0);
      assert.ok(Math.abs(Math.abs(same) - 1) < 2e-4, `attitude of ${body} at ${time} s: ${q}`);
    }
  await scrub(page, 40);
  await page.screenshot({path: join(pictures, 'replay.png')});
  assert.deepEqual(page.wrong, []);
  assert.deepEqual(page.asked, [url]);
  await no_serious_finding(page);
});

test('replay plays, pauses, steps and draws', async () => {
  const page = await open(replay('keys', 'drop'));
  const time = async () => parseFloat(await page.locator('#time').textContent()), picture = () => page.locator('#canvas').evaluate(c => c.toDataURL());
  const at_start = await picture();
  await page.keyboard.press(' ');
  await page.waitForFunction(() => parseFloat(document.getElementById('time').textContent) > 0.2);
  assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Pause');
  await page.keyboard.press(' ');
  const paused = await time();
  await page.waitForTimeout(150);
  assert.equal(await time(), paused);
  assert.ok(await picture() !== at_start, 'the picture moves');
  await page.keyboard.press('Home');
  assert.equal(await time(), 0);
  assert.ok(await picture() === at_start, 'the picture is that of the start again');
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs(await time() - 1 / 60) < 1e-3);
  await page.keyboard.press('End');
  assert.equal(await time(), 3);
  for (const [key, id] of [['f', 'follow'], ['c', 'contacts'], ['t', 'trails'], ['a', 'axes'], ['v', 'velocities']]) {
    const was = await page.isChecked('#' + id);
    await page.keyboard.press(key);
    assert.equal(await page.isChecked('#' + id), !was, key);
  }
  assert.deepEqual(page.wrong, []);
});

test('replay shows two methods over each other and side by side', async () => {
  const page = await open(replay('beside', 'spin-box', '--beside', 'rk4'), {colorScheme: 'dark'});
  assert.deepEqual(await page.locator('#legend li').allTextContents(), ['sheet (solid)', 'rk4 (see-through)']);
  const marks = await page.locator('#energy .u-series .u-marker').evaluateAll(all => all.map(mark => mark.style.border));
  assert.equal(marks.length, 6);
  assert.equal(new Set(marks).size, 6, 'every curve has colour and dashes of its own: ' + marks.join(' '));
  await scrub(page, 120);
  const sheet = await page.locator('#state tbody td').allTextContents();
  await page.selectOption('#run', '1');
  assert.notDeepEqual(await page.locator('#state tbody td').allTextContents(), sheet);
  const over = await page.locator('#canvas').evaluate(c => c.toDataURL());
  await page.check('#beside');
  assert.ok(await page.locator('#canvas').evaluate(c => c.toDataURL()) !== over, 'the picture changes');
  await page.check('#axes');
  await page.screenshot({path: join(pictures, 'replay-two-methods-dark.png')});
  assert.deepEqual(page.wrong, []);
  await no_serious_finding(page);
});

test('replay without its script shows the energy of each run', async () => {
  const page = await open(replay('still', 'drop', '--beside', 'located', '--until', '1'), {javaScriptEnabled: false});
  assert.ok(await page.locator('noscript svg').isVisible());
  assert.deepEqual(await page.locator('noscript svg text').allTextContents().then(all => all.filter(text => ['sheet', 'located', 'energy, J'].includes(text))), ['energy, J', 'sheet', 'located']);
  const runs = await page.locator('noscript tbody tr').allTextContents();
  assert.equal(runs.length, 2);
  const summary = JSON.parse(readFileSync(join(work, 'still/summary.json'), 'utf8'));
  assert.ok(runs[0].endsWith(String(+summary.energy.end.toPrecision(6))) && runs[1].endsWith(String(+summary.beside[0].energy.end.toPrecision(6))), runs.join('; '));
  for (const shell of ['main', '#transport']) assert.ok(!await page.locator(shell).isVisible());
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing hangs over the edge');
  await page.screenshot({path: join(pictures, 'replay-still.png')});
});

test('replay fits a phone', async () => {
  const page = await open(replay('phone', 'tumble'), {viewport: {width: 390, height: 780}, hasTouch: true});
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await page.screenshot({path: join(pictures, 'replay-phone.png')});
  assert.deepEqual(page.wrong, []);
});

test('a name with HTML is a name, and no other script runs', async () => {
  const scene = join(work, '<img src=x onerror=window.hurt=1>&quot;\'.json');
  writeFileSync(scene, JSON.stringify({cuboids: [{size: [1, 2, 3], mass: 1, position: [0, 0, 0]}], until: 0.1}));
  const page = await open(replay('name', scene));
  assert.match(await page.title(), /<img src=x onerror=window\.hurt=1>&quot;'/);
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(page.wrong, []);
  await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.hurt = 1';
    document.body.append(script);
  });
  assert.equal(await page.evaluate(() => window.hurt), undefined);
  assert.equal(page.wrong.length, 1, 'the browser says that the policy refused it');
});

test('a thousand cuboids', async t => {
  const cuboids = [];
  for (let i = 0; i < 1000; ++i) cuboids.push({size: [0.5, 0.7, 0.9], mass: 1, position: [2 * (i % 10), 3 + 2 * Math.floor(i / 100), 2 * (Math.floor(i / 10) % 10)], spin: [1, i / 500, 0.3]});
  const scene = join(work, 'thousand.json');
  writeFileSync(scene, JSON.stringify({cuboids, gravity: [0, 0, 0], until: 2, dt: 1 / 60, every: 1 / 30}));
  const page = await open(replay('thousand', scene)), frames = 60;
  const [rate, script] = await page.evaluate(async n => {
    let spent = 0, drawn = 0;  // the page's own work, without the software that stands in for a graphics card
    const ask = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = frame => ask(t => {
      const start = performance.now();
      frame(t);
      spent += performance.now() - start, ++drawn;
    });
    document.getElementById('play').click();
    const start = performance.now();
    for (let k = 0; k < n; ++k) await new Promise(ask);
    return [n / (performance.now() - start) * 1000, spent / drawn];
  }, frames);
  t.diagnostic(`1000 cuboids: ${script.toFixed(1)} ms of script a frame (30 frames a second leave 33 ms); ${rate.toFixed(0)} frames a second, drawn in software`);
  assert.ok(script > 0);
  await page.screenshot({path: join(pictures, 'replay-thousand.png')});
  assert.deepEqual(page.wrong, []);
});
