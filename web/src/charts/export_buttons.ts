// Takes a chart away: as a drawing, as a picture, as numbers.

import { element } from "../page/dom.ts";
import type { EpisodeChart } from "./episode_chart.ts";
import { chartToCsv, chartToPng, chartToSvg } from "./export_chart.ts";

const kFormats = ["SVG", "PNG", "CSV"] as const;

function download(name: string, content: Blob): void {
  const link = element("a", { download: name });
  link.href = URL.createObjectURL(content);
  link.click();
  URL.revokeObjectURL(link.href);
}

export class ExportButtons {
  readonly element: HTMLElement;

  /** `name`: what the chart shows; of the files, too. */
  constructor(
    private readonly name: string,
    private readonly chartOf: () => EpisodeChart | undefined,
  ) {
    this.element = element("span", { class: "export", role: "group", "aria-label": `save ${name}` });
    for (const format of kFormats) {
      const button = element("button", { type: "button", class: "text" }, format);
      button.addEventListener("click", () => void this.save(format));
      this.element.append(button);
    }
  }

  private async save(format: (typeof kFormats)[number]): Promise<void> {
    const chart = this.chartOf();
    if (!chart) return;
    const content = await this.contentOf(chart, format);
    download(`${this.name.replace(/[^\w.-]+/g, "_")}.${format.toLowerCase()}`, content);
  }

  private contentOf(chart: EpisodeChart, format: (typeof kFormats)[number]): Promise<Blob> | Blob {
    switch (format) {
      case "SVG":
        return new Blob([chartToSvg(chart.picture)], { type: "image/svg+xml" });
      case "PNG":
        return chartToPng(chart.picture);
      case "CSV":
        return new Blob([chartToCsv(chart.picture)], { type: "text/csv" });
    }
  }
}
