// What has changed between two figures as they are written.

const NUMBER = /[-\u2212]?\d[\d\u202f]*(?:\.\d+)?(?:e[-+\u2212]?\d+)?/g;

/** The changes of the numbers, as "+0.2 × −1"; what it was, if it is of other words; "" if all is the same. */
export function differences(now: string, before: string): string {
  if (now === before || !now || !before) return "";
  const [present, past] = [now, before].map((text) => text.match(NUMBER) ?? []);
  if (!present!.length || now.replace(NUMBER, "") !== before.replace(NUMBER, "")) return `was ${before}`;
  return present!.map((text, k) => change(text, past![k]!)).join(" \u00d7 ");
}

/** To the digits that are shown of the larger. */
function change(now: string, before: string): string {
  const by = value(now) - value(before);
  const size = Math.max(Math.abs(value(now)), Math.abs(value(before)));
  const digits = Math.min(12, Math.max(0, 2 - Math.floor(Math.log10(size || 1))));
  const text = Math.abs(by).toFixed(digits);
  return Number(text) === 0 ? "0" : `${by < 0 ? "\u2212" : "+"}${Number(text)}`;
}

function value(text: string): number {
  return Number(text.replaceAll("\u202f", "").replaceAll("\u2212", "-"));
}
