// The live scene in a browser, as its user meets it: rigor view is started, keys are pressed, a cuboid is pulled.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {once} from 'node:events';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {createInterface} from 'node:readline';
import {after, test} from 'node:test';
import {no_serious_finding, open as open_page, pictures, program, work} from './pages.mjs';

// small: it is drawn in software, sixty times a second, on a machine that may have better to do
const open = (url, options) => open_page(url, {viewport: {width: 900, height: 560}, ...options});
const started = [];
after(() => started.forEach(server => server.kill('SIGKILL')));
async function view(...words) {
  const server = spawn(program, ['view', ...words], {stdio: ['ignore', 'pipe', 'inherit']});
  started.push(server);
  const [line] = await once(createInterface(server.stdout), 'line');
  return {server, url: line.match(/^http:\/\/127\.0\.0\.1:\d+\//)[0]};
}
async function stop(server, signal) {
  server.kill(signal);
  const [code] = await once(server, 'exit');
  assert.equal(code, 0, signal);
}
const text = (page, id) => page.locator(id).textContent();
const time = async page => parseFloat(await text(page, '#time'));
const pressed = (page, id) => page.locator(`${id}[aria-pressed=true]`).waitFor({timeout: 20000});
const released = (page, id) => page.locator(`${id}[aria-pressed=false]`).waitFor({timeout: 20000});
const account = async (page, name) => parseFloat(await page.locator('#accounts tr', {hasText: name}).locator('td').textContent());
async function until(what, holds) {
  for (let k = 0; k < 400; ++k) {
    if (await holds()) return;
    await new Promise(done => setTimeout(done, 50));
  }
  assert.fail('waited in vain: ' + what);
}
const picture = page => page.locator('#canvas').evaluate(c => c.toDataURL());

test('space, r, g and n do what the assignment says', async () => {
  const {server, url} = await view('assignment', '--seed', '3'), page = await open(url);
  await until('the scene is there', async () => (await text(page, '#time')) === '0.00 s, seed 3');
  assert.equal(await account(page, 'energy, J'), await account(page, 'energy, J'));
  const at_rest = await picture(page);
  await page.keyboard.press(' ');
  await pressed(page, '#running');
  await until('time passes', async () => await time(page) > 0.5);
  assert.ok(await picture(page) !== at_rest, 'the picture moves');
  await page.keyboard.press('r');
  await pressed(page, '#vacuum');
  await until('the vacuum works', async () => await account(page, 'work of hand') !== 0);
  await page.screenshot({path: join(pictures, 'live.png')});
  await page.keyboard.press('r');
  await released(page, '#vacuum');
  await page.keyboard.press('g');
  await released(page, '#gravity');
  await until('the account says so', async () => await account(page, 'gravity switched') !== 0);
  await page.keyboard.press('g');
  await pressed(page, '#gravity');
  await page.keyboard.press(' ');
  await released(page, '#running');
  const paused = await time(page);
  await page.waitForTimeout(200);
  assert.equal(await time(page), paused);
  await page.keyboard.press('n');
  await until('a new seed', async () => (await text(page, '#time')) === '0.00 s, seed 4');
  assert.ok(await picture(page) !== at_rest);
  assert.deepEqual(page.wrong, []);
  assert.deepEqual(page.asked, [url], 'nothing but the page is asked for');
  assert.deepEqual(page.sockets, [url.replace('http', 'ws') + 'socket']);
  await no_serious_finding(page);
  await stop(server, 'SIGINT');
});

test('sliders and the method take effect, and are told to every viewer', async () => {
  const {server, url} = await view('slide'), page = await open(url), other = await open(url, {colorScheme: 'dark'});
  await until('both are there', async () => (await text(other, '#time')).endsWith('seed 1') && (await text(page, '#time')).endsWith('seed 1'));
  const slide = (id, value) => page.locator(id).evaluate((bar, x) => { bar.value = x; bar.dispatchEvent(new Event('input')); }, value);
  await slide('#restitution', 0.75);
  await slide('#static_friction', 0.2);
  await slide('#dynamic_friction', 0.1);
  await slide('#dt', 100);
  await page.selectOption('#method', 'rk4');
  for (const [id, wanted] of [['restitution', '0.75'], ['static_friction', '0.2'], ['dynamic_friction', '0.1'], ['dt', '1/30 s']])
    await until(id, async () => (await text(other, `output[for=${id}]`)) === wanted);
  await until('method', async () => (await other.inputValue('#method')) === 'rk4');
  await other.focus('#restitution');
  await other.keyboard.press('ArrowRight');
  await until('by keyboard', async () => (await text(page, 'output[for=restitution]')) === '0.8');
  await other.screenshot({path: join(pictures, 'live-dark.png')});
  await no_serious_finding(other);
  assert.deepEqual([...page.wrong, ...other.wrong], []);
  await stop(server, 'SIGTERM');
});

test('a cuboid follows the pointer, and is let go', async () => {
  const {server, url} = await view('drop'), page = await open(url);
  await until('the scene is there', async () => (await text(page, '#time')).endsWith('seed 1'));
  await page.keyboard.press('g');
  await page.keyboard.press(' ');
  await pressed(page, '#running');
  // the cuboid hangs in the middle of the picture: the camera looks at where it starts
  const {x, y, width, height} = await page.locator('#canvas').boundingBox(), middle = [x + width / 2, y + height / 2];
  const before = await picture(page);
  await page.mouse.move(...middle);
  await page.mouse.down();
  for (let k = 1; k <= 10; ++k) await page.mouse.move(middle[0] + 12 * k, middle[1] - 8 * k);
  await until('the hand works', async () => await account(page, 'work of hand') > 0.1);
  await page.screenshot({path: join(pictures, 'live-hand.png')});
  await page.waitForTimeout(1500);  // until it hangs still: e^(-5.5 x 1.5)
  const work_held = await account(page, 'work of hand');
  await page.mouse.up();
  await page.waitForTimeout(300);
  assert.ok(Math.abs(await account(page, 'work of hand') - work_held) < 0.1, 'a hand that let go does no work');
  assert.ok(await picture(page) !== before);
  assert.deepEqual(page.wrong, []);
  await stop(server, 'SIGINT');
});

test('a name with HTML is a name', async () => {
  const scene = join(work, '<img src=x onerror=window.hurt=1>&quot;\'.json');
  writeFileSync(scene, JSON.stringify({cuboids: [{size: [1, 2, 3], mass: 1, position: [0, 0, 0]}]}));
  const {server, url} = await view(scene), page = await open(url);
  await until('the scene is there', async () => (await text(page, '#time')).endsWith('seed 1'));
  assert.match(await page.title(), /<img src=x onerror=window\.hurt=1>&quot;'/);
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(page.wrong, []);
  await page.evaluate(() => fetch('http://127.0.0.1:9/').catch(() => 0));
  assert.match(page.wrong.join(), /Content Security Policy/, 'the page may not ask elsewhere');
  await stop(server, 'SIGINT');
});

test('a page says when rigor was stopped, and comes back with it', async () => {
  const {server, url} = await view('tumble'), page = await open(url, {viewport: {width: 390, height: 780}, hasTouch: true});
  await until('the scene is there', async () => (await text(page, '#time')).endsWith('seed 1'));
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'fits a phone');
  await page.screenshot({path: join(pictures, 'live-phone.png')});
  assert.deepEqual(page.wrong, []);
  await stop(server, 'SIGTERM');
  await until('it says so', async () => (await text(page, '#told')).includes('does not answer'));
  const again = await view('tumble', '--port', new URL(url).port);
  await page.locator('#told:empty').waitFor({state: 'attached', timeout: 10000});
  await stop(again.server, 'SIGINT');
});
