// SPDX-License-Identifier: BSD-3-Clause
// Template id over time, as in the paper's figure: novel templates along the upper bound, familiar ones
// below it.
import uPlot from 'uplot';
import { byId } from '../look/dom';
import type { Colours } from '../look/theme';
import type { RowStore } from '../model/row_store';
import { strided } from '../model/sampling';
import { Pace, type Panel, type PageState } from '../model/page_state';
import { kChoices } from '../wire/records';
import { axis, fitPlot, NowLine, onClick } from './plot_look';

const kMaxPoints = 6000;
const kRecognitions = kChoices['place.recognition'];
type Recognition = (typeof kRecognitions)[number];

export class TemplatesPanel implements Panel {
  private readonly root = byId('templates');
  private readonly pace = new Pace(200);
  private rows: RowStore | null = null;
  private drawn = -1;
  private readonly plot: uPlot;
  private readonly now: NowLine;

  constructor(private painted: Colours, seekTime: (seconds: number) => void) {
    const colour = (name: 'blue' | 'vermilion') => () => this.painted[name];
    const series = (label: string, name: 'blue' | 'vermilion'): uPlot.Series => ({
      label,
      stroke: colour(name),
      paths: () => null,
      points: { show: true, size: 3.5, width: 0, fill: colour(name), stroke: colour(name) },
    });
    const colours = () => this.painted;
    this.plot = new uPlot(
      {
        width: 300,
        height: 150,
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
        scales: { x: { time: false, range: (_, min, max) => [min, Math.max(max, min + 1)] },
                  y: { range: (_, min, max) => [0, Math.max(4, (max ?? 0) * 1.04, min)] } },
        axes: [axis('data time, s', 22, colours), { ...axis('template', 38, colours), incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000] }],
        series: [{}, series('familiar', 'vermilion'), series('novel', 'blue')],
      },
      [[], [], []],
      this.root,
    );
    this.now = new NowLine(this.plot);
    onClick(this.plot, seekTime);
  }

  update(state: PageState, time: number): boolean {
    const repaint = state.colours !== this.painted;
    this.painted = state.colours;
    const resized = fitPlot(this.plot, this.root);
    if (repaint && !resized) this.plot.redraw(false);
    const { rows } = state;
    let late = false;
    if (rows !== this.rows || rows.count !== this.drawn) {
      late = !this.pace.due(time);
      if (!late) this.setData(rows);
    }
    this.now.at(rows.value(state.row, 'frame.time'));
    return late;
  }

  private setData(rows: RowStore): void {
    this.rows = rows;
    this.drawn = rows.count;
    const stamp = rows.column('frame.time');
    const kind = rows.column('place.recognition');
    const id = rows.column('place.template_id');
    const kept = strided(rows.count, kMaxPoints);
    const of = (wanted: Recognition) => kept.map((i) => (kind[i] === kRecognitions.indexOf(wanted) ? (id[i] as number) : null));
    this.plot.setData([kept.map((i) => stamp[i] as number), of('familiar'), of('novel')]);
  }
}
