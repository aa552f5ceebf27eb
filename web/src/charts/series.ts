/** A curve of a chart. Colors are names of the style sheet, so that they follow the theme. */
export interface ChartSeries {
  values: Float32Array;
  color: string;
  kind: "line" | "points";
  width?: number; // of the line; otherwise 2 [CSS pixels]
  hasGaps?: boolean; // the line is broken where there are no values
  starts?: number[]; // indices at which the line begins anew
}
