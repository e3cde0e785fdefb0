// The studio's server. Every function throws ServerFault, or AbortError if it was aborted.

import type * as Api from "../../shared/api-types.ts";
import { ServerFault, lockedOut, ownFault, refusalOf, unreachable } from "../state/faults.ts";
import type { Design, DroppedCurve, Info, Ranges, Verified } from "../state/types.ts";

async function ask(path: string, body?: unknown, signal?: AbortSignal): Promise<Response> {
  const options: RequestInit = signal ? { signal } : {};
  if (body !== undefined) {
    options.method = "POST";
    options.headers = { "Content-Type": "application/json" };
    options.body = JSON.stringify(body);
  }
  let response: Response;
  try {
    response = await fetch(`api/${path}`, options);
  } catch (error) {
    if (signal?.aborted) throw error;
    throw unreachable();
  }
  if (!response.ok) throw await refusedBy(response);
  return response;
}

async function refusedBy(response: Response): Promise<ServerFault> {
  try {
    const refusal = (await response.json()) as Api.Refusal;
    return refusal.error.kind === "key" ? lockedOut() : refusalOf(refusal);
  } catch {
    // Not ours: a proxy, or a server that fell over. The status says what there is to say.
    return new ServerFault(ownFault("http", `The studio answered with status ${response.status}`));
  }
}

/** The body of an answer; a server that dies while it answers does not answer. */
async function received<T>(body: Promise<T>, signal?: AbortSignal): Promise<T> {
  try {
    return await body;
  } catch (error) {
    if (signal?.aborted) throw error;
    throw unreachable();
  }
}

async function json<T>(path: string, body?: unknown, signal?: AbortSignal): Promise<T> {
  const response = await ask(path, body, signal);
  return received(response.json() as Promise<T>, signal);
}

export function fetchInfo(): Promise<Info> {
  return json("info");
}

export interface Answer {
  /** See shared/view.ts. */
  bytes: ArrayBuffer;
  /** How long the server took (milliseconds). */
  server: number;
}

/** The view of a design. */
export async function fetchView(
  design: Design,
  states: number,
  signal?: AbortSignal,
): Promise<Answer> {
  const response = await ask("design", { design, states }, signal);
  const server = Number(/dur=([\d.]+)/.exec(response.headers.get("Server-Timing") ?? "")?.[1] ?? 0);
  return { bytes: await received(response.arrayBuffer(), signal), server };
}

export async function fetchRanges(design: Design, signal: AbortSignal): Promise<Ranges> {
  return (await json<Api.Ranges>("ranges", { design }, signal)).ranges;
}

export async function parseDesign(text: string): Promise<Design> {
  return (await json<Api.Parsed>("parse", { text })).design as unknown as Design;
}

export async function formatDesign(design: Design): Promise<string> {
  return (await json<Api.Written>("format", { design })).text;
}

export async function readCurve(file: File, unit: string): Promise<DroppedCurve> {
  return json("curve", { name: file.name, content: await base64(file), unit });
}

/** The target surface of a design, to be drawn, whatever is wrong with loads, boards and the like. */
export function fetchSurface({ shell, target, pattern, tolerance }: Design): Promise<Api.DrawnSurface> {
  return json("surface", { design: { shell, target, pattern, tolerance } });
}

/** The drawn sheet in a file; `asked` is what its reader is told. */
export async function readPattern(file: File, unit: string, asked: Record<string, unknown>): Promise<Api.DroppedTarget> {
  return json("pattern", { ...asked, name: file.name, content: await base64(file), unit });
}

/** Whether the lines of a drawing are those of a crease pattern: mountains, valleys and a border. */
export async function looksLikePattern(file: File): Promise<boolean> {
  return (await json<Api.DrawingLook>("look", { name: file.name, content: await base64(file), unit: "m" })).pattern;
}

/** What is known of the drawn sheet of a design. */
export function describeDrawing(design: Design): Promise<Api.DrawnSheetFacts> {
  return json("drawing", { design });
}

export async function readSurface(file: File, unit: string): Promise<Api.DroppedTarget> {
  return json("mesh", { name: file.name, content: await base64(file), unit });
}

/** What every family makes of the target of a design, told as it is found; aborting stops the work. */
export function compareFamilies(design: Design, signal: AbortSignal, progressed: Progressed, found: (tried: Api.FamilyTrial[]) => void): Promise<Api.FamilyChoice> {
  return streamed<Api.FamilyChoice, Api.FamilyTrial[]>("families", { design }, signal, progressed, found);
}

/** The view of a design that is fitted to its surface, a coarser one first; aborting stops the fit. */
export async function fitView(design: Design, states: number, signal: AbortSignal, progressed: Progressed, coarse: (bytes: ArrayBuffer) => void): Promise<ArrayBuffer> {
  return decodeBytes(await streamed<string>("fit", { design, states }, signal, progressed, (view) => coarse(decodeBytes(view))));
}

export interface Download {
  name: string;
  blob: Blob;
}

export async function exportDesign(
  design: Design,
  format: string,
  state: string | number,
  name: string,
): Promise<Download> {
  const response = await ask("export", { design, format, state, name });
  const header = response.headers.get("Content-Disposition") ?? "";
  const quoted = /filename\*=utf-8''([^;]+)/i.exec(header)?.[1];
  const plain = /filename="?([^";]+)"?/i.exec(header)?.[1];
  const file = quoted ? decodeURIComponent(quoted) : (plain ?? `${name}.${format}`);
  return { name: file, blob: await received(response.blob()) };
}

export type Progressed = (share: number, what: string) => void;

/** Prove how the motion ends, and what is borne; what is known sooner is told. Aborting stops the proof.
 * `patient`: it may take as long as a search. */
export function verify(design: Design, signal: AbortSignal, progressed: Progressed, found?: (known: Verified) => void, patient = false): Promise<Verified> {
  return streamed("verify", { design, patient }, signal, progressed, found);
}

/** A change of a design that does what its notes on a matter say, tried; null if none does. Aborting stops the trials.
 * `patient`: they may take as long as a search. */
export async function findMend(design: Design, about: string, signal: AbortSignal, progressed: Progressed, patient = false): Promise<Api.Remedy | null> {
  return (await streamed<Api.Mended>("mend", { design, about, patient }, signal, progressed)).mend;
}

/** What fewer panels cost, and how near a sheet of the size given comes; aborting stops the search. */
export function findTradeoff(design: Design, size: { rows: number; columns: number } | null, signal: AbortSignal, progressed: Progressed): Promise<Api.Tradeoff> {
  return streamed("tradeoff", { design, size }, signal, progressed);
}

/** The drawings that a workshop gets; aborting stops the work. */
export function drawSheets(design: Design, name: string, signal: AbortSignal, progressed: Progressed): Promise<Api.Sheets> {
  return streamed("sheets", { design, name }, signal, progressed);
}

/** The booklet of a kit, of that of a card model, or alone; aborting stops the work. */
export function drawBooklet(design: Design, name: string, format: string, signal: AbortSignal, progressed: Progressed): Promise<Api.Booklet> {
  return streamed("booklet", { design, name, format }, signal, progressed);
}

/** Search the variants of a design; what is found is told as it is, aborting stops the search. */
export function searchDesigns(design: Design, name: string, signal: AbortSignal, found: (state: Api.SearchState) => void): Promise<Api.SearchState> {
  return streamed("search", { design, name }, signal, () => undefined, found);
}

/** Designs that carry all load cases; what was tried is told as it ends, aborting stops the search. */
export function makeItCarry(design: Design, signal: AbortSignal, progressed: Progressed, tried: (changes: string[]) => void): Promise<Api.CarrySearch> {
  return streamed("carry", { design }, signal, progressed, tried);
}

/** The result of work whose progress, and what it finds, is told while it is under way. */
async function streamed<T, Found = T>(path: string, body: unknown, signal: AbortSignal, progressed: Progressed, found?: (value: Found) => void): Promise<T> {
  const response = await ask(path, body, signal);
  const reader = response.body!.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  for (;;) {
    const { value, done } = await received(reader.read(), signal);
    const lines = (rest + (value ?? "")).split("\n");
    // Every message ends its line: one that does not was cut off.
    rest = lines.pop()!;
    for (const line of lines) {
      if (!line.trim()) continue;
      const message = JSON.parse(line) as Api.Advance | { found: Found } | { result: T } | Api.Refusal;
      if ("error" in message) throw refusalOf(message);
      if ("result" in message) return message.result;
      if ("found" in message) found?.(message.found);
      else progressed(message.progress, message.what);
    }
    if (done) throw unreachable();
  }
}

async function base64(file: File): Promise<string> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = "";
  for (let i = 0; i < bytes.length; i += 32768) {
    text += String.fromCharCode(...bytes.subarray(i, i + 32768));
  }
  return btoa(text);
}

export function decodeBytes(text: string): ArrayBuffer {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
}

/** Float32 numbers, little endian, from base64. */
export function decodeFloats(text: string): Float32Array {
  return new Float32Array(decodeBytes(text));
}
