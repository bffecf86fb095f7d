(() => {
  "use strict";
  // A click on a dot marks the figure that its address names, on top of the list beside the truth.
  const mark = () => {
    for (const old of document.querySelectorAll("figure.chosen")) old.classList.remove("chosen");
    const figure = location.hash && document.getElementById(location.hash.slice(1));
    if (figure && figure.tagName === "FIGURE") figure.classList.add("chosen");
  };
  addEventListener("hashchange", mark);
  mark();
})();
