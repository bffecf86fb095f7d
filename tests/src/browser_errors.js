window.probeErrors = [];
addEventListener("error", (e) => {
  const what = e.message || `cannot load ${e.target.tagName} ${(e.target.src || e.target.href || "").slice(0, 80)}`;
  window.probeErrors.push(what);
}, true);
addEventListener("unhandledrejection", (e) => window.probeErrors.push(String(e.reason)));
