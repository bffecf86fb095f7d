addEventListener("load", async () => {
  const number = (cell) => (cell.dataset.v === undefined ? NaN : Number(cell.dataset.v));
  const broken = [];
  const pictures = [...document.images].filter((img) => img.getAttribute("src"));
  for (const img of pictures) img.loading = "eager";
  for (let k = 0; k < 100 && pictures.some((img) => !img.complete); k++) {
    await new Promise((done) => setTimeout(done, 50));
  }
  for (const img of pictures) if (!img.naturalWidth) broken.push(img.alt);
  // Every column of every table, both ways.
  const unsorted = [];
  const tables = [...document.querySelectorAll("table.sortable")];
  for (const table of tables) {
    for (const head of table.tHead.rows[0].cells) {
      for (const sign of [1, -1]) {
        head.querySelector("button").click();
        const values = [...table.tBodies[0].rows].map((r) => number(r.cells[head.cellIndex])).filter((v) => !isNaN(v));
        if (values.some((v, k) => k > 0 && sign * (v - values[k - 1]) < 0)) unsorted.push(head.textContent);
        const rows = [...table.tBodies[0].rows].map((r) => r.cells[head.cellIndex].dataset.v !== undefined);
        if (rows.indexOf(false) >= 0 && rows.indexOf(false) < rows.lastIndexOf(true)) unsorted.push(`${head.textContent}: gaps`);
      }
    }
  }
  const root = document.documentElement;
  const texts = [...document.querySelectorAll("p, td, th, figcaption, li, h1, h2, h3, dd, dt, label")].filter((e) => e.offsetParent);
  const size = Math.min(...texts.map((e) => parseFloat(getComputedStyle(e).fontSize)));
  // What sticks out of the window, outside of boxes that scroll by themselves.
  const inScroller = (e) => e.closest(".scroll") !== null;
  const wide = [...document.body.querySelectorAll("*")].filter((e) => !inScroller(e) && e.getBoundingClientRect().right > innerWidth + 1);
  parent.postMessage(JSON.stringify({
    errors: window.probeErrors,
    pictures: pictures.length,
    broken,
    tables: tables.length,
    unsorted,
    overflow_px: root.scrollWidth - innerWidth,
    wide: wide.slice(0, 3).map((e) => e.tagName + "." + e.className),
    text_px: size,
    title: document.title,
    words: document.body.innerText.split(/\s+/).length,
    width: innerWidth,
  }), "*");
});
