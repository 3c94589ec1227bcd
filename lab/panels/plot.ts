// <lab-plot>: lines or dots by uPlot, in the colours of the page.

import { css, html, LitElement, unsafeCSS } from 'lit';
import type uPlot from 'uplot';
import plotStyle from 'uplot/dist/uPlot.min.css?inline';
import { dark, light } from '../view/palette';
import { panelStyle } from './style';

export interface Plot {
  /** x, then y of each series; null: none. */
  data: (number | null)[][];
  names: string[];
  across: string;
  up: string;
  dots: boolean;
  /** Lines that stay level until the next point. */
  steps?: boolean;
  logarithmic: boolean;
}

export class PlotView extends LitElement {
  static override styles = [panelStyle, unsafeCSS(plotStyle), css`
    .place { width: 100%; min-height: 11rem; }
    .u-legend { font-size: 0.75rem; color: var(--ink); text-align: left; }
  `];
  static override properties = { plot: { attribute: false }, label: { type: String } };

  declare plot: Plot;
  declare label: string;
  private drawn: uPlot | null = null;
  private readonly scheme = matchMedia('(prefers-color-scheme: dark)');
  private readonly recolour = () => this.requestUpdate();

  override connectedCallback(): void {
    super.connectedCallback();
    this.scheme.addEventListener('change', this.recolour);
  }
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.scheme.removeEventListener('change', this.recolour);
    this.drawn?.destroy();
    this.drawn = null;
  }

  override render() {
    return html`<div class="place" role="img" aria-label=${this.label}></div>`;
  }

  override updated(): void {
    void this.draw();
  }

  private async draw(): Promise<void> {
    // With the first chart, not with the page.
    const { default: Chart } = await import('uplot');
    if (!this.isConnected) return;
    const place = this.renderRoot.querySelector<HTMLElement>('.place')!;
    this.drawn?.destroy();
    place.replaceChildren();
    this.drawn = new Chart(this.options(Math.max(place.clientWidth, 200), Chart), this.plot.data as uPlot.AlignedData, place);
  }

  private options(width: number, Chart: typeof uPlot): uPlot.Options {
    const { names, across, up, dots, logarithmic, steps } = this.plot;
    const colours = this.scheme.matches ? dark : light;
    const strokes = [colours.path, colours.goal, colours.start, colours.current];
    const axis = (label: string): uPlot.Axis => ({
      label, stroke: colours.ink, labelSize: 18, labelFont: '12px system-ui, sans-serif', font: '11px system-ui, sans-serif',
      size: 42, grid: { stroke: `${colours.grid}22`, width: 1 }, ticks: { show: false },
    });
    return {
      width, height: 190, cursor: { drag: { x: false, y: false } }, legend: { show: names.length > 1, live: false },
      scales: { x: { time: false }, y: logarithmic ? { distr: 3, log: 10 } : {} },
      axes: [{ ...axis(across), size: 30 }, axis(up)],
      series: [{ label: across }, ...names.map((label, i): uPlot.Series => ({
        label, stroke: strokes[i % strokes.length]!, width: 1.5, points: { show: dots, size: 4, fill: strokes[i % strokes.length]! },
        ...(dots ? { paths: () => null } : steps ? { paths: Chart.paths.stepped!({ align: 1 }) } : {}),
      }))],
    };
  }
}

customElements.define('lab-plot', PlotView);
