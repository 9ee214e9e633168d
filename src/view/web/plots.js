// Curves against time, with a line at the time shown.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const patterns = [[], [6, 4], [2, 3]], borders = ['solid', 'dashed', 'dotted'];  // on the plot and in its legend
export const short = x => x === 0 ? '0' : Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3 ? x.toExponential(2) : String(+x.toPrecision(4));

/// names: {name, color: a variable of the page (--s0) or a colour, dash: 0 none, 1 long, 2 short}; span: the shortest time
/// shown, s. Times and curves may be replaced by set(); on_pick(t) is called when the plot is clicked.
export class TimePlot {
  constructor(host, names, on_pick, span = 0) {
    const ink = css('--ink'), grid = {stroke: css('--line'), width: 1};
    const axis = {stroke: ink, grid, ticks: grid, font: '11px sans-serif'};
    const over = times => [times[0] ?? 0, Math.max(times.at(-1) ?? 0, (times[0] ?? 0) + span)];
    this.plot = new uPlot({
      width: host.clientWidth || 340, height: 150, legend: {show: true, live: false, markers: {dash: (_, i) => borders[names[i - 1]?.dash ?? 0]}}, cursor: {drag: {x: false, y: false}, points: {show: false}},
      scales: {x: {time: false, range: (u, low, high) => span ? over(u.data[0]) : [low, high]}}, padding: [6, 18, 0, 0],
      axes: [{...axis, size: 26, values: (_, ticks) => ticks.map(t => t + ' s')}, {...axis, size: 58, values: (_, ticks) => ticks.map(short)}],
      series: [{}, ...names.map(({name, color, dash}) => ({label: name, stroke: color.startsWith('--') ? css(color) : color, width: 1.6, dash: patterns[dash], points: {show: u => u.data[0].length === 1}}))],  // a moment alone is a dot
    }, [[], ...names.map(() => [])], host);
    this.line = this.plot.over.appendChild(document.createElement('div'));
    this.line.className = 'now';
    if (on_pick) this.plot.over.addEventListener('click', event => on_pick(this.plot.posToVal(event.offsetX, 'x')));
    new ResizeObserver(() => this.plot.setSize({width: host.clientWidth, height: 150})).observe(host);
  }
  set(times, curves) { this.plot.setData([times, ...curves]); }
  at(t) { this.line.style.transform = `translateX(${this.plot.valToPos(t, 'x')}px)`; }
}
