(() => {
  "use strict";
  const $ = (selector) => document.querySelector(selector);
  const viewer = $("#viewer"), stage = $("#stage"), range = $("#split"), side = $("#side");
  const left = $("#left"), right = $("#right"), under = $("#stage .under"), over = $("#stage .over");
  const chosen = (name) => $(`input[name=${name}]:checked`).value;

  // A choice is "truth", "m3" (the picture of row 3) or "e3" (its error map); the gallery holds every picture once.
  const source = (choice) => {
    const layer = chosen("layer");
    return document.getElementById(`${layer}-${choice}`);
  };
  const show = (img, choice) => {
    const from = source(choice);
    img.src = from.src;
    img.alt = from.alt;
    return from.dataset.name;
  };
  const scales = (choices) => {
    const maps = choices.some((c) => c.startsWith("e"));
    for (const scale of viewer.querySelectorAll(".scale")) {
      scale.hidden = !maps || scale.dataset.layer !== chosen("layer");
    }
  };
  const update = () => {
    const slider = chosen("mode") === "slider";
    stage.hidden = !slider;
    side.hidden = slider;
    $("#choose-left").hidden = !slider;
    $("#right-name").textContent = slider ? "Right" : "Method";
    if (slider) {
      $(".tag.a").textContent = show(over, left.value);
      $(".tag.b").textContent = show(under, right.value);
      scales([left.value, right.value]);
    } else {
      const row = right.value.slice(1);
      const choices = right.value === "truth" ? ["truth"] : ["truth", `m${row}`, `e${row}`];
      side.querySelectorAll("figure").forEach((figure, k) => {
        figure.hidden = k >= choices.length;
        if (!figure.hidden) figure.lastElementChild.textContent = show(figure.firstElementChild, choices[k]);
      });
      scales(choices);
    }
  };
  const split = () => {
    stage.style.setProperty("--x", `${range.value}%`);
    range.setAttribute("aria-valuetext", `${Math.round(range.value)} % ${$(".tag.a").textContent}`);
  };
  const drag = (event) => {
    const box = stage.getBoundingClientRect();
    range.value = Math.min(100, Math.max(0, (100 * (event.clientX - box.left)) / box.width));
    split();
  };
  stage.addEventListener("pointerdown", (event) => {
    stage.setPointerCapture(event.pointerId);
    range.focus({ preventScroll: true });
    drag(event);
  });
  // The focus stays on the range, so that the arrow keys go on from where the pointer left.
  stage.addEventListener("mousedown", (event) => event.preventDefault());
  stage.addEventListener("pointermove", (event) => {
    if (stage.hasPointerCapture(event.pointerId)) drag(event);
  });
  range.addEventListener("input", split);
  viewer.addEventListener("change", update);
  viewer.hidden = false;
  update();
  split();
})();
