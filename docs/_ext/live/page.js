// What a shell's page does within another: it leaves scrolling to that, and takes its theme.
if (parent !== window) {
  document.documentElement.classList.add("within");
  let used = false;
  addEventListener("pointerdown", () => { used = true; }, true);
  document.documentElement.addEventListener("pointerleave", () => { used = false; });
  addEventListener("wheel", (event) => {
    if (!used && !event.ctrlKey) event.stopImmediatePropagation();
  }, { capture: true, passive: true });
  // One finger up or down is the other page's, wherever it begins; to the side it turns the shell.
  addEventListener("touchstart", (event) => {
    if (event.touches.length === 1) event.stopImmediatePropagation();
  }, { capture: true, passive: true });
  let start = null;
  addEventListener("pointerdown", ({ pointerType, isPrimary, clientX }) => {
    start = pointerType === "touch" && isPrimary ? clientX : null;
  }, true);
  addEventListener("pointermove", (event) => {
    // Until it is known which it is, the shell keeps still.
    if (start !== null && Math.abs(event.clientX - start) < 12) event.stopImmediatePropagation();
    else start = null;
  }, true);
  addEventListener("message", ({ source, data }) => {
    if (source !== parent || (data !== "light" && data !== "dark")) return;
    // A page of variants unpacks its first shell before there is one.
    const set = () => (window.orishell ? window.orishell.theme.set(data) : setTimeout(set, 50));
    set();
  });
}
