// Results over the working range, with a mark at the slider's position, and the curves of the book.

import uPlot from "uplot";

import { h, script } from "./dom.js";
import { current, measured, number, word } from "./words.js";

const HEIGHT = 150;

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
export const colour = (i) => style(`--line-${i + 1}`);

function axes(unit) {
  const own = {
    stroke: style("--text"),
    grid: { stroke: style("--rule"), width: 1 },
    ticks: { stroke: style("--rule"), width: 1 },
    font: "12px system-ui, sans-serif",
    values: (_, splits) => splits.map((value) => number(Number(value.toPrecision(9)))),
  };
  return [
    { ...own, size: 30 },
    { ...own, size: 64, label: unit, labelSize: 18, labelFont: own.font },
  ];
}

// In the order of x, which uPlot needs.
function ordered(xs, ys) {
  const places = xs.map((_, i) => i).sort((a, b) => xs[a] - xs[b]);
  return [places.map((i) => xs[i]), places.map((i) => ys[i])];
}

// Pieces that go back and forth are cut into runs that do not.
function runs(piece) {
  const found = [];
  let run = [];
  let way = 0;
  for (const point of piece) {
    const next = run.length ? Math.sign(point[0] - run.at(-1)[0]) : 0;
    if (next && way && next !== way) {
      found.push(run);
      run = [run.at(-1)];
      way = next;
    }
    way ||= next;
    run.push(point);
  }
  found.push(run);
  return found;
}

// A result over the working range, of several designs and as it was published.
function over(designs, coordinate, column) {
  const value = h("b", {});
  const caption = h("figcaption", {}, script(column.symbol), " = ", value, h("span", { class: "quiet" }, "  ", script(column.text)));
  const tables = [];
  const series = [{}];
  designs.forEach(({ shown }, i) => {
    const own = shown.columns.find(({ name }) => name === column.name);
    if (!own || shown.columns[0].name !== coordinate.name) return;
    tables.push(ordered(shown.columns[0].values, own.values));
    series.push({ stroke: colour(i), width: 2, dash: i ? [6, 4] : undefined, points: { show: false } });
  });
  const published = designs[0].shown.published.filter(({ name }) => name === column.name);
  if (published.length) {
    tables.push(ordered(published.map(({ at }) => at), published.map(({ value }) => value)));
    series.push({ stroke: style("--text"), paths: () => null, points: { show: true, size: 4, fill: style("--paper") } });
  }
  return { caption, data: uPlot.join(tables), series, unit: column.unit, value, column };
}

// A curve as the book draws it: pieces of points.
function ofBook(curve) {
  const { x, y } = curve;
  const told = h("span", { class: "quiet" }, "  ", script(y.symbol), " – ", script(x.symbol), x.unit && ` (${x.unit})`);
  const pieces = curve.pieces.flatMap((piece, i) => runs(piece).map((run) => [run, i]));
  const points = pieces.flatMap(([run], series) => run.map(([x, y]) => ({ x, y, series })));
  points.sort((a, b) => a.x - b.x);
  const columns = pieces.map((_, series) => points.map((point) => (point.series === series ? point.y : undefined)));
  const several = curve.numbers.length > 0;
  const series = pieces.map(([, i]) => ({ stroke: colour(several ? i % 5 : 0), width: 1.5, points: { show: false } }));
  const caption = h("figcaption", {}, script(curve.caption), told);
  return { caption, data: [points.map(({ x }) => x), ...columns], series: [{}, ...series], unit: y.unit };
}

export class Curves {
  constructor(host, picked) {
    this.host = host;
    this.picked = picked;
    this.charts = [];
    // Widths change together: once for each frame.
    this.sizes = new ResizeObserver(() => requestAnimationFrame(() => this.resize()));
    this.sizes.observe(host);
  }

  resize() {
    const width = this.host.clientWidth;
    if (width > 0) this.charts.forEach(({ plot }) => plot.width !== width && plot.setSize({ width, height: HEIGHT }));
  }

  // Of one design or of several, the first of which has the slider: results by their names.
  show(designs, names) {
    const [{ shown }] = designs;
    const [coordinate] = shown.columns;
    this.xs = coordinate.values;
    const columns = [...names].map((name) => shown.columns.find((column) => column.name === name)).filter(Boolean);
    const charts = [...columns.map((column) => over(designs, coordinate, column)), ...shown.curves.map(ofBook)];
    // What is only other numbers keeps its place.
    const shape = JSON.stringify([current(), style("--paper"), charts.map(({ caption, unit, series }) => [caption.textContent, unit, series.length])]);
    if (shape === this.shape) {
      charts.forEach(({ data, column }, i) => {
        this.charts[i].plot.setData(data);
        this.charts[i].column = column;
      });
      return;
    }
    this.shape = shape;
    this.charts.forEach(({ plot }) => plot.destroy());
    this.host.replaceChildren();
    this.charts = [];
    charts.forEach((chart, i) => {
      if (i === columns.length) this.host.append(h("h3", {}, word("page.of_book")));
      this.charts.push(this.chart(chart));
    });
  }

  chart(chart) {
    const { caption, data, series, unit, column } = chart;
    const mark = column && h("div", { class: "mark" });
    const own = { ...chart, mark };
    own.plot = this.plot(caption, data, series, unit, () => this.mark(own));
    if (!mark) return own;
    const { over } = own.plot;
    over.append(mark);
    const pick = (event) => {
      if (!event.buttons) return;
      const x = own.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x");
      const distance = (i) => Math.abs(this.xs[i] - x);
      this.picked(this.xs.reduce((best, _, i) => (distance(i) < distance(best) ? i : best), 0));
    };
    over.addEventListener("pointerdown", pick);
    over.addEventListener("pointermove", pick);
    return own;
  }

  plot(caption, data, series, unit, drawn = () => {}) {
    const place = h("div", {});
    this.host.append(h("figure", { class: "chart", role: "img", "aria-label": caption.textContent }, caption, place));
    const options = {
      width: Math.max(this.host.clientWidth, 200),
      height: HEIGHT,
      series,
      axes: axes(unit),
      scales: { x: { time: false } },
      legend: { show: false },
      // Scales and sizes are known when it has been drawn.
      hooks: { draw: [drawn] },
      pxAlign: 0,
      cursor: { y: false, drag: { x: false, y: false } },
    };
    return new uPlot(options, data, place);
  }

  mark({ plot, mark }) {
    if (plot && mark) mark.style.transform = `translateX(${plot.valToPos(this.xs[this.row], "x")}px)`;
  }

  at(row) {
    this.row = row;
    for (const chart of this.charts) {
      if (!chart.mark) continue;
      this.mark(chart);
      chart.value.textContent = measured(chart.column.texts[row], chart.column.unit);
    }
  }
}
