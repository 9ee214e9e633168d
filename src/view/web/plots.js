// Curves against time, with a line at the time shown.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
export const short = x => x === 0 ? '0' : Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3 ? x.toExponential(2) : String(+x.toPrecision(4));

/// times and curves may be replaced by set(); on_pick(t) is called when the plot is clicked.
export class TimePlot {
  constructor(host, names, on_pick) {
    const ink = css('--ink'), grid = {stroke: css('--line'), width: 1}, dashes = [[], [6, 4], [2, 3]];
    const axis = {stroke: ink, grid, ticks: grid, font: '11px sans-serif'};
    this.host = host;
    this.plot = new uPlot({
      width: host.clientWidth || 340, height: 150, legend: {show: true, live: false}, cursor: {drag: {x: false, y: false}, points: {show: false}},
      scales: {x: {time: false}}, padding: [6, 18, 0, 0],
      axes: [{...axis, size: 26, values: (_, ticks) => ticks.map(t => t + ' s')}, {...axis, size: 58, values: (_, ticks) => ticks.map(short)}],
      series: [{}, ...names.map(({name, color, run}) => ({label: name, stroke: css('--s' + color), width: 1.6, dash: dashes[run % 3], points: {show: false}}))],
    }, [[0], ...names.map(() => [0])], host);
    this.line = this.plot.over.appendChild(document.createElement('div'));
    this.line.className = 'now';
    if (on_pick) this.plot.over.addEventListener('click', event => on_pick(this.plot.posToVal(event.offsetX, 'x')));
    new ResizeObserver(() => this.plot.setSize({width: host.clientWidth, height: 150})).observe(host);
  }
  set(times, curves) { this.plot.setData([times, ...curves]); }
  at(t) { this.line.style.transform = `translateX(${this.plot.valToPos(t, 'x')}px)`; }
}
