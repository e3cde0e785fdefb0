// Line icons on a grid of 16, drawn here.

import { s } from "./dom.ts";

const PATHS = {
  undo: "M6 3 2.5 6.5 6 10M3 6.5h6.5a4 4 0 0 1 0 8H7",
  redo: "M10 3l3.5 3.5L10 10M13 6.5H6.5a4 4 0 0 0 0 8H9",
  open: "M1.5 13.5v-11h4l1.5 2h6v2.5M1.5 13.5l2.5-6.5h11l-2.5 6.5z",
  save: "M8 1.5v8.5M4.5 6.5 8 10l3.5-3.5M2 11.5v3h12v-3",
  link: "M6.500 9.500a3 3 0 0 0 4.300.2l2.400-2.400a3 3 0 0 0-4.300-4.300L7.700 4.200M9.500 6.500a3 3 0 0 0-4.300-.2L2.800 8.700a3 3 0 0 0 4.300 4.300l1.200-1.200",
  export: "M8 10V1.5M4.5 5 8 1.5 11.5 5M2 9.5v5h12v-5",
  drop: "M9 1.5H3v13h10v-9zM9 1.5v4h4M8 7.5v4.5M6 10l2 2 2-2",
  sun: "M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 .8v1.7M8 13.5v1.7M.8 8h1.7M13.500 8h1.7M2.900 2.900l1.200 1.200M11.900 11.900l1.200 1.200M2.900 13.100l1.200-1.200M11.900 4.100l1.200-1.200",
  moon: "M13.500 9.800A6 6 0 0 1 6.200 2.500a6 6 0 1 0 7.300 7.300z",
  play: "M4 2.500v11l9-5.500z",
  pause: "M4.500 2.500v11M11.500 2.500v11",
  plus: "M8 3v10M3 8h10",
  minus: "M3 8h10",
  fit: "M2 5.500V2h3.500M10.500 2H14v3.500M14 10.500V14h-3.500M5.500 14H2v-3.500",
  pencil: "M2.5 13.5l.8-3.300L10.800 2.700l2.500 2.500-7.500 7.500zM9.300 4.200l2.500 2.500",
  locked: "M4 7.500h8v6H4zM5.500 7.500V5a2.500 2.500 0 0 1 5 0v2.500",
  unlocked: "M4 7.500h8v6H4zM5.500 7.500V4a2.500 2.500 0 0 1 4.900-.7",
  blank: "M3.500 1.500h6l3 3v10h-9zM8 7v5M5.500 9.500h5",
  close: "M3.500 3.500l9 9M12.500 3.500l-9 9",
  help: "M5.600 5.800a2.400 2.400 0 1 1 3.600 2.100c-.8.500-1.200.9-1.200 1.900M8 12.600v.2M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1z",
  warning: "M8 2 1.500 13.500h13zM8 6.500v3.500M8 11.800v.2",
  done: "M2.500 8.500 6.500 12.500 13.500 4",
} as const;

export type IconName = keyof typeof PATHS;

export function icon(name: IconName): SVGSVGElement {
  return s(
    "svg",
    { class: `icon icon-${name}`, viewBox: "0 0 16 16", "aria-hidden": "true", focusable: "false" },
    s("path", { d: PATHS[name] }),
  );
}
