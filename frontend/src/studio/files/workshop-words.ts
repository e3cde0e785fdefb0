// Which settings of the workshop are shown, and shares in words.

/** Settings that say nothing while others have these values, and so are not shown. */
export function isIdle(key: string, value: (key: string) => unknown): boolean {
  switch (key) {
    case "dash":
    case "duty":
      return value("creases") === "score";
    case "spacing":
      return !isNested(value) && typeof value("hinge_stock") !== "number";
    case "margin":
    case "joint":
    case "joint_width":
      return !isNested(value);
    case "stock_price":
    case "roll_price":
      return !Array.isArray(value(key.replace("_price", "")));
    case "hinge_price":
    case "tie_price":
      return typeof value(key.replace("_price", "_stock")) !== "number";
    default:
      return false;
  }
}

/** Whether the sheet, or boards, are laid out on something that is sold in one size. */
function isNested(value: (key: string) => unknown): boolean {
  return Array.isArray(value("stock")) || Array.isArray(value("roll"));
}

/** A share as a percentage. */
export function percent(share: number): string {
  return `${Math.round(100 * share)} %`;
}
