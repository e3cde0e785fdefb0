// Which settings of the workshop are shown, and shares in words.

/** Settings that say nothing while others have these values, and so are not shown. */
export function isIdle(key: string, value: (key: string) => unknown): boolean {
  switch (key) {
    case "dash":
    case "duty":
      return value("creases") === "score";
    case "margin":
    case "spacing":
    case "joint":
    case "joint_width":
      return !Array.isArray(value("stock"));
    default:
      return false;
  }
}

/** A share as a percentage. */
export function percent(share: number): string {
  return `${Math.round(100 * share)} %`;
}
