// Where the modules of a graph stand in its picture: what sends stands left of what receives.

export interface GraphPort {
  name: string;
  kind: "signal" | "slot" | "out port" | "in port";
  type: string;
}
export interface GraphModule {
  name: string;
  parameters: Record<string, unknown>;
  ports: GraphPort[];
}
export interface Connection {
  from: string; // "task.reward"
  to: string;
  type: string;
}
export interface Graph {
  modules: GraphModule[];
  connections: Connection[];
}

export interface PlacedPort {
  port: GraphPort;
  fullName: string;
  x: number;
  y: number;
  isSource: boolean; // it stands at the right side
}
export interface PlacedModule {
  module: GraphModule;
  x: number;
  y: number;
  height: number;
  ports: PlacedPort[];
}

export const kModuleWidth = 256;
export const kPortHeight = 19;
export const kHeadHeight = 28;
const kColumnGap = 84;
const kRowGap = 22;

export const isSource = ({ kind }: GraphPort): boolean => kind === "signal" || kind === "out port";

const moduleOf = (fullName: string): string => fullName.slice(0, fullName.indexOf("."));

/** The column of each module: one more than that of any before it which sends it something. What
 * would lead back is passed over, in the order in which the modules were made. */
export function columnsOf({ modules, connections }: Graph): Map<string, number> {
  const order = modules.map(({ name }) => name);
  const columns = new Map(order.map((name) => [name, 0]));
  for (const name of order) {
    for (const { from, to } of connections) {
      if (moduleOf(from) !== name) continue;
      const target = moduleOf(to);
      if (order.indexOf(target) <= order.indexOf(name)) continue;
      const column = Math.max(columns.get(target) ?? 0, (columns.get(name) ?? 0) + 1);
      columns.set(target, column);
    }
  }
  return columns;
}

/** `showsAll`: also ports that nothing is connected to. */
export function placeGraph(graph: Graph, showsAll: boolean): PlacedModule[] {
  const connected = new Set(graph.connections.flatMap(({ from, to }) => [from, to]));
  const columns = columnsOf(graph);
  const bottoms: number[] = [];
  return graph.modules.map((module) => {
    const column = columns.get(module.name) ?? 0;
    const x = column * (kModuleWidth + kColumnGap);
    const y = bottoms[column] ?? 0;
    const rows = [0, 0]; // of targets and of sources
    const ports = module.ports.flatMap((port): PlacedPort[] => {
      const fullName = `${module.name}.${port.name}`;
      if (!showsAll && !connected.has(fullName)) return [];
      const side = isSource(port) ? 1 : 0;
      const row = rows[side] as number;
      rows[side] = row + 1;
      return [
        {
          port,
          fullName,
          x: x + side * kModuleWidth,
          y: y + kHeadHeight + (row + 0.5) * kPortHeight,
          isSource: side === 1,
        },
      ];
    });
    const height = kHeadHeight + Math.max(...rows, 0) * kPortHeight + 8;
    bottoms[column] = y + height + kRowGap;
    return { module, x, y, height, ports };
  });
}
