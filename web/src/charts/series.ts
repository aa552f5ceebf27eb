/** A curve of a chart. Colors are names of the style sheet, so that they follow the theme. */
export interface ChartSeries {
  name: string; // in what is saved of the chart
  values: Float32Array;
  color: string;
  kind: "line" | "points";
  width?: number; // of the line; otherwise 2 [CSS pixels]
  hasGaps?: boolean; // the line is broken where there are no values
  starts?: number[]; // indices at which the line begins anew
}

const kColors = 8; // --series-1 … --series-8
const kBeforeShadows = 2; // of these: neither that of the active task nor that of the marks

/** Of the series with this index, by its name in the style sheet. */
export const seriesColor = (index: number): string => `--series-${(index % kColors) + 1}`;

export const shadowColor = (index: number): string =>
  seriesColor(kBeforeShadows + (index % (kColors - kBeforeShadows)));
