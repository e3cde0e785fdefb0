// Puts the viewer in the place of a shell's picture, when it is asked for or, once seen, by itself.
(() => {
  const dark = matchMedia("(prefers-color-scheme: dark)");

  function theme() {
    const chosen = document.body.dataset.theme;
    return chosen === "light" || chosen === "dark" ? chosen : dark.matches ? "dark" : "light";
  }

  function tell() {
    // Pages opened from disk have no origin to name; what is told is no secret.
    for (const frame of document.querySelectorAll(".live iframe")) frame.contentWindow.postMessage(theme(), "*");
  }

  function open(stage, asked) {
    if (stage.querySelector("iframe")) return;
    const poster = stage.querySelector(".live-poster");
    const frame = document.createElement("iframe");
    frame.title = `Turn and fold: ${poster.querySelector("img").alt}`;
    frame.addEventListener("load", () => {
      tell();
      stage.classList.replace("live-loading", "live-on");
      if (asked) frame.focus();
    });
    stage.classList.add("live-loading");
    frame.src = poster.href;
    stage.append(frame);
  }

  const seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      seen.unobserve(target);
      open(target, false);
    }
  });
  for (const stage of document.querySelectorAll(".live-stage")) {
    stage.querySelector(".live-poster").addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      open(stage, true);
    });
    if (stage.dataset.when === "at-once" && !navigator.connection?.saveData) seen.observe(stage);
  }
  dark.addEventListener("change", tell);
  new MutationObserver(tell).observe(document.body, { attributeFilter: ["data-theme"] });
})();
