import { expect, it } from "vitest";

const SOURCE: Record<string, string> = import.meta.glob("../src/**/*.ts", { query: "?raw", import: "default", eager: true });
/** Imports and re-exports, those of types too: a module cannot be understood without them. */
const IMPORT = /^(?:import|export)\b[^;"']*?["'](\.[^"']*\.ts)["']/gm;

function modules(): Map<string, string[]> {
  const nameOf = (path: string): string => new URL(path, "file:///tests/").pathname.replace("/src/", "");
  return new Map(Object.entries(SOURCE).map(([file, text]) => {
    const name = nameOf(file);
    const imported = [...text.matchAll(IMPORT)].map(([, path]) => new URL(path!, `file:///${name}`).pathname.slice(1));
    return [name, imported];
  }));
}

/** Circles: each as the modules in it, from the one where the search came upon it. */
function circles(imports: Map<string, string[]>): string[][] {
  const found: string[][] = [];
  const done = new Set<string>();
  const walk = (name: string, path: string[]): void => {
    if (path.includes(name)) found.push([...path.slice(path.indexOf(name)), name]);
    if (done.has(name)) return;
    done.add(name);
    for (const next of imports.get(name) ?? []) walk(next, [...path, name]);
  };
  for (const name of imports.keys()) walk(name, []);
  return found;
}

it("a circle is found", () => {
  const imports = new Map([["a", ["b"]], ["b", ["c", "d"]], ["c", []], ["d", ["b"]]]);
  expect(circles(imports)).toEqual([["b", "d", "b"]]);
});

it("no module imports itself by way of others", () => {
  const imports = modules();
  const known = new Set(imports.keys());
  expect([...imports.values()].flat().filter((name) => !known.has(name))).toEqual([]);
  expect([...imports.values()].flat().length).toBeGreaterThan(200);
  expect(circles(imports)).toEqual([]);
});

it("studio, viewer and the page of a search share what is in shared", () => {
  const across = [...modules()].flatMap(([name, imports]) => imports.map((each) => [name, each] as const));
  const folder = (name: string): string => name.split("/")[0]!;
  const strange = across.filter(([from, to]) => folder(from) !== folder(to) && folder(to) !== "shared");
  // front.html draws its shells by the viewer's parts.
  expect(strange.filter(([from, to]) => !(folder(from) === "front" && folder(to) === "viewer"))).toEqual([]);
});
